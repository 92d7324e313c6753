// The element tangent with moduli by hand: what automatic differentiation at the quadrature points is measured against.
#pragma once

#include "assembly/element_tangent.hpp"
#include "physics/materials/materials.hpp"

namespace mortise::test {

/// As `quadrature_point_tangent`, with the moduli by hand.
template <class M>
bool analytic_tangent(const M& material, const Hex8Geometry& geometry, const double q[8][3], double f[8][3], double* K) {
  for (int g = 0; g < Hex8::n_points; ++g) {
    const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], q);
    if (!(det(F) > 0)) return false;
    Tensor3<double> P;
    double A[9][9];
    material.moduli(F, P, A);
    add_divergence(P, geometry.grad_N[g], geometry.JxW[g], f);
    add_moduli(A, geometry.grad_N[g], geometry.JxW[g], K);
  }
  return true;
}

}  // namespace mortise::test
