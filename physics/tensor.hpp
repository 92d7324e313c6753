// Vectors and second-order tensors in three dimensions, over any scalar: double, a forward-AD type, complex numbers.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <type_traits>

namespace mortise {

/// The plain value of a scalar: itself for double, the innermost value for (nested) AD types, the real part of a complex step.
inline double value(const std::complex<double>& x) { return x.real(); }
template <class T>
double value(const T& x) {
  if constexpr (std::is_arithmetic_v<T>) {
    return x;
  } else {
    return value(x.val());
  }
}

template <class T>
struct Vec3 {
  T v[3];
  T& operator[](int i) { return v[i]; }
  const T& operator[](int i) const { return v[i]; }
};

/// A vector from its components, as decks and meshes have them.
inline Vec3<double> vec3(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a[0] + b[0]), T(a[1] + b[1]), T(a[2] + b[2])};
}

template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}

template <class T>
Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {T(s * a[0]), T(s * a[1]), T(s * a[2])};
}

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}

/// Euclidean length. Its derivative at the zero vector does not exist: callers keep away from it.
template <class T>
T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Second-order tensor; `(i, j)` is row i, column j.
template <class T>
struct Tensor3 {
  T a[3][3];
  T& operator()(int i, int j) { return a[i][j]; }
  const T& operator()(int i, int j) const { return a[i][j]; }
};

template <class T>
Tensor3<T> identity() {
  return {{{T(1.0), T(0.0), T(0.0)}, {T(0.0), T(1.0), T(0.0)}, {T(0.0), T(0.0), T(1.0)}}};
}

template <class T>
T det(const Tensor3<T>& F) {
  return F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) - F(0, 1) * (F(1, 0) * F(2, 2) - F(1, 2) * F(2, 0)) +
         F(0, 2) * (F(1, 0) * F(2, 1) - F(1, 1) * F(2, 0));
}

/// Cofactor tensor, cof F = det(F) F^-T.
template <class T>
Tensor3<T> cofactor(const Tensor3<T>& F) {
  Tensor3<T> c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c(i, j) = F(i1, j1) * F(i2, j2) - F(i1, j2) * F(i2, j1);
    }
  }
  return c;
}

/// Tensor cross product (Bonet, Gil & Ortigosa 2015): bilinear, symmetric in A and B, and cof F = F x F / 2, so that
/// d(cof F) = F x dF  and  (A x B) : C = A : (B x C).
template <class T>
Tensor3<T> tensor_cross(const Tensor3<T>& A, const Tensor3<T>& B) {
  Tensor3<T> c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c(i, j) = A(i1, j1) * B(i2, j2) - A(i1, j2) * B(i2, j1) + B(i1, j1) * A(i2, j2) - B(i1, j2) * A(i2, j1);
    }
  }
  return c;
}

/// F : F, the sum of the squares of the entries; equals tr C for a deformation gradient.
template <class T>
T norm_squared(const Tensor3<T>& F) {
  T sum = F(0, 0) * F(0, 0);
  for (int k = 1; k < 9; ++k) sum += F(k / 3, k % 3) * F(k / 3, k % 3);
  return sum;
}

/// A : B, the sum of the products of the entries.
template <class T>
T double_dot(const Tensor3<T>& A, const Tensor3<T>& B) {
  T sum = A(0, 0) * B(0, 0);
  for (int k = 1; k < 9; ++k) sum += A(k / 3, k % 3) * B(k / 3, k % 3);
  return sum;
}

/// s A.
template <class T>
Tensor3<T> scaled(const T& s, const Tensor3<T>& A) {
  Tensor3<T> B;
  for (int k = 0; k < 9; ++k) B(k / 3, k % 3) = s * A(k / 3, k % 3);
  return B;
}

/// A + B.
template <class T>
Tensor3<T> sum(const Tensor3<T>& A, const Tensor3<T>& B) {
  Tensor3<T> C;
  for (int k = 0; k < 9; ++k) C(k / 3, k % 3) = A(k / 3, k % 3) + B(k / 3, k % 3);
  return C;
}

/// A B.
template <class T>
Tensor3<T> operator*(const Tensor3<T>& A, const Tensor3<T>& B) {
  Tensor3<T> C;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j) + A(i, 2) * B(2, j);
  return C;
}

/// A^T B.
template <class T>
Tensor3<T> transpose_times(const Tensor3<T>& A, const Tensor3<T>& B) {
  Tensor3<T> C;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C(i, j) = A(0, i) * B(0, j) + A(1, i) * B(1, j) + A(2, i) * B(2, j);
  return C;
}

/// A B^T.
template <class T>
Tensor3<T> times_transpose(const Tensor3<T>& A, const Tensor3<T>& B) {
  Tensor3<T> C;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C(i, j) = A(i, 0) * B(j, 0) + A(i, 1) * B(j, 1) + A(i, 2) * B(j, 2);
  return C;
}

}  // namespace mortise
