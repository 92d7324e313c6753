// The mesh as the program sees it: nodes, blocks of elements, named sides and node sets.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/element_list.hpp"

namespace mortise {

using Point = std::array<double, 3>;

/// One block of elements of one type.
struct Block {
  std::int64_t id = 1;  ///< Exodus block id, > 0
  std::string name;     ///< may be empty
  ElementList elements;
};

/// A side of an element: element counted over all blocks in order, face counted from 0 in the Exodus numbering.
struct Side {
  int element;
  int face;
};

struct SideSet {
  std::int64_t id = 1;
  std::string name;
  std::vector<Side> sides;
};

struct NodeSet {
  std::int64_t id = 1;
  std::string name;
  std::vector<int> nodes;
};

/// Nodes, elements and sets; the numbers of the user are kept for messages and output.
struct Mesh {
  std::string source;                         ///< file name or recipe, for messages
  std::vector<Point> coordinates;             ///< reference positions
  std::vector<std::int64_t> node_numbers;     ///< the user's number of each node
  std::vector<std::int64_t> element_numbers;  ///< the user's number of each element, over all blocks in order
  std::vector<Block> blocks;
  std::vector<SideSet> side_sets;
  std::vector<NodeSet> node_sets;
};

/// Number of nodes of a mesh.
inline int n_nodes(const Mesh& mesh) { return static_cast<int>(mesh.coordinates.size()); }

/// Number of elements over all blocks.
int n_elements(const Mesh& mesh);

/// Type of element `e`, counted over all blocks in order.
ElementType element_type(const Mesh& mesh, int e);

/// Nodes of element `e`, counted over all blocks in order.
ElementNodeList element_nodes(const Mesh& mesh, int e);

/// Nodes of one side: corners, ordered so that the normal by the right-hand rule points out of the element, then the middles of
/// edges, then the middle.
std::vector<int> side_nodes(const Mesh& mesh, Side side);

/// Number of corners of a side.
std::size_t n_side_corners(const Mesh& mesh, Side side);

/// Lengths of the shortest and the longest edge of an element, from corner to corner.
std::pair<double, double> edge_range(const Mesh& mesh, ElementType type, ElementNodeList element);
inline double longest_edge(const Mesh& mesh, ElementType type, ElementNodeList element) {
  return edge_range(mesh, type, element).second;
}

}  // namespace mortise
