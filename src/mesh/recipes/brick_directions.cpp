#include "mesh/recipes/brick_directions.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace mortise::recipes {

namespace {

constexpr std::array<int, 8> bits_of_corner{0, 1, 3, 2,
                                            4, 5, 7, 6};  // 1: at the end of xi, 2: of eta, 4: of zeta; its own inverse

/// An edge seen from one of its ends.
struct Directed {
  int edge;
  bool is_against;  ///< the edge's own direction
};

/// Edges in classes of equal direction (a disjoint-set forest); each knows its direction relative to a parent.
class EdgeClasses {
 public:
  /// The edge between two nodes; when first seen its own direction is from `from` to `to`.
  Directed between(int from, int to) {
    const auto [at, is_new] = edges_.emplace(std::minmax(from, to), Edge{static_cast<int>(parents_.size()), from});
    if (is_new) parents_.push_back({at->second.number, false});
    return {at->second.number, at->second.from != from};
  }

  /// The first edge of its class, and whether the given direction is against that edge's own.
  Directed first(Directed edge) const {
    while (parents_[static_cast<std::size_t>(edge.edge)].edge != edge.edge) {
      const Directed& parent = parents_[static_cast<std::size_t>(edge.edge)];
      edge = {parent.edge, edge.is_against != parent.is_against};
    }
    return edge;
  }

  /// Makes the two directions the same one.
  void unite(const Directed& one, const Directed& other) {
    Directed a = first(one), b = first(other);
    assert(a.edge != b.edge || a.is_against == b.is_against);
    if (a.edge > b.edge) std::swap(a, b);
    if (a.edge < b.edge) parents_[static_cast<std::size_t>(b.edge)] = {a.edge, a.is_against != b.is_against};
  }

 private:
  struct Edge {
    int number, from;
  };
  std::map<std::pair<int, int>, Edge> edges_;
  std::vector<Directed> parents_;
};

/// The edges of a brick along one direction.
std::array<Directed, 4> edges_along(int direction, ElementNodeList brick, EdgeClasses& classes) {
  std::array<Directed, 4> edges{};
  std::size_t n = 0;
  for (std::size_t bits = 0; bits < 8; ++bits) {
    const std::size_t along = std::size_t{1} << direction;
    if ((bits & along) == 0)
      edges[n++] = classes.between(brick[static_cast<std::size_t>(bits_of_corner[bits])],
                                   brick[static_cast<std::size_t>(bits_of_corner[bits | along])]);
  }
  return edges;
}

}  // namespace

std::vector<Reversed> reversed_directions(const ElementList& bricks) {
  EdgeClasses classes;
  for (const auto& brick : bricks)
    for (int direction = 0; direction < 3; ++direction) {
      const auto edges = edges_along(direction, brick, classes);
      for (std::size_t k = 1; k < 4; ++k) classes.unite(edges[0], edges[k]);
    }
  std::vector<Reversed> reversed;
  for (const auto& brick : bricks) {
    reversed.emplace_back();
    for (int direction = 0; direction < 3; ++direction)
      reversed.back()[static_cast<std::size_t>(direction)] = classes.first(edges_along(direction, brick, classes)[0]).is_against;
  }
  return reversed;
}

int reversed_corner(int corner, const Reversed& reversed) {
  const int bits = bits_of_corner[static_cast<std::size_t>(corner)] ^ (reversed[0] + 2 * reversed[1] + 4 * reversed[2]);
  return bits_of_corner[static_cast<std::size_t>(bits)];
}

}  // namespace mortise::recipes
