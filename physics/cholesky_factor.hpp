// The upper triangular factor of a symmetric and positive definite tensor.
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// Right Cauchy-Green tensor C = U^T U by Cholesky, U upper triangular: a deformation gradient for laws that ask for one.
template <class T>
struct CholeskyFactor {
  Tensor3<T> U;
  T reciprocal[3];  ///< 1 / U_ii

  /// @param C symmetric and positive definite [-]
  explicit CholeskyFactor(const Tensor3<T>& C) {
    using std::sqrt;
    const T zero = 0.0;
    U(1, 0) = U(2, 0) = U(2, 1) = zero;
    U(0, 0) = sqrt(C(0, 0));
    reciprocal[0] = 1.0 / U(0, 0);
    U(0, 1) = C(0, 1) * reciprocal[0];
    U(0, 2) = C(0, 2) * reciprocal[0];
    U(1, 1) = sqrt(C(1, 1) - U(0, 1) * U(0, 1));
    reciprocal[1] = 1.0 / U(1, 1);
    U(1, 2) = (C(1, 2) - U(0, 1) * U(0, 2)) * reciprocal[1];
    U(2, 2) = sqrt(C(2, 2) - U(0, 2) * U(0, 2) - U(1, 2) * U(1, 2));
    reciprocal[2] = 1.0 / U(2, 2);
  }

  /// U^-1 B, of which symmetry leaves the lower triangle to be found. @param B such that U^-1 B is symmetric
  Tensor3<T> symmetric_solution(const Tensor3<T>& B) const {
    Tensor3<T> S;
    for (int j = 0; j < 3; ++j) S(2, j) = B(2, j) * reciprocal[2];
    for (int j = 0; j < 2; ++j) S(1, j) = (B(1, j) - U(1, 2) * S(2, j)) * reciprocal[1];
    S(0, 0) = (B(0, 0) - U(0, 1) * S(1, 0) - U(0, 2) * S(2, 0)) * reciprocal[0];
    S(0, 1) = S(1, 0);
    S(0, 2) = S(2, 0);
    S(1, 2) = S(2, 1);
    return S;
  }

  /// U^-T B.
  Tensor3<T> transposed_solution(const Tensor3<T>& B) const {
    Tensor3<T> X;
    for (int j = 0; j < 3; ++j) {
      X(0, j) = B(0, j) * reciprocal[0];
      X(1, j) = (B(1, j) - U(0, 1) * X(0, j)) * reciprocal[1];
      X(2, j) = (B(2, j) - U(0, 2) * X(0, j) - U(1, 2) * X(1, j)) * reciprocal[2];
    }
    return X;
  }

  /// B U^-1.
  Tensor3<T> times_inverse(const Tensor3<T>& B) const {
    Tensor3<T> X;
    for (int i = 0; i < 3; ++i) {
      X(i, 0) = B(i, 0) * reciprocal[0];
      X(i, 1) = (B(i, 1) - X(i, 0) * U(0, 1)) * reciprocal[1];
      X(i, 2) = (B(i, 2) - X(i, 0) * U(0, 2) - X(i, 1) * U(1, 2)) * reciprocal[2];
    }
    return X;
  }
};

}  // namespace mortise
