// A contact surface: facets over the scene's nodes, and the neighbourhoods that nodal normals need.
#pragma once

#include <array>
#include <vector>

#include "contact/mortar/nodal_normal.hpp"

namespace mortise {

/// Facets with outward normals by the right-hand rule; nodes are numbers of the scene's mesh.
struct ContactSurface {
  std::vector<std::array<int, 4>> facets;

  /// All nodes, ascending.
  std::vector<int> nodes() const;

  /// The patch of every node, in the order of `nodes()`; patch nodes are numbers of the scene's mesh.
  std::vector<NodePatch> patches() const;
};

}  // namespace mortise
