// Counting elements, naming the nodes of a side, measuring an element.
#include "mesh/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mortise {

namespace {

/// Corners of each face of a hex8 in the Exodus side numbering; right-handed about the outward normal.
constexpr std::array<std::array<int, 4>, 6> hex8_faces{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

}  // namespace

int n_elements(const Mesh& mesh) {
  std::size_t n = 0;
  for (const Block& block : mesh.blocks) n += block.elements.size();
  return static_cast<int>(n);
}

const std::array<int, 8>& element_nodes(const Mesh& mesh, int e) {
  assert(e >= 0 && e < n_elements(mesh));
  std::size_t in_block = static_cast<std::size_t>(e);
  std::size_t b = 0;
  while (in_block >= mesh.blocks[b].elements.size()) in_block -= mesh.blocks[b++].elements.size();
  return mesh.blocks[b].elements[in_block];
}

std::array<int, 4> side_nodes(const Mesh& mesh, Side side) {
  assert(side.face >= 0 && side.face < 6);
  const std::array<int, 8>& nodes = element_nodes(mesh, side.element);
  const std::array<int, 4>& face = hex8_faces[static_cast<std::size_t>(side.face)];
  std::array<int, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = nodes[static_cast<std::size_t>(face[i])];
  return result;
}

double longest_edge(const Mesh& mesh, const std::array<int, 8>& element) {
  constexpr std::array<std::array<std::size_t, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  double longest = 0;
  for (const auto& [a, b] : edges) {
    const Point &X = mesh.coordinates[static_cast<std::size_t>(element[a])],
                &Y = mesh.coordinates[static_cast<std::size_t>(element[b])];
    longest = std::max(longest, std::hypot(Y[0] - X[0], Y[1] - X[1], Y[2] - X[2]));
  }
  return longest;
}

}  // namespace mortise
