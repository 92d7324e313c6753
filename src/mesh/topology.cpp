// Tables of the Exodus manual (Schoof & Yarberry 1994, with later additions), from 0.
#include "mesh/topology.hpp"

namespace mortise {

namespace {

using Faces = std::vector<std::vector<int>>;
using Edges = std::vector<std::array<int, 2>>;

const Edges hex_edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
const Edges tet_edges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
const Edges wedge_edges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}};

const std::array<Topology, element_types.size() + discrete_types.size()> topologies{
    {{"hex8", "HEX", 8, 8, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}, hex_edges},
     {"hex20",
      "HEX",
      20,
      8,
      {{0, 1, 5, 4, 8, 13, 16, 12},
       {1, 2, 6, 5, 9, 14, 17, 13},
       {2, 3, 7, 6, 10, 15, 18, 14},
       {0, 4, 7, 3, 12, 19, 15, 11},
       {0, 3, 2, 1, 11, 10, 9, 8},
       {4, 5, 6, 7, 16, 17, 18, 19}},
      hex_edges},
     {"hex27",
      "HEX",
      27,
      8,
      {{0, 1, 5, 4, 8, 13, 16, 12, 25},
       {1, 2, 6, 5, 9, 14, 17, 13, 24},
       {2, 3, 7, 6, 10, 15, 18, 14, 26},
       {0, 4, 7, 3, 12, 19, 15, 11, 23},
       {0, 3, 2, 1, 11, 10, 9, 8, 21},
       {4, 5, 6, 7, 16, 17, 18, 19, 22}},
      hex_edges},
     {"tet4", "TETRA", 4, 4, {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}}, tet_edges},
     {"tet10", "TETRA", 10, 4, {{0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}, {0, 2, 1, 6, 5, 4}}, tet_edges},
     {"wedge6", "WEDGE", 6, 6, {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}}, wedge_edges},
     {"sphere", "SPHERE", 1, 1, {}, {}},
     {"bar2", "BAR", 2, 2, {}, {{0, 1}}},
     {"bar3", "BAR", 3, 2, {}, {{0, 1}}},
     {"bar4", "BAR", 4, 2, {}, {{0, 1}}}}};

}  // namespace

const Topology& topology(ElementType type) { return topologies[static_cast<std::size_t>(type)]; }

}  // namespace mortise
