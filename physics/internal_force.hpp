// The internal force of an element: the one statement from which residual and tangent are made.
#pragma once

#include "physics/elements/hex8.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Deformation gradient F = sum_a q_a (x) grad_N_a at one Gauss point. @param q current nodal positions [m]
template <class T>
Tensor3<T> deformation_gradient(const double grad_N[8][3], const T q[8][3]) {
  Tensor3<T> F;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      F(i, j) = q[0][i] * grad_N[0][j];
      for (int a = 1; a < 8; ++a) F(i, j) += q[a][i] * grad_N[a][j];
    }
  return F;
}

/// Adds the share of one Gauss point to the internal force:  f_a += P grad_N_a JxW  [N]  (thesis eq. 4.15).
template <class T>
void add_divergence(const Tensor3<T>& P, const double grad_N[8][3], double JxW, T f[8][3]) {
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) f[a][i] += JxW * (P(i, 0) * grad_N[a][0] + P(i, 1) * grad_N[a][1] + P(i, 2) * grad_N[a][2]);
}

/// Internal force of one element, f_a = sum_g P(F_g) grad_N_a JxW_g [N], added to `f`.
/// @param q current nodal positions [m]
/// @return false if det F <= 0 at a Gauss point: an inadmissible state, `f` is then of no use
template <class T, class Material>
bool add_internal_force(const Material& material, const Hex8Geometry& geometry, const T q[8][3], T f[8][3]) {
  for (int g = 0; g < Hex8::n_points; ++g) {
    const Tensor3<T> F = deformation_gradient(geometry.grad_N[g], q);
    if (!(value(T(det(F))) > 0)) return false;
    add_divergence(material.first_piola(F), geometry.grad_N[g], geometry.JxW[g], f);
  }
  return true;
}

/// Strain energy of one element [J]; the state must be admissible (det F > 0).
template <class T, class Material>
T strain_energy(const Material& material, const Hex8Geometry& geometry, const T q[8][3]) {
  T energy = 0.0;
  for (int g = 0; g < Hex8::n_points; ++g)
    energy += geometry.JxW[g] * material.strain_energy(deformation_gradient(geometry.grad_N[g], q));
  return energy;
}

/// Cauchy stress sigma = P F^T / J [Pa] at Gauss point g.
template <class Material>
Tensor3<double> cauchy_stress(const Material& material, const Hex8Geometry& geometry, int g, const double q[8][3]) {
  const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], q);
  const double J = det(F);
  Tensor3<double> sigma = times_transpose(material.first_piola(F), F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sigma(i, j) /= J;
  return sigma;
}

/// Von Mises stress sqrt(3/2 s : s) [Pa], s the deviator of sigma.
inline double von_mises(const Tensor3<double>& sigma) {
  const double d0 = sigma(0, 0) - sigma(1, 1), d1 = sigma(1, 1) - sigma(2, 2), d2 = sigma(2, 2) - sigma(0, 0);
  const double shear = sigma(0, 1) * sigma(0, 1) + sigma(1, 2) * sigma(1, 2) + sigma(0, 2) * sigma(0, 2);
  return std::sqrt(0.5 * (d0 * d0 + d1 * d1 + d2 * d2) + 3 * shear);
}

}  // namespace mortise
