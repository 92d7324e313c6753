// Saint Venant-Kirchhoff solid: Hooke's law between the Green-Lagrange strain and the second Piola-Kirchhoff stress.
#pragma once

#include "physics/materials/hooke.hpp"

namespace mortise {

/// Saint Venant-Kirchhoff solid (thesis eq. 3.106), E = (F^T F - I)/2. Softens and fails in strong compression: for moderate
/// strain.
///   W(F) = lambda/2 (tr E)^2 + mu E : E
struct SaintVenantKirchhoff : Hooke {
  static constexpr const char* name = "saint venant-kirchhoff";

  static SaintVenantKirchhoff from(const Moduli& m) { return {{m.shear_modulus(), m.lame_lambda()}}; }

  /// Strain energy per unit reference volume [J/m^3].
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    return energy(green_lagrange(F));
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = F S,  S = lambda tr E I + 2 mu E (thesis eq. 3.107).
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    return F * stress(green_lagrange(F));
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa], with B = F F^T (thesis eq. 3.108):
  ///   d_ik S_JL + lambda F_iJ F_kL + mu (F_iL F_kJ + B_ik d_JL)
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const Tensor3<double> S = stress(green_lagrange(F)), B = times_transpose(F, F);
    P = F * S;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            A[3 * i + j][3 * k + l] = lame_lambda * F(i, j) * F(k, l) + shear_modulus * F(i, l) * F(k, j);
        for (int m = 0; m < 3; ++m) {
          A[3 * i + j][3 * i + m] += S(j, m);
          A[3 * i + j][3 * m + j] += shear_modulus * B(i, m);
        }
      }
  }

 private:
  template <class T>
  static Tensor3<T> green_lagrange(const Tensor3<T>& F) {
    Tensor3<T> E = transpose_times(F, F);
    for (int i = 0; i < 3; ++i) {
      E(i, i) -= 1.0;
      for (int j = 0; j < 3; ++j) E(i, j) = 0.5 * E(i, j);
    }
    return E;
  }
};

}  // namespace mortise
