// Where an element of a block stands: its nodes, their unknowns and their reference positions.
#pragma once

#include <vector>

#include "assembly/dof_space.hpp"
#include "physics/elements/geometry.hpp"

namespace mortise {

template <class Element>
struct ElementPlace {
  std::vector<int> nodes, local;  ///< numbers of the nodes, and where their unknowns begin in vectors
  ElementNodes<Element> X;        ///< [m]
};

/// @param block of elements (element_block.hpp)
template <class Block>
ElementPlace<typename Block::Element> place_of(const Block& block, std::size_t e, const Mesh& mesh, const DofSpace& dofs) {
  ElementPlace<typename Block::Element> place;
  for (std::size_t a = 0; a < place.X.size(); ++a) {
    const int node = block.points(e)[a];
    place.nodes.push_back(node);
    place.local.push_back(dofs.local(node));
    place.X[a] = mesh.coordinates[node];
  }
  return place;
}

}  // namespace mortise
