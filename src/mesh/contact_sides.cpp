// Whether a side set can be a contact surface.
#include "mesh/contact_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace mortise {

namespace {

using Facet = std::vector<int>;

std::string describe_side(const CombinedMesh& mesh, const Side& side) {
  return fmt::format("side {} of {}", side.face + 1, describe_element(mesh, side.element));
}

/// Sides that lie between two elements. Only elements with all nodes of a side on the surface can be the other one.
void find_interior_sides(const CombinedMesh& mesh, const SideSet& sides, std::vector<SurfaceFault>& faults) {
  const Mesh& all = mesh.mesh;
  std::vector<bool> on_surface(all.coordinates.size(), false);
  std::vector<std::pair<Facet, std::size_t>> facets;  // sorted nodes, place in the set
  for (std::size_t i = 0; i < sides.sides.size(); ++i) {
    Facet nodes = side_nodes(all, sides.sides[i]);
    for (int a : nodes) on_surface[static_cast<std::size_t>(a)] = true;
    std::sort(nodes.begin(), nodes.end());
    facets.emplace_back(nodes, i);
  }
  std::sort(facets.begin(), facets.end());

  std::vector<int> n_elements_at(sides.sides.size(), 0);
  int e = 0;
  for (const Block& block : all.blocks)
    for (const auto& element : block.elements) {
      const int n_faces = static_cast<int>(topology(block.elements.type()).faces.size());
      const auto n_on_surface =
          std::count_if(element.begin(), element.end(), [&](int a) { return on_surface[static_cast<std::size_t>(a)]; });
      for (int face = 0; n_on_surface >= 3 && face < n_faces; ++face) {
        Facet nodes = side_nodes(all, {e, face});
        std::sort(nodes.begin(), nodes.end());
        for (auto at = std::lower_bound(facets.begin(), facets.end(), std::pair<Facet, std::size_t>{nodes, 0});
             at != facets.end() && at->first == nodes; ++at)
          ++n_elements_at[at->second];
      }
      ++e;
    }
  const auto is_interior = [](int n) { return n > 1; };
  const auto n = std::count_if(n_elements_at.begin(), n_elements_at.end(), is_interior);
  if (n == 0) return;
  const auto first = std::find_if(n_elements_at.begin(), n_elements_at.end(), is_interior) - n_elements_at.begin();
  faults.push_back({"M52", fmt::format("{} of {} sides with elements on both sides (first: {}) - a contact surface is outside", n,
                                       sides.sides.size(), describe_side(mesh, sides.sides[static_cast<std::size_t>(first)]))});
}

/// An edge as one facet sees it.
struct FacetEdge {
  int low, high;      ///< its nodes
  bool is_ascending;  ///< the facet, walked about its outward normal, goes from `low` to `high`
  std::size_t side;
};

/// Faults of the edges; a regular edge has one facet, or two that walk it in opposite directions.
void check_edges(const CombinedMesh& mesh, const SideSet& sides, std::vector<SurfaceFault>& faults) {
  std::vector<FacetEdge> edges;
  for (std::size_t i = 0; i < sides.sides.size(); ++i) {
    const Facet nodes = side_nodes(mesh.mesh, sides.sides[i]);
    const std::size_t n = n_side_corners(mesh.mesh, sides.sides[i]);
    for (std::size_t a = 0; a < n; ++a) {
      const auto [low, high] = std::minmax(nodes[a], nodes[(a + 1) % n]);
      edges.push_back({low, high, nodes[a] == low, i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FacetEdge& a, const FacetEdge& b) {
    return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side);
  });

  std::size_t n_branching = 0, n_turning = 0;
  std::string first_branching, first_turning;
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end =
        std::find_if(begin, edges.end(), [&](const FacetEdge& e) { return e.low != begin->low || e.high != begin->high; });
    const auto n_facets = end - begin;
    if (n_facets > 2 && n_branching++ == 0)
      first_branching =
          fmt::format("{} between {} and {}", n_facets, describe_node(mesh, begin->low), describe_node(mesh, begin->high));
    if (n_facets == 2 && begin->is_ascending == (begin + 1)->is_ascending && n_turning++ == 0)
      first_turning = fmt::format("{} and {}", describe_side(mesh, sides.sides[begin->side]),
                                  describe_side(mesh, sides.sides[(begin + 1)->side]));
    begin = end;
  }
  const auto edges_of = [](std::size_t n) { return fmt::format("{} edge{}", n, n == 1 ? "" : "s"); };
  if (n_branching > 0)
    faults.push_back(
        {"M53", fmt::format("{} where more than two facets meet (first: {}) - there the surface has no normal; leave "
                            "one of the surfaces out",
                            edges_of(n_branching), first_branching)});
  if (n_turning > 0)
    faults.push_back({"M54", fmt::format("{} where the outward normal turns over (first: between {}) - there the surface has no "
                                         "normal; leave one of the surfaces out",
                                         edges_of(n_turning), first_turning)});
}

}  // namespace

std::vector<SurfaceFault> contact_surface_faults(const CombinedMesh& mesh, const SideSet& sides) {
  std::vector<SurfaceFault> faults;
  find_interior_sides(mesh, sides, faults);
  if (faults.empty()) check_edges(mesh, sides, faults);  // sides inside a body spoil the edges as well
  return faults;
}

}  // namespace mortise
