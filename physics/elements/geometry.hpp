// The reference geometry of an element: gradients and volumes at quadrature points, volumes, mass matrix.
#pragma once

#include "physics/elements/quadrature.hpp"
#include "physics/tensor.hpp"

namespace mortise {

template <class Element>
using ElementNodes = std::array<std::array<double, 3>, Element::n_nodes>;

/// dX/dxi [m] at a local point. @param X reference positions of the nodes [m]
template <class Element>
Tensor3<double> element_map(const ElementNodes<Element>& X, const std::array<double, 3>& xi) {
  Tensor3<double> dX_dxi{};
  for (int a = 0; a < Element::n_nodes; ++a) {
    const auto dN = Element::dN_dxi(a, xi);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) dX_dxi(i, j) += X[a][i] * dN[j];
  }
  return dX_dxi;
}

/// grad_N_a = dN_a/dX [1/m] of all nodes at a local point, and det dX/dxi.
template <class Element>
double reference_gradients(const ElementNodes<Element>& X, const std::array<double, 3>& xi, double grad_N[][3]) {
  const Tensor3<double> dX_dxi = element_map<Element>(X, xi), cof = cofactor(dX_dxi);
  const double J = det(dX_dxi);
  for (int a = 0; a < Element::n_nodes; ++a) {
    const auto dN = Element::dN_dxi(a, xi);
    for (int i = 0; i < 3; ++i) grad_N[a][i] = (cof(i, 0) * dN[0] + cof(i, 1) * dN[1] + cof(i, 2) * dN[2]) / J;
  }
  return J;
}

/// What an element keeps of its reference configuration: grad_N = dN/dX [1/m] and JxW [m^3] at each point of its stiffness rule.
template <class Element>
struct ElementGeometry {
  static constexpr int n_points = static_cast<int>(Element::stiffness_rule.size());
  double grad_N[n_points][Element::n_nodes][3];
  double JxW[n_points];
};

/// Reference geometry of one element from its nodal positions X [m].
/// JxW <= 0 at some point means an inverted element: meshes are checked for that when they are read.
template <class Element>
ElementGeometry<Element> reference_geometry(const ElementNodes<Element>& X) {
  ElementGeometry<Element> geometry;
  for (int g = 0; g < geometry.n_points; ++g) {
    const auto& point = Element::stiffness_rule[g];
    geometry.JxW[g] = point.weight * reference_gradients<Element>(X, point.xi, geometry.grad_N[g]);
  }
  return geometry;
}

/// Volume of the reference element [m^3].
template <class Element>
double volume(const ElementGeometry<Element>& geometry) {
  double sum = 0;
  for (double w : geometry.JxW) sum += w;
  return sum;
}

/// M_ab = int N_a N_b dV [m^3] by a rule on the element, n x n row-major: times the density it is the consistent mass.
/// The Hex8 stiffness rule (2 x 2 x 2) is the thesis', `Element::mass_rule` is exact for straight-edged elements.
template <class Element, std::size_t n>
std::array<double, Element::n_nodes * Element::n_nodes> mass_matrix(const ElementNodes<Element>& X,
                                                                    const std::array<QuadraturePoint, n>& rule) {
  std::array<double, Element::n_nodes * Element::n_nodes> M{};
  for (const auto& point : rule) {
    const double dV = point.weight * det(element_map<Element>(X, point.xi));
    for (int a = 0; a < Element::n_nodes; ++a)
      for (int b = 0; b < Element::n_nodes; ++b)
        M[a * Element::n_nodes + b] += Element::N(a, point.xi) * Element::N(b, point.xi) * dV;
  }
  return M;
}

/// Lumped mass per node [m^3], positive for every element: the diagonal of the consistent matrix, scaled to the element's volume
/// (Hinton, Rock & Zienkiewicz 1976). Row sums would give corners of quadratic elements negative masses.
template <class Element>
std::array<double, Element::n_nodes> lumped_mass(const std::array<double, Element::n_nodes * Element::n_nodes>& M) {
  std::array<double, Element::n_nodes> lumped{};
  double total = 0, trace = 0;
  for (double entry : M) total += entry;
  for (int a = 0; a < Element::n_nodes; ++a) trace += M[a * (Element::n_nodes + 1)];
  for (int a = 0; a < Element::n_nodes; ++a) lumped[a] = M[a * (Element::n_nodes + 1)] * total / trace;
  return lumped;
}

}  // namespace mortise
