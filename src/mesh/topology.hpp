// The types of elements that a mesh may hold: their Exodus names, faces and edges.
#pragma once

#include <array>
#include <cassert>
#include <string>
#include <vector>

#include "physics/elements/tetrahedra.hpp"
#include "physics/elements/wedge6.hpp"

namespace mortise {

enum class ElementType { hex8, hex20, hex27, tet4, tet10, wedge6, sphere, bar2, bar3, bar4 };

/// Solid elements: those with a volume, that bodies are made of.
inline constexpr std::array element_types{ElementType::hex8, ElementType::hex20, ElementType::hex27,
                                          ElementType::tet4, ElementType::tet10, ElementType::wedge6};

/// Elements without volume: points that may carry a mass, and bars that strings are made of.
inline constexpr std::array discrete_types{ElementType::sphere, ElementType::bar2, ElementType::bar3, ElementType::bar4};

constexpr bool is_bar(ElementType type) {
  return type == ElementType::bar2 || type == ElementType::bar3 || type == ElementType::bar4;
}
constexpr bool is_solid(ElementType type) { return type != ElementType::sphere && !is_bar(type); }

/// What is where in an element; nodes are counted from 0 in Exodus order.
struct Topology {
  std::string name;   ///< as in messages, e.g. "hex8"
  std::string shape;  ///< as Exodus files have it, without the number of nodes, e.g. "HEX"
  int n_nodes;
  int n_corners;  ///< the first nodes
  std::vector<std::vector<int>>
      faces;  ///< Exodus side numbering; corners right-handed about the outward normal, then edges, middle
  std::vector<std::array<int, 2>> edges;  ///< between corners
};

const Topology& topology(ElementType type);

/// Calls f(Hex8{}), f(Tet10{}) ...: the shape functions that belong to a type. Precondition: a solid one.
template <class Function>
decltype(auto) with_element(ElementType type, Function f) {
  assert(is_solid(type));
  switch (type) {
    case ElementType::hex20:
      return f(Hex20{});
    case ElementType::hex27:
      return f(Hex27{});
    case ElementType::tet4:
      return f(Tet4{});
    case ElementType::tet10:
      return f(Tet10{});
    case ElementType::wedge6:
      return f(Wedge6{});
    default:
      return f(Hex8{});
  }
}

}  // namespace mortise
