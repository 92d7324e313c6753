#include "make_pairs.hpp"

#include <fmt/format.h>

#include <map>

#include "mesh/combine.hpp"
#include "opposite_surfaces.hpp"

namespace mortise {
namespace {

Friction friction_of(const DeckNames& names, const FrictionOptions& o, const DeckPath& path) {
  const auto placed = [&](const NumberOrFormula& value, const std::vector<std::string>& variables) {
    using Placed = std::variant<double, PlacedFormula>;
    if (const double* number = std::get_if<double>(&value)) return Placed(*number);
    return Placed(names.formula(std::get<std::string>(value), path, variables));
  };
  Friction friction{friction::Coulomb{}, o.tangential_penalty, o.slip_regularisation, o.slip};
  if (o.bound) {
    friction.law = friction::Tresca{placed(*o.bound, friction_bound_variables)};
  } else {
    friction.law = friction::Coulomb{placed(*o.coefficient, friction_coefficient_variables)};
  }
  return friction;
}

}  // namespace

void make_pairs(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings) {
  std::map<int, std::string> secondary_of;
  for (const auto& [name, o] : names.deck().options().contact) {
    ContactPair pair;
    if (!find_surfaces(names, scene, "contact", name, o.secondary, o.primary, mesh_errors, pair)) continue;
    pair.where_penetrating = names.deck().error("M51", {"contact", name}, "");
    pair.quadrature_degree = o.quadrature_degree;
    pair.force = o.force;
    pair.has_frozen_integrals = o.has_frozen_integrals;
    pair.enforcement = o.enforcement;
    pair.penalty = o.normal_penalty.value_or(0);
    pair.largest_penetration = o.largest_penetration.value_or(1e-6 * pair.size);
    pair.function = o.function;
    pair.closing = o.closing;
    pair.activity = o.activity;
    if (o.friction.acts()) {
      pair.friction = friction_of(names, o.friction, {"contact", name, o.friction.law()});
      pair.n_unknowns = 4;
    }
    number_multipliers(scene, pair);
    for (int node : pair.secondary_nodes) {
      const auto [at, is_new] = secondary_of.insert({node, name});
      if (is_new) continue;
      names.error("D19", {"contact", name, "secondary"},
                  fmt::format("{} is on the secondary side of \"{}\" too - swap the sides of one pair",
                              describe_node(scene.mesh, node), at->second));
      break;
    }
    if (pair.size > 3 * pair.primary_size)
      warnings.push_back(
          fmt::format("contact > {}: the secondary side is coarser than the primary side (facets of {:.3g} and {:.3g}) - swap "
                      "them for a sharper pressure",
                      name, pair.size, pair.primary_size));
    const double opposite_modulus = pair.primary_size / pair.opposite_compliance;
    constexpr double much_stiffer = 100;
    if (pair.youngs_modulus > much_stiffer * opposite_modulus && pair.size >= pair.primary_size)
      warnings.push_back(
          fmt::format("contact > {}: the secondary side is much stiffer than the primary side (Young's moduli of {:.3g} and "
                      "{:.3g}), and not finer - best the softer side is the secondary one",
                      name, pair.youngs_modulus, opposite_modulus));
    scene.pairs.push_back(std::move(pair));
  }
}

}  // namespace mortise
