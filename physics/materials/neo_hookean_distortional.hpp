// The neo-Hookean energy of the change of shape alone.
#pragma once

#include "physics/materials/invariants.hpp"

namespace mortise {

/// Neo-Hookean energy (thesis eq. 3.129) of the isochoric part J^(-1/3) F of the deformation (eq. 3.96).
///   W(F) = mu/2 (J^(-2/3) tr C - 3)
struct NeoHookeanDistortional {
  static constexpr const char* isochoric_volumetric_name = "neo-hookean isochoric-volumetric";
  static constexpr const char* incompressible_name = "neo-hookean incompressible";
  double modulus;  ///< mu [Pa], > 0

  double shear_modulus() const { return modulus; }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::pow;
    return 0.5 * modulus * (pow(det(F), -2.0 / 3.0) * norm_squared(F) - 3.0);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = mu J^(-2/3) (F - tr C / 3 F^-T).  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::pow;
    const T J = det(F);
    const T W_1 = 0.5 * modulus * pow(J, -2.0 / 3.0);
    const T W_J = -2.0 / 3.0 * W_1 * norm_squared(F) / J;
    return stress_of_first_invariant(F, W_1, W_J);
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] by the chain rule of invariants.hpp.  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F), I1 = norm_squared(F), cube_root = std::cbrt(J);
    const double W_1 = 0.5 * modulus / (cube_root * cube_root), W_1J = -2. / 3. * W_1 / J;
    moduli_of_first_invariant(F, W_1, W_1J * I1, W_1J, -5. / 3. * W_1J * I1 / J, P, A);
  }
};

}  // namespace mortise
