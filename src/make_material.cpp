#include "make_material.hpp"

#include <fmt/format.h>

namespace mortise {
namespace {

/// Of the pair that is set.
Moduli moduli(const models::ElasticModuli& o) {
  if (o.youngs_modulus) return {*o.youngs_modulus, *o.poissons_ratio};
  if (o.lame_lambda) return Moduli::from_shear_and_lambda(*o.shear_modulus, *o.lame_lambda);
  return Moduli::from_bulk_and_shear(*o.bulk_modulus, *o.shear_modulus);
}

OgdenDistortional distortional(const models::OgdenSeries& o) {
  OgdenDistortional ogden;
  for (std::size_t p = 0; p < o.moduli.size(); ++p) ogden.terms.push_back({o.moduli[p], o.exponents[p]});
  return ogden;
}

Material make(const models::LinearElastic& o) { return LinearElastic::from(moduli(o)); }
Material make(const models::SaintVenantKirchhoff& o) { return SaintVenantKirchhoff::from(moduli(o)); }
Material make(const models::NeoHookean& o) { return NeoHookean::from(moduli(o)); }
Material make(const models::NeoHookeanPowerLaw& o) { return NeoHookeanPowerLaw::from(moduli(o)); }
Material make(const models::MooneyRivlin& o) { return MooneyRivlin{o.c1, o.c2, o.c}; }
Material make(const models::Ogden& o) { return Ogden{distortional(o), o.bulk_modulus, o.volumetric_exponent}; }
Material make(const models::NeoHookeanIsochoric& o) { return NeoHookeanIsochoric::from(moduli(o)); }
Material make(const models::MooneyRivlinIsochoric& o) { return MooneyRivlinIsochoric{{o.c1, o.c2}, o.bulk_modulus}; }
Material make(const models::NeoHookeanIncompressible& o) {
  return NeoHookeanIncompressible{{o.shear_modulus ? *o.shear_modulus : *o.youngs_modulus / 3}};
}
Material make(const models::MooneyRivlinIncompressible& o) { return MooneyRivlinIncompressible{{o.c1, o.c2}}; }
Material make(const models::OgdenIncompressible& o) { return OgdenIncompressible{distortional(o)}; }

}  // namespace

Material make_material(const MaterialOptions& o) {
  return std::visit([](const auto& model) { return make(model); }, *o.model);
}

Moduli small_strain_moduli(const Material& material) {
  return std::visit([](const auto& one) { return one.small_strain(); }, material);
}

std::string oddity(const Material& material) {
  const Moduli moduli = small_strain_moduli(material);
  if (moduli.bulk_modulus() >= moduli.shear_modulus()) return "";
  return fmt::format(
      "at small strain the bulk modulus ({:.4g}) is below the shear modulus ({:.4g}), Poisson's ratio is {:.3g} - are all moduli "
      "in the same unit?",
      moduli.bulk_modulus(), moduli.shear_modulus(), moduli.poissons_ratio());
}

}  // namespace mortise
