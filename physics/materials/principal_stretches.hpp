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
  PrincipalStretches s{{}, F, identity<double>()};
  bool is_orthogonal = false;
  for (int sweep = 0; sweep < largest_sweeps && !is_orthogonal; ++sweep) {
    is_orthogonal = true;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        double pp = 0, qq = 0, pq = 0;
        for (int i = 0; i < 3; ++i) {
          pp += s.n(i, p) * s.n(i, p);
          qq += s.n(i, q) * s.n(i, q);
          pq += s.n(i, p) * s.n(i, q);
        }
        if (pq * pq <= round_off * round_off * pp * qq) continue;
        is_orthogonal = false;
        const double half = 0.5 * (qq - pp);
        const double tangent = pq / (half + std::copysign(std::sqrt(half * half + pq * pq), half));
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
        for (Tensor3<double>* columns : {&s.n, &s.N})
          for (int i = 0; i < 3; ++i) {
            const double x_p = (*columns)(i, p), x_q = (*columns)(i, q);
            (*columns)(i, p) = cosine * x_p - sine * x_q;
            (*columns)(i, q) = sine * x_p + cosine * x_q;
          }
      }
  }
  for (int a = 0; a < 3; ++a) {
    s.stretch[a] = std::sqrt(s.n(0, a) * s.n(0, a) + s.n(1, a) * s.n(1, a) + s.n(2, a) * s.n(2, a));
    for (int i = 0; i < 3; ++i) s.n(i, a) /= s.stretch[a];
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
  double dyad[9][9], image[9][9];  // row 3 a + b: n_a (x) N_b, and the derivative of P in that direction
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
  for (int k = 0; k < 9; ++k)
    for (int l = 0; l < 9; ++l) {
      A[k][l] = 0;
      for (int r = 0; r < 9; ++r) A[k][l] += dyad[r][k] * image[r][l];
    }
}

}  // namespace mortise
