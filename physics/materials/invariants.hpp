// Stress and moduli of energies W(I1, I2, J) of the principal invariants, by the chain rule (thesis eqs. 3.98, 3.99).
//
//   I1 = F : F,  I2 = cof F : cof F,  J = det F,
//   dI1/dF = 2 F,  dI2/dF = 2 (I1 F - F C),  dJ/dF = cof F,
// for energies that are linear in I1 and I2, with factors that may depend on J. Subscripts are derivatives: W_1 = dW/dI1 [Pa].
// Moduli are A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa].
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// I2(C) = I2(F^T F).
template <class T>
T second_invariant(const Tensor3<T>& F) {
  return norm_squared(cofactor(F));
}

/// dI2/dF = 2 (I1 F - F C), found as 2 (cof F) x F with half as many products.
template <class T>
Tensor3<T> second_invariant_slope(const Tensor3<T>& F) {
  Tensor3<T> slope = tensor_cross(cofactor(F), F);
  for (int k = 0; k < 9; ++k) slope(k / 3, k % 3) *= 2.0;
  return slope;
}

/// First Piola-Kirchhoff stress [Pa] of W(I1, J):  P = 2 W_1 F + W_J cof F.
template <class T>
Tensor3<T> stress_of_first_invariant(const Tensor3<T>& F, const T& W_1, const T& W_J) {
  Tensor3<T> P = cofactor(F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) P(i, j) = 2.0 * W_1 * F(i, j) + W_J * P(i, j);
  return P;
}

/// Adds  factor B  to P.
template <class T>
void add_scaled(Tensor3<T>& P, const T& factor, const Tensor3<T>& B) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) P(i, j) += factor * B(i, j);
}

/// P and A of W(J):  P = W_J K,  A = W_JJ K (x) K + W_J dK/dF  with K = cof F,  dK_iJ/dF_kL = (K_iJ K_kL - K_iL K_kJ) / J.
/// Both are added to.
inline void add_moduli_of_volume(const Tensor3<double>& F, double W_J, double W_JJ, Tensor3<double>& P, double A[9][9]) {
  const Tensor3<double> K = cofactor(F);
  const double turn = W_J / det(F), square = W_JJ + turn;
  add_scaled(P, W_J, K);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) A[3 * i + j][3 * k + l] += square * K(i, j) * K(k, l) - turn * K(i, l) * K(k, j);
}

/// P and A of W(I1, J):  A = 2 W_1 1 + 2 W_1J (F (x) K + K (x) F) + what W_J and W_JJ add (see `add_moduli_of_volume`).
inline void moduli_of_first_invariant(const Tensor3<double>& F, double W_1, double W_J, double W_1J, double W_JJ,
                                      Tensor3<double>& P, double A[9][9]) {
  const Tensor3<double> K = cofactor(F);
  const double turn = W_J / det(F), square = W_JJ + turn;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      P(i, j) = 2 * W_1 * F(i, j) + W_J * K(i, j);
      const double along_K = square * K(i, j) + 2 * W_1J * F(i, j), along_F = 2 * W_1J * K(i, j);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) A[3 * i + j][3 * k + l] = along_K * K(k, l) + along_F * F(k, l) - turn * K(i, l) * K(k, j);
    }
  for (int k = 0; k < 9; ++k) A[k][k] += 2 * W_1;
}

/// Adds to P and A what a term of W that is linear in I2 gives, but for W_J and W_JJ:  P += W_2 G  with G = dI2/dF,
///   A += W_2J (G (x) K + K (x) G) + W_2 dG/dF,
///   dG_iJ/dF_kL = 2 (2 F_iJ F_kL - F_iL F_kJ + I1 d_ik d_JL - d_ik C_JL - B_ik d_JL),  B = F F^T.
inline void add_moduli_of_second_invariant(const Tensor3<double>& F, double W_2, double W_2J, Tensor3<double>& P,
                                           double A[9][9]) {
  const Tensor3<double> K = cofactor(F), G = second_invariant_slope(F), C = transpose_times(F, F), B = times_transpose(F, F);
  const double I1 = norm_squared(F);
  add_scaled(P, W_2, G);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          A[3 * i + j][3 * k + l] +=
              W_2J * (G(i, j) * K(k, l) + K(i, j) * G(k, l)) + 2 * W_2 * (2 * F(i, j) * F(k, l) - F(i, l) * F(k, j));
      for (int m = 0; m < 3; ++m) {
        A[3 * i + j][3 * i + m] -= 2 * W_2 * C(j, m);
        A[3 * i + j][3 * m + j] -= 2 * W_2 * B(i, m);
      }
      A[3 * i + j][3 * i + j] += 2 * W_2 * I1;
    }
}

}  // namespace mortise
