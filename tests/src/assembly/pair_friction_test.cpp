// Friction of a facet pair: conjugate to its slip, without resultant, without moment where promised, objective, differentiated.
#include <gtest/gtest.h>

#include "support/gradient_check.hpp"
#include "support/random_pairs.hpp"

namespace mortise::test {
namespace {

const auto& rule = triangle_rule(5);

PairFriction random_friction(Random& random, const PairInput& input, bool is_moment_free) {
  PairFriction friction{input.x, 0.5, {}, 0.5, {}, is_moment_free};
  for (auto& x : friction.before) x = x + random.vector(0.05);
  for (int I = 0; I < 4; ++I) {
    friction.traction[I] = random.vector(1);
    friction.traction_before[I] = random.vector(1);
  }
  return friction;
}

/// Forces of friction alone: those of the pair less those without friction.
std::array<Vec3<double>, 8> friction_forces(const PairInput& input, const FrictionalOutput& out) {
  PairOutput without;
  EXPECT_TRUE(pair_values(input, rule, without));
  std::array<Vec3<double>, 8> f;
  for (int k = 0; k < 24; ++k) f[k / 3][k % 3] = out.row[k] - without.row[k];
  return f;
}

TEST(PairFriction, IsConjugateToItsSlipAndHasNoResultantAndMomentWherePromised) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial)
    for (const bool is_moment_free : {false, true}) {
      const auto input = overlapping_pair(random, 0.05);
      const auto friction = random_friction(random, input, is_moment_free);
      FrictionalOutput out;
      ASSERT_TRUE(pair_values(input, friction, rule, out));
      const auto f = friction_forces(input, out);
      double work = 0, of_slip = 0, size = 0;
      Vec3<double> sum{}, moment{};
      for (int a = 0; a < 8; ++a) {
        const Vec3<double> dx = 2.0 * (input.x[a] - friction.before[a]);
        work += dot(f[a], dx);
        size += norm(f[a]);
        sum = sum + f[a];
        moment = moment + cross(input.x[a], f[a]);
      }
      for (int I = 0; I < 4; ++I)
        for (int i = 0; i < 3; ++i)
          of_slip -= 0.5 * (friction.traction[I][i] + friction.traction_before[I][i]) * out.row[40 + 3 * I + i];
      EXPECT_NEAR(work, of_slip, 1e-14);
      EXPECT_LE(norm(sum), 1e-14 * size);
      if (is_moment_free) {
        EXPECT_LE(norm(moment), 1e-13 * size);
      }
    }
}

TEST(PairFriction, SeesNoSlipInAFiniteRotationWherePromised) {
  Random random(2);
  double greatest = 0, of_thesis = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const auto begin = overlapping_pair(random, 0.05);
    const auto Q = random.rotation();
    if (1 + Q(0, 0) + Q(1, 1) + Q(2, 2) < 0.5) continue;  // near half a turn the middle of the step is a point
    for (const bool is_moment_free : {true, false}) {
      PairInput middle = begin;
      PairFriction friction{begin.x, 0.5, {}, 1, {}, is_moment_free};
      for (auto& x : middle.x) x = 0.5 * (x + rotate(Q, x) + Vec3<double>{0.3, -0.2, 0.1});
      for (auto& n : middle.normal) {
        n = n + rotate(Q, n);
        n = (1 / norm(n)) * n;
      }
      FrictionalOutput out;
      if (!pair_values(middle, friction, rule, out)) continue;
      double& worst = is_moment_free ? greatest : of_thesis;
      for (int k = 40; k < 52; ++k) worst = std::max(worst, std::abs(out.row[k]));
    }
  }
  EXPECT_LE(greatest, 1e-13);
  EXPECT_GE(of_thesis, 1e-4);
}

TEST(FrictionalTangent, IsTheDerivativeOfItsValues) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto input = overlapping_pair(random, 0.05);
    const auto friction = random_friction(random, input, trial % 2 == 0);
    FrictionalTangent tangent;
    ASSERT_TRUE(pair_tangent(input, friction, rule, tangent));
    const std::vector<double> jacobian(&tangent.d[0][0], &tangent.d[0][0] + 52 * 52);
    auto all = inputs_of(input);
    for (const auto& t : friction.traction) all.insert(all.end(), {t[0], t[1], t[2]});
    const auto rows = [&friction](const std::vector<double>& at) {
      PairFriction now = friction;
      for (int k = 0; k < 12; ++k) now.traction[k / 3][k % 3] = at[40 + k];
      FrictionalOutput values;
      pair_values(from_inputs(at), now, rule, values);
      return std::vector<double>(values.row, values.row + 52);
    };
    EXPECT_TRUE(is_derivative(jacobian, rows, all, {2e-4, 1e-7, 2})) << "trial " << trial;
  }
}

}  // namespace
}  // namespace mortise::test
