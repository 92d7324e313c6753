#include "opposite_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/contact_sides.hpp"
#include "physics/traction.hpp"

namespace mortise {
namespace {

class SurfaceFinder {
 public:
  SurfaceFinder(const DeckNames& names, const Scene& scene, const std::string& list, const std::string& name,
                std::vector<std::string>& mesh_errors)
      : names_(names), scene_(scene), entry_{list, name}, mesh_errors_(mesh_errors) {}

  bool find(const std::string& secondary_set, const std::string& primary_set, OppositeSurfaces& pair) {
    const auto* secondary = names_.sides_of(secondary_set, at("secondary"));
    const auto* primary = names_.sides_of(primary_set, at("primary"));
    if (!secondary || !primary) return false;
    const bool is_sound = is_contact_surface(*secondary, at("secondary"));
    if (!is_contact_surface(*primary, at("primary")) || !is_sound) return false;
    const bool is_bilinear = are_quadrilaterals(*secondary, at("secondary"));
    if (!are_quadrilaterals(*primary, at("primary")) || !is_bilinear) return false;
    pair.name = entry_[1];
    for (const Side& side : secondary->sides) {
      pair.secondary.facets.push_back(facet_nodes(side));
      pair.secondary_elements.push_back(side.element);
    }
    for (const Side& side : primary->sides) pair.primary.facets.push_back(facet_nodes(side));
    pair.secondary_nodes = pair.secondary.nodes();
    const auto primary_nodes = pair.primary.nodes();
    if (share_nodes(pair.secondary_nodes, primary_nodes)) return false;
    const double area = facet_areas(pair.secondary, pair.secondary_nodes, pair.tributary_area);
    pair.size = std::sqrt(area / pair.secondary.facets.size());
    std::vector<double> unused;
    pair.primary_size = std::sqrt(facet_areas(pair.primary, primary_nodes, unused) / pair.primary.facets.size());
    pair.youngs_modulus = modulus_behind(*secondary);
    pair.opposite_compliance = pair.primary_size / modulus_behind(*primary);
    return true;
  }

 private:
  DeckPath at(const std::string& parameter) const { return {entry_[0], entry_[1], parameter}; }

  bool is_contact_surface(const SideSet& sides, const DeckPath& path) {
    const auto faults = contact_surface_faults(scene_.mesh, sides);
    for (const auto& fault : faults) mesh_errors_.push_back(names_.deck().error(fault.code, path, fault.text));
    return faults.empty();
  }

  bool are_quadrilaterals(const SideSet& sides, const DeckPath& path) const {
    for (const Side& side : sides.sides) {
      const auto n = side_nodes(scene_.mesh.mesh, side).size();
      if (n == 4) continue;
      names_.error("D20", path,
                   fmt::format("holds a side with {} nodes ({}) - contact surfaces have sides with 4 nodes: of hex8, or the "
                               "quadrilaterals of wedge6",
                               n, describe_element(scene_.mesh, side.element)));
      return false;
    }
    return true;
  }

  bool share_nodes(const std::vector<int>& secondary_nodes, const std::vector<int>& primary_nodes) const {
    std::vector<int> shared;
    std::set_intersection(secondary_nodes.begin(), secondary_nodes.end(), primary_nodes.begin(), primary_nodes.end(),
                          std::back_inserter(shared));
    if (shared.empty()) return false;
    names_.error("D19", entry_,
                 fmt::format("secondary and primary share {} nodes (first: {}) - two surfaces without common nodes are needed",
                             shared.size(), describe_node(scene_.mesh, shared[0])));
    return true;
  }

  std::array<int, 4> facet_nodes(const Side& side) const {
    const std::vector<int> nodes = side_nodes(scene_.mesh.mesh, side);
    return {nodes[0], nodes[1], nodes[2], nodes[3]};
  }

  double modulus_behind(const SideSet& sides) const {
    for (const Body& body : scene_.bodies)
      if (std::binary_search(body.elements.begin(), body.elements.end(), sides.sides[0].element)) return body.youngs_modulus;
    throw std::logic_error("an element without a body");
  }

  double facet_areas(const ContactSurface& surface, const std::vector<int>& nodes, std::vector<double>& tributary) const {
    tributary.assign(nodes.size(), 0.0);
    double area = 0;
    for (const auto& facet : surface.facets) {
      std::array<Point, 4> X;
      for (int a = 0; a < 4; ++a) X[a] = scene_.mesh.mesh.coordinates[facet[a]];
      const auto w = side_weights<Quad4>(X);
      for (int a = 0; a < 4; ++a) {
        tributary[std::lower_bound(nodes.begin(), nodes.end(), facet[a]) - nodes.begin()] += w[a];
        area += w[a];
      }
    }
    return area;
  }

  const DeckNames& names_;
  const Scene& scene_;
  const DeckPath entry_;
  std::vector<std::string>& mesh_errors_;
};

}  // namespace

bool find_surfaces(const DeckNames& names, const Scene& scene, const std::string& list, const std::string& name,
                   const std::string& secondary, const std::string& primary, std::vector<std::string>& mesh_errors,
                   OppositeSurfaces& pair) {
  return SurfaceFinder(names, scene, list, name, mesh_errors).find(secondary, primary, pair);
}

void number_multipliers(Scene& scene, ContactNodes& nodes) {
  nodes.first_multiplier = scene.n_multipliers;
  scene.n_multipliers += static_cast<int>(nodes.secondary_nodes.size());
}

}  // namespace mortise
