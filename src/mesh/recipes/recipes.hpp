// Meshes made by a recipe: the shapes that need no file.
#pragma once

#include "mesh/mesh.hpp"

namespace mortise {

/// A brick [0, size] of elements[0] x elements[1] x elements[2] hex8, one block, sides named
/// left right (x), front back (y), bottom top (z), node sets of the same names, numbers counted from 1, x fastest.
/// `grading` is last / first element size per axis (geometric; 1 = uniform).
/// @throws MeshError for non-positive data
Mesh graded_block(const std::array<double, 3>& size, const std::array<int, 3>& elements, const std::array<double, 3>& grading);

/// The uniform brick.
Mesh block(const std::array<double, 3>& size, const std::array<int, 3>& elements);

}  // namespace mortise
