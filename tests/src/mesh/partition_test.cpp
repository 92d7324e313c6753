// The partition of a mesh among ranks.
#include "mesh/partition.hpp"

#include <algorithm>

#include "mesh/combine.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

std::vector<double> weight_per_rank(const std::vector<int>& rank, int n_ranks, const std::vector<int>& heavy, int extra) {
  std::vector<double> sum(static_cast<std::size_t>(n_ranks), 0.0);
  for (std::size_t e = 0; e < rank.size(); ++e) {
    const bool is_heavy = std::find(heavy.begin(), heavy.end(), static_cast<int>(e)) != heavy.end();
    sum.at(static_cast<std::size_t>(rank[e])) += is_heavy ? 1 + extra : 1;
  }
  return sum;
}

void expect_balanced(const std::vector<double>& sum, double tolerance) {
  double mean = 0;
  for (double s : sum) mean += s / static_cast<double>(sum.size());
  for (double s : sum) EXPECT_NEAR(s, mean, tolerance * mean);
}

void expect_nodes_at_lowest_rank(const Mesh& mesh, const Partition& partition) {
  std::vector<int> lowest(mesh.coordinates.size(), 1 << 30);
  for (int e = 0; e < n_elements(mesh); ++e)
    for (int a : element_nodes(mesh, e))
      lowest[static_cast<std::size_t>(a)] =
          std::min(lowest[static_cast<std::size_t>(a)], partition.element_rank[static_cast<std::size_t>(e)]);
  EXPECT_EQ(partition.node_rank, lowest);
}

TEST(Partition, CoversAllElementsInBalanceAndIsRepeatable) {
  const Mesh mesh = block({1, 1, 1}, {10, 10, 10});
  for (int n_ranks : {2, 3, 4, 12}) {
    const Partition partition = make_partition(mesh, n_ranks, {});
    ASSERT_EQ(partition.element_rank.size(), 1000U);
    expect_balanced(weight_per_rank(partition.element_rank, n_ranks, {}, 0), 0.1);
    expect_nodes_at_lowest_rank(mesh, partition);
    EXPECT_EQ(make_partition(mesh, n_ranks, {}).element_rank, partition.element_rank);
  }
}

TEST(Partition, SharesTheWorkOfContactElements) {
  const CombinedMesh mesh = combine({{"a", block({1, 1, 1}, {8, 8, 8})}, {"b", block({1, 1, 1}, {6, 6, 6})}});
  std::vector<int> contact;
  for (const Side& side : find_side_set(mesh, "b/bottom")->sides) contact.push_back(side.element);
  const Partition partition = make_partition(mesh.mesh, 4, contact, 5);
  expect_balanced(weight_per_rank(partition.element_rank, 4, contact, 5), 0.1);
}

TEST(Partition, CutsFewFaces) {
  const Mesh mesh = block({4, 1, 1}, {40, 6, 6});
  const Partition partition = make_partition(mesh, 2, {});
  int n_cut = 0;
  for (int e = 0; e + 1 < n_elements(mesh); ++e)  // neighbours along x
    if (e % 40 != 39)
      n_cut += partition.element_rank[static_cast<std::size_t>(e)] != partition.element_rank[static_cast<std::size_t>(e) + 1];
  EXPECT_LE(n_cut, 45);  // 36 by the best plane
}

TEST(Partition, OnOneRankIsTrivial) {
  const Partition partition = make_partition(block({1, 1, 1}, {2, 2, 2}), 1, {});
  EXPECT_EQ(partition.element_rank, std::vector<int>(8, 0));
  EXPECT_EQ(partition.node_rank, std::vector<int>(27, 0));
}

TEST(Partition, SurvivesMoreRanksThanElements) {
  for (int n_ranks : {2, 3, 7, 8, 9, 64}) {
    const Mesh mesh = block({1, 1, 1}, {2, 2, 2});
    const Partition partition = make_partition(mesh, n_ranks, {0, 7});
    ASSERT_EQ(partition.element_rank.size(), 8U);
    for (int rank : partition.element_rank) EXPECT_TRUE(rank >= 0 && rank < n_ranks);
    expect_nodes_at_lowest_rank(mesh, partition);
  }
}

TEST(Partition, GivesNodesWithoutElementsToRankZero) {
  Mesh mesh = block({1, 1, 1}, {4, 4, 4});
  mesh.coordinates.push_back({9, 9, 9});
  EXPECT_EQ(make_partition(mesh, 3, {}).node_rank.back(), 0);
}

}  // namespace
}  // namespace mortise
