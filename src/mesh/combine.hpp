// From the meshes of a deck to the one mesh of the scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/options.hpp"
#include "mesh/mesh.hpp"

namespace mortise {

/// Reads the file (relative to `folder`) or makes the recipe, then places it: rotation about the axis through the mesh origin,
/// then origin.
/// @throws MeshError, FileError
Mesh make_mesh(const MeshOptions& options, const std::filesystem::path& folder);

/// A named mesh and where its parts went in the combined one. What the user calls node 17 has the number 17 + node_number_offset
/// there; likewise for elements and ids. Offsets are 0 for the first mesh.
struct MeshPart {
  std::string name;
  int first_node, n_nodes;
  int first_element, n_elements;
  int first_block, n_blocks;
  std::int64_t node_number_offset;
  std::int64_t element_number_offset;
  int first_side_set, n_side_sets;
  int first_node_set, n_node_sets;
  std::int64_t block_id_offset;
  std::int64_t side_set_id_offset;
  std::int64_t node_set_id_offset;
};

struct CombinedMesh {
  Mesh mesh;  ///< set and block names are "mesh name/own name" (own name = number where it has none); ids unique
  std::vector<MeshPart> parts;
};

/// Puts several meshes behind each other. Numbers and ids that collide are shifted by a round number, so that the user still
/// recognises his own (17 becomes 1017); names are prefixed.
/// @throws MeshError if all together are too large for 32-bit counting
CombinedMesh combine(const std::vector<std::pair<std::string, Mesh>>& meshes);

// ---- finding things by the user's words; a null or empty result means: there is none ---------------------------------

/// The mesh of that name.
const MeshPart* find_part(const CombinedMesh& mesh, const std::string& name);

/// The set called "mesh/name" or "mesh/number", the number being the id in the user's own file; a name goes before a number.
const SideSet* find_side_set(const CombinedMesh& mesh, const std::string& name);
const NodeSet* find_node_set(const CombinedMesh& mesh, const std::string& name);

/// Index in `mesh.mesh.blocks` of a block of one part, by its own name or number.
std::optional<int> find_block(const CombinedMesh& mesh, const MeshPart& part, const std::string& name);

/// Index of a node of one part by the user's number.
std::optional<int> find_node(const CombinedMesh& mesh, const MeshPart& part, std::int64_t number);

/// Names of all side and node sets, each once, for "did you mean".
std::vector<std::string> set_names(const CombinedMesh& mesh);

/// Own names of the blocks of a part, for "did you mean".
std::vector<std::string> block_names(const CombinedMesh& mesh, const MeshPart& part);

/// What the user calls a node: `node 17 of mesh "slab"`.
std::string describe_node(const CombinedMesh& mesh, int node);

/// What the user calls an element: `element 4711 of mesh "slab"`.
std::string describe_element(const CombinedMesh& mesh, int element);

}  // namespace mortise
