// The stress of energy-momentum schemes: its work over a time step is the difference of the strain energy, exactly.
//
//   P* = F_m S*,   S* = S_m + gamma dC,   gamma = (2 (W_1 - W_n) - S_m : dC) / |dC|^2     (thesis eq. 5.61; Gonzalez 2000)
//
// with F_m = (F_n + F_1)/2, C_m = (C_n + C_1)/2, dC = C_1 - C_n = 2 sym(F_m^T dF) and S_m = S(C_m) = 2 dW/dC(C_m). Then
// P* : dF = S* : dC / 2 = W_1 - W_n, and since S* is symmetric and F_m that of the mean positions, moments about them balance.
// Subscripts n and 1 are the beginning and the end of the step.
//
// Any objective law serves: it sees C through its upper triangular Cholesky factor, U^T U = C, for which S(C) = U^-1 P(U).
#pragma once

#include "physics/cholesky_factor.hpp"
#include "physics/materials/lift.hpp"

namespace mortise {

/// Second Piola-Kirchhoff stress S(C) = 2 dW/dC [Pa] of an objective law. @param C symmetric and positive definite [-]
template <class T, class Law>
Tensor3<T> second_piola(const Law& law, const Tensor3<T>& C) {
  const CholeskyFactor<T> factor(C);
  return factor.symmetric_solution(law.first_piola(factor.U));
}

/// Kinematics of a step.
template <class T>
struct StrainStep {
  Tensor3<T> F_m;  ///< mean deformation gradient
  Tensor3<T> C_m;  ///< mean of the right Cauchy-Green tensors, which is not F_m^T F_m
  Tensor3<T> dC;   ///< their difference, from that of the deformation gradients, so that it keeps its digits

  StrainStep(const Tensor3<double>& F_n, const Tensor3<T>& F_1) {
    Tensor3<T> dF;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        dF(i, j) = F_1(i, j) - F_n(i, j);
        F_m(i, j) = F_n(i, j) + 0.5 * dF(i, j);
      }
    const Tensor3<T> half = transpose_times(F_m, dF);
    C_m = transpose_times(F_m, F_m);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) {
        dC(i, j) = half(i, j) + half(j, i);
        C_m(i, j) += 0.25 * (dF(0, i) * dF(0, j) + dF(1, i) * dF(1, j) + dF(2, i) * dF(2, j));
        dC(j, i) = dC(i, j);
        C_m(j, i) = C_m(i, j);
      }
  }

  /// C_m + t dC.
  Tensor3<T> at(double t) const {
    Tensor3<T> C;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) C(i, j) = C_m(i, j) + t * dC(i, j);
    return C;
  }
};

/// How the energy of a step is found, so that gamma dC does not suffer from W_1 - W_n being small.
enum class EnergyDifference {
  negligible,  ///< gamma dC is below round-off
  quadrature,  ///< 2 (W_1 - W_n) = int S(C_m + t dC) : dC dt, by three Gauss points of which C_m is one
  direct       ///< of the two energies
};

/// The choice, by the strain of the step  rho = sqrt(tr (C_m^-1 dC)^2)  [-], the norm of dC in the metric C_m. Errors, relative
/// to moduli times strains of order one:
///   negligible   |gamma dC| = c_2 rho^2,   c_2 = 0.1 ... 3:    below 3e-16 for rho < 1e-8
///   quadrature   truncation c_6 rho^6,     c_6 = 4e-4 ... 0.3: below 5e-15 for rho < 5e-3; round-off eps
///   direct       round-off of W over rho:                      below 2e-13 for rho > 5e-3; no other
/// The smaller c are those of S ~ C^-1, the greater of S ~ J^-9 C^-1, Ogden's volumetric term, the steepest of the materials.
/// Five points would reach rho = 0.1, but cost more than the two energies.
inline EnergyDifference energy_difference(const Tensor3<double>& C_m, const Tensor3<double>& dC) {
  constexpr double smallest = 1e-8, greatest = 5e-3;
  const Tensor3<double> M = cofactor(C_m) * dC;
  const double J = det(C_m);
  double trace = 0;  // of M^2
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) trace += M(i, j) * M(j, i);
  if (trace < smallest * smallest * J * J) return EnergyDifference::negligible;
  return trace < greatest * greatest * J * J ? EnergyDifference::quadrature : EnergyDifference::direct;
}

/// 2 (W_1 - W_n) - S_m : dC  [J/m^3]: what gamma divides. By quadrature its round-off is eps |S| |dC|.
template <class T, class Law>
T energy_excess(const Law& law, const Tensor3<double>& F_n, const Tensor3<T>& F_1, const StrainStep<T>& step,
                const Tensor3<T>& S_m, EnergyDifference kind) {
  if (kind == EnergyDifference::quadrature) {
    constexpr double t = 0.38729833462074168852, weight = 5. / 18;  // sqrt(3/20)
    const Tensor3<T> S_ahead = second_piola(law, step.at(t)), S_behind = second_piola(law, step.at(-t));
    T excess = 0.0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) excess += ((S_ahead(i, j) - S_m(i, j)) + (S_behind(i, j) - S_m(i, j))) * step.dC(i, j);
    return weight * excess;
  }
  if constexpr (std::is_same_v<T, double>) {
    return 2 * (law.strain_energy(F_1) - law.strain_energy(F_n)) - double_dot(S_m, step.dC);
  } else {
    return 2.0 * (lifted_energy(law, F_1) - law.strain_energy(F_n)) - double_dot(S_m, step.dC);
  }
}

/// Algorithmic first Piola-Kirchhoff stress P* = F_m S* [Pa] over a step (thesis eq. 5.61), with the energy found as told.
/// @param F_n, F_1 deformation gradients with positive determinants [-]
/// `kind` depends on values alone: derivatives are those of the formula in use.
template <class T, class Law>
Tensor3<T> algorithmic_first_piola(const Law& law, const Tensor3<double>& F_n, const Tensor3<T>& F_1, const StrainStep<T>& step,
                                   EnergyDifference kind) {
  Tensor3<T> S = second_piola(law, step.C_m);
  if (kind != EnergyDifference::negligible) {
    const T gamma = energy_excess(law, F_n, F_1, step, S, kind) / norm_squared(step.dC);
    for (int k = 0; k < 9; ++k) S(k / 3, k % 3) += gamma * step.dC(k / 3, k % 3);
  }
  return step.F_m * S;
}

/// The same with the energy found as suits the step.
template <class T, class Law>
Tensor3<T> algorithmic_first_piola(const Law& law, const Tensor3<double>& F_n, const Tensor3<T>& F_1) {
  const StrainStep<T> step(F_n, F_1);
  return algorithmic_first_piola(law, F_n, F_1, step, energy_difference(values(step.C_m), values(step.dC)));
}

/// Adds to A = dP*/dF_1 what gamma and its derivative give, and gamma dC to S. With dC_1 = 2 sym(F_1^T dF_1),
///   d(gamma dC) = gamma dC_1 + dC (h : dC_1),   h = dgamma/dC_1 = (S_1 - S_m - 1/2 dS/dC(C_m) : dC - 2 gamma dC) / |dC|^2:
/// since W_1 has the derivative S_1 / 2 the stress of one more point is all that is needed, and no other moduli.
/// @param dS dS/dC(C_m) : dC [Pa]
template <class Law>
void add_moduli_of_energy_excess(const Law& law, const Tensor3<double>& F_n, const Tensor3<double>& F_1,
                                 const StrainStep<double>& step, const Tensor3<double>& dS, EnergyDifference kind,
                                 Tensor3<double>& S, double A[9][9]) {
  const Tensor3<double>&F_m = step.F_m, &dC = step.dC;
  const double square = norm_squared(dC), gamma = energy_excess(law, F_n, F_1, step, S, kind) / square;
  const Tensor3<double> S_1 = second_piola(law, step.at(0.5));
  Tensor3<double> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      h(i, j) = ((S_1(i, j) - S(i, j) - 0.5 * dS(i, j)) - 2 * gamma * dC(i, j)) / square;
      S(i, j) += gamma * dC(i, j);
    }
  const Tensor3<double> along = F_m * dC, slope = scaled(2.0, F_1 * h), B = scaled(gamma, times_transpose(F_m, F_1));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double* row = A[3 * i + j];
      for (int k = 0; k < 3; ++k) {
        const double turn = gamma * F_1(k, j);
        for (int l = 0; l < 3; ++l) row[3 * k + l] += along(i, j) * slope(k, l) + turn * F_m(i, l);
        row[3 * k + j] += B(i, k);
      }
    }
}

/// A_iJkL = R_iq D_qJrL Q_kr.
inline void transform(const Tensor3<double>& R, const double D[9][9], const Tensor3<double>& Q, double A[9][9]) {
  double half[9][9];  // D_qJrL Q_kr
  for (int qJ = 0; qJ < 9; ++qJ)
    for (int L = 0; L < 3; ++L) {
      const double d_0 = D[qJ][L], d_1 = D[qJ][3 + L], d_2 = D[qJ][6 + L];
      half[qJ][L] = d_0 * Q(0, 0) + d_1 * Q(0, 1) + d_2 * Q(0, 2);
      half[qJ][3 + L] = d_0 * Q(1, 0) + d_1 * Q(1, 1) + d_2 * Q(1, 2);
      half[qJ][6 + L] = d_0 * Q(2, 0) + d_1 * Q(2, 1) + d_2 * Q(2, 2);
    }
  for (int J = 0; J < 3; ++J)
    for (int kL = 0; kL < 9; ++kL) {
      const double d_0 = half[J][kL], d_1 = half[3 + J][kL], d_2 = half[6 + J][kL];
      A[J][kL] = R(0, 0) * d_0 + R(0, 1) * d_1 + R(0, 2) * d_2;
      A[3 + J][kL] = R(1, 0) * d_0 + R(1, 1) * d_1 + R(1, 2) * d_2;
      A[6 + J][kL] = R(2, 0) * d_0 + R(2, 1) * d_1 + R(2, 2) * d_2;
    }
}

/// P* and its derivative A[3 i + J][3 k + L] = dP*_iJ/dF_1,kL [Pa], which is not symmetric. With the law's moduli at U, less the
/// part of its stress, D = A(U) - 1 (x) S_m, and R = F U^-1,
///   A = 1/2 1 (x) S* + 1/2 R_m D R_1^T + what gamma adds.
/// The derivative of `direct` is exact; that of `quadrature` differs from it by the derivative of the truncation, 2e-11 at most,
/// and by round-off in h: eps |S| / |dC|.
template <class Law>
void algorithmic_moduli(const Law& law, const Tensor3<double>& F_n, const Tensor3<double>& F_1, Tensor3<double>& P,
                        double A[9][9]) {
  const StrainStep<double> step(F_n, F_1);
  const CholeskyFactor<double> factor(step.C_m);
  double D[9][9];
  law.moduli(factor.U, P, D);
  Tensor3<double> S = factor.symmetric_solution(P);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 3; ++l) D[3 * i + j][3 * i + l] -= S(j, l);

  const Tensor3<double> R_m = scaled(0.5, factor.times_inverse(step.F_m)), R_1 = factor.times_inverse(F_1);
  transform(R_m, D, R_1, A);
  const EnergyDifference kind = energy_difference(step.C_m, step.dC);
  if (kind != EnergyDifference::negligible) {
    const Tensor3<double> X = factor.transposed_solution(step.dC);
    Tensor3<double> dP;
    for (int q = 0; q < 3; ++q)
      for (int J = 0; J < 3; ++J) {
        const double* row = D[3 * q + J];
        double sum = 0;
        for (int r = 0; r < 3; ++r) sum += row[3 * r] * X(r, 0) + row[3 * r + 1] * X(r, 1) + row[3 * r + 2] * X(r, 2);
        dP(q, J) = 0.5 * sum;
      }
    add_moduli_of_energy_excess(law, F_n, F_1, step, factor.symmetric_solution(dP), kind, S, A);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 3; ++l) A[3 * i + j][3 * i + l] += 0.5 * S(j, l);
  P = step.F_m * S;
}

}  // namespace mortise
