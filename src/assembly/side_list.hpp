// The sides of a load or bedding that this rank integrates: those of its own elements.
#pragma once

#include <vector>

#include "assembly/dof_space.hpp"
#include "physics/elements/sides.hpp"

namespace mortise {

/// Nodes of a side, and where their unknowns are in the overlap.
struct LocalSide {
  std::vector<int> nodes, local;
  int number;  ///< in the list that it was taken from
};

inline std::vector<LocalSide> owned_sides(const Mesh& mesh, const std::vector<Side>& sides, const Partition& partition,
                                          const DofSpace& dofs) {
  std::vector<LocalSide> owned;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (partition.element_rank[sides[s].element] != dofs.comm()->getRank()) continue;
    LocalSide one{side_nodes(mesh, sides[s]), {}, static_cast<int>(s)};
    for (int node : one.nodes) one.local.push_back(dofs.local(node));
    owned.push_back(std::move(one));
  }
  return owned;
}

/// Reference positions of the nodes of a side of type `Kind` [m].
template <class Kind>
std::array<Point, Kind::n_nodes> reference_positions(const Mesh& mesh, const LocalSide& side) {
  std::array<Point, Kind::n_nodes> X;
  for (std::size_t a = 0; a < X.size(); ++a) X[a] = mesh.coordinates[side.nodes[a]];
  return X;
}

/// Adds 3 values per node to the overlap.
inline void scatter(const std::vector<int>& local, const double* values, double* f) {
  for (std::size_t a = 0; a < local.size(); ++a)
    for (int i = 0; i < 3; ++i) f[local[a] + i] += values[3 * a + i];
}

}  // namespace mortise
