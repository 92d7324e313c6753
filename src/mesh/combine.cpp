// Making the meshes of a deck, and putting them behind each other.
#include "mesh/combine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "errors.hpp"
#include "mesh/angles.hpp"
#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/convert.hpp"
#include "mesh/recipes/recipes.hpp"

namespace mortise {

namespace {

Mesh make_unplaced(const MeshOptions& options, const std::filesystem::path& folder) {
  if (options.file.has_value() == options.recipe.has_value()) {
    MeshErrors errors("mesh");
    errors.add("M43", "needs either \"file\" or \"recipe\"");
    errors.throw_if_any();
  }
  if (options.file) return read_exodus(folder / *options.file);
  return recipes::with_elements(make(*options.recipe), options.element_type);
}

/// Rodrigues' rotation of X about the unit vector k:  X cos + (k x X) sin + k (k . X)(1 - cos).
Point rotated(const Point& X, const Point& k, double sine, double cosine) {
  const double along = (k[0] * X[0] + k[1] * X[1] + k[2] * X[2]) * (1 - cosine);
  const Point across{k[1] * X[2] - k[2] * X[1], k[2] * X[0] - k[0] * X[2], k[0] * X[1] - k[1] * X[0]};
  Point result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = X[i] * cosine + across[i] * sine + k[i] * along;
  return result;
}

void place(Mesh& mesh, const MeshOptions& options) {
  const auto [x, y, z, degrees] = options.rotation;
  const double length = std::hypot(x, y, z);
  MeshErrors errors(mesh.source);
  if (!std::isfinite(length) || !std::isfinite(degrees) || (length == 0 && degrees != 0))
    errors.add("M42",
               fmt::format("\"rotation\" = {{{}, {}, {}, {}}} - needs an axis that is not zero, and degrees", x, y, z, degrees));
  for (double coordinate : options.origin)
    if (!std::isfinite(coordinate)) errors.add("M42", fmt::format("\"origin\" holds {} - must be finite", coordinate));
  errors.throw_if_any();

  const auto [sine, cosine] = sine_cosine(degrees);
  const bool turns = sine != 0 || cosine != 1;
  for (Point& X : mesh.coordinates) {
    if (turns) X = rotated(X, {x / length, y / length, z / length}, sine, cosine);
    for (std::size_t i = 0; i < 3; ++i) X[i] += options.origin[i];
  }
}

/// What is added to a part's numbers (`own`, all positive) so that they stay apart from those used before (at most
/// `highest_used`): 0 if they do already, otherwise the least multiple of a power of ten above `own` that is enough.
std::int64_t offset_for(std::int64_t highest_used, const std::vector<std::int64_t>& own) {
  if (own.empty()) return 0;
  const auto [lowest, highest] = std::minmax_element(own.begin(), own.end());
  if (*lowest > highest_used) return 0;
  std::int64_t step = 10;
  while (step <= *highest && step < 1000000000000000000) step *= 10;
  return (highest_used + step - 1) / step * step;
}

/// Appends a part's numbers to the combined ones; returns their offset.
std::int64_t append_numbers(std::vector<std::int64_t>& all, const std::vector<std::int64_t>& own) {
  const std::int64_t offset = offset_for(all.empty() ? 0 : *std::max_element(all.begin(), all.end()), own);
  for (std::int64_t n : own) all.push_back(n + offset);
  return offset;
}

/// Copies blocks or sets with shifted ids and prefixed names; returns the offset of the ids. Their indices remain to be shifted.
template <class Entity>
std::int64_t append_named(std::vector<Entity>& all, const std::vector<Entity>& own, const std::string& mesh_name) {
  std::vector<std::int64_t> used, ids;
  for (const Entity& entity : all) used.push_back(entity.id);
  for (const Entity& entity : own) ids.push_back(entity.id);
  const std::int64_t offset = append_numbers(used, ids);
  for (const Entity& entity : own) {
    all.push_back(entity);
    all.back().id += offset;
    all.back().name = mesh_name + "/" + (entity.name.empty() ? std::to_string(entity.id) : entity.name);
  }
  return offset;
}

template <class T>
int count(const std::vector<T>& list) {
  return static_cast<int>(list.size());
}

void append(CombinedMesh& combined, const std::string& name, const Mesh& own) {
  Mesh& mesh = combined.mesh;
  MeshPart part{};
  part.name = name;
  part.first_node = n_nodes(mesh), part.n_nodes = n_nodes(own);
  part.first_element = n_elements(mesh), part.n_elements = n_elements(own);
  part.first_block = count(mesh.blocks), part.n_blocks = count(own.blocks);
  part.first_side_set = count(mesh.side_sets), part.n_side_sets = count(own.side_sets);
  part.first_node_set = count(mesh.node_sets), part.n_node_sets = count(own.node_sets);

  mesh.coordinates.insert(mesh.coordinates.end(), own.coordinates.begin(), own.coordinates.end());
  part.node_number_offset = append_numbers(mesh.node_numbers, own.node_numbers);
  part.element_number_offset = append_numbers(mesh.element_numbers, own.element_numbers);
  part.block_id_offset = append_named(mesh.blocks, own.blocks, name);
  part.side_set_id_offset = append_named(mesh.side_sets, own.side_sets, name);
  part.node_set_id_offset = append_named(mesh.node_sets, own.node_sets, name);

  const auto at = [](auto& list, int first) { return list.begin() + first; };
  for (auto block = at(mesh.blocks, part.first_block); block != mesh.blocks.end(); ++block)
    for (int& a : block->elements.nodes()) a += part.first_node;
  for (auto set = at(mesh.side_sets, part.first_side_set); set != mesh.side_sets.end(); ++set)
    for (Side& side : set->sides) side.element += part.first_element;
  for (auto set = at(mesh.node_sets, part.first_node_set); set != mesh.node_sets.end(); ++set)
    for (int& a : set->nodes) a += part.first_node;
  combined.parts.push_back(part);
}

}  // namespace

Mesh make_mesh(const MeshOptions& options, const std::filesystem::path& folder) {
  Mesh mesh = make_unplaced(options, folder);
  place(mesh, options);
  check_mesh(mesh);  // so far from the origin that coordinates lose their digits, elements have no volume left
  return mesh;
}

CombinedMesh combine(const std::vector<std::pair<std::string, Mesh>>& meshes) {
  std::size_t n_all_nodes = 0;
  std::vector<std::string> sources;
  for (const auto& [name, mesh] : meshes) {
    n_all_nodes += mesh.coordinates.size();
    sources.push_back(mesh.source);
  }
  CombinedMesh combined;
  combined.mesh.source = join(sources);
  constexpr std::size_t limit = std::numeric_limits<int>::max() / 8;
  if (n_all_nodes > limit) {
    MeshErrors errors(combined.mesh.source);
    errors.add("M06", fmt::format("together {} nodes - at most {}", n_all_nodes, limit));
    errors.throw_if_any();
  }
  for (const auto& [name, mesh] : meshes) append(combined, name, mesh);
  return combined;
}

}  // namespace mortise
