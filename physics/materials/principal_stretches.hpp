// Principal stretches and directions, and what isotropic materials make of them.
#pragma once

#include <cmath>

#include "physics/tensor.hpp"

namespace mortise {

/// F = sum_a stretch[a] n_a (x) N_a: stretches > 0, in no order; directions are the columns of `n` (current) and `N` (reference).
struct PrincipalStretches {
  double stretch[3];
  Tensor3<double> n, N;
};

/// Principal stretches by one-sided Jacobi rotations (Hestenes 1958): the columns of F N are turned until they are orthogonal.
/// Since F^T F is never formed, also small stretches have all their digits, and directions are orthogonal to round-off however
/// near stretches are to each other. @param F with det F > 0
inline PrincipalStretches principal_stretches(const Tensor3<double>& F) {
  constexpr double round_off = 1e-15;
  constexpr int largest_sweeps = 20;  // quadratic convergence: 4 or 5 are used
  double column[3][6];                // of F N, and below it of N
  for (int p = 0; p < 3; ++p)
    for (int i = 0; i < 3; ++i) {
      column[p][i] = F(i, p);
      column[p][3 + i] = i == p;
    }
  bool is_orthogonal = false;
  for (int sweep = 0; sweep < largest_sweeps && !is_orthogonal; ++sweep) {
    is_orthogonal = true;
    for (int pair = 0; pair < 3; ++pair) {
      double *x = column[pair], *y = column[(pair + 1) % 3];
      const double xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2],
                   xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
      if (xy * xy <= round_off * round_off * xx * yy) continue;
      is_orthogonal = false;
      const double half = 0.5 * (yy - xx);
      const double tangent = xy / (half + std::copysign(std::sqrt(half * half + xy * xy), half));
      const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
      for (int i = 0; i < 6; ++i) {
        const double x_i = x[i], y_i = y[i];
        x[i] = cosine * x_i - sine * y_i;
        y[i] = sine * x_i + cosine * y_i;
      }
    }
  }
  PrincipalStretches s;
  for (int a = 0; a < 3; ++a) {
    const double* x = column[a];
    s.stretch[a] = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int i = 0; i < 3; ++i) {
      s.n(i, a) = x[i] / s.stretch[a];
      s.N(i, a) = x[3 + i];
    }
  }
  return s;
}

/// P = sum_a stress[a] n_a (x) N_a. @param stress dW/dlambda_a [Pa]
inline Tensor3<double> stress_along(const PrincipalStretches& s, const double stress[3]) {
  Tensor3<double> P;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      P(i, j) = stress[0] * s.n(i, 0) * s.N(j, 0) + stress[1] * s.n(i, 1) * s.N(j, 1) + stress[2] * s.n(i, 2) * s.N(j, 2);
  return P;
}

/// Derivatives of an isotropic energy W(lambda_1, lambda_2, lambda_3) by the principal stretches [Pa].
struct PrincipalModuli {
  double stress[3];        ///< P_a = dW/dlambda_a
  double curvature[3][3];  ///< dP_a/dlambda_b
  double shear[3];         ///< (P_b - P_c) / (lambda_b - lambda_c), or its limit; (a, b, c) cyclic
};

/// A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] of an isotropic material (Smith, Goes & Kim 2019, "Analytic eigensystems"): in the
/// dyads n_a (x) N_b stretches act among themselves by `curvature`; a pair b, c is sheared by `shear` and twisted by
/// (P_b + P_c) / (lambda_b + lambda_c), which has no singular limit.
inline void moduli_along(const PrincipalStretches& s, const PrincipalModuli& m, double A[9][9]) {
  double image[9][9];  // row 3 a + b: the derivative of P in the direction n_a (x) N_b
  double dyad[9][9];   // row 3 a + b: n_a (x) N_b
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) dyad[3 * a + b][3 * i + j] = s.n(i, a) * s.N(j, b);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3, bc = 3 * b + c, cb = 3 * c + b;
    const double twist = (m.stress[b] + m.stress[c]) / (s.stretch[b] + s.stretch[c]);
    const double same = 0.5 * (m.shear[a] + twist), other = 0.5 * (m.shear[a] - twist);
    for (int k = 0; k < 9; ++k) {
      image[4 * a][k] = m.curvature[a][0] * dyad[0][k] + m.curvature[a][1] * dyad[4][k] + m.curvature[a][2] * dyad[8][k];
      image[bc][k] = same * dyad[bc][k] + other * dyad[cb][k];
      image[cb][k] = same * dyad[cb][k] + other * dyad[bc][k];
    }
  }
  // A = sum_ab n_a (x) N_b (x) image_ab, one index after the other: half the work of summing dyads.
  for (int i = 0; i < 3; ++i) {
    double turned[3][9];  // sum_a n_ia image_ab
    for (int b = 0; b < 3; ++b)
      for (int l = 0; l < 9; ++l)
        turned[b][l] = s.n(i, 0) * image[b][l] + s.n(i, 1) * image[3 + b][l] + s.n(i, 2) * image[6 + b][l];
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 9; ++l)
        A[3 * i + j][l] = s.N(j, 0) * turned[0][l] + s.N(j, 1) * turned[1][l] + s.N(j, 2) * turned[2][l];
  }
}

}  // namespace mortise
