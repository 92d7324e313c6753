// Finding parts, sets, blocks and nodes of the combined mesh by the user's words, and naming them back.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>

#include "mesh/combine.hpp"

namespace mortise {

namespace {

/// A whole string as a number: "7" but not "7a".
std::optional<std::int64_t> number_in(const std::string& text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, number);
  if (status != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// Index of the entity with the full name, or else with the own id, among [first, first + n).
template <class Entity>
std::optional<int> find_among(const std::vector<Entity>& entities, int first, int n, std::int64_t id_offset,
                              const std::string& full_name, const std::string& own_name) {
  const auto begin = entities.begin() + first, end = begin + n;
  auto found = std::find_if(begin, end, [&](const Entity& entity) { return entity.name == full_name; });
  if (const auto number = number_in(own_name); found == end && number)
    found = std::find_if(begin, end, [&](const Entity& entity) { return entity.id - id_offset == *number; });
  if (found == end) return std::nullopt;
  return static_cast<int>(found - entities.begin());
}

struct PartAndName {
  const MeshPart* part;  ///< null if there is no such mesh
  std::string own_name;
};

/// "slab/top" -> the mesh "slab" and "top"; names of meshes hold no slash.
PartAndName split(const CombinedMesh& mesh, const std::string& name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return {nullptr, name};
  return {find_part(mesh, name.substr(0, slash)), name.substr(slash + 1)};
}

/// The part that holds entry `i` of the range that `first` and `n` describe.
const MeshPart& part_of(const CombinedMesh& mesh, int i, int MeshPart::*first, int MeshPart::*n) {
  const auto part =
      std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& p) { return i >= p.*first && i < p.*first + p.*n; });
  assert(part != mesh.parts.end());
  return *part;
}

}  // namespace

const MeshPart* find_part(const CombinedMesh& mesh, const std::string& name) {
  const auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& p) { return p.name == name; });
  return part == mesh.parts.end() ? nullptr : &*part;
}

const SideSet* find_side_set(const CombinedMesh& mesh, const std::string& name) {
  const auto [part, own_name] = split(mesh, name);
  if (part == nullptr) return nullptr;
  const auto i =
      find_among(mesh.mesh.side_sets, part->first_side_set, part->n_side_sets, part->side_set_id_offset, name, own_name);
  return i ? &mesh.mesh.side_sets[static_cast<std::size_t>(*i)] : nullptr;
}

const NodeSet* find_node_set(const CombinedMesh& mesh, const std::string& name) {
  const auto [part, own_name] = split(mesh, name);
  if (part == nullptr) return nullptr;
  const auto i =
      find_among(mesh.mesh.node_sets, part->first_node_set, part->n_node_sets, part->node_set_id_offset, name, own_name);
  return i ? &mesh.mesh.node_sets[static_cast<std::size_t>(*i)] : nullptr;
}

std::optional<int> find_block(const CombinedMesh& mesh, const MeshPart& part, const std::string& name) {
  return find_among(mesh.mesh.blocks, part.first_block, part.n_blocks, part.block_id_offset, part.name + "/" + name, name);
}

std::optional<int> find_node(const CombinedMesh& mesh, const MeshPart& part, std::int64_t number) {
  const auto begin = mesh.mesh.node_numbers.begin() + part.first_node, end = begin + part.n_nodes;
  const auto found = std::find(begin, end, number + part.node_number_offset);
  if (found == end) return std::nullopt;
  return static_cast<int>(found - mesh.mesh.node_numbers.begin());
}

std::vector<std::string> set_names(const CombinedMesh& mesh) {
  std::vector<std::string> names;
  for (const SideSet& set : mesh.mesh.side_sets) names.push_back(set.name);
  for (const NodeSet& set : mesh.mesh.node_sets)
    if (std::find(names.begin(), names.end(), set.name) == names.end()) names.push_back(set.name);
  return names;
}

std::vector<std::string> block_names(const CombinedMesh& mesh, const MeshPart& part) {
  std::vector<std::string> names;
  for (int b = part.first_block; b < part.first_block + part.n_blocks; ++b)
    names.push_back(mesh.mesh.blocks[static_cast<std::size_t>(b)].name.substr(part.name.size() + 1));
  return names;
}

std::string describe_node(const CombinedMesh& mesh, int node) {
  const MeshPart& part = part_of(mesh, node, &MeshPart::first_node, &MeshPart::n_nodes);
  return fmt::format("node {} of mesh \"{}\"", mesh.mesh.node_numbers[static_cast<std::size_t>(node)] - part.node_number_offset,
                     part.name);
}

std::string describe_element(const CombinedMesh& mesh, int element) {
  const MeshPart& part = part_of(mesh, element, &MeshPart::first_element, &MeshPart::n_elements);
  return fmt::format("element {} of mesh \"{}\"",
                     mesh.mesh.element_numbers[static_cast<std::size_t>(element)] - part.element_number_offset, part.name);
}

}  // namespace mortise
