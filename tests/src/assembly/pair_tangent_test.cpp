// The derivative of a facet pair: against differences, against differentiation without stages, and in hard positions.
#include "assembly/pair_tangent.hpp"

#include <gtest/gtest.h>

#include <Sacado.hpp>

#include "contact/surface.hpp"
#include "support/facets.hpp"
#include "support/gradient_check.hpp"
#include "support/random_pairs.hpp"

namespace mortise::test {
namespace {

const auto& rule = triangle_rule(5);

double largest_entry(const PairTangent& pair) {  // infinite if any entry is not a number
  double size = 0;
  const auto include = [&size](double entry) { size = std::max(size, std::isfinite(entry) ? std::abs(entry) : HUGE_VAL); };
  for (const auto& row : pair.d) std::for_each(row, row + 40, include);
  for (const auto& row : pair.d_area) std::for_each(row, row + 36, include);
  return size;
}

double largest_row(const PairOutput& pair) {
  double size = 0;
  for (double row : pair.row) size = std::max(size, std::isfinite(row) ? std::abs(row) : HUGE_VAL);
  return size;
}

PairInput moved(PairInput input, const Tensor3<double>& Q, const Vec3<double>& shift) {
  for (auto& x : input.x) x = rotate(Q, x) + shift;
  for (auto& n : input.normal) n = rotate(Q, n);
  return input;
}

TEST(PairTangent, HasTheRowsOfThePairValues) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto input = random_pair(random);
    PairOutput values;
    PairTangent tangent;
    const bool overlap = pair_values(input, rule, values);
    ASSERT_EQ(pair_tangent(input, rule, tangent), overlap);
    if (!overlap) continue;
    for (int r = 0; r < 40; ++r) EXPECT_NEAR(tangent.row[r], values.row[r], 1e-15);
    for (int I = 0; I < 4; ++I) EXPECT_NEAR(tangent.covered_area[I], values.covered_area[I], 1e-15);
  }
}

TEST(PairTangent, IsTheDerivativeOfThePairValues) {
  Random random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const auto input = overlapping_pair(random, 0.05);
    PairTangent tangent;
    ASSERT_TRUE(pair_tangent(input, rule, tangent));
    std::vector<double> jacobian(&tangent.d[0][0], &tangent.d[0][0] + 1600);
    for (const auto& row : tangent.d_area) {
      jacobian.insert(jacobian.end(), row, row + 36);
      jacobian.insert(jacobian.end(), 4, 0.0);
    }
    const auto rows = [](const std::vector<double>& at) {
      PairOutput values;
      pair_values(from_inputs(at), rule, values);
      std::vector<double> all(values.row, values.row + 40);
      all.insert(all.end(), values.covered_area, values.covered_area + 4);
      return all;
    };
    // Steps short of the next change in the number of corners, where the derivative has a kink.
    EXPECT_TRUE(is_derivative(jacobian, rows, inputs_of(input), {2e-4, 1e-7, 2})) << "trial " << trial;
  }
}

/// The same shares with every step, frame included, on numbers that carry all 40 derivatives: no stages, no closed forms.
TEST(PairTangent, EqualsDifferentiationWithoutStages) {
  using Fad = Sacado::Fad::SFad<double, 40>;
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto input = overlapping_pair(random);
    const auto all = inputs_of(input);
    std::array<Vec3<Fad>, 8> x;
    std::array<Vec3<Fad>, 4> n;
    std::array<Fad, 4> p;
    for (int k = 0; k < 24; ++k) x[k / 3][k % 3] = Fad(40, k, all[k]);
    for (int k = 24; k < 36; ++k) n[(k - 24) / 3][k % 3] = Fad(40, k, all[k]);
    for (int I = 0; I < 4; ++I) p[I] = Fad(40, 36 + I, all[36 + I]);
    const Vec3<Fad> centre = Fad(0.25) * ((x[0] + x[1]) + (x[2] + x[3])), sum = (n[0] + n[1]) + (n[2] + n[3]);
    const Vec3<Fad> up = Fad(1.0 / norm(sum)) * sum, side = cross(up, Vec3<Fad>{Fad(0.36), Fad(0.48), Fad(-0.8)});
    const Vec3<Fad> t1 = Fad(1.0 / norm(side)) * side, t2 = cross(up, t1);
    Fad y[16];
    for (int a = 0; a < 8; ++a) {
      x[a] = x[a] - centre;
      y[2 * a] = dot(t1, x[a]);
      y[2 * a + 1] = dot(t2, x[a]);
    }
    const auto integrals = planar_integrals(y, rule);
    const auto expected = pair_shares(x, n, p, integrals);
    PairTangent tangent;
    ASSERT_TRUE(pair_tangent(input, rule, tangent));
    const double size = largest_entry(tangent);
    const auto compare = [&](int row, const Fad& value) {
      EXPECT_NEAR(tangent.row[row], value.val(), 1e-14);
      for (int c = 0; c < 40; ++c) EXPECT_NEAR(tangent.d[row][c], value.dx(c), 1e-12 * size) << "row " << row << ", column " << c;
    };
    for (int k = 0; k < 24; ++k) compare(k, expected.force[k / 3][k % 3]);
    for (int k = 0; k < 12; ++k) compare(24 + k, expected.n_load[k / 3][k % 3]);
    for (int I = 0; I < 4; ++I) {
      compare(36 + I, expected.weighted_gap[I]);
      const Fad area = (integrals.D[I][0] + integrals.D[I][1]) + (integrals.D[I][2] + integrals.D[I][3]);
      for (int c = 0; c < 36; ++c) EXPECT_NEAR(tangent.d_area[I][c], area.dx(c), 1e-12 * size);
    }
  }
}

TEST(PairTangent, DoesNotNoticeATranslation) {
  Random random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const auto input = overlapping_pair(random);
    PairTangent pair;
    ASSERT_TRUE(pair_tangent(input, rule, pair));
    for (int r = 0; r < 40; ++r)
      for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int a = 0; a < 8; ++a) sum += pair.d[r][3 * a + i];
        EXPECT_NEAR(sum, 0, 1e-13 * largest_entry(pair)) << "row " << r;
      }
    PairOutput far;
    ASSERT_TRUE(pair_values(moved(input, identity<double>(), {1000, -500, 300}), rule, far));
    for (int r = 0; r < 40; ++r) EXPECT_NEAR(far.row[r], pair.row[r], 1e-11);  // 1000 costs three digits and a half
  }
}

TEST(PairTangent, TurnsWithSpace) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const auto input = overlapping_pair(random);
    const auto Q = random.rotation();
    PairOutput here, there;
    ASSERT_TRUE(pair_values(input, rule, here));
    ASSERT_TRUE(pair_values(moved(input, Q, {0, 0, 0}), rule, there));
    for (int k = 0; k < 36; k += 3) {
      const auto expected = rotate(Q, {here.row[k], here.row[k + 1], here.row[k + 2]});
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(there.row[k + i], expected[i], 1e-13);
    }
    for (int I = 0; I < 4; ++I) EXPECT_NEAR(there.row[36 + I], here.row[36 + I], 1e-13);
  }
}

/// A facet in the middle of a curved surface meets a primary facet; the force that turns the normals acts on the patches round
/// its nodes.
TEST(PairForce, HasNoResultantAndNoMomentOnceTheNormalsTurn) {
  Random random(6);
  double worst_force = 0, worst_moment = 0, moment_without = 0;
  for (int trial = 0; trial < 200; ++trial) {
    auto mesh = square(3, -1.5, 3);
    const auto Q = random.rotation();
    for (auto& p : mesh.x) p = rotate(Q, Vec3<double>{p[0], p[1], -0.1 * (p[0] * p[0] + p[1] * p[1])} + random.vector(0.1));
    const ContactSurface surface{mesh.facets};
    const auto patches = surface.patches();
    const auto& facet = mesh.facets[4];
    auto input = moved(overlapping_pair(random, 0.1), identity<double>(), {0, 0, 0});
    const auto primary = upside_down(square(1, -0.3, 1));
    for (int a = 0; a < 4; ++a) {
      input.x[a] = mesh.x[facet[a]];
      input.x[4 + a] = rotate(Q, primary.x[primary.facets[0][a]] + random.vector(0.1));
      std::vector<Vec3<double>> x;
      for (int node : patches[facet[a]].nodes) x.push_back(mesh.x[node]);
      input.normal[a] = nodal_normal(patches[facet[a]], x);
    }
    PairOutput pair;
    ASSERT_TRUE(pair_values(input, rule, pair));
    Vec3<double> force{}, moment{};
    double size = 0;
    const auto add = [&](const Vec3<double>& x, const Vec3<double>& f) {
      force = force + f;
      moment = moment + cross(x, f);
      size += norm(f);
    };
    for (int a = 0; a < 8; ++a) add(input.x[a], {pair.row[3 * a], pair.row[3 * a + 1], pair.row[3 * a + 2]});
    moment_without = std::max(moment_without, norm(moment) / size);
    for (int I = 0; I < 4; ++I) {
      const auto& patch = patches[facet[I]];
      std::vector<Vec3<double>> x, f;
      for (int node : patch.nodes) x.push_back(mesh.x[node]);
      normal_pull_back(patch, x, Vec3<double>{pair.row[24 + 3 * I], pair.row[25 + 3 * I], pair.row[26 + 3 * I]}, f);
      for (std::size_t a = 0; a < f.size(); ++a) add(x[a], f[a]);
    }
    worst_force = std::max(worst_force, norm(force) / size);
    worst_moment = std::max(worst_moment, norm(moment) / size);
  }
  EXPECT_LE(worst_force, 1e-15);
  EXPECT_LE(worst_moment, 1e-14);
  EXPECT_GT(moment_without, 1e-4);  // it is the turning of the normals that balances the moment
  RecordProperty("force_1e-18", std::to_string(worst_force * 1e18));
  RecordProperty("moment_1e-18", std::to_string(worst_moment * 1e18));
}

/// Matching meshes whose nodes are off by a little: all pairs of 3 x 3 with 3 x 3 facets.
double greatest_jacobian_entry(double noise, unsigned seed, double distortion) {
  Random random(seed), shape(7);
  auto secondary = square(3, 0, 3);
  for (auto& p : secondary.x) p = p + shape.vector(distortion);
  auto primary = upside_down(secondary);
  for (auto& p : primary.x) {
    const auto move = random.vector(noise);
    p = p + Vec3<double>{move[0], move[1], 0.01};
  }
  double size = 0;
  for (int s = 0; s < 9; ++s)
    for (int p = 0; p < 9; ++p) {
      PairInput input;
      input.x = pair_nodes(secondary, s, primary, p);
      for (int a = 0; a < 4; ++a) {
        input.normal[a] = {0, 0, 1};
        input.pressure[a] = 1 + 0.2 * a;
      }
      PairTangent pair;
      if (pair_tangent(input, rule, pair)) size = std::max(size, largest_entry(pair));
    }
  return size;
}

TEST(PairTangent, StaysBoundedOnConformingMeshes) {
  for (const double distortion : {0.0, 0.06, 0.2}) {
    const double regular = greatest_jacobian_entry(0.1, 1, distortion);  // nodes far from matching
    double worst = 0;
    for (const double noise : {0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5}) {
      double greatest = 0;
      for (unsigned seed = 1; seed <= 20; ++seed) greatest = std::max(greatest, greatest_jacobian_entry(noise, seed, distortion));
      EXPECT_LE(greatest, 10 * regular) << "noise " << noise << ", distortion " << distortion;
      worst = std::max(worst, greatest / regular);
    }
    RecordProperty("entry_over_regular_at_distortion_" + std::to_string(distortion), std::to_string(worst));
  }
}

TEST(PairTangent, IsFreeOfNansInHardPositions) {
  const auto flat = square(1);
  PairInput input;
  input.x = pair_nodes(flat, 0, upside_down(flat), 0);
  for (int a = 0; a < 4; ++a) {
    input.normal[a] = {0, 0, 1};
    input.pressure[a] = 1;
  }
  const auto expect_numbers = [](const PairInput& at, const std::string& what) {
    PairTangent pair;
    if (!pair_tangent(at, rule, pair)) return;
    EXPECT_TRUE(std::isfinite(largest_row(pair))) << what;
    EXPECT_TRUE(std::isfinite(largest_entry(pair))) << what;
  };
  for (const double degrees : {0.0, 45.0, 80.0, 89.0, 89.9, 89.99, 90.0, 90.01, 91.0, 135.0, 180.0})  // case A7
    for (const double shift : {0.0, 0.3}) {
      auto tilted = input;
      const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
      for (int a = 4; a < 8; ++a) tilted.x[a] = {shift + c * tilted.x[a][0], tilted.x[a][1], s * tilted.x[a][0]};
      expect_numbers(tilted, "tilted by " + std::to_string(degrees));
    }
  for (int i = -8; i <= 8; ++i)  // coincident, touching and nested on a grid of eighths; case A6
    for (int j = -8; j <= 8; ++j)
      for (const double size : {0.5, 1.0, 2.0}) {
        auto aligned = input;
        for (int a = 4; a < 8; ++a) aligned.x[a] = {size * aligned.x[a][0] + i / 8.0, size * aligned.x[a][1] + j / 8.0, 0.01};
        expect_numbers(aligned, "aligned " + std::to_string(i) + " " + std::to_string(j));
      }
  Random random(8);
  for (int trial = 0; trial < 2000; ++trial) {  // anything, reflex and crossed facets included
    auto wild = random_pair(random, 0.5);
    expect_numbers(wild, "wild " + std::to_string(trial));
  }
}

}  // namespace
}  // namespace mortise::test
