#include "make_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "mesh/contact_sides.hpp"
#include "physics/traction.hpp"

namespace mortise {
namespace {

class PairMaker {
 public:
  PairMaker(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings)
      : names_(names), scene_(scene), mesh_errors_(mesh_errors), warnings_(warnings) {}

  void make() {
    std::map<int, std::string> secondary_of;
    for (const auto& [name, o] : names_.deck().options().contact) {
      const auto* secondary = names_.sides_of(o.secondary, {"contact", name, "secondary"});
      const auto* primary = names_.sides_of(o.primary, {"contact", name, "primary"});
      if (!secondary || !primary) continue;
      const bool is_sound = is_contact_surface(*secondary, {"contact", name, "secondary"});
      if (!is_contact_surface(*primary, {"contact", name, "primary"}) || !is_sound) continue;
      const bool is_bilinear = are_quadrilaterals(*secondary, {"contact", name, "secondary"});
      if (!are_quadrilaterals(*primary, {"contact", name, "primary"}) || !is_bilinear) continue;
      ContactPair pair;
      pair.name = name;
      pair.where_penetrating = names_.deck().error("M51", {"contact", name}, "");
      pair.quadrature_degree = o.quadrature_degree;
      pair.closing = o.closing;
      pair.activity = o.activity;
      if (o.friction.acts()) {
        pair.friction = friction_of(o.friction, {"contact", name, o.friction.law()});
        pair.n_unknowns = 4;
      }
      for (const Side& side : secondary->sides) {
        pair.secondary.facets.push_back(facet_nodes(side));
        pair.secondary_elements.push_back(side.element);
      }
      for (const Side& side : primary->sides) pair.primary.facets.push_back(facet_nodes(side));
      pair.secondary_nodes = pair.secondary.nodes();
      const auto primary_nodes = pair.primary.nodes();
      std::vector<int> shared;
      std::set_intersection(pair.secondary_nodes.begin(), pair.secondary_nodes.end(), primary_nodes.begin(), primary_nodes.end(),
                            std::back_inserter(shared));
      if (!shared.empty()) {
        names_.error(
            "D19", {"contact", name},
            fmt::format("secondary and primary share {} nodes (first: {}) - two surfaces without common nodes are needed",
                        shared.size(), describe_node(scene_.mesh, shared[0])));
        continue;
      }
      pair.first_multiplier = scene_.n_multipliers;
      scene_.n_multipliers += static_cast<int>(pair.secondary_nodes.size());
      for (int node : pair.secondary_nodes) {
        const auto [at, is_new] = secondary_of.insert({node, name});
        if (is_new) continue;
        names_.error("D19", {"contact", name, "secondary"},
                     fmt::format("{} is on the secondary side of \"{}\" too - swap the sides of one pair",
                                 describe_node(scene_.mesh, node), at->second));
        break;
      }
      const double area = facet_areas(pair.secondary, pair.secondary_nodes, pair.tributary_area);
      pair.size = std::sqrt(area / pair.secondary.facets.size());
      std::vector<double> unused;
      pair.primary_size = std::sqrt(facet_areas(pair.primary, primary_nodes, unused) / pair.primary.facets.size());
      pair.youngs_modulus = modulus_behind(*secondary);
      const double opposite_modulus = modulus_behind(*primary);
      pair.opposite_compliance = pair.primary_size / opposite_modulus;
      if (pair.size > 3 * pair.primary_size)
        warnings_.push_back(
            fmt::format("contact > {}: the secondary side is coarser than the primary side (facets of {:.3g} and {:.3g}) - swap "
                        "them for a sharper pressure",
                        name, pair.size, pair.primary_size));
      constexpr double much_stiffer = 100;
      if (pair.youngs_modulus > much_stiffer * opposite_modulus && pair.size >= pair.primary_size)
        warnings_.push_back(
            fmt::format("contact > {}: the secondary side is much stiffer than the primary side (Young's moduli of {:.3g} and "
                        "{:.3g}), and not finer - best the softer side is the secondary one",
                        name, pair.youngs_modulus, opposite_modulus));
      scene_.pairs.push_back(std::move(pair));
    }
  }

 private:
  bool is_contact_surface(const SideSet& sides, const DeckPath& path) {
    const auto faults = contact_surface_faults(scene_.mesh, sides);
    for (const auto& fault : faults) mesh_errors_.push_back(names_.deck().error(fault.code, path, fault.text));
    return faults.empty();
  }

  bool are_quadrilaterals(const SideSet& sides, const DeckPath& path) {
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

  Friction friction_of(const FrictionOptions& o, const DeckPath& path) const {
    const auto placed = [&](const NumberOrFormula& value, const std::vector<std::string>& variables) {
      using Placed = std::variant<double, PlacedFormula>;
      if (const double* number = std::get_if<double>(&value)) return Placed(*number);
      return Placed(names_.formula(std::get<std::string>(value), path, variables));
    };
    Friction friction{friction::Coulomb{}, o.tangential_penalty, o.slip_regularisation, o.slip};
    if (o.bound) {
      friction.law = friction::Tresca{placed(*o.bound, friction_bound_variables)};
    } else {
      friction.law = friction::Coulomb{placed(*o.coefficient, friction_coefficient_variables)};
    }
    return friction;
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
  Scene& scene_;
  std::vector<std::string>&mesh_errors_, &warnings_;
};

}  // namespace

void make_pairs(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings) {
  PairMaker(names, scene, mesh_errors, warnings).make();
}

}  // namespace mortise
