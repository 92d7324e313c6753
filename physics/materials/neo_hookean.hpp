// Compressible neo-Hookean solid with logarithmic volumetric energy.
#pragma once

#include "physics/materials/moduli.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Compressible neo-Hookean solid (thesis eq. 3.130; Bonet & Wood 2008, section 6.4.3).
///   W(F) = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2
struct NeoHookean {
  static constexpr const char* name = "neo-hookean";
  double shear_modulus;  ///< mu [Pa], > 0
  double lame_lambda;    ///< lambda [Pa]

  static NeoHookean from(const Moduli& m) { return {m.shear_modulus(), m.lame_lambda()}; }

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
    const T beta = (lame_lambda * log(J) - shear_modulus) / J;
    Tensor3<T> P = cofactor(F);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) P(i, j) = shear_modulus * F(i, j) + beta * P(i, j);
    return P;
  }
};

}  // namespace mortise
