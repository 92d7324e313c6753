// Directions of bricks that agree from neighbour to neighbour, however the lattices that they come from are turned.
#pragma once

#include <array>
#include <vector>

#include "mesh/element_list.hpp"

namespace mortise::recipes {

/// Which of a brick's local directions xi, eta, zeta run against those of the whole mesh.
using Reversed = std::array<bool, 3>;

/// Gives every edge of a mesh of hex8 a direction such that the four parallel edges of each brick have the same one, which is
/// that of the first brick among all that follow each other so. Bricks that are cut by their directions then fit together.
/// Precondition: there are such directions; a band of bricks that closes with a half turn (Moebius) has none.
/// @return of each brick, in order
std::vector<Reversed> reversed_directions(const ElementList& bricks);

/// The corner of a brick that takes the place of `corner` when directions are reversed.
int reversed_corner(int corner, const Reversed& reversed);

}  // namespace mortise::recipes
