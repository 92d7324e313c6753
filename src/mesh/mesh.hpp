// The mesh as the program sees it: nodes, blocks of elements, named sides and node sets.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mortise {

using Point = std::array<double, 3>;

/// One block of hex8 elements, with the nodes of each element in Exodus order.
struct Block {
  std::int64_t id = 1;                       ///< Exodus block id, > 0
  std::string name;                          ///< may be empty
  std::vector<std::array<int, 8>> elements;  ///< 0-based indices into Mesh::coordinates
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

/// Nodes of element `e`, counted over all blocks in order.
const std::array<int, 8>& element_nodes(const Mesh& mesh, int e);

/// Nodes of one side, ordered so that the normal by the right-hand rule points out of the element.
std::array<int, 4> side_nodes(const Mesh& mesh, Side side);

/// Length of the longest of the 12 edges of an element.
double longest_edge(const Mesh& mesh, const std::array<int, 8>& element);

}  // namespace mortise
