// Single points, and a line of bars: meshes without volume.
#include <fmt/format.h>

#include <numeric>

#include "mesh/recipes/data_check.hpp"

namespace mortise::recipes {

namespace {

/// A mesh of one block named as its recipe; numbers count from 1.
Mesh one_block(const std::string& recipe, ElementType type, std::vector<Point> coordinates) {
  Mesh mesh;
  mesh.source = fmt::format("recipe \"{}\"", recipe);
  mesh.blocks = {{1, recipe, ElementList(type)}};
  mesh.coordinates = std::move(coordinates);
  mesh.node_numbers.resize(mesh.coordinates.size());
  std::iota(mesh.node_numbers.begin(), mesh.node_numbers.end(), 1);
  return mesh;
}

void number_elements(Mesh& mesh) {
  mesh.element_numbers.resize(mesh.blocks.front().elements.size());
  std::iota(mesh.element_numbers.begin(), mesh.element_numbers.end(), 1);
  check_mesh(mesh);
}

}  // namespace

Mesh make(const Points& o) {
  check_data(o);
  std::vector<Point> coordinates;
  for (std::size_t k = 0; k + 2 < o.coordinates.size(); k += 3)
    coordinates.push_back({o.coordinates[k], o.coordinates[k + 1], o.coordinates[k + 2]});
  Mesh mesh = one_block(Points::name, ElementType::sphere, std::move(coordinates));
  for (int a = 0; a < n_nodes(mesh); ++a) {
    mesh.blocks.front().elements.push_back({a});
    mesh.node_sets.push_back({a + 1, std::to_string(a + 1), {a}});
  }
  number_elements(mesh);
  return mesh;
}

Mesh make(const Line& o) {
  check_data(o);
  const int n = o.elements * o.order;
  std::vector<Point> coordinates;
  for (int a = 0; a <= n; ++a) {
    const double share = static_cast<double>(a) / n;
    Point X{};
    for (std::size_t i = 0; i < 3; ++i) X[i] = (1 - share) * o.from[i] + share * o.to[i];
    coordinates.push_back(X);
  }
  constexpr std::array types{ElementType::bar2, ElementType::bar3, ElementType::bar4};
  Mesh mesh = one_block(Line::name, types.at(static_cast<std::size_t>(o.order) - 1), std::move(coordinates));
  for (int e = 0; e < o.elements; ++e) {
    std::vector<int> bar{e * o.order, (e + 1) * o.order};
    for (int a = 1; a < o.order; ++a) bar.push_back(e * o.order + a);
    mesh.blocks.front().elements.push_back(bar);
  }
  mesh.node_sets = {{1, "start", {0}}, {2, "end", {n}}};
  number_elements(mesh);
  return mesh;
}

}  // namespace mortise::recipes
