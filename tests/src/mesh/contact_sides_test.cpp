// Side sets that can be contact surfaces, and those that cannot.
#include "mesh/contact_sides.hpp"

#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

/// The brick as the mesh "part" of a scene, with one more set of sides.
CombinedMesh with_set(Mesh mesh, const std::vector<Side>& sides) {
  mesh.side_sets.push_back({99, "rim", sides});
  return combine({{"part", std::move(mesh)}});
}

std::vector<SurfaceFault> faults_of(const CombinedMesh& mesh, const std::string& set = "part/rim") {
  return contact_surface_faults(mesh, *find_side_set(mesh, set));
}

/// Elements of `block` x fastest: keeps those listed, and removes the nodes that are left over.
Mesh only(Mesh mesh, const std::vector<int>& elements) {
  Mesh kept;
  kept.source = mesh.source;
  kept.blocks = {{1, "block", ElementList()}};
  std::vector<int> index(mesh.coordinates.size(), -1);
  for (int e : elements) {
    const ElementNodeList of_all = element_nodes(mesh, e);
    std::vector<int> nodes(of_all.begin(), of_all.end());
    for (int& a : nodes) {
      int& to = index[static_cast<std::size_t>(a)];
      if (to < 0) {
        to = n_nodes(kept);
        kept.coordinates.push_back(mesh.coordinates[static_cast<std::size_t>(a)]);
        kept.node_numbers.push_back(to + 1);
      }
      a = to;
    }
    kept.blocks[0].elements.push_back(nodes);
    kept.element_numbers.push_back(static_cast<std::int64_t>(kept.element_numbers.size()) + 1);
  }
  return kept;
}

/// Faces of a hex8 by what they look at, counted from 0.
enum Face { front = 0, right = 1, back = 2, left = 3, bottom = 4, top = 5 };

TEST(ContactSides, OfABrickAreSound) {
  const CombinedMesh mesh = combine({{"part", graded_block({3, 2, 1}, {4, 3, 2}, {1, 2, 3})}});
  for (const char* set : {"left", "right", "front", "back", "bottom", "top"})
    EXPECT_TRUE(faults_of(mesh, "part/" + std::string(set)).empty()) << set;
}

TEST(ContactSides, RoundACornerAreSound) {
  EXPECT_TRUE(faults_of(with_set(block({2, 1, 1}, {2, 1, 1}), {{0, top}, {1, top}, {1, right}, {0, left}, {0, front}})).empty());
}

TEST(ContactSides, BetweenTwoElementsAreRefused) {
  const auto faults = faults_of(with_set(block({2, 1, 1}, {2, 1, 1}), {{0, top}, {0, right}, {1, left}}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].code, "M52");
  expect_words(faults[0].text, {"2 of 3 sides", "first: side 2 of element 1 of mesh \"part\""});
}

// Two elements that have only an edge in common: four facets meet at it.
TEST(ContactSides, ThatBranchAreRefused) {
  const Mesh mesh = only(block({2, 1, 2}, {2, 1, 2}), {0, 3});
  const auto faults = faults_of(with_set(mesh, {{0, top}, {0, right}, {1, bottom}, {1, left}}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].code, "M53");
  expect_words(faults[0].text, {"1 edge ", "first: 4 between node", "of mesh \"part\""});
}

TEST(ContactSides, ThatTurnOverAreRefused) {
  const Mesh mesh = only(block({2, 1, 2}, {2, 1, 2}), {0, 3});
  const auto faults = faults_of(with_set(mesh, {{0, top}, {1, bottom}}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].code, "M54");
  expect_words(faults[0].text, {"1 edge ", "side 6 of element 1 of mesh \"part\" and side 5 of element 2"});
  EXPECT_TRUE(faults_of(with_set(mesh, {{0, top}, {1, left}})).empty()) << "a step is a surface";
}

}  // namespace
}  // namespace mortise
