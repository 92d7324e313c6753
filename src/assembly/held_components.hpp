// Which components of a traction have nothing to hold, because supports do.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "contact/mortar/nodal_normal.hpp"
#include "scene.hpp"

namespace mortise {

/// Secondary nodes (by position) and axes.
using Components = std::set<std::pair<std::size_t, int>>;

/// A traction at a held node moves nothing but the node's free neighbours, which have conditions of their own: where both sides
/// are held there would be one too many. A secondary surface that is held as a whole round a node keeps its traction there, and
/// draws the other side along, unless that is held too.
/// @param patches of the secondary nodes  @param primary all primary nodes  @param held by supports in this step
inline Components held_components(const std::vector<NodePatch>& patches, const std::vector<int>& primary,
                                  const std::vector<PrescribedDof>& held) {
  Components found;
  if (held.empty()) return found;
  std::set<std::pair<int, int>> is_held;
  for (const PrescribedDof& p : held) is_held.insert({p.node, p.axis});
  for (int axis = 0; axis < 3; ++axis) {
    const auto all_held = [&](const std::vector<int>& nodes) {
      for (int node : nodes)
        if (is_held.count({node, axis}) == 0) return false;
      return true;
    };
    const bool is_primary_held = all_held(primary);
    for (std::size_t k = 0; k < patches.size(); ++k)
      if (is_held.count({patches[k].nodes[0], axis}) > 0 && (is_primary_held || !all_held(patches[k].nodes)))
        found.insert({k, axis});
  }
  return found;
}

}  // namespace mortise
