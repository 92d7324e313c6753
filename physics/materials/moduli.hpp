// Elastic moduli of isotropic solids at small strain, each from Young's modulus and Poisson's ratio (thesis eq. 3.103).
#pragma once

namespace mortise {

/// Young's modulus [Pa] > 0 and Poisson's ratio [-] in (-1, 0.5), turned into the other moduli [Pa].
struct Moduli {
  double youngs_modulus;
  double poissons_ratio;

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
  double lame_lambda() const { return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)); }
  double bulk_modulus() const { return youngs_modulus / (3 * (1 - 2 * poissons_ratio)); }
};

}  // namespace mortise
