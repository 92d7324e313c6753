// Meshes that are accepted with a warning.
#include "mesh/suspicions.hpp"

#include "mesh/checks.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

/// Puts a second mesh into the first one, joined nowhere.
void add(Mesh& mesh, Mesh other, const Point& origin) {
  const int n = n_nodes(mesh), n_elements_before = n_elements(mesh);
  for (Point x : other.coordinates) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += origin[i];
    mesh.coordinates.push_back(x);
    mesh.node_numbers.push_back(static_cast<std::int64_t>(mesh.coordinates.size()));
  }
  for (const auto& own : other.blocks[0].elements) {
    std::vector<int> element(own.begin(), own.end());
    for (int& a : element) a += n;
    mesh.blocks[0].elements.push_back(element);
    mesh.element_numbers.push_back(n_elements_before + static_cast<std::int64_t>(mesh.element_numbers.size()));
  }
}

TEST(MeshWarnings, AreNoneForABrick) {
  EXPECT_EQ(mesh_warnings(graded_block({3, 2, 1}, {12, 8, 5}, {1, 0.1, 20})), std::vector<std::string>{});
}

TEST(MeshWarnings, CountTheNodesOfASeam) {
  for (const double shift : {0.0, 1e-8}) {
    Mesh mesh = block({2, 2, 2}, {2, 2, 2});
    mesh.source = "tool.exo";
    for (auto& number : mesh.node_numbers) number += 100;
    add(mesh, block({2, 2, 2}, {2, 2, 2}), {0, 0, 2 + shift});
    check_mesh(mesh);
    const auto warnings = mesh_warnings(mesh);
    ASSERT_EQ(warnings.size(), 1U);
    expect_words(warnings[0], {"tool.exo: 9 pairs of nodes in one place", "nodes 119 and 28"});
  }
}

TEST(MeshWarnings, CallNothingCoincidentThatIsApart) {
  Mesh mesh = block({2, 2, 2}, {2, 2, 2});
  add(mesh, block({2, 2, 2}, {2, 2, 2}), {0, 0, 2 + 1e-5});
  EXPECT_EQ(mesh_warnings(mesh), std::vector<std::string>{});
}

TEST(MeshWarnings, JudgeNearnessByTheElementsThere) {
  Mesh mesh = block({1e-4, 1e-4, 1e-4}, {1, 1, 1});  // 1e-7 apart is near for the large elements, not for these
  add(mesh, block({1, 1, 1}, {2, 2, 2}), {0, 0, 1e-4 + 1e-7});
  EXPECT_EQ(mesh_warnings(mesh), std::vector<std::string>{});
}

TEST(MeshWarnings, NameTheElementsWhoseSizesAreFarApart) {
  Mesh mesh = block({1, 1, 1}, {1, 1, 1});
  add(mesh, block({2e4, 2e4, 2e4}, {1, 1, 1}), {5, 5, 5});
  mesh.element_numbers = {71, 72};
  const auto warnings = mesh_warnings(mesh);
  ASSERT_EQ(warnings.size(), 1U);
  expect_words(warnings[0], {"elements 71 and 72 are 1 and 2e+04"});
}

}  // namespace
}  // namespace mortise
