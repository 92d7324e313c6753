// Lattices of hexahedra: a shape is one or several of them, glued where their nodes have the same key.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise::recipes {

/// What a node is, in whole numbers that the shape chooses: lattice nodes of equal key are one node. So a direction is closed by
/// counting modulo its cells, and lattices are glued without a distance that decides.
using Key = std::array<int, 4>;

/// cells[0] x cells[1] x cells[2] hexahedra; i, j, k run along right-handed directions of the shape.
struct Lattice {
  std::array<int, 3> cells;
  std::function<Key(int i, int j, int k)> key;  ///< of a lattice node, 0 <= i <= cells[0] and so on
  std::array<std::string, 6> sides;  ///< names of the faces i = 0, i = end, j = 0, j = end, k = 0, k = end; empty: not a side
};

/// The lattice along x, y, z of a block and its relatives, with the sides of a block; keys are {i, j, k, 0}.
Lattice box_lattice(const std::array<int, 3>& elements);

/// One block of hex8 named `recipe`, side sets and node sets in the order in which the lattices name them; nodes and elements are
/// counted from 1 through the lattices, i fastest. Faces of the same name in several lattices are one side.
/// @param position reference position of the node of a key
/// @throws MeshError where elements have no positive volume
Mesh hexahedra(const std::string& recipe, const std::vector<Lattice>& lattices, const std::function<Point(const Key&)>& position);

}  // namespace mortise::recipes
