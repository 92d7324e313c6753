// What is allowed in a mesh, but seldom meant.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// Warnings about a mesh that `check_mesh` accepts, each `source: what`:
/// - nodes in one place (closer than 1e-6 of the elements there): bodies that touch at the start are made so, and bodies that
/// were
///   meant to be one;
/// - elements whose longest edges differ by more than a factor of 1e4.
/// Counts are given, and the first by the user's numbers.
std::vector<std::string> mesh_warnings(const Mesh& mesh);

}  // namespace mortise
