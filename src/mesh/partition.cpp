// METIS on the dual graph of the mesh.
#include "mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace mortise {

namespace {

/// Consecutive elements to consecutive ranks: for meshes too small to be worth a graph (METIS fails with more parts than
/// elements), and for points and chains of bars, whose numbers run along them.
std::vector<int> in_order(int n, int n_ranks) {
  std::vector<int> rank(static_cast<std::size_t>(n));
  for (int e = 0; e < n; ++e) rank[static_cast<std::size_t>(e)] = static_cast<int>(static_cast<std::int64_t>(e) * n_ranks / n);
  return rank;
}

bool has_solids(const Mesh& mesh) {
  return std::any_of(mesh.blocks.begin(), mesh.blocks.end(), [](const Block& b) { return is_solid(b.elements.type()); });
}

std::vector<int> by_metis(const Mesh& mesh, int n, int n_ranks, const std::vector<int>& contact_elements, int contact_weight) {
  std::vector<idx_t> offsets{0}, nodes;
  nodes.reserve(8 * static_cast<std::size_t>(n));
  offsets.reserve(static_cast<std::size_t>(n) + 1);
  for (const Block& block : mesh.blocks)
    for (const auto& element : block.elements) {
      nodes.insert(nodes.end(), element.begin(), element.end());
      offsets.push_back(static_cast<idx_t>(nodes.size()));
    }
  std::vector<idx_t> weights(static_cast<std::size_t>(n), 1);
  for (int e : contact_elements) weights[static_cast<std::size_t>(e)] = 1 + contact_weight;

  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // the same partition on every rank and in every run
  options[METIS_OPTION_NUMBERING] = 0;
  if (n_ranks <= 8) options[METIS_OPTION_PTYPE] = METIS_PTYPE_RB;  // bisection balances better; k-way is faster for many parts
  idx_t n_graph_elements = n, n_graph_nodes = n_nodes(mesh), n_common = 4, n_parts = n_ranks, cut = 0;
  std::vector<idx_t> rank(static_cast<std::size_t>(n)), node_part(mesh.coordinates.size());
  const int status = METIS_PartMeshDual(&n_graph_elements, &n_graph_nodes, offsets.data(), nodes.data(), weights.data(), nullptr,
                                        &n_common, &n_parts, nullptr, options, &cut, rank.data(), node_part.data());
  if (status == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (status != METIS_OK) throw std::logic_error("METIS_PartMeshDual refused its input");
  return {rank.begin(), rank.end()};
}

}  // namespace

Partition make_partition(const Mesh& mesh, int n_ranks, const std::vector<int>& contact_elements, int contact_weight) {
  assert(n_ranks >= 1 && contact_weight >= 0);
  const int n = n_elements(mesh);
  Partition partition;
  if (n_ranks == 1) {
    partition.element_rank.assign(static_cast<std::size_t>(n), 0);
  } else if (n < 4 * n_ranks || !has_solids(mesh)) {
    partition.element_rank = in_order(n, n_ranks);
  } else {
    partition.element_rank = by_metis(mesh, n, n_ranks, contact_elements, contact_weight);
  }

  partition.node_rank.assign(mesh.coordinates.size(), n_ranks);
  std::size_t e = 0;
  for (const Block& block : mesh.blocks)
    for (const auto& element : block.elements) {
      for (int a : element) {
        int& rank = partition.node_rank[static_cast<std::size_t>(a)];
        rank = std::min(rank, partition.element_rank[e]);
      }
      ++e;
    }
  std::replace(partition.node_rank.begin(), partition.node_rank.end(), n_ranks, 0);
  return partition;
}

}  // namespace mortise
