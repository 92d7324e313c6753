// Linear elastic solid: Hooke's law between the linearised strain and the stress.
#pragma once

#include "physics/materials/moduli.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Linear elastic solid (thesis eq. 3.102), e = sym(F - I). For small strain *and* small rotation: a rotation without strain
/// stores energy, since e is not invariant under it.
///   W(F) = lambda/2 (tr e)^2 + mu e : e
struct LinearElastic {
  static constexpr const char* name = "linear elastic";
  double shear_modulus;  ///< mu     [Pa], > 0
  double lame_lambda;    ///< lambda [Pa]

  static LinearElastic from(const Moduli& m) { return {m.shear_modulus(), m.lame_lambda()}; }
  Moduli small_strain() const { return Moduli::from_shear_and_lambda(shear_modulus, lame_lambda); }

  /// Strain energy per unit reference volume [J/m^3].
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    const Tensor3<T> e = linearised_strain(F);
    const T trace = e(0, 0) + e(1, 1) + e(2, 2);
    return 0.5 * lame_lambda * trace * trace + shear_modulus * norm_squared(e);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa], at small strain the same as any other:  P = lambda tr e I + 2 mu e.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    Tensor3<T> P = linearised_strain(F);
    const T pressure = lame_lambda * (P(0, 0) + P(1, 1) + P(2, 2));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) P(i, j) = 2.0 * shear_modulus * P(i, j);
    for (int i = 0; i < 3; ++i) P(i, i) += pressure;
    return P;
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
