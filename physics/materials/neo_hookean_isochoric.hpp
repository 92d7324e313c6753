// Neo-Hookean solid split into isochoric and volumetric energy.
#pragma once

#include "physics/materials/moduli.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Neo-Hookean solid with isochoric-volumetric split (thesis eq. 3.96 with a quadratic volumetric energy).
///   W(F) = mu/2 (J^(-2/3) tr C - 3) + kappa/2 (J - 1)^2
struct NeoHookeanIsochoric {
  static constexpr const char* name = "neo-hookean isochoric-volumetric";
  double shear_modulus;  ///< mu    [Pa], > 0
  double bulk_modulus;   ///< kappa [Pa], > 0

  static NeoHookeanIsochoric from(const Moduli& m) { return {m.shear_modulus(), m.bulk_modulus()}; }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::pow;
    const T J = det(F);
    return 0.5 * shear_modulus * (pow(J, -2.0 / 3.0) * norm_squared(F) - 3.0) + 0.5 * bulk_modulus * (J - 1.0) * (J - 1.0);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = mu J^(-2/3) (F - tr C / 3 F^-T) + kappa (J - 1) J F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::pow;
    const T J = det(F);
    const T mu_bar = shear_modulus * pow(J, -2.0 / 3.0);
    const T beta = bulk_modulus * (J - 1.0) - mu_bar * norm_squared(F) / (3.0 * J);
    Tensor3<T> P = cofactor(F);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) P(i, j) = mu_bar * F(i, j) + beta * P(i, j);
    return P;
  }
};

}  // namespace mortise
