// Counting elements, naming the nodes of a side, measuring an element.
#include "mesh/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace mortise {

int n_elements(const Mesh& mesh) {
  std::size_t n = 0;
  for (const Block& block : mesh.blocks) n += block.elements.size();
  return static_cast<int>(n);
}

namespace {

/// Element `e` of all as element `in_block` of its block.
std::pair<const Block*, std::size_t> find_element(const Mesh& mesh, int e) {
  assert(e >= 0 && e < n_elements(mesh));
  std::size_t in_block = static_cast<std::size_t>(e);
  std::size_t b = 0;
  while (in_block >= mesh.blocks[b].elements.size()) in_block -= mesh.blocks[b++].elements.size();
  return {&mesh.blocks[b], in_block};
}

const std::vector<int>& face_of(const Mesh& mesh, Side side) {
  const auto& faces = topology(element_type(mesh, side.element)).faces;
  assert(side.face >= 0 && static_cast<std::size_t>(side.face) < faces.size());
  return faces[static_cast<std::size_t>(side.face)];
}

}  // namespace

ElementType element_type(const Mesh& mesh, int e) { return find_element(mesh, e).first->elements.type(); }

ElementNodeList element_nodes(const Mesh& mesh, int e) {
  const auto [block, in_block] = find_element(mesh, e);
  return block->elements[in_block];
}

std::vector<int> side_nodes(const Mesh& mesh, Side side) {
  const ElementNodeList nodes = element_nodes(mesh, side.element);
  std::vector<int> result;
  for (int a : face_of(mesh, side)) result.push_back(nodes[static_cast<std::size_t>(a)]);
  return result;
}

std::size_t n_side_corners(const Mesh& mesh, Side side) {
  const std::size_t n = face_of(mesh, side).size();
  return n == 3 || n == 6 ? 3 : 4;
}

std::pair<double, double> edge_range(const Mesh& mesh, ElementType type, ElementNodeList element) {
  double shortest = std::numeric_limits<double>::max(), longest = 0;
  for (const auto& [a, b] : topology(type).edges) {
    const Point &X = mesh.coordinates[static_cast<std::size_t>(element[static_cast<std::size_t>(a)])],
                &Y = mesh.coordinates[static_cast<std::size_t>(element[static_cast<std::size_t>(b)])];
    const double edge = std::hypot(Y[0] - X[0], Y[1] - X[1], Y[2] - X[2]);
    shortest = std::min(shortest, edge);
    longest = std::max(longest, edge);
  }
  return {shortest, longest};
}

}  // namespace mortise
