// A force per mass on an element.
#pragma once

#include "physics/elements/geometry.hpp"

namespace mortise {

/// Adds the nodal forces [N] of a force per mass b [m/s^2]:  f_a = int N_a rho b dV, by the element's mass rule.
/// @param X reference positions of the nodes [m]  @param density rho, mass per reference volume [kg/m^3]
/// @param b called with the reference position of each point of the rule  @param f 3 n_nodes values, node by node
template <class Element, class Acceleration>
void add_body_force(const ElementNodes<Element>& X, double density, const Acceleration& b, double* f) {
  for (const auto& point : Element::mass_rule) {
    std::array<double, 3> at{};
    for (int a = 0; a < Element::n_nodes; ++a)
      for (int i = 0; i < 3; ++i) at[i] += Element::N(a, point.xi) * X[a][i];
    const double mass = density * point.weight * det(element_map<Element>(X, point.xi));
    const std::array<double, 3> force_per_mass = b(at);
    for (int a = 0; a < Element::n_nodes; ++a)
      for (int i = 0; i < 3; ++i) f[3 * a + i] += Element::N(a, point.xi) * force_per_mass[i] * mass;
  }
}

}  // namespace mortise
