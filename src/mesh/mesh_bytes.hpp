// A mesh as bytes, to be handed from one process to another on the same machine.
#pragma once

#include <string>

#include "mesh/mesh.hpp"

namespace mortise {

/// All of a mesh, in this machine's own representation.
std::string bytes_of(const Mesh& mesh);

/// The mesh that `bytes_of` turned into `bytes`, bit for bit.
/// @throws std::logic_error if they hold anything else
Mesh mesh_of(const std::string& bytes);

}  // namespace mortise
