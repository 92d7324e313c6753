// The closed set of materials: a new one is its header, one line here, one in the deck table, one in the test list.
#pragma once

#include <variant>

#include "physics/materials/neo_hookean.hpp"
#include "physics/materials/neo_hookean_isochoric.hpp"
#include "physics/materials/saint_venant_kirchhoff.hpp"

namespace mortise {

using Material = std::variant<NeoHookean, NeoHookeanIsochoric, SaintVenantKirchhoff>;

}  // namespace mortise
