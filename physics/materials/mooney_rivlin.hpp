// Compressible Mooney-Rivlin solid in the form that is free of stress at rest.
#pragma once

#include "physics/materials/invariants.hpp"
#include "physics/materials/moduli.hpp"

namespace mortise {

/// Compressible Mooney-Rivlin solid (thesis eqs. 3.125 and 6.46, with the coefficient of ln J that leaves no stress at rest).
///   W(F) = c1 (I1 - 3) + c2 (I2 - 3) + c (J - 1)^2 - d ln J,  d = 2 (c1 + 2 c2)
struct MooneyRivlin {
  static constexpr const char* name = "mooney-rivlin";
  double c1, c2;  ///< [Pa], c1 + c2 > 0 and c1 + 2 c2 > 0
  double c;       ///< [Pa]

  double d() const { return 2 * (c1 + 2 * c2); }
  Moduli small_strain() const { return Moduli::from_shear_and_lambda(2 * (c1 + c2), 2 * c + 4 * c2); }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    using std::log;
    const T J = det(F);
    return c1 * (norm_squared(F) - 3.0) + c2 * (second_invariant(F) - 3.0) + c * (J - 1.0) * (J - 1.0) - d() * log(J);
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = 2 c1 F + 2 c2 (I1 F - F C) + (2 c (J - 1) J - d) F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    const T J = det(F);
    const T W_J = 2.0 * c * (J - 1.0) - d() / J;
    Tensor3<T> P = stress_of_first_invariant(F, T(c1), W_J);
    add_to(P, T(c2), second_invariant_slope(F));
    return P;
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa] by the chain rule of invariants.hpp.  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    const double J = det(F);
    moduli_of_first_invariant(F, c1, 2 * c * (J - 1) - d() / J, 0, 2 * c + d() / (J * J), P, A);
    add_moduli_of_second_invariant(F, c2, 0, P, A);
  }
};

}  // namespace mortise
