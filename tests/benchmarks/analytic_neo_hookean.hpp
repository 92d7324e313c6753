// The neo-Hookean element tangent by hand: what automatic differentiation at the quadrature points is measured against.
#pragma once

#include "assembly/element_tangent.hpp"
#include "physics/materials/neo_hookean.hpp"

namespace mortise::test {

/// P and dP/dF of `NeoHookean` in closed form, with G = F^-T:
///   dP_iJ/dF_kL = mu d_ik d_JL + lambda G_iJ G_kL + (mu - lambda ln J) G_iL G_kJ
inline void analytic_stress_and_moduli(const NeoHookean& material, const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) {
  const double mu = material.shear_modulus, lambda = material.lame_lambda, J = det(F), log_J = std::log(J),
               turn = mu - lambda * log_J;
  Tensor3<double> G = cofactor(F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      G(i, j) /= J;
      P(i, j) = mu * F(i, j) - turn * G(i, j);
    }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) A[3 * i + j][3 * k + l] = lambda * G(i, j) * G(k, l) + turn * G(i, l) * G(k, j);
  for (int k = 0; k < 9; ++k) A[k][k] += mu;
}

/// As `quadrature_point_tangent`, with the moduli by hand.
inline bool analytic_tangent(const NeoHookean& material, const Hex8Geometry& geometry, const double q[8][3], double f[8][3],
                             double* K) {
  for (int g = 0; g < Hex8::n_points; ++g) {
    const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], q);
    if (!(det(F) > 0)) return false;
    Tensor3<double> P;
    double A[9][9];
    analytic_stress_and_moduli(material, F, P, A);
    add_divergence(P, geometry.grad_N[g], geometry.JxW[g], f);
    add_moduli(A, geometry.grad_N[g], geometry.JxW[g], K);
  }
  return true;
}

}  // namespace mortise::test
