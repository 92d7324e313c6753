#include "contact/surface.hpp"

#include <algorithm>

namespace mortise {

std::vector<int> ContactSurface::nodes() const {
  std::vector<int> all;
  for (const auto& facet : facets) all.insert(all.end(), facet.begin(), facet.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<NodePatch> ContactSurface::patches() const {
  const auto all = nodes();
  std::vector<NodePatch> patches(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) patches[k].nodes.push_back(all[k]);
  const auto position = [](NodePatch& patch, int node) {
    const auto found = std::find(patch.nodes.begin(), patch.nodes.end(), node);
    if (found != patch.nodes.end()) return static_cast<int>(found - patch.nodes.begin());
    patch.nodes.push_back(node);
    return static_cast<int>(patch.nodes.size()) - 1;
  };
  for (const auto& facet : facets)
    for (int a = 0; a < 4; ++a) {
      auto& patch = patches[std::lower_bound(all.begin(), all.end(), facet[a]) - all.begin()];
      const int next = position(patch, facet[(a + 1) % 4]), previous = position(patch, facet[(a + 3) % 4]);
      patch.corners.push_back({next, previous});
    }
  return patches;
}

}  // namespace mortise
