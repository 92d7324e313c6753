// Solids whose energy is split into one of shape and one of volume.
#pragma once

#include "physics/materials/invariants.hpp"
#include "physics/materials/moduli.hpp"

namespace mortise {

/// Isochoric-volumetric split (thesis eq. 3.100) with quadratic volumetric energy.
///   W(F) = W_iso(J^(-1/3) F) + kappa/2 (J - 1)^2
/// @tparam Distortional W_iso, as a function of F: a struct such as NeoHookeanDistortional
template <class Distortional>
struct IsochoricVolumetric {
  static constexpr const char* name = Distortional::isochoric_volumetric_name;
  static constexpr bool is_incompressible = false;
  Distortional isochoric;
  double bulk_modulus;  ///< kappa [Pa], > 0

  /// With the energy of shape that has no parameter but the shear modulus.
  static IsochoricVolumetric from(const Moduli& m) { return {{m.shear_modulus()}, m.bulk_modulus()}; }
  Moduli small_strain() const { return Moduli::from_bulk_and_shear(bulk_modulus, isochoric.shear_modulus()); }

  /// W_iso with its stress and moduli, for elements that have a pressure of their own.
  const Distortional& distortional() const { return isochoric; }
  /// 1 / kappa [1/Pa] of W_vol = kappa/2 (J - 1)^2.
  double volumetric_compliance() const { return 1 / bulk_modulus; }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    const T swelling = det(F) - 1.0;
    return isochoric.strain_energy(F) + 0.5 * bulk_modulus * swelling * swelling;
  }

  /// First Piola-Kirchhoff stress P = dW/dF [Pa]:  P = P_iso + kappa (J - 1) J F^-T.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    Tensor3<T> P = isochoric.first_piola(F);
    add_to(P, T(bulk_modulus * (det(F) - 1.0)), cofactor(F));
    return P;
  }

  /// P and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa].  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const {
    isochoric.moduli(F, P, A);
    add_moduli_of_volume(F, bulk_modulus * (det(F) - 1), bulk_modulus, P, A);
  }
};

}  // namespace mortise
