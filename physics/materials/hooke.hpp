// Hooke's law between a strain and its stress, whichever strain that is: what linear materials share.
#pragma once

#include "physics/materials/moduli.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// Moduli of an isotropic linear law (thesis eq. 3.103) with its energy and stress.
struct Hooke {
  double shear_modulus;  ///< mu     [Pa], > 0
  double lame_lambda;    ///< lambda [Pa]

  Moduli small_strain() const { return Moduli::from_shear_and_lambda(shear_modulus, lame_lambda); }

  /// lambda/2 (tr e)^2 + mu e : e  [J/m^3]. @param e symmetric strain [-]
  template <class T>
  T energy(const Tensor3<T>& e) const {
    const T trace = e(0, 0) + e(1, 1) + e(2, 2);
    return 0.5 * lame_lambda * trace * trace + shear_modulus * norm_squared(e);
  }

  /// lambda tr e I + 2 mu e  [Pa].
  template <class T>
  Tensor3<T> stress(const Tensor3<T>& e) const {
    const T pressure = lame_lambda * (e(0, 0) + e(1, 1) + e(2, 2));
    Tensor3<T> s;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) s(i, j) = 2.0 * shear_modulus * e(i, j);
    for (int i = 0; i < 3; ++i) s(i, i) += pressure;
    return s;
  }
};

}  // namespace mortise
