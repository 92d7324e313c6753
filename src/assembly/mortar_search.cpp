// The search of a mortar pair: which primary facets may lie opposite a secondary one, and how far behind it that means anything.
#include <algorithm>
#include <optional>

#include "assembly/mortar_term.hpp"

namespace mortise {

Box MortarTerm::box_of(const double* x, const std::array<int, 4>& facet) const {
  Box box;
  for (int node : facet) box.include(position(x, node));
  return box;
}

Vec3<double> MortarTerm::normal_of(const double* x, const std::array<int, 4>& facet) const {
  const Vec3<double> n = cross(position(x, facet[2]) - position(x, facet[0]), position(x, facet[3]) - position(x, facet[1]));
  return (1 / norm(n)) * n;
}

// How far behind a facet the secondary surface comes back, facing the other way; `most` if it does not.
double MortarTerm::thickness_behind(const BoxTree& own, const double* x, int facet, double most) const {
  const auto centre_of = [&](const std::array<int, 4>& nodes) {
    return 0.25 * ((position(x, nodes[0]) + position(x, nodes[1])) + (position(x, nodes[2]) + position(x, nodes[3])));
  };
  const auto& nodes = pair_.secondary.facets[facet];
  const Vec3<double> centre = centre_of(nodes), normal = normal_of(x, nodes);
  Box box;
  box.include(centre);
  box.include(centre - most * normal);
  double thickness = most;
  for (int other : own.query(box)) {
    const auto& others = pair_.secondary.facets[other];
    if (!(dot(normal_of(x, others), normal) < 0)) continue;
    const Vec3<double> away = centre_of(others) - centre;
    const double behind = -dot(away, normal), aside = norm(away + behind * normal),
                 reach = 0.5 * std::max(norm(position(x, others[2]) - position(x, others[0])),
                                        norm(position(x, others[3]) - position(x, others[1])));
    if (behind > 0 && aside <= reach) thickness = std::min(thickness, behind);
  }
  return thickness;
}

bool MortarTerm::search(const double* x, double reach, double inward) {
  ++counts_.searches;
  const auto tree_of = [&](const ContactSurface& surface) {
    std::vector<Box> boxes;
    for (const auto& facet : surface.facets) boxes.push_back(box_of(x, facet));
    return BoxTree(std::move(boxes));
  };
  const BoxTree tree = tree_of(pair_.primary);
  std::optional<BoxTree> own;
  if (inward > pair_.size) own = tree_of(pair_.secondary);
  bool changed = false;
  for (auto& facet : facets_) {
    // Along the normal as far as overlaps count, to all sides by what the surfaces may move.
    const auto& nodes = pair_.secondary.facets[facet.index];
    const Vec3<double> normal = normal_of(x, nodes);
    const double depth = own ? thickness_behind(*own, x, facet.index, inward) : inward;
    facet.deepest = depth + reach;
    Box box = box_of(x, nodes);
    for (int node : nodes) {
      box.include(position(x, node) + farthest() * normal);
      box.include(position(x, node) - depth * normal);
    }
    box.widen(reach);
    auto hits = tree.query(box);
    if (hits == facet.candidates) continue;
    facet.candidates = std::move(hits);
    list_points(facet);
    changed = true;
  }
  return changed;
}

}  // namespace mortise
