// Whether a side set can be a contact surface.
#pragma once

#include <string>
#include <vector>

#include "mesh/combine.hpp"

namespace mortise {

struct SurfaceFault {
  std::string code;  ///< M52 to M54
  std::string text;  ///< how many, the first by the user's numbers, and what is allowed
};

/// A contact surface lies on the outside of bodies and has one normal everywhere: no side with elements on both sides (M52), no
/// edge of more than two facets (M53), and facets that share an edge face the same way (M54).
/// @param sides a checked side set of the mesh
std::vector<SurfaceFault> contact_surface_faults(const CombinedMesh& mesh, const SideSet& sides);

}  // namespace mortise
