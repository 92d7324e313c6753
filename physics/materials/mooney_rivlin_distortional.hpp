// The Mooney-Rivlin energy of the change of shape alone.
#pragma once

#include "physics/materials/invariants.hpp"

namespace mortise {

/// Mooney-Rivlin energy (thesis eq. 3.119, mu_1 = 2 c1, mu_2 = -2 c2) of the isochoric part J^(-1/3) F of the deformation.
///   W(F) = c1 (J^(-2/3) I1 - 3) + c2 (J^(-4/3) I2 - 3)
struct MooneyRivlinDistortional {
  static constexpr const char* isochoric_volumetric_name = "mooney-rivlin isochoric-volumetric";
  static constexpr const char* incompressible_name = "mooney-rivlin incompressible";
  double c1, c2;  ///< [Pa], c1 + c2 > 0

  double shear_modulus() const { return 2 * (c1 + c2); }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::pow;
    const T shrink = pow(det(F), -2.0 / 3.0);
    return c1 * (shrink * norm_squared(F) - 3.0) + c2 * (shrink * shrink * second_invariant(F) - 3.0);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:
  ///   P = 2 c1 J^(-2/3) (F - I1/3 F^-T) + 2 c2 J^(-4/3) (I1 F - F C - 2/3 I2 F^-T).  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    using std::pow;
    const T J = det(F), shrink = pow(J, -2.0 / 3.0);
    const T W_1 = c1 * shrink, W_2 = c2 * shrink * shrink;
    const T W_J = (-2.0 / 3.0 * W_1 * norm_squared(F) - 4.0 / 3.0 * W_2 * second_invariant(F)) / J;
    Tensor3<T> P = stress_of_first_invariant(F, W_1, W_J);
    add_to(P, W_2, second_invariant_slope(F));
    return P;
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] by the chain rule of invariants.hpp.  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F), I1 = norm_squared(F), I2 = second_invariant(F), shrink = 1 / (std::cbrt(J) * std::cbrt(J));
    const double W_1 = c1 * shrink, W_2 = c2 * shrink * shrink, W_1J = -2. / 3. * W_1 / J, W_2J = -4. / 3. * W_2 / J;
    const double W_JJ = (-5. / 3. * W_1J * I1 - 7. / 3. * W_2J * I2) / J;
    moduli_of_first_invariant(F, W_1, W_1J * I1 + W_2J * I2, W_1J, W_JJ, P, A);
    add_moduli_of_second_invariant(F, W_2, W_2J, P, A);
  }
};

}  // namespace mortise
