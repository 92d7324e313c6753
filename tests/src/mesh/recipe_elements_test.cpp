// Every recipe in every type of element: whole, right way round, as large as its formula says, the same file each time.
#include <algorithm>
#include <set>

#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/convert.hpp"
#include "physics/elements/geometry.hpp"
#include "physics/traction.hpp"
#include "recipe_cases.hpp"
#include "scratch.hpp"
#include "support/text.hpp"

namespace mortise {
namespace {

/// The example of a recipe, its elements as `type`.
template <class Case>
Mesh example(int times, ElementType type) {
  return recipes::with_elements(recipes::make(Case::data(times)), type);
}

int parts_of_a_brick(ElementType type) {
  if (type == ElementType::wedge6) return 2;
  return type == ElementType::tet4 || type == ElementType::tet10 ? 6 : 1;
}

// ---- measures that know any element -----------------------------------------------------------------------------------

/// Volume of element `e` by its stiffness rule, and the least det dX/dxi of the rule's points and of its nodes.
std::pair<double, double> volume_and_least_jacobian(const Mesh& mesh, int e) {
  return with_element(element_type(mesh, e), [&](auto element) {
    using Element = decltype(element);
    ElementNodes<Element> X;
    for (std::size_t a = 0; a < X.size(); ++a) X[a] = at(mesh, element_nodes(mesh, e)[a]);
    double volume = 0, least = INFINITY;
    for (const auto& point : Element::stiffness_rule) {
      const double J = det(element_map<Element>(X, point.xi));
      volume += point.weight * J;
      least = std::min(least, J);
    }
    for (int a = 0; a < Element::n_nodes; ++a)
      least = std::min(least, det(element_map<Element>(X, {Element::node[a][0], Element::node[a][1], Element::node[a][2]})));
    return std::pair{volume, least};
  });
}

/// Area of a side, and its area vector.
std::pair<double, Point> area_of(const Mesh& mesh, const Side& side) {
  const auto nodes = side_nodes(mesh, side);
  return with_side(static_cast<int>(nodes.size()), [&](auto kind) {
    using Kind = decltype(kind);
    std::array<Point, Kind::n_nodes> X;
    for (std::size_t a = 0; a < X.size(); ++a) X[a] = at(mesh, nodes[a]);
    double area = 0;
    Point vector{0, 0, 0};
    for (const auto& point : Kind::rule) {
      const auto [along, across] = side_tangents<Kind>(X, point.xi);
      const auto normal = cross(along, across);
      area += point.weight * std::sqrt(dot(normal, normal));
      for (int i = 0; i < 3; ++i) vector[i] += point.weight * normal[i];
    }
    return std::pair{area, vector};
  });
}

std::vector<int> sorted_corners(const Mesh& mesh, const Side& side) {
  auto nodes = side_nodes(mesh, side);
  nodes.resize(n_side_corners(mesh, side));
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

// ---- the suite --------------------------------------------------------------------------------------------------------

template <class Case>
class EveryRecipeInEveryElement : public testing::Test {};
TYPED_TEST_SUITE(EveryRecipeInEveryElement, Recipes);

TYPED_TEST(EveryRecipeInEveryElement, PassesTheChecksAndIsNowhereInverted) {
  for (int times : {1, 2}) {
    const int n_bricks = n_elements(recipes::make(TypeParam::data(times)));
    for (ElementType type : element_types) {
      const Mesh mesh = example<TypeParam>(times, type);
      EXPECT_NO_THROW(check_mesh(mesh)) << topology(type).name;
      ASSERT_EQ(mesh.blocks.size(), 1U);
      EXPECT_EQ(mesh.blocks[0].elements.type(), type);
      EXPECT_EQ(n_elements(mesh), n_bricks * parts_of_a_brick(type));
      for (int e = 0; e < n_elements(mesh); ++e)
        ASSERT_GT(volume_and_least_jacobian(mesh, e).second, 0) << topology(type).name << ", element " << e;
    }
  }
}

/// Volume, and area of each side.
std::map<std::string, double> sizes(const Mesh& mesh) {
  std::map<std::string, double> sizes;
  for (int e = 0; e < n_elements(mesh); ++e) sizes["volume"] += volume_and_least_jacobian(mesh, e).first;
  for (const SideSet& set : mesh.side_sets)
    for (const Side& side : set.sides) sizes[set.name] += area_of(mesh, side).first;
  return sizes;
}

TYPED_TEST(EveryRecipeInEveryElement, HasAVolumeAndAreasOfSidesThatConvergeWithOrder2) {
  for (ElementType type : {ElementType::tet4, ElementType::wedge6}) {
    std::map<std::string, std::array<double, 3>> found;
    for (std::size_t i = 0; i < 3; ++i)
      for (const auto& [name, size] : sizes(example<TypeParam>(2 << i, type))) found[name][i] = size;
    auto exact = TypeParam::areas();
    exact["volume"] = TypeParam::volume();
    ASSERT_EQ(found.size(), exact.size());
    for (const auto& [name, size] : exact) expect_order_2(found[name], size, topology(type).name + " " + name);
  }
}

// Straight edges make no other shape; a curved side of a brick has a root in its area, which two rules see differently.
TYPED_TEST(EveryRecipeInEveryElement, IsAsLargeWithNodesOnItsEdgesAsWithout) {
  for (const auto& [linear, quadratic] : {std::pair{ElementType::hex8, ElementType::hex20},
                                          {ElementType::hex8, ElementType::hex27},
                                          {ElementType::tet4, ElementType::tet10}}) {
    const auto coarse = sizes(example<TypeParam>(2, linear)), found = sizes(example<TypeParam>(2, quadratic));
    for (const auto& [name, size] : found)
      EXPECT_NEAR(size, coarse.at(name), (name == "volume" ? 1e-12 : 1e-4) * size) << topology(quadratic).name << " " << name;
  }
}

TYPED_TEST(EveryRecipeInEveryElement, FitsTogetherAndHasItsBoundaryInOneSideEach) {
  for (ElementType type : element_types) {
    const Mesh mesh = example<TypeParam>(2, type);
    std::map<std::vector<int>, int> elements_at, sets_at;
    for (int e = 0; e < n_elements(mesh); ++e)
      for (int face = 0; face < static_cast<int>(topology(type).faces.size()); ++face)
        ++elements_at[sorted_corners(mesh, {e, face})];
    Point total{};
    double sum = 0;
    for (const SideSet& set : mesh.side_sets)
      for (const Side& side : set.sides) {
        ++sets_at[sorted_corners(mesh, side)];
        const auto [area, vector] = area_of(mesh, side);
        sum += area;
        for (std::size_t i = 0; i < 3; ++i) total[i] += vector[i];
      }
    for (const auto& [facet, n] : elements_at) {
      ASSERT_LE(n, 2) << topology(type).name;
      ASSERT_EQ(sets_at.count(facet) > 0 ? sets_at[facet] : 0, n == 1 ? 1 : 0) << topology(type).name;
    }
    EXPECT_LT(norm(total), 1e-13 * sum) << "not a closed surface of " << topology(type).name;
  }
}

TYPED_TEST(EveryRecipeInEveryElement, HasNodeSetsOfItsSides) {
  for (ElementType type : element_types) {
    const Mesh mesh = example<TypeParam>(2, type);
    ASSERT_EQ(mesh.node_sets.size(), mesh.side_sets.size());
    for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
      std::set<int> nodes;
      for (const Side& side : mesh.side_sets[s].sides)
        for (int a : side_nodes(mesh, side)) nodes.insert(a);
      EXPECT_EQ(mesh.node_sets[s].name, mesh.side_sets[s].name);
      EXPECT_EQ(mesh.node_sets[s].nodes, std::vector<int>(nodes.begin(), nodes.end())) << topology(type).name;
    }
  }
}

TYPED_TEST(EveryRecipeInEveryElement, HasNoNodeTwiceInOnePlace) {
  for (ElementType type : element_types) {
    const Mesh mesh = example<TypeParam>(2, type);
    double size = 0;
    for (const Point& x : mesh.coordinates) size = std::max(size, norm(x));
    std::vector<Point> points = mesh.coordinates;
    std::sort(points.begin(), points.end());
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = a + 1; b < points.size() && points[b][0] - points[a][0] < 1e-3 * size; ++b) {
        const Point &x = points[a], &y = points[b];
        ASSERT_GT(norm({x[0] - y[0], x[1] - y[1], x[2] - y[2]}), 1e-3 * size) << topology(type).name;
      }
  }
}

TYPED_TEST(EveryRecipeInEveryElement, HasTheMiddleOfEachEdgeWhereAnElementHasANodeThere) {
  for (ElementType type : {ElementType::hex20, ElementType::hex27, ElementType::tet10}) {
    const Mesh mesh = example<TypeParam>(1, type);
    const Topology& shape = topology(type);
    for (const auto& face : shape.faces) {  // corners round the face, then the nodes between them
      const std::size_t n = type == ElementType::tet10 ? 3 : 4;
      for (std::size_t k = 0; k < n; ++k)
        for (const auto& element : mesh.blocks[0].elements) {
          const auto node = [&](std::size_t of_face) { return at(mesh, element[static_cast<std::size_t>(face[of_face])]); };
          const Point from = node(k), to = node((k + 1) % n), middle = node(n + k);
          for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(middle[i], (from[i] + to[i]) / 2) << shape.name;
        }
    }
  }
}

TYPED_TEST(EveryRecipeInEveryElement, IsTheSameFileEachTimeAndReadsBack) {
  const ScratchFolder folder;
  for (ElementType type : element_types) {
    const Mesh mesh = example<TypeParam>(1, type);
    write_exodus(mesh, folder / "one.e", "title");
    write_exodus(example<TypeParam>(1, type), folder / "two.e", "title");
    const std::string one = test::text_of(folder / "one.e");
    EXPECT_GT(one.size(), 1000U);
    EXPECT_TRUE(one == test::text_of(folder / "two.e")) << topology(type).name;
    const Mesh read = read_exodus(folder / "one.e");
    EXPECT_TRUE(read.blocks[0].elements == mesh.blocks[0].elements) << topology(type).name;
    EXPECT_EQ(read.coordinates, mesh.coordinates) << topology(type).name;
    std::filesystem::remove(folder / "one.e");
    std::filesystem::remove(folder / "two.e");
  }
}

// Sums of two are the same either way round; the middles of faces and bricks are sums of four and eight.
TEST(RoundRecipesInEveryElement, AreSymmetricToTheLastBitWhereNodesAreOnEdges) {
  for (ElementType type : {ElementType::hex8, ElementType::hex20})
    for (const Mesh& mesh : {example<HollowSphereCase>(2, type), example<CylinderCase>(2, type)})
      for (std::size_t axis : {0, 1}) {
        std::set<Point> points, mirrored;
        for (Point x : mesh.coordinates) {
          points.insert({x[0] + 0.0, x[1] + 0.0, x[2] + 0.0});  // -0 becomes 0
          x[axis] = -x[axis];
          mirrored.insert({x[0] + 0.0, x[1] + 0.0, x[2] + 0.0});
        }
        EXPECT_EQ(points, mirrored) << topology(type).name;
      }
}

}  // namespace
}  // namespace mortise
