// The mass matrix of one element, by the kind that the deck names.
#pragma once

#include <array>

#include "deck/damping_options.hpp"
#include "physics/elements/geometry.hpp"

namespace mortise {

/// int N_a N_b dV [m^3], n x n row-major. @param X reference positions [m]
template <class Element>
std::array<double, Element::n_nodes * Element::n_nodes> mass_over_density(MassKind kind, const ElementNodes<Element>& X) {
  if (kind == MassKind::stiffness_rule) return mass_matrix<Element>(X, Element::stiffness_rule);
  const auto consistent = mass_matrix<Element>(X, Element::mass_rule);
  if (kind == MassKind::consistent) return consistent;
  std::array<double, Element::n_nodes * Element::n_nodes> diagonal{};
  const auto lumped = lumped_mass<Element>(consistent);
  for (std::size_t a = 0; a < lumped.size(); ++a) diagonal[a * (Element::n_nodes + 1)] = lumped[a];
  return diagonal;
}

}  // namespace mortise
