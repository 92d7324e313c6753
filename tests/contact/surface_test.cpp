// Surfaces: neighbourhoods, nodal normals and the search.
#include "contact/surface.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "contact/bounding_volume.hpp"
#include "support/facets.hpp"
#include "support/gradient_check.hpp"

namespace mortise::test {
namespace {

/// n x n facets on a bumpy dome that bulges upwards.
FlatMesh dome(int n, Random& random) {
  auto mesh = square(n, -1, 2);
  for (auto& p : mesh.x) {
    p[2] = 0.6 - 0.5 * (p[0] * p[0] + p[1] * p[1]);
    p = p + random.vector(0.1 / n);
  }
  return mesh;
}

std::vector<Vec3<double>> positions(const FlatMesh& mesh, const NodePatch& patch) {
  std::vector<Vec3<double>> x;
  for (int node : patch.nodes) x.push_back(mesh.x[node]);
  return x;
}

std::vector<double> flat(const std::vector<Vec3<double>>& x) {
  std::vector<double> all;
  for (const auto& p : x) all.insert(all.end(), {p[0], p[1], p[2]});
  return all;
}

std::vector<Vec3<double>> points(const std::vector<double>& all) {
  std::vector<Vec3<double>> x(all.size() / 3);
  for (std::size_t k = 0; k < all.size(); ++k) x[k / 3][k % 3] = all[k];
  return x;
}

TEST(ContactSurface, KnowsItsNodesOnceEach) {
  const ContactSurface surface{{{7, 3, 5, 9}, {3, 1, 2, 5}}};
  EXPECT_EQ(surface.nodes(), (std::vector<int>{1, 2, 3, 5, 7, 9}));
}

TEST(ContactSurface, HasPatchesOfTheFacetsRoundEachNode) {
  const auto mesh = square(3);
  const ContactSurface surface{mesh.facets};
  const auto patches = surface.patches();
  ASSERT_EQ(patches.size(), 16U);
  for (std::size_t k = 0; k < 16; ++k) {
    const int on_edges = (k % 4 == 0 || k % 4 == 3) + (k / 4 == 0 || k / 4 == 3);
    const std::size_t n_facets = on_edges == 0 ? 4 : on_edges == 1 ? 2 : 1;
    EXPECT_EQ(patches[k].corners.size(), n_facets);
    EXPECT_EQ(patches[k].nodes.front(), static_cast<int>(k));
    EXPECT_EQ(patches[k].nodes.size(), n_facets == 4 ? 5U : n_facets == 2 ? 4U : 3U);  // the node and its neighbours along edges
    EXPECT_EQ(std::set<int>(patches[k].nodes.begin(), patches[k].nodes.end()).size(), patches[k].nodes.size());
    for (const auto& corner : patches[k].corners) {
      std::array<int, 3> seen{patches[k].nodes[0], patches[k].nodes[corner[0]], patches[k].nodes[corner[1]]};
      const bool found = std::any_of(mesh.facets.begin(), mesh.facets.end(), [&](const std::array<int, 4>& facet) {
        for (int a = 0; a < 4; ++a)
          if (facet[a] == seen[0] && facet[(a + 1) % 4] == seen[1] && facet[(a + 3) % 4] == seen[2]) return true;
        return false;
      });
      EXPECT_TRUE(found);
    }
  }
}

TEST(NodalNormals, AreUnitVectorsThatPointOutwards) {
  Random random(1);
  const auto mesh = dome(5, random);
  for (const auto& patch : ContactSurface{mesh.facets}.patches()) {
    const auto n = nodal_normal(patch, positions(mesh, patch));
    EXPECT_NEAR(norm(n), 1, 1e-15);
    EXPECT_GT(dot(n, mesh.x[patch.nodes[0]] - Vec3<double>{0, 0, -2}), 0.5);
  }
}

TEST(NodalNormals, AreThoseOfThePlaneOnAPlane) {
  Random random(2);
  auto mesh = square(4);
  shake_inside(mesh, 0.07, random);
  const auto Q = random.rotation();
  place(mesh, Q, {5, -3, 2});
  const auto expected = rotate(Q, {0, 0, 1});
  for (const auto& patch : ContactSurface{mesh.facets}.patches())
    EXPECT_LE(norm(nodal_normal(patch, positions(mesh, patch)) - expected), 1e-14);
}

TEST(NodalNormals, TurnWithTheSurfaceAndIgnoreTranslation) {
  Random random(3);
  const auto mesh = dome(4, random);
  const auto Q = random.rotation();
  auto moved = mesh;
  place(moved, Q, {3, -1, 2});
  for (const auto& patch : ContactSurface{mesh.facets}.patches()) {
    const auto expected = rotate(Q, nodal_normal(patch, positions(mesh, patch)));
    EXPECT_LE(norm(nodal_normal(patch, positions(moved, patch)) - expected), 1e-13);
  }
}

TEST(NodalNormals, DoNotDependOnTheSizeOfTheFacets) {  // a mean of unit normals
  std::vector<Vec3<double>> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const NodePatch patch{{0, 1, 2, 3}, {{1, 2}, {2, 3}}};
  const auto n = nodal_normal(patch, x);
  x[3] = {0, 0, 100};
  EXPECT_LE(norm(nodal_normal(patch, x) - n), 1e-15);
  EXPECT_LE(norm(n - Vec3<double>{std::sqrt(0.5), 0, std::sqrt(0.5)}), 1e-15);
}

TEST(NodalNormals, HaveAPullBackThatIsTheTransposedDerivative) {
  Random random(4);
  const auto mesh = dome(3, random);
  for (const auto& patch : ContactSurface{mesh.facets}.patches()) {
    const auto x = positions(mesh, patch);
    std::vector<double> jacobian;
    std::vector<Vec3<double>> row;
    for (int i = 0; i < 3; ++i) {
      Vec3<double> axis{};
      axis[i] = 1;
      normal_pull_back(patch, x, axis, row);
      const auto entries = flat(row);
      jacobian.insert(jacobian.end(), entries.begin(), entries.end());
    }
    const auto normal = [&patch](const std::vector<double>& at) {
      const auto n = nodal_normal(patch, points(at));
      return std::vector<double>{n[0], n[1], n[2]};
    };
    EXPECT_TRUE(is_derivative(jacobian, normal, flat(x)));
  }
}

TEST(NodalNormals, HaveAPullBackThatCarriesTheMomentOfTheLoad) {  // sum x_a x f_a = n x b, and no resultant
  Random random(5);
  const auto mesh = dome(3, random);
  for (const auto& patch : ContactSurface{mesh.facets}.patches()) {
    const auto x = positions(mesh, patch);
    const auto b = random.vector(1);
    std::vector<Vec3<double>> f;
    normal_pull_back(patch, x, b, f);
    Vec3<double> force{}, moment = cross(b, nodal_normal(patch, x));
    for (std::size_t a = 0; a < f.size(); ++a) {
      force = force + f[a];
      moment = moment + cross(x[a], f[a]);
    }
    EXPECT_LE(norm(force), 1e-14);
    EXPECT_LE(norm(moment), 1e-14);
  }
}

TEST(BoxTree, FindsWhatBruteForceFinds) {
  Random random(6);
  for (int n : {0, 1, 3, 4, 5, 50, 500}) {
    std::vector<Box> boxes(n);
    for (auto& box : boxes) {
      const auto middle = random.vector(1);
      box.include(middle);
      box.include(middle + random.vector(0.1));
    }
    if (n > 10) boxes[3] = boxes[7] = boxes[8];  // coincident ones
    const BoxTree tree(boxes);
    for (int trial = 0; trial < 100; ++trial) {
      Box query;
      query.include(random.vector(1));
      query.widen(random.in(0, 0.3));
      if (trial == 0 && n > 10) query = boxes[3];
      std::vector<int> expected;
      for (int k = 0; k < n; ++k)
        if (boxes[k].overlaps(query)) expected.push_back(k);
      EXPECT_EQ(tree.query(query), expected);
    }
  }
}

TEST(BoxTree, FindsBoxesThatOnlyTouch) {
  Box left, right;
  left.include(Vec3<double>{0, 0, 0});
  left.include(Vec3<double>{1, 1, 1});
  right.include(Vec3<double>{1, 1, 1});
  right.include(Vec3<double>{2, 2, 2});
  EXPECT_EQ(BoxTree({left}).query(right), std::vector<int>{0});
  right.widen(-1e-9);
  EXPECT_TRUE(BoxTree({left}).query(right).empty());
}

}  // namespace
}  // namespace mortise::test
