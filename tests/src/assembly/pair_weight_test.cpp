// What part of a pair counts: nothing comes or goes at once where facets turn away from each other or part.
#include <gtest/gtest.h>

#include "contact/mortar/overlap_weight.hpp"
#include "support/gradient_check.hpp"
#include "support/random_pairs.hpp"

namespace mortise::test {
namespace {

const auto& rule = triangle_rule(5);
constexpr double farthest = 0.4;

/// The primary facet of a pair turned about an axis in the secondary one, and moved away.
PairInput turned(PairInput input, double degrees, double away) {
  const Vec3<double> sum = (input.normal[0] + input.normal[1]) + (input.normal[2] + input.normal[3]), n = (1 / norm(sum)) * sum,
                     side = input.x[1] - input.x[0], across = cross(n, side), axis = (1 / norm(across)) * across,
                     centre = 0.25 * ((input.x[4] + input.x[5]) + (input.x[6] + input.x[7]));
  const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
  for (int a = 4; a < 8; ++a) {
    const Vec3<double> r = input.x[a] - centre;
    input.x[a] = centre + c * r + s * cross(axis, r) + ((1 - c) * dot(axis, r)) * axis + away * n;
  }
  return input;
}

/// Weighed shares and areas; all 0 where the pair does not count.
std::vector<double> weighed(const PairInput& input, bool with_slopes, PairTangent& pair) {
  PairWeight weight = facing_weight(input);
  if (weight.value == 0 || !(with_slopes ? pair_tangent(input, rule, pair) : pair_values(input, rule, pair)))
    return std::vector<double>(44, 0.0);
  add_nearness(pair, farthest, with_slopes, weight);
  weigh(weight, with_slopes, pair);
  std::vector<double> all(pair.row, pair.row + 40);
  all.insert(all.end(), pair.covered_area, pair.covered_area + 4);
  return all;
}

TEST(PairWeight, IsOneForFacingFacetsAndNoneForThoseTurnedAway) {
  Random random(3);
  const auto input = overlapping_pair(random, 0.3);
  EXPECT_EQ(facing_weight(turned(input, 0, 0)).value, 1);
  EXPECT_EQ(facing_weight(turned(input, 100, 0)).value, 0);
  EXPECT_EQ(facing_weight(turned(input, 180, 0)).value, 0);
  EXPECT_EQ(nearness_weight(-3.0, farthest), 1);
  EXPECT_EQ(nearness_weight(0.8 * farthest, farthest), 1);
  EXPECT_EQ(nearness_weight(farthest, farthest), 0);
  EXPECT_NEAR(nearness_weight(0.9 * farthest, farthest), 0.5, 1e-14);
}

TEST(PairWeight, HasItsDerivativeInTheSharesOfThePair) {
  Random random(5);
  int n_turning = 0, n_parting = 0;
  for (int trial = 0; trial < 200 && (n_turning < 5 || n_parting < 5); ++trial) {
    const bool is_turning = trial % 2 == 0;
    const auto input = turned(overlapping_pair(random, 0.3), is_turning ? random.in(68, 78) : 0, is_turning ? 0 : 0.9 * farthest);
    PairTangent pair;
    const double facing = facing_weight(input).value;
    const auto rows = weighed(input, true, pair);
    const double area = rows[40] + rows[41] + rows[42] + rows[43];
    if (!(area > 1e-3) || (is_turning && !(facing > 0.05 && facing < 0.95))) continue;
    ++(is_turning ? n_turning : n_parting);
    std::vector<double> jacobian(&pair.d[0][0], &pair.d[0][0] + 1600);
    for (const auto& row : pair.d_area) {
      jacobian.insert(jacobian.end(), row, row + 36);
      jacobian.insert(jacobian.end(), 4, 0.0);
    }
    const auto f = [](const std::vector<double>& at) {
      PairTangent values;
      return weighed(from_inputs(at), false, values);
    };
    EXPECT_TRUE(is_derivative(jacobian, f, inputs_of(input), {1e-4, 1e-6, 2})) << "trial " << trial;
  }
  EXPECT_EQ(n_turning, 5);
  EXPECT_EQ(n_parting, 5);
}

// Case A7 of the catalogue of hard cases: force over the angle, up to where the facet shows its back.
TEST(PairWeight, MakesForcesContinuousOverTheAngle) {
  Random random(8);
  const auto input = overlapping_pair(random, 0.3);
  PairTangent pair;
  const auto shares = [&](double degrees) { return weighed(turned(input, degrees, 0), false, pair); };
  double scale = 0, jump = 0;
  for (double row : shares(0)) scale = std::max(scale, std::abs(row));
  constexpr double step = 1e-6;  // degrees
  for (double degrees = 60; degrees < 100; degrees += 0.01) {
    const auto here = shares(degrees), there = shares(degrees + step);
    for (std::size_t k = 0; k < here.size(); ++k) jump = std::max(jump, std::abs(here[k] - there[k]));
  }
  EXPECT_LE(jump, 1e-6 * scale);
}

}  // namespace
}  // namespace mortise::test
