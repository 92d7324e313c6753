// Which rank owns which element and node: METIS on the dual graph of the whole mesh.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

struct Partition {
  std::vector<int> element_rank;  ///< per element over all blocks
  std::vector<int> node_rank;     ///< per node: the lowest rank among its elements; a node without elements belongs to rank 0
};

/// Deterministic: the same mesh, weights and count give the same partition on every rank, so no communication is needed.
/// Elements that carry a contact facet weigh `1 + contact_weight`.
/// @param contact_elements elements with a secondary contact facet
Partition make_partition(const Mesh& mesh, int n_ranks, const std::vector<int>& contact_elements, int contact_weight = 2);

}  // namespace mortise
