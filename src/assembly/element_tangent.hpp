// Seeds Sacado for element residuals: the tangent at two levels of automatic differentiation, from one source.
#pragma once

#include <Sacado.hpp>

#include "physics/internal_force.hpp"

namespace mortise {

/// Derivative of the first Piola-Kirchhoff stress at one point: A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa], with P.
template <class Material>
void stress_and_moduli(const Material& material, const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) {
  // The caching kind takes one logarithm per expression instead of one per direction; 10, not 9, because pairs are vectorised.
  using Fad = Sacado::CacheFad::SFad<double, 10>;
  Tensor3<Fad> F_ad;  // derivatives start at zero
  for (int k = 0; k < 9; ++k) {
    F_ad(k / 3, k % 3).val() = F(k / 3, k % 3);
    F_ad(k / 3, k % 3).fastAccessDx(k) = 1;
  }
  const Tensor3<Fad> P_ad = material.first_piola(F_ad);
  for (int k = 0; k < 9; ++k) {
    P(k / 3, k % 3) = P_ad(k / 3, k % 3).val();
    for (int l = 0; l < 9; ++l) A[k][l] = P_ad(k / 3, k % 3).fastAccessDx(l);
  }
}

/// Adds the share of one Gauss point to the element tangent: K_ai,bk += grad_N_a,J A_iJkL grad_N_b,L JxW  [N/m], 24 x 24
/// row-major.
inline void add_moduli(const double A[9][9], const double grad_N[8][3], double JxW, double* K) {
  for (int b = 0; b < 8; ++b) {
    double T[9][3];
    for (int iJ = 0; iJ < 9; ++iJ)
      for (int k = 0; k < 3; ++k)
        T[iJ][k] = JxW * (A[iJ][3 * k] * grad_N[b][0] + A[iJ][3 * k + 1] * grad_N[b][1] + A[iJ][3 * k + 2] * grad_N[b][2]);
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          K[24 * (3 * a + i) + 3 * b + k] +=
              grad_N[a][0] * T[3 * i][k] + grad_N[a][1] * T[3 * i + 1][k] + grad_N[a][2] * T[3 * i + 2][k];
  }
}

/// Element internal force f [N] and tangent K = df/dq [N/m] by AD at the quadrature points (9 directions): the default.
/// Both are added to. @return false for an inadmissible state
template <class Material>
bool quadrature_point_tangent(const Material& material, const Hex8Geometry& geometry, const double q[8][3], double f[8][3],
                              double* K) {
  for (int g = 0; g < Hex8::n_points; ++g) {
    const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], q);
    if (!(det(F) > 0)) return false;
    Tensor3<double> P;
    double A[9][9];
    stress_and_moduli(material, F, P, A);
    add_divergence(P, geometry.grad_N[g], geometry.JxW[g], f);
    add_moduli(A, geometry.grad_N[g], geometry.JxW[g], K);
  }
  return true;
}

/// The same by AD of the whole element (24 directions): the cross-check.
template <class Material>
bool whole_element_tangent(const Material& material, const Hex8Geometry& geometry, const double q[8][3], double f[8][3],
                           double* K) {
  using Fad = Sacado::Fad::SFad<double, 24>;
  Fad q_ad[8][3], f_ad[8][3];
  for (int k = 0; k < 24; ++k) {
    q_ad[k / 3][k % 3] = Fad(24, k, q[k / 3][k % 3]);
    f_ad[k / 3][k % 3] = 0.0;
  }
  if (!add_internal_force(material, geometry, q_ad, f_ad)) return false;
  for (int k = 0; k < 24; ++k) {
    f[k / 3][k % 3] += f_ad[k / 3][k % 3].val();
    for (int l = 0; l < 24; ++l) K[24 * k + l] += f_ad[k / 3][k % 3].fastAccessDx(l);
  }
  return true;
}

}  // namespace mortise
