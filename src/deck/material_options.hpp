// What a deck says about materials: each model with the parameters that it has.
//
// A new model is one struct here with its line in `MaterialModel`, its description in material_descriptions.hpp and the function
// that makes the material of it in make_material.cpp.
#pragma once

#include <optional>
#include <variant>
#include <vector>

namespace mortise {

namespace models {

/// Two of the five: the pair that the deck sets. All but the ratio [Pa].
struct ElasticModuli {
  std::optional<double> youngs_modulus, poissons_ratio, shear_modulus, lame_lambda, bulk_modulus;
};

struct LinearElastic : ElasticModuli {
  static constexpr const char* name = "linear elastic";
  static constexpr const char* help = "Hooke's law (thesis eq. 3.102), for small strains and small rotations only";
};

struct SaintVenantKirchhoff : ElasticModuli {
  static constexpr const char* name = "saint venant-kirchhoff";
  static constexpr const char* help = "Hooke's law at any rotation (3.106), for small strains: it softens in compression";
};

struct NeoHookean : ElasticModuli {
  static constexpr const char* name = "neo-hookean";
  static constexpr const char* help = "W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2 (3.130)";
};

struct NeoHookeanPowerLaw : ElasticModuli {
  static constexpr const char* name = "neo-hookean power-law";
  static constexpr const char* help =
      "W = mu/2 (I1 - 3) + mu/(2 b) (J^(-2 b) - 1), b = nu/(1 - 2 nu); nu = 0: the limit -mu ln J";
};

struct MooneyRivlin {
  static constexpr const char* name = "mooney-rivlin";
  static constexpr const char* help =
      "W = c1 (I1 - 3) + c2 (I2 - 3) + c (J - 1)^2 - 2 (c1 + 2 c2) ln J (3.125, free of stress at rest)";
  double c1 = 0, c2 = 0, c = 0;
};

/// The terms of Ogden's energy: mu_p [Pa] and alpha_p.
struct OgdenSeries {
  std::vector<double> exponents, moduli;
};

struct Ogden : OgdenSeries {
  static constexpr const char* name = "ogden";
  static constexpr const char* help =
      "W = sum mu/a (l1^a + l2^a + l3^a - 3) + kappa (ln J / b + (J^(-b) - 1) / b^2), l = J^(-1/3) principal stretch (3.113)";
  double bulk_modulus = 0;
  double volumetric_exponent = 0;
};

struct NeoHookeanIsochoric : ElasticModuli {
  static constexpr const char* name = "neo-hookean isochoric-volumetric";
  static constexpr const char* help = "W = mu/2 (J^(-2/3) I1 - 3) + kappa/2 (J - 1)^2 (3.96, 3.100)";
};

struct MooneyRivlinIsochoric {
  static constexpr const char* name = "mooney-rivlin isochoric-volumetric";
  static constexpr const char* help = "W = c1 (J^(-2/3) I1 - 3) + c2 (J^(-4/3) I2 - 3) + kappa/2 (J - 1)^2 (3.96, 3.100)";
  double c1 = 0, c2 = 0;
  double bulk_modulus = 0;
};

struct NeoHookeanIncompressible {
  static constexpr const char* name = "neo-hookean incompressible";
  static constexpr const char* help = "W = mu/2 (J^(-2/3) I1 - 3) with J = 1 and a pressure (3.95, 3.129)";
  std::optional<double> youngs_modulus, shear_modulus;  ///< one of them [Pa]; E = 3 mu
};

struct MooneyRivlinIncompressible {
  static constexpr const char* name = "mooney-rivlin incompressible";
  static constexpr const char* help = "W = c1 (J^(-2/3) I1 - 3) + c2 (J^(-4/3) I2 - 3) with J = 1 and a pressure (3.95, 3.119)";
  double c1 = 0, c2 = 0;
};

struct OgdenIncompressible : OgdenSeries {
  static constexpr const char* name = "ogden incompressible";
  static constexpr const char* help =
      "W = sum mu/a (l1^a + l2^a + l3^a - 3) with J = 1 and a pressure, l = J^(-1/3) principal stretch (3.95, 3.111)";
};

}  // namespace models

/// What a deck may ask for, in the order of the reference.
using MaterialModel =
    std::variant<models::LinearElastic, models::SaintVenantKirchhoff, models::NeoHookean, models::NeoHookeanPowerLaw,
                 models::MooneyRivlin, models::Ogden, models::NeoHookeanIsochoric, models::MooneyRivlinIsochoric,
                 models::NeoHookeanIncompressible, models::MooneyRivlinIncompressible, models::OgdenIncompressible>;

/// One entry of `materials`.
struct MaterialOptions {
  std::optional<MaterialModel> model;  ///< always set once the deck has been read
  std::optional<double> density;       ///< mass per reference volume
};

}  // namespace mortise
