// Measures of stress and strain at a point, from the deformation gradient F and the first Piola-Kirchhoff stress P.
#pragma once

#include <Eigen/Eigenvalues>
#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// Cauchy stress sigma = P F^T / J [Pa]: force per current area (thesis eq. 3.49). Needs J = det F > 0, as all that divides by J.
inline Tensor3<double> cauchy_stress(const Tensor3<double>& P, const Tensor3<double>& F) {
  const double J = det(F);
  Tensor3<double> sigma = times_transpose(P, F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sigma(i, j) /= J;
  return sigma;
}

/// Kirchhoff stress tau = J sigma = P F^T [Pa] (thesis eq. 3.52): conjugate to the rate of deformation, per reference volume.
inline Tensor3<double> kirchhoff_stress(const Tensor3<double>& P, const Tensor3<double>& F) { return times_transpose(P, F); }

/// Second Piola-Kirchhoff stress S = F^-1 P [Pa] (thesis eq. 3.51): conjugate to the Green-Lagrange strain.
inline Tensor3<double> second_piola_stress(const Tensor3<double>& P, const Tensor3<double>& F) {
  return scaled(1 / det(F), transpose_times(cofactor(F), P));  // F^-1 = (cof F)^T / J
}

/// Green-Lagrange strain E = (F^T F - I) / 2 [-] (thesis eq. 3.21): of the reference configuration, zero for any rotation.
inline Tensor3<double> green_lagrange_strain(const Tensor3<double>& F) {
  return scaled(0.5, sum(transpose_times(F, F), scaled(-1.0, identity<double>())));
}

/// Euler-Almansi strain e = (I - F^-T F^-1) / 2 [-] (thesis eq. 3.23): of the current configuration, E = F^T e F.
inline Tensor3<double> almansi_strain(const Tensor3<double>& F) {
  const Tensor3<double> inverse_transpose = scaled(1 / det(F), cofactor(F));
  return scaled(0.5, sum(identity<double>(), scaled(-1.0, times_transpose(inverse_transpose, inverse_transpose))));
}

/// Von Mises stress sqrt(3/2 s : s) [Pa], s the deviator of sigma.
inline double von_mises(const Tensor3<double>& sigma) {
  const double d0 = sigma(0, 0) - sigma(1, 1), d1 = sigma(1, 1) - sigma(2, 2), d2 = sigma(2, 2) - sigma(0, 0);
  const double shear = sigma(0, 1) * sigma(0, 1) + sigma(1, 2) * sigma(1, 2) + sigma(0, 2) * sigma(0, 2);
  return std::sqrt(0.5 * (d0 * d0 + d1 * d1 + d2 * d2) + 3 * shear);
}

/// Eigenvalues of a symmetric tensor, and unit vectors along its axes.
struct PrincipalAxes {
  std::array<double, 3> values;            ///< greatest first
  std::array<Vec3<double>, 3> directions;  ///< of the values, orthogonal; not always right-handed
};

/// A = sum_k values_k directions_k (x) directions_k (thesis eq. 3.39). Of the two unit vectors along an axis it is the one whose
/// first component that is not small (above 1e-6) is positive, so that neighbouring points agree. Where values coincide, the axes
/// to them are any orthogonal ones. @param A symmetric: the lower triangle is read
inline PrincipalAxes principal_axes(const Tensor3<double>& A) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) matrix(i, j) = A(i, j);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);  // smallest first
  PrincipalAxes axes;
  for (int k = 0; k < 3; ++k) {
    axes.values[k] = solver.eigenvalues()[2 - k];
    const Eigen::Vector3d v = solver.eigenvectors().col(2 - k);
    int i = 0;
    while (i < 2 && std::abs(v[i]) <= 1e-6) ++i;
    const double sign = v[i] < 0 ? -1 : 1;
    axes.directions[k] = {sign * v[0], sign * v[1], sign * v[2]};
  }
  return axes;
}

}  // namespace mortise
