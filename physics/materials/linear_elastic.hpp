// Linear elastic solid: Hooke's law between the linearised strain and the stress.
#pragma once

#include "physics/materials/hooke.hpp"

namespace mortise {

/// Linear elastic solid (thesis eq. 3.102), e = sym(F - I). For small strain *and* small rotation: a rotation without strain
/// stores energy, since e is not invariant under it.
///   W(F) = lambda/2 (tr e)^2 + mu e : e
struct LinearElastic : Hooke {
  static constexpr const char* name = "linear elastic";

  static LinearElastic from(const Moduli& m) { return {{m.shear_modulus(), m.lame_lambda()}}; }

  /// Strain energy per unit reference volume [J/m^3].
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    return energy(linearised_strain(F));
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa], at small strain the same as any other:  P = lambda tr e I + 2 mu e.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    return stress(linearised_strain(F));
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa]:  lambda d_iJ d_kL + mu (d_ik d_JL + d_iL d_kJ).
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    P = first_piola(F);
    for (int k = 0; k < 9; ++k)
      for (int l = 0; l < 9; ++l) A[k][l] = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        A[4 * i][4 * j] += lame_lambda;
        A[3 * i + j][3 * i + j] += shear_modulus;
        A[3 * i + j][3 * j + i] += shear_modulus;
      }
  }

 private:
  template <class T>
  static Tensor3<T> linearised_strain(const Tensor3<T>& F) {
    Tensor3<T> e;
    for (int i = 0; i < 3; ++i) {
      e(i, i) = F(i, i) - 1.0;
      for (int j = 0; j < i; ++j) e(i, j) = e(j, i) = T(0.5 * (F(i, j) + F(j, i)));
    }
    return e;
  }
};

}  // namespace mortise
