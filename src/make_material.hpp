// The material of a body from what the deck says about it.
#pragma once

#include <string>

#include "deck/material_options.hpp"
#include "physics/materials/materials.hpp"

namespace mortise {

/// @param o options that the reader has accepted
Material make_material(const MaterialOptions& o);

/// Moduli of the material at small strain.
Moduli small_strain_moduli(const Material& material);

/// What is odd about data that may be used nonetheless, or an empty text: a bulk modulus below the shear modulus, where a solid
/// under tension hardly narrows, or widens.
std::string oddity(const Material& material);

}  // namespace mortise
