// From lattices to a mesh: nodes by their keys, elements, named sides.
#include "mesh/recipes/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "mesh/checks.hpp"

namespace mortise::recipes {

namespace {

struct HashOfKey {
  std::size_t operator()(const Key& key) const {
    std::size_t hash = 0;
    for (int part : key) hash = hash * 1000003 + static_cast<std::size_t>(part);
    return hash;
  }
};

using NodeOfKey = std::unordered_map<Key, int, HashOfKey>;

/// Where each side name comes in the sets: in the order of their first mention.
std::vector<std::string> side_names(const std::vector<Lattice>& lattices) {
  std::vector<std::string> names;
  for (const Lattice& lattice : lattices)
    for (const std::string& name : lattice.sides)
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

/// Nodes of the lattice, i fastest; keys that are new become nodes.
std::vector<int> add_nodes(const Lattice& lattice, const std::function<Point(const Key&)>& position, NodeOfKey& node_of,
                           Mesh& mesh) {
  std::vector<int> nodes;
  for (int k = 0; k <= lattice.cells[2]; ++k)
    for (int j = 0; j <= lattice.cells[1]; ++j)
      for (int i = 0; i <= lattice.cells[0]; ++i) {
        const Key key = lattice.key(i, j, k);
        const auto [entry, is_new] = node_of.emplace(key, n_nodes(mesh));
        if (is_new) mesh.coordinates.push_back(position(key));
        nodes.push_back(entry->second);
      }
  return nodes;
}

void add_elements(const Lattice& lattice, const std::vector<int>& nodes, Mesh& mesh) {
  constexpr std::array<int, 6> face{3, 1, 0, 2, 4, 5};  // of the sides of a lattice, in the Exodus numbering, from 0
  std::array<SideSet*, 6> set_of{};
  for (std::size_t s = 0; s < 6; ++s)
    for (SideSet& set : mesh.side_sets)
      if (set.name == lattice.sides[s]) set_of[s] = &set;

  const auto [ni, nj, nk] = lattice.cells;
  const int row = ni + 1, layer = row * (nj + 1);
  ElementList& elements = mesh.blocks.front().elements;
  for (int k = 0; k < nk; ++k)
    for (int j = 0; j < nj; ++j)
      for (int i = 0; i < ni; ++i) {
        const auto at = [&, first = k * layer + j * row + i](int further) {
          return nodes[static_cast<std::size_t>(first + further)];
        };
        const int e = static_cast<int>(elements.size());
        elements.push_back({at(0), at(1), at(row + 1), at(row), at(layer), at(layer + 1), at(layer + row + 1), at(layer + row)});
        const std::array<bool, 6> at_side{i == 0, i == ni - 1, j == 0, j == nj - 1, k == 0, k == nk - 1};
        for (std::size_t s = 0; s < 6; ++s)
          if (at_side[s] && set_of[s] != nullptr) set_of[s]->sides.push_back({e, face[s]});
      }
}

/// The nodes of a side, ascending.
NodeSet nodes_of(const Mesh& mesh, const SideSet& sides) {
  NodeSet set{sides.id, sides.name, {}};
  for (const Side& side : sides.sides)
    for (int a : side_nodes(mesh, side)) set.nodes.push_back(a);
  std::sort(set.nodes.begin(), set.nodes.end());
  set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
  return set;
}

}  // namespace

Lattice box_lattice(const std::array<int, 3>& elements) {
  return {elements, [](int i, int j, int k) { return Key{i, j, k, 0}; }, {"left", "right", "front", "back", "bottom", "top"}};
}

Mesh hexahedra(const std::string& recipe, const std::vector<Lattice>& lattices,
               const std::function<Point(const Key&)>& position) {
  Mesh mesh;
  mesh.source = fmt::format("recipe \"{}\"", recipe);
  mesh.blocks = {{1, recipe, ElementList()}};
  for (const std::string& name : side_names(lattices))
    mesh.side_sets.push_back({static_cast<std::int64_t>(mesh.side_sets.size()) + 1, name, {}});

  NodeOfKey node_of;
  for (const Lattice& lattice : lattices) add_elements(lattice, add_nodes(lattice, position, node_of, mesh), mesh);
  for (const SideSet& set : mesh.side_sets) mesh.node_sets.push_back(nodes_of(mesh, set));

  mesh.node_numbers.resize(mesh.coordinates.size());
  std::iota(mesh.node_numbers.begin(), mesh.node_numbers.end(), 1);
  mesh.element_numbers.resize(static_cast<std::size_t>(n_elements(mesh)));
  std::iota(mesh.element_numbers.begin(), mesh.element_numbers.end(), 1);
  check_mesh(mesh);  // an extreme grading makes flat elements
  return mesh;
}

}  // namespace mortise::recipes
