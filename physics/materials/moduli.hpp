// Elastic moduli of isotropic solids at small strain, from any usual pair of them (thesis eq. 3.103).
#pragma once

#include <limits>

namespace mortise {

/// The moduli [Pa] of an isotropic solid at small strain. Kept as shear modulus and Lame's lambda, from which all others follow
/// without loss of digits, up to the incompressible solid with its infinite lambda.
class Moduli {
 public:
  /// @param youngs_modulus [Pa], > 0  @param poissons_ratio [-], in (-1, 0.5)
  Moduli(double youngs_modulus, double poissons_ratio)
      : shear_modulus_(youngs_modulus / (2 * (1 + poissons_ratio))),
        lame_lambda_(youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))) {}

  /// @param shear_modulus [Pa], > 0  @param lame_lambda [Pa], > -2/3 shear modulus
  static Moduli from_shear_and_lambda(double shear_modulus, double lame_lambda) {
    Moduli moduli(1, 0);
    moduli.shear_modulus_ = shear_modulus;
    moduli.lame_lambda_ = lame_lambda;
    return moduli;
  }

  /// @param bulk_modulus [Pa], > 0  @param shear_modulus [Pa], > 0
  static Moduli from_bulk_and_shear(double bulk_modulus, double shear_modulus) {
    return from_shear_and_lambda(shear_modulus, bulk_modulus - 2 * shear_modulus / 3);
  }

  /// The solid that keeps its volume. @param shear_modulus [Pa], > 0
  static Moduli incompressible(double shear_modulus) {
    return from_shear_and_lambda(shear_modulus, std::numeric_limits<double>::infinity());
  }

  double shear_modulus() const { return shear_modulus_; }
  double lame_lambda() const { return lame_lambda_; }
  double bulk_modulus() const { return lame_lambda_ + 2 * shear_modulus_ / 3; }
  double poissons_ratio() const {  // not with 1 / lambda where lambda may be 0, nor with lambda / lambda where it is infinite
    return lame_lambda_ > shear_modulus_ ? 0.5 / (1 + shear_modulus_ / lame_lambda_)
                                         : lame_lambda_ / (2 * (lame_lambda_ + shear_modulus_));
  }
  double youngs_modulus() const { return 2 * shear_modulus_ * (1 + poissons_ratio()); }

 private:
  double shear_modulus_;
  double lame_lambda_;
};

}  // namespace mortise
