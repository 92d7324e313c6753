// Seeds Sacado for the stress at a quadrature point: nine directions, the entries of F.
#pragma once

#include <Sacado.hpp>

#include "physics/tensor.hpp"

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

}  // namespace mortise
