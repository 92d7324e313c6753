// How a mortar pair's force and gap are read.
#pragma once

namespace mortise {

/// Readings of the contact force (conventions of the field differ; see `pair_residual.hpp`).
enum class ContactForce {
  thesis,              ///< the variation of the weighted gap with D and M held and the normal varied (thesis eq. 4.123)
  interpolated_normal  ///< tractions along the nodal normals, gap along the interpolated one (Popp et al. 2010)
};

}  // namespace mortise
