// Solids that keep their volume: the pressure is a multiplier, not a function of the deformation.
#pragma once

#include "physics/materials/moduli.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Incompressible solid (thesis eq. 3.95): the constraint J = 1, with a pressure as its multiplier, beside an energy of shape.
///   W(F) = W_iso(J^(-1/3) F),  J = 1
/// Energy, stress and moduli here are those of W_iso alone: an element adds the pressure. They are the same for every J, so that
/// states which do not fulfil the constraint yet may be evaluated.
/// @tparam Distortional W_iso, as a function of F: a struct such as NeoHookeanDistortional
template <class Distortional>
struct Incompressible {
  static constexpr const char* name = Distortional::incompressible_name;
  static constexpr bool is_incompressible = true;
  Distortional isochoric;

  Moduli small_strain() const { return Moduli::incompressible(isochoric.shear_modulus()); }

  /// W_iso with its stress and moduli, for elements that have a pressure of their own.
  const Distortional& distortional() const { return isochoric; }
  /// 1 / kappa = 0 [1/Pa].
  double volumetric_compliance() const { return 0; }

  /// Strain energy per unit reference volume [J/m^3]; needs J = det F > 0.
  template <class T>
  T strain_energy(const Tensor3<T>& F) const {
    return isochoric.strain_energy(F);
  }

  /// First Piola-Kirchhoff stress dW_iso/dF [Pa], without that of the pressure.  Needs J > 0.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    return isochoric.first_piola(F);
  }

  /// That stress and its derivative A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa].  Needs J > 0.
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const { isochoric.moduli(F, P, A); }
};

}  // namespace mortise
