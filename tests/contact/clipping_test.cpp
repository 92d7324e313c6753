// Overlaps of facets: exact areas, no area lost or found between neighbours, and no harm in degenerate positions.
#include <gtest/gtest.h>

#include <functional>

#include "support/facets.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

struct Closure {
  double facet = 0;    ///< greatest |sum of overlaps - facet| / facet
  double total = 0;    ///< total area covered
  int n_segments = 0;  ///< overlaps with more than round-off of area
};

/// Clips every secondary facet with every primary facet, as the mortar term does: in the auxiliary plane.
Closure closure(const FlatMesh& secondary, const FlatMesh& primary, const Vec3<double>& normal) {
  Closure result;
  for (std::size_t s = 0; s < secondary.facets.size(); ++s) {
    double covered = 0, whole = 0;
    for (std::size_t p = 0; p < primary.facets.size(); ++p) {
      const auto plane = AuxiliaryPlane::project(pair_nodes(secondary, s, primary, p), {normal, normal, normal, normal});
      const auto [subject, clip] = quads(plane.y);
      const double area = overlap_of(subject, clip).area;
      whole = 0.5 * std::abs(twice_area(subject));
      covered += area;
      result.n_segments += area > 1e-12 * whole;
    }
    result.facet = std::max(result.facet, std::abs(covered - whole) / whole);
    result.total += covered;
  }
  return result;
}

const Vec3<double> up{0, 0, 1};

/// The bound of the conventions: round-off, and the digits that a shift costs.
double bound(double shift, double h) { return 2e-12 * (1 + shift / (100 * h)); }

TEST(Clipping, HasTheExactAreaOfTheReferenceOverlaps) {
  if (!have_reference("overlap_cases.json")) GTEST_SKIP() << no_reference("overlap_cases.json");
  const auto cases = reference("overlap_cases.json");
  EXPECT_EQ(cases.size(), 34U);
  for (const auto& one : cases) {
    Quad<double> both[2];
    double extent = 0;
    for (int a = 0; a < 4; ++a)
      for (int side = 0; side < 2; ++side) {
        const auto& corner = one[side == 0 ? "slave_f" : "master_f"][a];
        both[side][a] = {corner[0], corner[1]};
        extent = std::max({extent, std::abs(both[side][a].x), std::abs(both[side][a].y)});
      }
    const double exact = one["area_of_double_rounded_coordinates"];
    const double round_off = 4 * 0x1p-53 * extent * extent;  // vertices are rounded to the last digit of the coordinates
    EXPECT_NEAR(overlap_of(both[0], both[1]).area, exact, round_off) << one["name"];
    EXPECT_NEAR(overlap_of(both[1], both[0]).area, exact, round_off) << one["name"] << ", exchanged";
  }
}

TEST(Clipping, LosesNothingBetweenConformingMeshes) {  // case A1
  const auto secondary = square(6), primary = upside_down(square(6));
  const auto result = closure(secondary, primary, up);
  EXPECT_EQ(result.n_segments, 36);
  EXPECT_LE(result.facet, 1e-15);
  EXPECT_NEAR(result.total, 1, 1e-15);
}

TEST(Clipping, LosesNothingFarFromTheOriginAndTurned) {  // case A1, shifted by 700
  Random random(1);
  for (int trial = 0; trial < 5; ++trial) {
    auto secondary = square(6), primary = upside_down(square(6));
    const auto Q = random.rotation();
    place(secondary, Q, {700, 700, 700});
    place(primary, Q, {700, 700, 700});
    const auto result = closure(secondary, primary, rotate(Q, up));
    EXPECT_EQ(result.n_segments, 36);
    EXPECT_LE(result.facet, 1e-12 * (1 + 700 * 6 / 100.0));
  }
}

TEST(Clipping, LosesNothingWhenMatchingNodesAreSlightlyOff) {  // case A2
  const double h = 1.0 / 6;
  for (double noise = 1e-17; noise < 1e-5; noise *= 10)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      Random random(seed);
      const auto secondary = square(6);
      auto primary = upside_down(square(6));
      shake_inside(primary, noise, random);
      const auto result = closure(secondary, primary, up);
      EXPECT_LE(result.facet, bound(0, h)) << "noise " << noise;
      EXPECT_NEAR(result.total, 1, 1e-15 + 10 * noise);
      const auto exchanged = closure(primary, secondary, up);
      EXPECT_LE(exchanged.facet, bound(0, h)) << "noise " << noise;
    }
}

TEST(Clipping, LosesNothingOnNestedMeshes) {  // case A3: nodes exactly on nodes and on edges
  for (const double shift : {0.0, 700.0}) {
    auto fine = square(8), coarse = square(4);
    place(fine, identity<double>(), {shift, shift, 0});
    place(coarse, identity<double>(), {shift, shift, 0});
    for (const auto& result : {closure(fine, upside_down(coarse), up), closure(coarse, upside_down(fine), up)}) {
      EXPECT_LE(result.facet, bound(shift, 1.0 / 8));
      EXPECT_EQ(result.n_segments, 64);
    }
  }
}

TEST(Clipping, LosesNothingOnRandomMeshes) {  // case A4, nothing dropped
  double worst = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    auto secondary = square(5), primary = upside_down(square(7, -0.25, 1.5));
    shake_inside(secondary, 0.3 / 5, random);
    shake_inside(primary, 0.3 * 1.5 / 7, random);
    const double shift = seed % 4 == 0 ? 700 : 0;
    const auto Q = random.rotation();
    place(secondary, Q, {shift, 0, shift});
    place(primary, Q, {shift, 0, shift});
    const auto result = closure(secondary, primary, rotate(Q, up));
    EXPECT_LE(result.facet, bound(1.5 * shift, 0.2));
    if (shift == 0) worst = std::max(worst, result.facet);
  }
  RecordProperty("greatest_closure_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(Clipping, SplitsFacetsWithAReflexCorner) {  // case A5
  const int n = 6;
  const double h = 1.0 / n;
  for (int corner = 0; corner < 4; ++corner) {
    auto with_reflex = square(n, -0.1, 1.2);
    const double H = 1.2 / n, sx = corner % 2 ? 1 : -1, sy = corner / 2 ? 1 : -1;
    auto& node = with_reflex.x[3 * (n + 1) + 3];
    node[0] += 0.8 * sx * H;  // beyond the diagonal of the facet there, by 0.3 edges
    node[1] += 0.8 * sy * H;
    int n_reflex = 0;
    for (const auto& facet : with_reflex.facets) {
      Quad<double> q;
      for (int a = 0; a < 4; ++a) q[a] = {with_reflex.x[facet[a]][0], with_reflex.x[facet[a]][1]};
      std::array<Polygon<double>, 2> pieces;
      const int n_pieces = convex_pieces(q, pieces);
      double area = 0;
      for (int k = 0; k < n_pieces; ++k) area += area_of(pieces[k]);
      EXPECT_NEAR(area, 0.5 * twice_area(q), 1e-16);
      n_reflex += n_pieces == 2;
    }
    EXPECT_EQ(n_reflex, 1);
    EXPECT_LE(closure(square(n), upside_down(with_reflex), up).facet, bound(0, h));
    auto secondary = with_reflex;
    EXPECT_LE(closure(secondary, upside_down(square(7, -0.2, 1.4)), up).facet, bound(0, h));
  }
}

TEST(Clipping, HasNoPiecesOfCrossedAndFlatFacets) {
  std::array<Polygon<double>, 2> pieces;
  EXPECT_EQ(convex_pieces(Quad<double>{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, pieces), 0);
  EXPECT_EQ(convex_pieces(Quad<double>{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}, pieces), 0);
  EXPECT_EQ(convex_pieces(Quad<double>{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, pieces), 0);
}

TEST(Clipping, GivesNoAreaWhereFacetsOnlyTouch) {  // case A6
  const Quad<double> unit{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const auto moved = [&](double dx, double dy) {
    auto q = unit;
    for (auto& p : q) p = {p.x + dx, p.y + dy};
    return q;
  };
  EXPECT_EQ(overlap_of(unit, moved(3, 0)).area, 0);
  EXPECT_EQ(overlap_of(unit, moved(1, 0)).area, 0);
  EXPECT_EQ(overlap_of(unit, moved(1, 0.5)).area, 0);
  EXPECT_EQ(overlap_of(unit, moved(1, 1)).area, 0);
  EXPECT_EQ(overlap_of(unit, moved(-1, 1)).area, 0);
  EXPECT_NEAR(overlap_of(unit, moved(1 - 1e-9, 0)).area, 1e-9, 4e-16);
}

TEST(Clipping, NeverNeedsMoreVerticesThanAPolygonHolds) {  // Polygon::add asserts
  Random random(3);
  int most = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    auto subject = random_quad(random, 0, 0, 1, 0.2);
    auto clip = random_quad(random, random.in(-1, 1), random.in(-1, 1), random.in(0.5, 2), 0.2);
    if (trial % 2 == 0)  // on a grid of quarters: corners on corners and on edges, edges on edges, triangles and needles
      for (auto* q : {&subject, &clip})
        for (auto& p : *q) p = {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4};
    if (trial % 4 == 1) {  // nearly the same facet
      clip = subject;
      for (auto& p : clip) p = {p.x + random.in(-1e-15, 1e-15), p.y + random.in(-1e-15, 1e-15)};
    }
    const auto overlap = overlap_of(subject, clip);
    most = std::max(most, overlap.most_vertices);
    const double smaller = 0.5 * std::min(std::abs(twice_area(subject)), std::abs(twice_area(clip)));
    ASSERT_TRUE(overlap.area >= -1e-15 && overlap.area <= smaller + 1e-14) << "trial " << trial;
  }
  EXPECT_GE(most, 8);
  RecordProperty("most_vertices", most);
}

}  // namespace
}  // namespace mortise::test
