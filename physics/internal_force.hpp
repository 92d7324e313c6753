// What a quadrature point gives to an element: deformation gradient, forces, stiffness.
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// Deformation gradient F = sum_a q_a (x) grad_N_a at one quadrature point. @param q current nodal positions [m], n x 3
template <int n, class T>
Tensor3<T> deformation_gradient(const double (&grad_N)[n][3], const T* q) {
  Tensor3<T> F;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      F(i, j) = q[i] * grad_N[0][j];
      for (int a = 1; a < n; ++a) F(i, j) += q[3 * a + i] * grad_N[a][j];
    }
  return F;
}

/// Adds the share of one quadrature point to the internal force:  f_a += P grad_N_a JxW  [N]  (thesis eq. 4.15).
template <int n, class T>
void add_divergence(const Tensor3<T>& P, const double (&grad_N)[n][3], double JxW, T* f) {
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) f[3 * a + i] += JxW * (P(i, 0) * grad_N[a][0] + P(i, 1) * grad_N[a][1] + P(i, 2) * grad_N[a][2]);
}

/// Adds the share of one quadrature point to the stiffness:  K_ai,bk += grad_N_a,J A_iJkL grad_N_b,L JxW  [N/m]  for b >= a only;
/// `mirror` completes it. A, the derivative of a stress that has an energy, is symmetric.
/// @param K rows of length `width`, the positions first
template <int n>
void add_moduli(const double A[9][9], const double (&grad_N)[n][3], double JxW, double* K, int width) {
  for (int a = 0; a < n; ++a) {
    double T[3][9];  // grad_N_a,J A_iJkL JxW
    const double w0 = JxW * grad_N[a][0], w1 = JxW * grad_N[a][1], w2 = JxW * grad_N[a][2];
    for (int i = 0; i < 3; ++i)
      for (int kL = 0; kL < 9; ++kL) T[i][kL] = w0 * A[3 * i][kL] + w1 * A[3 * i + 1][kL] + w2 * A[3 * i + 2][kL];
    for (int i = 0; i < 3; ++i) {
      double* row = K + (3 * a + i) * width;
      for (int b = a; b < n; ++b)
        for (int k = 0; k < 3; ++k)
          row[3 * b + k] += T[i][3 * k] * grad_N[b][0] + T[i][3 * k + 1] * grad_N[b][1] + T[i][3 * k + 2] * grad_N[b][2];
    }
  }
}

/// Copies the upper triangle of the leading m x m part to the lower one.
inline void mirror(int m, double* K, int width) {
  for (int r = 1; r < m; ++r)
    for (int c = 0; c < r; ++c) K[r * width + c] = K[c * width + r];
}

/// The sum over quadrature points of  grad_N_a,J A_iJkL grad_N_b,L JxW  [N/m]  for moduli without symmetry.
/// All nodes b of a pair i, k stand side by side, an even number of them, so that they are taken two at a time.
template <int n>
class UnsymmetricStiffness {
 public:
  void add(const double A[9][9], const double (&grad_N)[n][3], double JxW) {
    double g[3][width];  // grad_N_b,L JxW
    for (int L = 0; L < 3; ++L)
      for (int b = 0; b < width; ++b) g[L][b] = b < n ? JxW * grad_N[b][L] : 0;
    for (int i = 0; i < 3; ++i) {
      double T[3][3 * width];  // A_iJkL grad_N_b,L JxW
      for (int J = 0; J < 3; ++J)
        for (int k = 0; k < 3; ++k) {
          const double* A_k = A[3 * i + J] + 3 * k;
          const double A_0 = A_k[0], A_1 = A_k[1], A_2 = A_k[2];
          for (int b = 0; b < width; ++b) T[J][k * width + b] = A_0 * g[0][b] + A_1 * g[1][b] + A_2 * g[2][b];
        }
      for (int a = 0; a < n; ++a) {
        const double g_0 = grad_N[a][0], g_1 = grad_N[a][1], g_2 = grad_N[a][2];
        for (int kb = 0; kb < 3 * width; ++kb) sum_[a][i][kb] += g_0 * T[0][kb] + g_1 * T[1][kb] + g_2 * T[2][kb];
      }
    }
  }

  /// K_ai,bk += the sum. @param K rows of length `row_length`, the positions first
  void add_to(double* K, int row_length) const {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        double* row = K + (3 * a + i) * row_length;
        const double* sum = sum_[a][i];
        for (int b = 0; b < n; ++b) {
          row[3 * b] += sum[b];
          row[3 * b + 1] += sum[width + b];
          row[3 * b + 2] += sum[2 * width + b];
        }
      }
  }

 private:
  static constexpr int width = n + n % 2;
  double sum_[n][3][3 * width] = {};
};

}  // namespace mortise
