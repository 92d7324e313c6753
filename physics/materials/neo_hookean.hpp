// Compressible neo-Hookean solid with logarithmic volumetric energy.
#pragma once

#include "physics/materials/invariants.hpp"
#include "physics/materials/moduli.hpp"

namespace mortise {

/// Compressible neo-Hookean solid (thesis eq. 3.130; Bonet & Wood 2008, section 6.4.3).
///   W(F) = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2
struct NeoHookean {
  static constexpr const char* name = "neo-hookean";
  double shear_modulus;  ///< mu [Pa], > 0
  double lame_lambda;    ///< lambda [Pa]

  static NeoHookean from(const Moduli& m) { return {m.shear_modulus(), m.lame_lambda()}; }
  Moduli small_strain() const { return Moduli::from_shear_and_lambda(shear_modulus, lame_lambda); }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::log;  // so that Sacado's log is found for AD types
    const T log_J = log(det(F));
    return 0.5 * shear_modulus * (norm_squared(F) - 3.0) - shear_modulus * log_J + 0.5 * lame_lambda * log_J * log_J;
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = mu F + (lambda ln J - mu) F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::log;
    const T J = det(F);
    const T W_J = (lame_lambda * log(J) - shear_modulus) / J;
    return stress_of_first_invariant(F, T(0.5 * shear_modulus), W_J);
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] by the chain rule of invariants.hpp.  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F), W_J = (lame_lambda * std::log(J) - shear_modulus) / J;
    moduli_of_first_invariant(F, 0.5 * shear_modulus, W_J, 0, (lame_lambda / J - W_J) / J, P, A);
  }
};

}  // namespace mortise
