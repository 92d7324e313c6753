// Meshes of points and bars: as recipes, in Exodus files, checked and partitioned.
#include <gtest/gtest.h>

#include <fstream>

#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/partition.hpp"
#include "mesh/recipes/recipes.hpp"
#include "mesh/suspicions.hpp"
#include "physics/elements/bars.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

Mesh points() { return recipes::make(recipes::Points{{0, 0, 0, 1, 2, 3, 1, 0, -1}}); }
Mesh line(int elements, int order) { return recipes::make(recipes::Line{{0, 0, 0}, {1, 2, 2}, elements, order}); }

/// A brick with a point mass on a block of its own, and a bar that hangs from the brick.
Mesh brick_with_appendages() {
  Mesh mesh = block({1, 1, 1}, {2, 1, 1});
  const int last = n_nodes(mesh);
  mesh.coordinates.push_back({2, 2, 2});
  mesh.coordinates.push_back({2, 2, 3});
  for (int k = 0; k < 2; ++k) {
    mesh.node_numbers.push_back(last + 1 + k);
    mesh.element_numbers.push_back(3 + k);
  }
  mesh.blocks.push_back({2, "mass", ElementList(ElementType::sphere)});
  mesh.blocks.back().elements.push_back({last});
  mesh.blocks.push_back({3, "rope", ElementList(ElementType::bar2)});
  mesh.blocks.back().elements.push_back({0, last + 1});
  return mesh;
}

TEST(Points, AreOneSphereAndOneNodeSetEach) {
  const Mesh mesh = points();
  ASSERT_EQ(n_elements(mesh), 3);
  EXPECT_EQ(element_type(mesh, 2), ElementType::sphere);
  EXPECT_EQ(mesh.coordinates[1], (Point{1, 2, 3}));
  ASSERT_EQ(mesh.node_sets.size(), 3U);
  EXPECT_EQ(mesh.node_sets[2].name, "3");
  EXPECT_EQ(mesh.node_sets[2].nodes, std::vector<int>{2});
  EXPECT_TRUE(mesh.side_sets.empty());
  EXPECT_TRUE(mesh_warnings(mesh).empty());
}

TEST(Line, HasBarsOfItsOrderFromStartToEnd) {
  for (int order : {1, 2, 3}) {
    const Mesh mesh = line(4, order);
    ASSERT_EQ(n_elements(mesh), 4) << order;
    EXPECT_EQ(n_nodes(mesh), 4 * order + 1);
    EXPECT_EQ(mesh.node_sets[0].name, "start");
    EXPECT_EQ(mesh.coordinates[static_cast<std::size_t>(mesh.node_sets[1].nodes[0])], (Point{1, 2, 2}));
    // straight, with the local coordinate as measure: dX/dxi = 3/4 (length of an element) / 2 along the line
    for (int e = 0; e < 4; ++e) {
      const auto nodes = element_nodes(mesh, e);
      const auto dN = bar_derivatives(nodes.size(), 0.3);
      double x = 0;
      for (std::size_t a = 0; a < nodes.size(); ++a) x += dN[a] * mesh.coordinates[static_cast<std::size_t>(nodes[a])][0];
      EXPECT_NEAR(x, 0.125, 1e-15) << order;
    }
  }
}

TEST(Bars, HaveShapesThatSumToOneAndAreOneAtTheirNodes) {
  for (std::size_t n : {2U, 3U, 4U}) {
    const BarValues at = bar_nodes(n);
    for (std::size_t a = 0; a < n; ++a) {
      const BarValues N = bar_shapes(n, at[a]);
      for (std::size_t b = 0; b < n; ++b) EXPECT_NEAR(N[b], a == b ? 1 : 0, 1e-15);
    }
    double sum = 0, slope = 0, change = 0;
    for (std::size_t a = 0; a < n; ++a) {
      sum += bar_shapes(n, 0.37)[a];
      slope += bar_derivatives(n, 0.37)[a];
      change += (bar_shapes(n, 0.37 + 1e-6)[a] - bar_shapes(n, 0.37 - 1e-6)[a]) * at[a] * at[a] * (n > 2 ? 1 : 0);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR(slope, 0, 1e-14);
    if (n > 2) {
      EXPECT_NEAR(change / 2e-6, 2 * 0.37, 1e-9);  // xi^2 is held exactly
    }
  }
}

TEST(Discrete, MeshesSurviveTheirExodusFile) {
  const ScratchFolder folder;
  for (const Mesh& mesh : {points(), line(3, 1), line(3, 2), line(3, 3), brick_with_appendages()}) {
    write_exodus(mesh, folder / "mesh.e", "discrete");
    const Mesh back = read_exodus(folder / "mesh.e");
    EXPECT_EQ(back.coordinates, mesh.coordinates);
    ASSERT_EQ(back.blocks.size(), mesh.blocks.size());
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) EXPECT_EQ(back.blocks[b].elements, mesh.blocks[b].elements);
    ASSERT_EQ(back.node_sets.size(), mesh.node_sets.size());
    for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) {
      EXPECT_EQ(back.node_sets[s].name, mesh.node_sets[s].name);
      EXPECT_EQ(back.node_sets[s].nodes, mesh.node_sets[s].nodes);
    }
  }
}

TEST(Discrete, BarsMayBeCalledBeams) {
  const ScratchFolder folder;
  write_exodus(line(3, 1), folder / "mesh.e", "discrete");
  std::ifstream in(folder / "mesh.e", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  bytes.replace(bytes.find("BAR2"), 4, "BEAM");
  std::ofstream(folder / "beams.e", std::ios::binary) << bytes;
  EXPECT_EQ(read_exodus(folder / "beams.e").blocks[0].elements, line(3, 1).blocks[0].elements);
}

TEST(Discrete, BarsWithoutLengthOrOutOfOrderAreRefused) {
  Mesh flat = line(2, 1);
  flat.coordinates[1] = flat.coordinates[0];
  expect_words(mesh_error_of([&] { check_mesh(flat); }), {"M21", "element 1"});
  Mesh folded = line(1, 3);
  std::swap(folded.coordinates[1], folded.coordinates[2]);
  expect_words(mesh_error_of([&] { check_mesh(folded); }), {"M21", "element 1"});
  EXPECT_NO_THROW(check_mesh(line(2, 3)));
  EXPECT_NO_THROW(check_mesh(brick_with_appendages()));
}

TEST(Discrete, EveryRankHasElementsAndEveryNodeOneOwner) {
  Mesh many = line(40, 2);
  for (int n_ranks : {1, 2, 4}) {
    for (const Mesh& mesh : {many, recipes::make(recipes::Points{std::vector<double>(120, 1.0)}), brick_with_appendages()}) {
      const Partition partition = make_partition(mesh, n_ranks, {});
      for (int rank = 0; rank < n_ranks; ++rank)
        EXPECT_GT(std::count(partition.element_rank.begin(), partition.element_rank.end(), rank), 0);
      for (int rank : partition.node_rank) {
        EXPECT_GE(rank, 0);
        EXPECT_LT(rank, n_ranks);
      }
    }
  }
}

TEST(Discrete, FaultyDataNameTheirParameter) {
  expect_words(mesh_error_of([] { recipes::make(recipes::Points{{1, 2}}); }), {"\"coordinates\""});
  expect_words(mesh_error_of([] { recipes::make(recipes::Line{{1, 1, 1}, {1, 1, 1}, 2, 1}); }), {"\"to\""});
  expect_words(mesh_error_of([] { recipes::make(recipes::Line{{0, 0, 0}, {1, 1, 1}, 2, 4}); }), {"\"order\""});
}

}  // namespace
}  // namespace mortise
