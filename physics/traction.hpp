// Dead traction on a side of an element: force per unit reference area in a fixed direction.
#pragma once

#include "physics/elements/sides.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Tangents dx/dxi and dx/deta [m] of a side at a local point. @param x positions of its nodes [m]
template <class Side, class T>
std::array<Vec3<T>, 2> side_tangents(const std::array<std::array<T, 3>, Side::n_nodes>& x, const LocalPoint& xi) {
  std::array<Vec3<T>, 2> tangents;
  for (auto& tangent : tangents)
    for (int i = 0; i < 3; ++i) tangent[i] = 0.0;
  for (int a = 0; a < Side::n_nodes; ++a) {
    const LocalPoint dN = Side::dN_dxi(a, xi);
    for (int k = 0; k < 2; ++k)
      for (int i = 0; i < 3; ++i) tangents[k][i] += dN[k] * x[a][i];
  }
  return tangents;
}

/// Nodal weights W_a = int N_a dA [m^2] of a side in the reference configuration; the force on node a is W_a t.
/// @param X positions of the nodes [m], in the side's order
template <class Side>
std::array<double, Side::n_nodes> side_weights(const std::array<std::array<double, 3>, Side::n_nodes>& X) {
  std::array<double, Side::n_nodes> weights{};
  for (const auto& point : Side::rule) {
    const auto [along, across] = side_tangents<Side>(X, point.xi);
    const double dA = point.weight * norm(cross(along, across));
    for (int a = 0; a < Side::n_nodes; ++a) weights[a] += Side::N(a, point.xi) * dA;
  }
  return weights;
}

}  // namespace mortise
