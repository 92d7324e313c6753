// Ogden solid: an energy in powers of the principal stretches, split into one of shape and one of volume.
#pragma once

#include "physics/materials/exponential_quotients.hpp"
#include "physics/materials/invariants.hpp"
#include "physics/materials/moduli.hpp"
#include "physics/materials/ogden_distortional.hpp"

namespace mortise {

/// Ogden solid with isochoric-volumetric split (thesis eq. 3.113; Holzapfel 2000, eqs. 6.137-6.139).
///   W(F) = W_iso(J^(-1/3) F) + kappa (ln J / beta + (J^(-beta) - 1) / beta^2)
/// At beta = 0 the second part is its limit kappa/2 (ln J)^2. It is not the volumetric energy of the mixed elements, which
/// therefore do not take this solid.
struct Ogden {
  static constexpr const char* name = "ogden";
  OgdenDistortional isochoric;
  double bulk_modulus;         ///< kappa [Pa], > 0
  double volumetric_exponent;  ///< beta [-]

  Moduli small_strain() const { return Moduli::from_bulk_and_shear(bulk_modulus, isochoric.shear_modulus()); }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::log;
    const T log_J = log(det(F)), exponent = -volumetric_exponent * log_J;
    return isochoric.strain_energy(F) + bulk_modulus * log_J * log_J * second_exponential_quotient(exponent);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = P_iso + kappa/beta (1 - J^(-beta)) F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::log;
    const T J = det(F), log_J = log(J), exponent = -volumetric_exponent * log_J;
    Tensor3<T> P = isochoric.first_piola(F);
    add_to(P, T(bulk_modulus * log_J * exponential_quotient(exponent) / J), cofactor(F));
    return P;
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa].  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F), log_J = std::log(J), exponent = -volumetric_exponent * log_J;
    const double pressure = log_J * exponential_quotient(exponent);  // in kappa / J
    isochoric.moduli(F, P, A);
    add_moduli_of_volume(F, bulk_modulus * pressure / J, bulk_modulus * (std::exp(exponent) - pressure) / (J * J), P, A);
  }
};

}  // namespace mortise
