// A million pairs of facets: no area is lost or found between the primary facets that cover a secondary one, in whatever
// position.
#include <gtest/gtest.h>

#include <iostream>

#include "contact/mortar/planar.hpp"
#include "support/exact_area.hpp"
#include "support/facets.hpp"

namespace mortise::test {
namespace {

constexpr int n = 4;  // primary facets in a row; 16 pairs a trial
using Nodes = std::array<std::array<Vec2<double>, n + 1>, n + 1>;

/// A secondary facet, and primary facets that cover it.
struct Covered {
  Quad<double> secondary;
  Nodes primary;
  Quad<double> facet(int i, int j) const { return {primary[i][j], primary[i + 1][j], primary[i + 1][j + 1], primary[i][j + 1]}; }
};

/// Nodes inside are moved by up to `shaken` edges: convex facets up to 0.24.
Nodes grid(Random& random, double low, double size, double shaken) {
  Nodes nodes;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const bool is_inside = i > 0 && j > 0 && i < n && j < n;
      const double move = is_inside ? shaken * size / n : 0;
      nodes[i][j] = {low + size * i / n + random.in(-move, move), low + size * j / n + random.in(-move, move)};
    }
  return nodes;
}

template <class Function>
void for_each_node(Covered& c, Function f) {
  for (auto& p : c.secondary) f(p);
  for (auto& row : c.primary)
    for (auto& p : row) f(p);
}

enum Family { random_quads, conforming, slightly_off, nested, with_slivers, reflex, shifted, needles, n_families };
const char* const names[] = {"random",           "conforming (A1)", "slightly off (A2)", "nested (A3)",
                             "slivers (A4, A6)", "reflex (A5)",     "shifted",           "needles"};

Covered covered(Family family, Random& random) {
  Covered c{random_quad(random, random.in(-0.3, 0.3), random.in(-0.3, 0.3), random.in(0.3, 1), 0.2),
            grid(random, random.in(-1.5, -1.4), random.in(2.9, 3.2), 0.24)};
  const auto corner = [&](int i, int j) { return c.primary[1 + i][1 + j]; };
  const auto inner_facet = [&] { return Quad<double>{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}; };
  switch (family) {
    case conforming:
    case slightly_off:
      c.secondary = inner_facet();
      if (family == slightly_off) {
        const double off = std::pow(10, random.in(-17, -6));
        for (auto& row : c.primary)
          for (auto& p : row) p = {p.x + random.in(-off, off), p.y + random.in(-off, off)};
      }
      break;
    case nested: {  // corners on nodes and on edges
      c.primary = grid(random, -1, 2, 0);
      const double x = 0.25 * std::floor(random.in(-4, 1)), y = 0.25 * std::floor(random.in(-4, 1));
      const double w = 0.25 * std::floor(random.in(1, 5)), l = 0.25 * std::floor(random.in(1, 5));
      c.secondary = {{{x, y}, {x + w, y}, {x + w, y + l}, {x, y + l}}};
      break;
    }
    case with_slivers: {  // edges next to the lines of the grid
      c.primary = grid(random, -1, 2, 0);
      const double off = std::pow(10, random.in(-16, -3));
      c.secondary = {{{-0.5 - off, -0.5 + off}, {0.5 + off, -0.5 - off}, {0.5 - off, 0.5 + off}, {-0.5 + off, 0.5 - off}}};
      break;
    }
    case reflex: {
      auto& node = c.primary[2][2];  // beyond the diagonal of one facet, by 0.2 to 0.4 edges
      const double size = (c.primary[n][0].x - c.primary[0][0].x) / n;
      c.primary = grid(random, c.primary[0][0].x, n * size, 0);
      node = {node.x + random.in(0.7, 0.9) * size, node.y + random.in(0.7, 0.9) * size};
      break;
    }
    case needles: {
      const double thin = std::pow(10, random.in(-6, -1));
      for (auto& p : c.secondary) p.y *= thin;
      break;
    }
    default:
      break;
  }
  const double angle = random.in(0, 6.283), cosine = std::cos(angle), sine = std::sin(angle);
  const bool is_turned = family != nested && random.in(0, 1) < 0.5;
  const double shift = family == shifted ? 700 : 0;
  for_each_node(c, [&](Vec2<double>& p) {
    if (is_turned) p = {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
    p = {p.x + shift, p.y - shift};
  });
  return c;
}

/// Greatest coordinate, and the least width of the secondary facet (area over diameter).
std::pair<double, double> extent_and_width(Covered& c, double area) {
  double extent = 0, diameter = 0;
  for_each_node(c, [&](const Vec2<double>& p) { extent = std::max({extent, std::abs(p.x), std::abs(p.y)}); });
  for (const auto& p : c.secondary)
    for (const auto& q : c.secondary) diameter = std::max(diameter, std::hypot(p.x - q.x, p.y - q.y));
  return {extent, area / diameter};
}

TEST(Closure, HoldsOverAMillionPairs) {
  Random random(6);
  constexpr int n_trials = 62500;
  double worst[n_families] = {}, worst_of_bound = 0;
  int n_pairs = 0, n_overlaps = 0;
  for (int trial = 0; trial < n_trials; ++trial) {
    const auto family = static_cast<Family>(trial % n_families);
    Covered c = covered(family, random);
    const double area = 0.5 * std::abs(twice_area(c.secondary));
    const auto [extent, width] = extent_and_width(c, area);
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Quad<double> primary = c.facet(i, j);
        const double overlap = overlap_of(c.secondary, primary).area, exchanged = overlap_of(primary, c.secondary).area;
        const double round_off = 32 * 0x1p-53 * extent * std::sqrt(area) / std::min(1.0, width);
        ASSERT_NEAR(overlap, exchanged, round_off) << names[family] << ", trial " << trial;
        ASSERT_GE(overlap, -round_off);
        ASSERT_LE(overlap, std::min(area, 0.5 * std::abs(twice_area(primary))) + round_off);
        sum += overlap;
        ++n_pairs;
        n_overlaps += overlap > 1e-14 * area;
      }
    const double missed = std::abs(sum - area) / area, bound = 2e-12 * (1 + extent / (100 * width));
    ASSERT_LE(missed, bound) << names[family] << ", trial " << trial;
    worst[family] = std::max(worst[family], missed);
    worst_of_bound = std::max(worst_of_bound, missed / bound);
  }
  EXPECT_EQ(n_pairs, 1000000);
  EXPECT_GT(n_overlaps, 200000);
  std::cout << n_pairs << " pairs, " << n_overlaps << " overlaps; greatest closure error";
  for (int family = 0; family < n_families; ++family) std::cout << ", " << names[family] << " " << worst[family];
  std::cout << "; at most " << worst_of_bound << " of what is allowed\n";
}

/// What the contact terms sum up are integrals: none of them leaves out a segment.
TEST(Closure, HoldsOfTheMortarIntegralsToo) {
  Random random(7);
  const auto rule = triangle_rule(5);
  for (int trial = 0; trial < 400; ++trial) {
    const auto family = static_cast<Family>(trial % n_families);
    Covered c = covered(family, random);
    const double area = 0.5 * std::abs(twice_area(c.secondary));
    const auto [extent, width] = extent_and_width(c, area);
    double of_D = 0, of_M = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Quad<double> primary = c.facet(i, j);
        double y[16];
        for (int a = 0; a < 4; ++a) {
          y[2 * a] = c.secondary[a].x;
          y[2 * a + 1] = c.secondary[a].y;
          y[8 + 2 * a] = primary[a].x;
          y[8 + 2 * a + 1] = primary[a].y;
        }
        const auto integrals = planar_integrals(y, rule);
        for (int I = 0; I < 4; ++I)
          for (int J = 0; J < 4; ++J) {
            of_D += integrals.D[I][J];
            of_M += integrals.M[I][J];
          }
      }
    const double bound = 2e-12 * (1 + extent / (100 * width));
    EXPECT_LE(std::abs(of_D - area) / area, bound) << names[family] << ", trial " << trial;
    EXPECT_LE(std::abs(of_M - area) / area, bound) << names[family] << ", trial " << trial;
  }
}

/// A convex quadrilateral, counter-clockwise, on the grid of integers from 0 to 31; three corners may be in line.
IntegerPolygon integer_quad(Random& random) {
  for (;;) {
    IntegerPolygon q;
    for (int k = 0; k < 4; ++k) q.push_back({static_cast<long>(random.in(0, 32)), static_cast<long>(random.in(0, 32))});
    bool is_convex = true;
    long twice = 0;
    for (int k = 0; k < 4; ++k) {
      is_convex = is_convex && cross(q[(k + 1) % 4] - q[k], q[(k + 2) % 4] - q[(k + 1) % 4]) >= 0;
      twice += cross(q[k], q[(k + 1) % 4]);
    }
    const bool is_crossed = cross(q[2] - q[0], q[3] - q[1]) != twice || twice <= 0;
    if (is_convex && !is_crossed) return q;
  }
}

Quad<double> quad_of(const IntegerPolygon& p) {
  Quad<double> q;
  for (int k = 0; k < 4; ++k) q[k] = {static_cast<double>(p[k][0]), static_cast<double>(p[k][1])};
  return q;
}

TEST(ExactOverlap, IsThatOfKnownCases) {
  const IntegerPolygon unit{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto moved = [&](long dx, long dy) {
    IntegerPolygon p = unit;
    for (auto& v : p) v = {v[0] + dx, v[1] + dy};
    return p;
  };
  EXPECT_TRUE(exact_overlap(unit, unit) == Rational(16));
  EXPECT_TRUE(exact_overlap(unit, moved(1, 2)) == Rational(6));
  for (const auto& [dx, dy] : {std::pair<long, long>{4, 0}, {4, 1}, {0, -4}, {4, 4}, {9, 0}})
    EXPECT_TRUE(exact_overlap(unit, moved(dx, dy)) == Rational(0)) << dx << ", " << dy;
  const IntegerPolygon diamond{{2, -1}, {5, 2}, {2, 5}, {-1, 2}}, triangle{{0, 0}, {3, 0}, {0, 1}, {0, 0}};
  EXPECT_TRUE(exact_overlap(unit, diamond) == Rational(14));
  EXPECT_TRUE(exact_overlap(diamond, unit) == Rational(14));
  EXPECT_TRUE(exact_overlap(triangle, IntegerPolygon{{1, -1}, {2, -1}, {2, 3}, {1, 3}}) == Rational(1, 2));
}

TEST(Clipping, HasTheExactRationalAreaOfPairsOnAGrid) {
  Random random(8);
  int n_empty = 0, n_touching = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const IntegerPolygon a = integer_quad(random);
    const IntegerPolygon b = trial % 10 == 0 ? a : integer_quad(random);  // the same facet is one of them
    const Rational exact = exact_overlap(a, b);
    ASSERT_TRUE(exact == exact_overlap(b, a)) << trial;
    const double round_off = 4 * 0x1p-53 * 31 * 31;
    ASSERT_NEAR(overlap_of(quad_of(a), quad_of(b)).area, static_cast<double>(exact), round_off) << trial;
    ASSERT_NEAR(overlap_of(quad_of(b), quad_of(a)).area, static_cast<double>(exact), round_off) << trial;
    n_empty += exact == Rational(0);
    n_touching += Rational(0) < exact && exact < Rational(1, 2);
  }
  EXPECT_GT(n_empty, 200);
  EXPECT_GT(n_touching, 200);
}

/// A nodal normal is nowhere divided by: where normals that lean by 30 degrees meet in one point nothing is singular (case A8).
TEST(AuxiliaryPlane, KnowsNoFocalPoint) {
  const double lean = std::sqrt(3) / 2;
  const std::array<Vec3<double>, 4> normals{{{0.5, 0, lean}, {-0.5, 0, lean}, {-0.5, 0, lean}, {0.5, 0, lean}}};
  for (const double height : {0.5, lean, 1.0, 2.0}) {  // the normals of a facet of length 1 meet in the height 0.866
    const std::array<Vec3<double>, 8> x{{{0, 0, 0},
                                         {1, 0, 0},
                                         {1, 1, 0},
                                         {0, 1, 0},
                                         {0.5, 0.5, height},
                                         {0.5, 1.5, height},
                                         {1.5, 1.5, height},
                                         {1.5, 0.5, height}}};
    const auto plane = AuxiliaryPlane::project(x, normals);
    const auto [secondary, primary] = quads(plane.y);
    EXPECT_NEAR(overlap_of(secondary, primary).area, 0.25, 1e-15) << height;
  }
}

}  // namespace
}  // namespace mortise::test
