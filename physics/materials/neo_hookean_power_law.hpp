// Compressible neo-Hookean solid whose volumetric energy is a power of J.
#pragma once

#include "physics/materials/exponential_quotients.hpp"
#include "physics/materials/invariants.hpp"
#include "physics/materials/moduli.hpp"

namespace mortise {

/// Compressible neo-Hookean solid with power-law volumetric energy (Holzapfel 2000, eq. 6.148).
///   W(F) = c (tr C - 3) + c/beta (J^(-2 beta) - 1),  c = mu/2,  beta = lambda / (2 mu) = nu / (1 - 2 nu)
/// At nu = 0 the second part is its limit -2 c ln J.
struct NeoHookeanPowerLaw {
  static constexpr const char* name = "neo-hookean power-law";
  double shear_modulus;        ///< mu [Pa], > 0
  double volumetric_exponent;  ///< beta [-], > -1/3

  static NeoHookeanPowerLaw from(const Moduli& m) { return {m.shear_modulus(), m.lame_lambda() / (2 * m.shear_modulus())}; }
  Moduli small_strain() const { return Moduli::from_shear_and_lambda(shear_modulus, 2 * shear_modulus * volumetric_exponent); }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::log;
    const T log_J = log(det(F)), exponent = -2.0 * volumetric_exponent * log_J;
    return 0.5 * shear_modulus * (norm_squared(F) - 3.0) - shear_modulus * log_J * exponential_quotient(exponent);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = mu F - mu J^(-2 beta) F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::pow;
    const T W_J = -shear_modulus * pow(det(F), -2.0 * volumetric_exponent - 1.0);
    return stress_of_first_invariant(F, T(0.5 * shear_modulus), W_J);
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] by the chain rule of invariants.hpp.  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F), power = 2 * volumetric_exponent + 1, W_J = -shear_modulus * std::pow(J, -power);
    moduli_of_first_invariant(F, 0.5 * shear_modulus, W_J, 0, -power * W_J / J, P, A);
  }
};

}  // namespace mortise
