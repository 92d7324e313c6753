// Making, placing and combining meshes, and speaking the user's numbers.
#include "mesh/combine.hpp"

#include <algorithm>
#include <set>

#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

MeshOptions brick(const std::array<double, 3>& size, const std::array<int, 3>& elements) {
  MeshOptions options;
  options.recipe = recipes::Block{size, elements};
  return options;
}

TEST(MakeMesh, ShiftsByTheOrigin) {
  MeshOptions options = brick({1, 1, 1}, {1, 1, 1});
  options.origin = {1, 1.5, 3};
  const Mesh mesh = make_mesh(options, "");
  EXPECT_EQ(mesh.coordinates.front(), (Point{1, 1.5, 3}));
  EXPECT_EQ(mesh.coordinates.back(), (Point{2, 2.5, 4}));
}

TEST(MakeMesh, RotatesByQuarterTurnsExactlyAndThenShifts) {
  MeshOptions options = brick({1, 2, 3}, {1, 1, 1});
  options.rotation = {0, 0, 2, 90};
  options.origin = {10, 0, 0};
  EXPECT_EQ(make_mesh(options, "").coordinates.back(), (Point{10 - 2, 1, 3}));
  for (const auto& [degrees, x, y] : {std::array<double, 3>{180, -1, -2}, {-90, 2, -1}, {450, -2, 1}, {-360, 1, 2}}) {
    options.rotation[3] = degrees;
    EXPECT_EQ(make_mesh(options, "").coordinates.back(), (Point{10 + x, y, 3})) << degrees;
  }
}

TEST(MakeMesh, RotatesAboutAnyAxisAsRodriguesSays) {
  MeshOptions options = brick({1, 1, 1}, {1, 1, 1});
  options.rotation = {1, 1, 1, 120};  // x -> y -> z -> x
  const Mesh mesh = make_mesh(options, "");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(mesh.coordinates[1][i], (Point{0, 1, 0})[i], 1e-15);
  options.rotation = {0, 1, 0, 30};  // about y: x goes towards -z
  const Point x = make_mesh(options, "").coordinates[1];
  EXPECT_NEAR(x[0], std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(x[2], -0.5, 1e-15);
}

TEST(MakeMesh, KeepsVolumesUnderRotation) {
  MeshOptions options = brick({1, 2, 3}, {2, 2, 2});
  options.rotation = {0.3, -0.8, 0.2, 77};
  const Mesh mesh = make_mesh(options, "");
  for (int e = 0; e < n_elements(mesh); ++e) EXPECT_NEAR(volume(mesh, e), 0.75, 1e-14);
}

TEST(MakeMesh, ReadsFilesRelativeToTheDeck) {
  const ScratchFolder folder;
  write_exodus(block({1, 1, 1}, {1, 1, 1}), folder / "cube.e", "");
  MeshOptions options;
  options.file = "cube.e";
  EXPECT_EQ(n_nodes(make_mesh(options, folder / "")), 8);
  options.recipe = recipes::Block{};
  expect_words(mesh_error_of([&] { make_mesh(options, folder / ""); }), {"M43", "either"});
}

TEST(MakeMesh, RefusesPlacesThatAreNone) {
  MeshOptions options = brick({1, 1, 1}, {1, 1, 1});
  options.rotation = {0, 0, 0, 45};
  options.origin[1] = INFINITY;
  expect_words(mesh_error_of([&] { make_mesh(options, ""); }), {"M42", "\"rotation\" = {0, 0, 0, 45}", "\"origin\""});
}

CombinedMesh ironing() {
  Mesh indenter = block({1, 1, 1}, {4, 4, 4});
  indenter.side_sets[4].name = "";
  indenter.side_sets[4].id = 9;
  return combine({{"slab", block({9, 4, 3}, {20, 5, 3})}, {"indenter", indenter}, {"third", block({1, 1, 1}, {1, 1, 1})}});
}

TEST(CombinedMesh, PassesTheChecksOfEveryMesh) { EXPECT_NO_THROW(check_mesh(ironing().mesh)); }

TEST(CombinedMesh, ShiftsIndicesOfElementsSidesAndSets) {
  const CombinedMesh combined = ironing();
  ASSERT_EQ(combined.parts.size(), 3U);
  const MeshPart& part = combined.parts[1];
  EXPECT_EQ(part.first_node, 504);
  EXPECT_EQ(part.n_nodes, 125);
  EXPECT_EQ(part.first_element, 300);
  EXPECT_EQ(part.first_block, 1);
  const SideSet* top = find_side_set(combined, "indenter/top");
  ASSERT_NE(top, nullptr);
  EXPECT_EQ(top->sides.size(), 16U);
  for (const Side& side : top->sides) EXPECT_EQ(centre(combined.mesh, side)[2], 1);
  const NodeSet* top_nodes = find_node_set(combined, "indenter/top");
  ASSERT_NE(top_nodes, nullptr);
  for (int a : top_nodes->nodes) EXPECT_GE(a, 504);
}

TEST(CombinedMesh, KeepsNumbersUniqueAndRecognisable) {
  const CombinedMesh combined = ironing();
  EXPECT_EQ(combined.parts[0].node_number_offset, 0);
  EXPECT_EQ(combined.parts[1].node_number_offset, 1000);
  EXPECT_EQ(combined.parts[2].node_number_offset, 1130);
  EXPECT_EQ(combined.mesh.node_numbers[504 + 16], 1017);
  const std::set<std::int64_t> distinct(combined.mesh.node_numbers.begin(), combined.mesh.node_numbers.end());
  EXPECT_EQ(distinct.size(), combined.mesh.node_numbers.size());
  EXPECT_EQ(describe_node(combined, 16), "node 17 of mesh \"slab\"");
  EXPECT_EQ(describe_node(combined, 504 + 16), "node 17 of mesh \"indenter\"");
  EXPECT_EQ(describe_element(combined, 364), "element 1 of mesh \"third\"");
  EXPECT_EQ(find_node(combined, combined.parts[1], 17), 504 + 16);
  EXPECT_EQ(find_node(combined, combined.parts[1], 126), std::nullopt);
}

TEST(CombinedMesh, LeavesNumbersAloneThatDoNotCollide) {
  Mesh second = block({1, 1, 1}, {1, 1, 1});
  for (auto& number : second.node_numbers) number += 500;
  const CombinedMesh combined = combine({{"a", block({1, 1, 1}, {1, 1, 1})}, {"b", second}});
  EXPECT_EQ(combined.parts[1].node_number_offset, 0);
  EXPECT_EQ(combined.mesh.node_numbers[8], 501);
}

TEST(CombinedMesh, FindsSetsByNameAndByTheUsersNumber) {
  const CombinedMesh combined = ironing();
  EXPECT_EQ(find_side_set(combined, "slab/6"), find_side_set(combined, "slab/top"));
  EXPECT_EQ(find_node_set(combined, "third/1"), find_node_set(combined, "third/left"));
  ASSERT_NE(find_side_set(combined, "indenter/9"), nullptr);
  EXPECT_EQ(find_side_set(combined, "indenter/9")->name, "indenter/9");
  for (const char* name : {"indenter/5", "slab/tpo", "top", "absent/top", "slab/", "slab/6x", "slab/16", ""})
    EXPECT_EQ(find_side_set(combined, name), nullptr) << name;
}

TEST(CombinedMesh, FindsBlocksByNameAndByTheUsersNumber) {
  const CombinedMesh combined = ironing();
  const MeshPart* part = find_part(combined, "third");
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(find_block(combined, *part, "block"), 2);
  EXPECT_EQ(find_block(combined, *part, "1"), 2);
  EXPECT_EQ(find_block(combined, *part, "2"), std::nullopt);
  EXPECT_EQ(block_names(combined, *part), std::vector<std::string>{"block"});
  EXPECT_EQ(find_part(combined, "fourth"), nullptr);
}

TEST(CombinedMesh, OffersEachSetNameOnce) {
  const std::vector<std::string> names = set_names(ironing());
  EXPECT_EQ(std::count(names.begin(), names.end(), "slab/top"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "indenter/9"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "indenter/bottom"), 1);  // the node set
  EXPECT_EQ(did_you_mean("slab/tpo", names), "; did you mean \"slab/top\"?");
}

TEST(CombinedMesh, IsWrittenAndReadBack) {
  const ScratchFolder folder;
  const CombinedMesh combined = ironing();
  write_exodus(combined.mesh, folder / "mesh.e", "ironing");
  const Mesh mesh = read_exodus(folder / "mesh.e");
  EXPECT_EQ(mesh.node_numbers, combined.mesh.node_numbers);
  EXPECT_EQ(mesh.side_sets.back().name, "third/top");
}

}  // namespace
}  // namespace mortise
