// Counting elements and naming the nodes of a side.
#include "mesh/mesh.hpp"

#include <cassert>

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

}  // namespace mortise
