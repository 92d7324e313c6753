// A mesh as bytes, to be handed from one process to another on the same machine.
#pragma once

#include <string>

#include "mesh/exodus.hpp"

namespace mortise {

/// All of a mesh, or of a frame with its mesh, in this machine's own representation.
std::string bytes_of(const Mesh& mesh);
std::string bytes_of(const MeshFrame& frame);

/// What `bytes_of` turned into `bytes`, bit for bit.
/// @throws std::logic_error if they hold anything else
Mesh mesh_of(const std::string& bytes);
MeshFrame frame_of(const std::string& bytes);

}  // namespace mortise
