// The Ogden energy of the change of shape alone.
#pragma once

#include <vector>

#include "physics/materials/lift.hpp"
#include "physics/materials/principal_stretches.hpp"

namespace mortise {

/// One term of Ogden's energy: mu [Pa] and alpha [-], not 0.
struct OgdenTerm {
  double modulus;
  double exponent;
};

/// Ogden energy (thesis eq. 3.111) of the isochoric part J^(-1/3) F of the deformation, in the principal stretches lambda_a of F.
///   W(F) = sum_p mu_p / alpha_p (sum_a lambda_bar_a^alpha_p - 3),  lambda_bar_a = J^(-1/3) lambda_a
/// Any number of terms. All is computed in doubles, the derivatives by hand; AD scalars get them by `lift.hpp`, since derivatives
/// of eigenvalues lose their digits where two of them are nearly equal.
struct OgdenDistortional {
  static constexpr const char* incompressible_name = "ogden incompressible";
  std::vector<OgdenTerm> terms;

  /// Consistency condition (thesis eq. 3.112):  2 mu = sum_p mu_p alpha_p.
  double shear_modulus() const {
    double sum = 0;
    for (const OgdenTerm& term : terms) sum += term.modulus * term.exponent;
    return 0.5 * sum;
  }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    if constexpr (std::is_same_v<T, double>) {
      const Logarithms log_stretch(principal_stretches(F));
      double W = 0;
      for (const OgdenTerm& term : terms)
        for (double e : log_stretch.isochoric) W += term.modulus / term.exponent * std::expm1(term.exponent * e);
      return W;
    } else {
      return lifted_energy(*this, F);
    }
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = sum_a tau_a / lambda_a n_a (x) N_a  with the principal Kirchhoff stresses
  /// tau_a = sum_p mu_p (lambda_bar_a^alpha_p - mean over the three).  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    if constexpr (std::is_same_v<T, double>) {
      const PrincipalStretches s = principal_stretches(F);
      const Logarithms log_stretch(s);
      double stress[3] = {};
      for (const OgdenTerm& term : terms) {
        const Powers powers(log_stretch, term.exponent);
        for (int a = 0; a < 3; ++a) stress[a] += term.modulus * powers.deviation[a] / s.stretch[a];
      }
      return stress_along(s, stress);
    } else {
      return lifted_stress(*this, F);
    }
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa], with
  ///   d tau_a / d ln lambda_b = sum_p mu_p alpha_p (d_ab x_a - (x_a + x_b)/3 + mean/3),  x_a = lambda_bar_a^alpha_p.
  /// Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const PrincipalStretches s = principal_stretches(F);
    const Logarithms log_stretch(s);
    double tau[3] = {}, slope[3][3] = {}, quotient[3] = {};
    const double gap[3] = {relative_gap(s, 0), relative_gap(s, 1), relative_gap(s, 2)};
    double log_gap[3];
    for (int a = 0; a < 3; ++a) log_gap[a] = std::log1p(gap[a]);
    for (const OgdenTerm& term : terms) {
      const Powers powers(log_stretch, term.exponent);
      const double stiffness = term.modulus * term.exponent;
      for (int a = 0; a < 3; ++a) {
        tau[a] += term.modulus * powers.deviation[a];
        slope[a][a] += stiffness * powers.x[a];
        for (int b = 0; b < 3; ++b) slope[a][b] -= stiffness / 3 * (powers.x[a] + powers.deviation[b]);
        quotient[a] += term.modulus * powers.x[(a + 2) % 3] * power_quotient(term.exponent, gap[a], log_gap[a]);
      }
    }
    PrincipalModuli m;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      m.stress[a] = tau[a] / s.stretch[a];
      for (int d = 0; d < 3; ++d) m.curvature[a][d] = (slope[a][d] - (a == d) * tau[a]) / (s.stretch[a] * s.stretch[d]);
      // tau/lambda has the divided difference ((tau_b - tau_c)/(lambda_b - lambda_c) - tau_c/lambda_c) / lambda_b
      m.shear[a] = (quotient[a] - tau[c]) / (s.stretch[b] * s.stretch[c]);
    }
    P = stress_along(s, m.stress);
    moduli_along(s, m, A);
  }

 private:
  /// ln lambda_bar_a.
  struct Logarithms {
    double isochoric[3];
    explicit Logarithms(const PrincipalStretches& s) {
      for (int a = 0; a < 3; ++a) isochoric[a] = std::log(s.stretch[a]);
      const double mean = (isochoric[0] + isochoric[1] + isochoric[2]) / 3;
      for (double& e : isochoric) e -= mean;
    }
  };

  /// x_a = lambda_bar_a^alpha, and how far each is from their mean.
  struct Powers {
    double x[3], deviation[3];
    Powers(const Logarithms& log_stretch, double exponent) {
      for (int a = 0; a < 3; ++a) x[a] = std::exp(exponent * log_stretch.isochoric[a]);
      const double mean = (x[0] + x[1] + x[2]) / 3;
      for (int a = 0; a < 3; ++a) deviation[a] = x[a] - mean;
    }
  };

  /// (lambda_b - lambda_c) / lambda_c,  (a, b, c) cyclic.
  static double relative_gap(const PrincipalStretches& s, int a) {
    const double other = s.stretch[(a + 2) % 3];
    return (s.stretch[(a + 1) % 3] - other) / other;
  }

  /// ((1 + gap)^alpha - 1) / gap without cancellation, alpha at gap = 0: the divided difference of a power.
  static double power_quotient(double exponent, double gap, double log_gap) {
    return gap == 0 ? exponent : std::expm1(exponent * log_gap) / gap;
  }
};

}  // namespace mortise
