// Exodus files: reading a mesh with every range checked, and writing one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// Reads nodes, blocks of all types that topology.hpp knows, side sets, node sets, names and number maps.
/// Ranges are checked before they are used (connectivity, sides, faces, node set members, finite coordinates,
/// repeated nodes in an element, positive Jacobian at the Gauss points; codes in checks.hpp); side nodes come from our own table.
/// Empty blocks are left out. Classic, 64-bit offset, 64-bit data and netCDF-4 files, 32- or 64-bit integers.
/// @throws MeshError naming the file and the first offenders by the user's numbers; FileError if it cannot be opened
Mesh read_exodus(const std::filesystem::path& file);

/// Values of a variable: one per node, or a single one for the whole mesh.
struct MeshVariable {
  std::string name;
  std::vector<double> values;
};

/// What a file with results holds at its last time.
struct MeshFrame {
  Mesh mesh;
  double time = 0;
  std::vector<MeshVariable> nodal, global;

  /// A nodal variable, or null.
  const std::vector<double>* at_nodes(const std::string& name) const;
};

/// Reads a mesh as `read_exodus`, and the last frame behind it.
/// @throws MeshError, also if the file has no frame; FileError
MeshFrame read_last_frame(const std::filesystem::path& file);

/// Writes `mesh` with names and number maps, in the classic 64-bit offset format (netCDF-4 if a number needs more than 32 bits).
/// @param title at most 80 characters are kept
/// @throws FileError
void write_exodus(const Mesh& mesh, const std::filesystem::path& file, const std::string& title);

}  // namespace mortise
