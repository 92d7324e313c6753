// Quadrature, inverse maps and the mortar integrals D and M.
#include <gtest/gtest.h>

#include "contact/mortar/planar.hpp"
#include "support/facets.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

using Integrals = MortarIntegrals<double>;

Integrals integrals_of(const Quad<double>& secondary, const Quad<double>& primary, int degree) {
  double y[16];
  for (int a = 0; a < 4; ++a) {
    y[2 * a] = secondary[a].x;
    y[2 * a + 1] = secondary[a].y;
    y[8 + 2 * a] = primary[a].x;
    y[8 + 2 * a + 1] = primary[a].y;
  }
  return planar_integrals(y, triangle_rule(degree));
}

double difference(const double have[4][4], const nlohmann::json& expected) {
  double largest = 0;
  for (int I = 0; I < 4; ++I)
    for (int J = 0; J < 4; ++J) largest = std::max(largest, std::abs(have[I][J] - expected[I][J].get<double>()));
  return largest;
}

Quad<double> corners(const nlohmann::json& list) {
  Quad<double> q;
  for (int a = 0; a < 4; ++a) q[a] = {list[a][0], list[a][1]};
  return q;
}

double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

TEST(TriangleRule, IsExactToItsDegree) {
  for (int degree = 3; degree <= 8; ++degree) {
    const auto& rule = triangle_rule(degree);
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k) {
          double sum = 0;
          for (const auto& p : rule) sum += p.weight * std::pow(p.b0, i) * std::pow(p.b1, j) * std::pow(p.b2, k);
          const double exact = 2 * factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 2);
          EXPECT_NEAR(sum, exact, 2e-16) << "degree " << degree << ": " << i << j << k;
        }
  }
}

TEST(TriangleRule, HasPositiveWeightsAndPointsInside) {
  const std::size_t n_points[] = {6, 7, 12, 16, 16};
  for (int degree = 4; degree <= 8; ++degree) {
    EXPECT_EQ(triangle_rule(degree).size(), n_points[degree - 4]);
    for (const auto& p : triangle_rule(degree)) {
      EXPECT_GT(std::min({p.weight, p.b0, p.b1, p.b2}), 0);
      EXPECT_NEAR(p.b0 + p.b1 + p.b2, 1, 3e-16);
    }
  }
}

TEST(TriangleRule, OfDegreeThreeIsThatOfTheThesis) {
  EXPECT_EQ(triangle_rule(3).size(), 4u);  // Tab. 4.1: the centroid and three points, the first with a negative weight
  EXPECT_DOUBLE_EQ(triangle_rule(3)[0].weight, -27.0 / 48);
}

TEST(InverseBilinear, ReturnsWhereAPointOfAConvexFacetCameFrom) {
  Random random(1);
  double worst = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const auto q = random_quad(random, 0, 0, 1, trial % 3 == 0 ? 0 : 0.15);  // every third a square: no quadratic term
    const double s = random.in(0, 1), t = random.in(0, 1);
    const auto N = bilinear_shape(s, t);
    Vec2<double> x{0, 0};
    for (int a = 0; a < 4; ++a) x = {x.x + N[a] * q[a].x, x.y + N[a] * q[a].y};
    const auto back = inverse_bilinear(q, x);
    worst = std::max({worst, std::abs(back.x - s), std::abs(back.y - t)});
  }
  EXPECT_LE(worst, 1e-14);
  RecordProperty("greatest_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(InverseBilinear, WorksOnFacetsOfEitherOrientation) {
  const Quad<double> q{{{0, 0}, {0.1, 1}, {1.2, 1.1}, {0.9, -0.1}}};
  const auto N = bilinear_shape(0.3, 0.6);
  Vec2<double> x{0, 0};
  for (int a = 0; a < 4; ++a) x = {x.x + N[a] * q[a].x, x.y + N[a] * q[a].y};
  const auto back = inverse_bilinear(q, x);
  EXPECT_NEAR(back.x, 0.3, 1e-15);
  EXPECT_NEAR(back.y, 0.6, 1e-15);
}

/// The map of a facet with a reflex corner folds over near that corner: points have two sources, one of them inside the unit
/// square and not turned over. Case A10.
TEST(InverseBilinear, StaysInsideFacetsWithAReflexCorner) {
  Random random(2);
  int n_points = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    Quad<double> q{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const int corner = trial % 4;
    const double depth = random.in(0.05, 0.6);
    q[corner] = {-depth * q[corner].x, -depth * q[corner].y};
    std::array<Polygon<double>, 2> pieces;
    ASSERT_EQ(convex_pieces(q, pieces), 2);
    const auto& v = pieces[trial / 4 % 2].vertex;
    double a = random.in(0, 1), b = random.in(0, 1);
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    const Vec2<double> x{v[0].x + a * (v[1].x - v[0].x) + b * (v[2].x - v[0].x),
                         v[0].y + a * (v[1].y - v[0].y) + b * (v[2].y - v[0].y)};
    const auto source = inverse_bilinear(q, x);
    const auto N = bilinear_shape(source.x, source.y);
    Vec2<double> image{0, 0};
    for (int k = 0; k < 4; ++k) image = {image.x + N[k] * q[k].x, image.y + N[k] * q[k].y};
    ++n_points;
    const double outside = std::max({-source.x, source.x - 1, -source.y, source.y - 1});
    ASSERT_LE(outside, 1e-7) << "corner " << corner << ", depth " << depth;  // at the fold a root of round-off
    ASSERT_NEAR(image.x, x.x, 1e-14) << "corner " << corner << ", depth " << depth;
    ASSERT_NEAR(image.y, x.y, 1e-14) << "corner " << corner << ", depth " << depth;
  }
  EXPECT_EQ(n_points, 100000);
}

TEST(MortarIntegrals, AreExactOnAffineFacets) {
  if (!have_reference("mortar_matrices.json")) GTEST_SKIP() << no_reference("mortar_matrices.json");
  const auto matrices = reference("mortar_matrices.json");
  int n_compared = 0;
  for (const auto& one : reference("overlap_cases.json")) {
    const std::string name = one["name"];
    if (!matrices.contains(name)) continue;
    for (int degree = 4; degree <= 8; ++degree) {
      const auto have = integrals_of(corners(one["slave_f"]), corners(one["master_f"]), degree);
      EXPECT_LE(difference(have.D, matrices[name]["D"]), 1e-14 * 0.25) << name << ", degree " << degree;
      EXPECT_LE(difference(have.M, matrices[name]["M"]), 1e-14 * 0.25) << name << ", degree " << degree;
    }
    ++n_compared;
  }
  EXPECT_EQ(n_compared, 9);
}

/// On general facets the integrands are no polynomials; the rules come the nearer the higher their degree.
TEST(MortarIntegrals, ApproachTheExactValuesOnGeneralFacets) {
  if (!have_reference("mortar_matrices.json")) GTEST_SKIP() << no_reference("mortar_matrices.json");
  const auto expected = reference("mortar_matrices.json")["general_convex_pair_physical_space"];
  bool found = false;
  for (const auto& one : reference("overlap_cases.json")) {
    if (one["name"] != "general_convex_pair") continue;
    found = true;
    const double bound[] = {4e-7, 1e-7, 3e-10, 3e-12, 3e-12};
    for (int degree = 4; degree <= 8; ++degree) {
      const auto have = integrals_of(corners(one["slave_f"]), corners(one["master_f"]), degree);
      const double error = std::max(difference(have.D, expected["D"]), difference(have.M, expected["M"]));
      EXPECT_LE(error, bound[degree - 4]);
      RecordProperty("error_degree_" + std::to_string(degree), std::to_string(error * 1e12) + "e-12");
    }
  }
  EXPECT_TRUE(found);
}

TEST(MortarIntegrals, HaveTheAreaOfTheOverlapAsTheirSum) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto secondary = random_quad(random, 0, 0, 1, 0.2);
    auto primary = random_quad(random, random.in(-0.7, 0.7), random.in(-0.7, 0.7), random.in(0.5, 1.5), 0.2);
    std::swap(primary[1], primary[3]);
    const auto have = integrals_of(secondary, primary, 5);
    double D = 0, M = 0;
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) {
        D += have.D[I][J];
        M += have.M[I][J];
        EXPECT_EQ(have.D[I][J], have.D[J][I]);
      }
    const double area = overlap_of(secondary, primary).area;
    ASSERT_NEAR(D, area, 1e-14);
    ASSERT_NEAR(M, area, 1e-14);
  }
}

TEST(MortarIntegrals, VanishWithoutNansWhereFacetsOnlyTouch) {  // case A6
  const Quad<double> unit{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const auto [dx, dy] : {Vec2<double>{1, 0}, {1, 1}, {0, -1}, {1, 0.5}, {2, 2}}) {
    Quad<double> other = unit;
    for (auto& p : other) p = {p.x + dx, p.y + dy};
    const auto have = integrals_of(unit, other, 5);
    for (int k = 0; k < 16; ++k) {
      EXPECT_EQ(have.D[k / 4][k % 4], 0);
      EXPECT_EQ(have.M[k / 4][k % 4], 0);
    }
  }
  for (double width = 1e-6; width > 1e-17; width /= 10) {  // a strip: small, never harmful
    Quad<double> other = unit;
    for (auto& p : other) p.x += 1 - width;
    const auto have = integrals_of(unit, other, 5);
    double sum = 0;
    for (int k = 0; k < 16; ++k) sum += have.M[k / 4][k % 4];
    EXPECT_NEAR(sum, width, 4e-16);
  }
}

/// Matching meshes whose nodes are off by a little meet in slivers of round-off as well, which must not spoil D and M; and their
/// crossings lie anywhere along an edge, which only the error of the quadrature may notice.
TEST(MortarIntegrals, HardlyChangeWhenMatchingNodesAreSlightlyOff) {
  const auto row_of_facet = [](double noise, unsigned seed,
                               int degree) {  // D and M of the middle facet of 3 x 3 with all 9 others
    Random random(seed), shape(7);
    auto mesh = square(3, 0, 3);
    for (auto& p : mesh.x) p = p + shape.vector(0.06);
    auto primary = mesh;
    for (auto& p : primary.x) p = p + random.vector(noise);
    const auto quad = [](const FlatMesh& of, int facet) {
      Quad<double> q;
      for (int a = 0; a < 4; ++a) q[a] = {of.x[of.facets[facet][a]][0], of.x[of.facets[facet][a]][1]};
      return q;
    };
    std::vector<double> row(32, 0.0);
    for (int f = 0; f < 9; ++f) {
      const auto share = integrals_of(quad(mesh, 4), quad(primary, f), degree);
      for (int k = 0; k < 16; ++k) {
        row[k] += share.D[k / 4][k % 4];
        if (f == 4) row[16 + k] = share.M[k / 4][k % 4];
      }
    }
    return row;
  };
  for (const auto& [degree, quadrature] : {std::pair<int, double>{5, 1e-8}, {8, 1e-14}}) {
    const auto exact = row_of_facet(0, 1, degree);
    double worst = 0;
    for (double noise = 1e-17; noise < 1e-5; noise *= 10)
      for (unsigned seed = 1; seed <= 50; ++seed) {
        const auto row = row_of_facet(noise, seed, degree);
        for (std::size_t k = 0; k < 32; ++k) worst = std::max(worst, std::abs(row[k] - exact[k]) - 2 * noise);
      }
    EXPECT_LE(worst, quadrature) << "degree " << degree;
    RecordProperty("change_at_degree_" + std::to_string(degree), std::to_string(worst * 1e15) + "e-15");
  }
}

/// Whole interfaces of 60 x 60 with n x n secondary and m x m primary facets, against rational arithmetic.
TEST(MortarIntegrals, AssembleToTheExactMatricesOfNonConformingInterfaces) {
  if (!have_reference("mortar_matrices.json")) GTEST_SKIP() << no_reference("mortar_matrices.json");
  const auto matrices = reference("mortar_matrices.json");
  for (const auto [n, m] : {std::array<int, 2>{3, 4}, {4, 3}, {2, 3}}) {
    const auto square_of = [](int k) { return std::to_string(k) + "x" + std::to_string(k); };
    const auto& expected = matrices.at("interface_" + square_of(n) + "_slave_vs_" + square_of(m) + "_master_60x60");
    const auto secondary = square(n, 0, 60), primary = upside_down(square(m, 0, 60));
    const std::size_t rows = secondary.x.size(), columns = primary.x.size();
    std::vector<std::vector<double>> D(rows, std::vector<double>(rows, 0.0)), M(rows, std::vector<double>(columns, 0.0));
    for (const auto& s : secondary.facets)
      for (const auto& p : primary.facets) {
        Quad<double> both[2];
        for (int a = 0; a < 4; ++a) {
          both[0][a] = {secondary.x[s[a]][0], secondary.x[s[a]][1]};
          both[1][a] = {primary.x[p[a]][0], primary.x[p[a]][1]};
        }
        const auto share = integrals_of(both[0], both[1], 4);
        for (int I = 0; I < 4; ++I)
          for (int J = 0; J < 4; ++J) {
            D[s[I]][s[J]] += share.D[I][J];
            M[s[I]][p[J]] += share.M[I][J];
          }
      }
    ASSERT_EQ(expected["D"].size(), rows);
    ASSERT_EQ(expected["M"][0].size(), columns);
    const double largest = 3600.0 / n / n;  // area of a facet
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < rows; ++c) EXPECT_NEAR(D[r][c], expected["D"][r][c].get<double>(), 1e-13 * largest);
      for (std::size_t c = 0; c < columns; ++c) EXPECT_NEAR(M[r][c], expected["M"][r][c].get<double>(), 1e-13 * largest);
    }
  }
}

}  // namespace
}  // namespace mortise::test
