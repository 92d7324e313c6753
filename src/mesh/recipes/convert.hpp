// Bricks made into other elements.
#pragma once

#include "mesh/mesh.hpp"

namespace mortise::recipes {

/// The mesh of a recipe with elements of another type in place of its hex8: a brick becomes one hex20 or hex27, two wedge6, or
/// six tetrahedra about the diagonal from its first to its seventh node, so that lattices of bricks stay conforming. Nodes that
/// are no corners are put in the middle of straight edges and flat faces. Side sets and node sets keep their names and places.
Mesh with_elements(Mesh hexahedra, ElementType type);

}  // namespace mortise::recipes
