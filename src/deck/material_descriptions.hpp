// The descriptions of all material models: their parameters in a deck, with bounds and help (see fields.hpp).
#pragma once

#include <algorithm>
#include <string>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "deck/material_options.hpp"

namespace mortise {

namespace models {

/// The pairs of moduli that describe an isotropic solid at small strain.
inline bool is_usual_pair(const ElasticModuli& o) {
  const bool E = o.youngs_modulus.has_value(), nu = o.poissons_ratio.has_value(), mu = o.shear_modulus.has_value(),
             lambda = o.lame_lambda.has_value(), kappa = o.bulk_modulus.has_value();
  return E + nu + mu + lambda + kappa == 2 && ((E && nu) || (mu && lambda) || (kappa && mu));
}

/// The names of those that are set.
inline std::string set_moduli(const ElasticModuli& o) {
  std::vector<std::string> names;
  if (o.youngs_modulus) names.emplace_back("youngs modulus");
  if (o.poissons_ratio) names.emplace_back("poissons ratio");
  if (o.shear_modulus) names.emplace_back("shear modulus");
  if (o.lame_lambda) names.emplace_back("lame lambda");
  if (o.bulk_modulus) names.emplace_back("bulk modulus");
  return names.empty() ? "none" : quoted_names(names);
}

template <class Fields>
void describe(Fields& f, ElasticModuli& o) {
  const std::string unit = "force/length^2";
  f.optional("youngs modulus", o.youngs_modulus, positive, unit, "small-strain Young's modulus");
  f.optional("poissons ratio", o.poissons_ratio,
             between(-1., 0.5).because("at 0.5 the bulk modulus is infinite, at -1 the shear modulus is"), "-",
             "small-strain Poisson's ratio");
  f.optional("shear modulus", o.shear_modulus, positive, unit, "small-strain shear modulus mu");
  f.optional("lame lambda", o.lame_lambda, anything, unit, "Lame's first parameter");
  f.optional("bulk modulus", o.bulk_modulus, positive, unit, "small-strain bulk modulus kappa");
  f.rule("D12", {"youngs modulus", "poissons ratio", "shear modulus", "lame lambda", "bulk modulus"}, is_usual_pair(o),
         "must belong to exactly one pair of moduli: \"youngs modulus\" and \"poissons ratio\", or \"shear modulus\" and \"lame "
         "lambda\", or \"bulk modulus\" and \"shear modulus\"",
         "; set: " + set_moduli(o));
  f.rule("D08", {"lame lambda", "shear modulus"},
         !o.lame_lambda || !o.shear_modulus || 3 * *o.lame_lambda + 2 * *o.shear_modulus > 0,
         "must be > -2/3 \"shear modulus\", so that the bulk modulus is positive");
}

/// c1 and c2 of Mooney and Rivlin.
template <class Fields, class Model>
void describe_mooney_rivlin(Fields& f, Model& o) {
  f.required("c1", o.c1, anything, "force/length^2", "factor of I1 - 3");
  f.required("c2", o.c2, anything, "force/length^2", "factor of I2 - 3");
  f.rule("D08", {"c1", "c2"}, o.c1 + o.c2 > 0, "must give with \"c2\" a shear modulus 2 (c1 + c2) > 0");
}

template <class Fields>
void describe_bulk_modulus(Fields& f, double& bulk_modulus) {
  f.required("bulk modulus", bulk_modulus, positive, "force/length^2", "kappa");
}

template <class Fields>
void describe(Fields& f, MooneyRivlin& o) {
  describe_mooney_rivlin(f, o);
  f.required("c", o.c, anything, "force/length^2", "factor of (J - 1)^2");
  f.rule("D08", {"c2", "c1"}, o.c1 + 2 * o.c2 > 0, "must give c1 + 2 c2 > 0: otherwise volume can be pressed to nothing");
  f.rule("D08", {"c", "c1", "c2"}, 3 * o.c + 8 * o.c2 + 2 * o.c1 > 0, "must give a bulk modulus 2 c + 4 c1/3 + 16 c2/3 > 0");
}

template <class Fields>
void describe(Fields& f, MooneyRivlinIsochoric& o) {
  describe_mooney_rivlin(f, o);
  describe_bulk_modulus(f, o.bulk_modulus);
}

template <class Fields>
void describe(Fields& f, MooneyRivlinIncompressible& o) {
  describe_mooney_rivlin(f, o);
}

template <class Fields>
void describe(Fields& f, NeoHookeanIncompressible& o) {
  f.optional("youngs modulus", o.youngs_modulus, positive, "force/length^2", "small-strain Young's modulus, 3 mu");
  f.optional("shear modulus", o.shear_modulus, positive, "force/length^2", "small-strain shear modulus mu");
  f.exactly_one_of({"youngs modulus", "shear modulus"});
}

/// sum mu_p alpha_p, as far as both are given: twice the shear modulus (thesis eq. 3.112).
inline double twice_shear_modulus(const OgdenSeries& o) {
  double sum = 0;
  for (std::size_t p = 0; p < std::min(o.exponents.size(), o.moduli.size()); ++p) sum += o.moduli[p] * o.exponents[p];
  return sum;
}

template <class Fields>
void describe(Fields& f, OgdenSeries& o) {
  const Bound not_zero =
      Bound{"other than 0", [](double x) { return x != 0; }, ""}.because("a stretch to the power of 0 stores no energy");
  f.required("exponents", o.exponents, not_zero, "-", "a of each term");
  f.required("moduli", o.moduli, anything, "force/length^2", "mu of each term");
  f.rule("D17", {"moduli", "exponents"}, o.moduli.size() == o.exponents.size(), "must have as many entries as \"exponents\"");
  f.rule("D08", {"moduli", "exponents"}, o.moduli.size() != o.exponents.size() || twice_shear_modulus(o) > 0,
         "must give with \"exponents\" a shear modulus sum(mu a)/2 > 0");
}

template <class Fields>
void describe(Fields& f, Ogden& o) {
  describe(f, static_cast<OgdenSeries&>(o));
  describe_bulk_modulus(f, o.bulk_modulus);
  f.required("volumetric exponent", o.volumetric_exponent, anything, "-", "b; 0: the limit kappa/2 (ln J)^2");
}

}  // namespace models

template <class Fields>
void describe(Fields& f, MaterialOptions& o) {
  f.kind("model", o.model, Presence::required,
         "strain energy W per reference volume; numbers in brackets are equations of the thesis. The incompressible models "
         "need elements with a pressure of their own, the formulation \"mixed\"");
  f.optional("density", o.density, positive, "mass/length^3",
             "mass per reference volume; what a body force, and damping by mass, multiply with");
}

}  // namespace mortise
