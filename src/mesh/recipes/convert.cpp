#include "mesh/recipes/convert.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

#include "mesh/recipes/brick_directions.hpp"

namespace mortise::recipes {

namespace {

using Corners = std::vector<std::vector<int>>;  ///< of each part of a brick

/// How a brick is cut into parts with corners only.
const Corners& parts_of_brick(ElementType type) {
  static const Corners whole{{0, 1, 2, 3, 4, 5, 6, 7}};
  static const Corners wedges{{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};
  static const Corners tetrahedra{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  switch (type) {
    case ElementType::tet4:
    case ElementType::tet10:
      return tetrahedra;
    case ElementType::wedge6:
      return wedges;
    default:
      return whole;
  }
}

/// The parts of each brick. Tetrahedra lie about the diagonal from where all three directions begin to where they end, which cuts
/// each side from where its two begin: neighbours cut the side between them alike if their directions agree.
std::vector<Corners> parts_of_bricks(const ElementList& bricks, ElementType type) {
  const Corners& parts = parts_of_brick(type);
  std::vector<Corners> of_bricks(bricks.size(), parts);
  if (parts.size() < 6) return of_bricks;
  const auto reversed = reversed_directions(bricks);
  for (std::size_t e = 0; e < bricks.size(); ++e) {
    const bool is_mirrored = (reversed[e][0] + reversed[e][1] + reversed[e][2]) % 2 == 1;
    for (auto& part : of_bricks[e]) {
      for (int& corner : part) corner = reversed_corner(corner, reversed[e]);
      if (is_mirrored) std::swap(part[1], part[2]);
    }
  }
  return of_bricks;
}

/// Corners that a node of an element lies in the middle of; the node itself for a corner. From the shape functions of the element
/// with corners only: those that do not vanish at the node.
std::vector<std::vector<int>> surroundings(ElementType type) {
  return with_element(type, [&](auto kind) {
    using Element = decltype(kind);
    const ElementType linear = topology(type).n_corners == 8   ? ElementType::hex8
                               : topology(type).n_corners == 6 ? ElementType::wedge6
                                                               : ElementType::tet4;
    std::vector<std::vector<int>> around(Element::n_nodes);
    with_element(linear, [&](auto corner_kind) {
      using Linear = decltype(corner_kind);
      for (int a = 0; a < Element::n_nodes; ++a)
        for (int b = 0; b < Linear::n_nodes; ++b)
          if (Linear::N(b, {Element::node[a][0], Element::node[a][1], Element::node[a][2]}) > 0)
            around[static_cast<std::size_t>(a)].push_back(b);
    });
    return around;
  });
}

/// The nodes of a mesh, and those added in the middle of some of them.
class Nodes {
 public:
  explicit Nodes(std::vector<Point>& coordinates) : coordinates_(coordinates) {}

  /// The node in the middle of `corners`; the same for the same corners.
  int between(std::vector<int> corners) {
    if (corners.size() == 1) return corners.front();
    std::sort(corners.begin(), corners.end());
    const auto [entry, is_new] = made_.emplace(corners, static_cast<int>(coordinates_.size()));
    if (is_new) {
      Point middle{0, 0, 0};
      for (int a : corners)
        for (std::size_t i = 0; i < 3; ++i) middle[i] += coordinates_[static_cast<std::size_t>(a)][i];
      for (double& x : middle) x /= static_cast<double>(corners.size());
      coordinates_.push_back(middle);
    }
    return entry->second;
  }

 private:
  std::vector<Point>& coordinates_;
  std::map<std::vector<int>, int> made_;
};

/// Sides of the parts of brick `e` that lie on the brick's side.
std::vector<Side> sides_of_parts(const Mesh& mesh, int first, int n_parts, const std::vector<int>& brick_side) {
  std::vector<Side> sides;
  for (int part = first; part < first + n_parts; ++part) {
    const auto& faces = topology(element_type(mesh, part)).faces;
    for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
      const auto nodes = side_nodes(mesh, {part, face});
      const auto corners_end = nodes.begin() + static_cast<long>(n_side_corners(mesh, {part, face}));
      const bool is_on_it = std::all_of(nodes.begin(), corners_end, [&](int a) {
        return std::find(brick_side.begin(), brick_side.end(), a) != brick_side.end();
      });
      if (is_on_it) sides.push_back({part, face});
    }
  }
  return sides;
}

}  // namespace

Mesh with_elements(Mesh hexahedra, ElementType type) {
  if (type == ElementType::hex8) return hexahedra;
  assert(hexahedra.blocks.size() == 1);
  const Mesh bricks = hexahedra;
  Mesh& mesh = hexahedra;
  mesh.blocks.front().elements = ElementList(type);
  Nodes nodes(mesh.coordinates);
  const auto parts = parts_of_bricks(bricks.blocks.front().elements, type);
  const auto around = surroundings(type);
  auto parts_here = parts.begin();
  for (const auto& brick : bricks.blocks.front().elements)
    for (const auto& part : *parts_here++) {
      std::vector<int> element;
      for (const auto& corners : around) {
        std::vector<int> of_mesh;
        for (int corner : corners) of_mesh.push_back(brick[static_cast<std::size_t>(part[static_cast<std::size_t>(corner)])]);
        element.push_back(nodes.between(of_mesh));
      }
      mesh.blocks.front().elements.push_back(element);
    }

  const int n_parts = static_cast<int>(parts_of_brick(type).size());
  for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
    auto& sides = mesh.side_sets[s].sides;
    sides.clear();
    for (const Side& side : bricks.side_sets[s].sides)
      for (const Side& of_part : sides_of_parts(mesh, side.element * n_parts, n_parts, side_nodes(bricks, side)))
        sides.push_back(of_part);
    auto& set = mesh.node_sets[s].nodes;
    set.clear();
    for (const Side& side : sides)
      for (int a : side_nodes(mesh, side)) set.push_back(a);
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
  }
  mesh.node_numbers.resize(mesh.coordinates.size());
  std::iota(mesh.node_numbers.begin(), mesh.node_numbers.end(), 1);
  mesh.element_numbers.resize(static_cast<std::size_t>(n_elements(mesh)));
  std::iota(mesh.element_numbers.begin(), mesh.element_numbers.end(), 1);
  return hexahedra;
}

}  // namespace mortise::recipes
