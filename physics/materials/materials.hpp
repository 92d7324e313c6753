// The closed set of materials: a new one is its header and one line here; CONTRIBUTING.md has the rest.
#pragma once

#include <type_traits>
#include <variant>

#include "physics/materials/incompressible.hpp"
#include "physics/materials/isochoric_volumetric.hpp"
#include "physics/materials/linear_elastic.hpp"
#include "physics/materials/mooney_rivlin.hpp"
#include "physics/materials/mooney_rivlin_distortional.hpp"
#include "physics/materials/neo_hookean.hpp"
#include "physics/materials/neo_hookean_distortional.hpp"
#include "physics/materials/neo_hookean_power_law.hpp"
#include "physics/materials/ogden.hpp"
#include "physics/materials/ogden_distortional.hpp"
#include "physics/materials/saint_venant_kirchhoff.hpp"

namespace mortise {

using NeoHookeanIsochoric = IsochoricVolumetric<NeoHookeanDistortional>;
using MooneyRivlinIsochoric = IsochoricVolumetric<MooneyRivlinDistortional>;
using NeoHookeanIncompressible = Incompressible<NeoHookeanDistortional>;
using MooneyRivlinIncompressible = Incompressible<MooneyRivlinDistortional>;
using OgdenIncompressible = Incompressible<OgdenDistortional>;

/// Each has `strain_energy(F)` and `first_piola(F)` for scalars with or without first derivatives, `moduli(F, P, A)` by hand, and
/// `small_strain()`. All need det F > 0, which callers check before.
using Material =
    std::variant<LinearElastic, SaintVenantKirchhoff, NeoHookean, NeoHookeanPowerLaw, MooneyRivlin, Ogden, NeoHookeanIsochoric,
                 MooneyRivlinIsochoric, NeoHookeanIncompressible, MooneyRivlinIncompressible, OgdenIncompressible>;

/// Whether a material has `distortional()` and `volumetric_compliance()`: what elements with a pressure of their own need.
template <class M, class = void>
inline constexpr bool is_split = false;
template <class M>
inline constexpr bool is_split<M, std::void_t<decltype(std::declval<const M&>().distortional())>> = true;

/// Whether a material has no volumetric energy: elements without a pressure of their own cannot hold its volume.
template <class M>
constexpr bool is_incompressible() {
  if constexpr (is_split<M>) {
    return M::is_incompressible;
  } else {
    return false;
  }
}

/// Whether the stress is linear in F, so that the moduli are the same at every state.
inline bool is_linear(const Material& material) { return std::holds_alternative<LinearElastic>(material); }

}  // namespace mortise
