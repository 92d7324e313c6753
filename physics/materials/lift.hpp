// Carries what is known in doubles - energy, stress, moduli - over to scalars with first derivatives.
#pragma once

#include <type_traits>

#include "physics/tensor.hpp"

namespace mortise {

/// F without its derivatives.
template <class T>
Tensor3<double> values(const Tensor3<T>& F) {
  Tensor3<double> F_0;
  for (int k = 0; k < 9; ++k) F_0(k / 3, k % 3) = value(F(k / 3, k % 3));
  return F_0;
}

/// F - F_0: derivatives without a value.
template <class T>
Tensor3<T> increment(const Tensor3<T>& F, const Tensor3<double>& F_0) {
  Tensor3<T> dF;
  for (int k = 0; k < 9; ++k) dF(k / 3, k % 3) = F(k / 3, k % 3) - F_0(k / 3, k % 3);
  return dF;
}

/// W(F) = W_0 + P_0 : (F - F_0) [J/m^3] about the value F_0 of F: exact in value and first derivatives, which is all that an AD
/// scalar of first order or a complex step asks for.
template <class T, class Material>
T lifted_energy(const Material& material, const Tensor3<T>& F) {
  static_assert(std::is_same_v<typename T::value_type, double>, "a scalar with second derivatives would lose them");
  const Tensor3<double> F_0 = values(F), P_0 = material.first_piola(F_0);
  const Tensor3<T> dF = increment(F, F_0);
  T W = material.strain_energy(F_0);
  for (int k = 0; k < 9; ++k) W += P_0(k / 3, k % 3) * dF(k / 3, k % 3);
  return W;
}

/// P(F) = P_0 + A_0 : (F - F_0) [Pa], likewise.
template <class T, class Material>
Tensor3<T> lifted_stress(const Material& material, const Tensor3<T>& F) {
  static_assert(std::is_same_v<typename T::value_type, double>, "a scalar with second derivatives would lose them");
  const Tensor3<double> F_0 = values(F);
  Tensor3<double> P_0;
  double A_0[9][9];
  material.moduli(F_0, P_0, A_0);
  const Tensor3<T> dF = increment(F, F_0);
  Tensor3<T> P;
  for (int k = 0; k < 9; ++k) {
    T& P_k = P(k / 3, k % 3);
    P_k = P_0(k / 3, k % 3);
    for (int l = 0; l < 9; ++l) P_k += A_0[k][l] * dF(l / 3, l % 3);
  }
  return P;
}

}  // namespace mortise
