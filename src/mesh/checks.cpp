// The checks that every mesh passes before anything is computed on it.
#include "mesh/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "errors.hpp"
#include "physics/elements/bars.hpp"
#include "physics/elements/geometry.hpp"
#include "utf8.hpp"

namespace mortise {

namespace {

using Element = ElementNodeList;

std::string name_of(const char* kind, std::int64_t id, const std::string& name) {
  return name.empty() ? fmt::format("{} {}", kind, id) : fmt::format("{} {} \"{}\"", kind, id, printable(name));
}

/// `1 node` or `3 nodes`.
std::string count_of(std::size_t n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

/// Offenders of one kind in one place: how many, and where the first is.
struct Offenders {
  std::size_t n = 0;
  std::size_t first = 0;
  void note(std::size_t i) {
    if (n++ == 0) first = i;
  }
};

bool finite(const Point& x) { return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]); }

constexpr double largest_coordinate = 1e100;  ///< the product of three lengths must not overflow

/// Finite, and not so large that volumes overflow.
bool usable(const Point& x) {
  return std::all_of(x.begin(), x.end(), [](double x_i) { return std::abs(x_i) <= largest_coordinate; });
}

bool has_all_nodes(const Mesh& mesh, const Element& element) {
  return std::all_of(element.begin(), element.end(), [&](int a) { return a >= 0 && a < n_nodes(mesh); });
}

bool has_a_node_twice(Element nodes) {
  std::vector<int> element(nodes.begin(), nodes.end());
  std::sort(element.begin(), element.end());
  return std::adjacent_find(element.begin(), element.end()) != element.end();
}

/// Least det dX/dxi over the quadrature points of an element [length^3] and the point where it stands (counted from 1, first
/// coordinate fastest).
struct LeastJacobian {
  double value;
  int gauss_point;
  double scale;  ///< what the determinant would be for a cube with the longest edge of the element
};

/// The same for a bar: dX/dxi along the chord between its ends [length].
LeastJacobian least_jacobian_of_bar(const Mesh& mesh, ElementType type, ElementNodeList element) {
  LeastJacobian least{0, 1, longest_edge(mesh, type, element)};
  if (least.scale == 0) return least;
  const auto position = [&](std::size_t a) {
    const Point& X = mesh.coordinates[static_cast<std::size_t>(element[a])];
    return Vec3<double>{X[0], X[1], X[2]};
  };
  const Vec3<double> first = position(0), chord = position(1) - first;
  const auto rule = bar_rule(static_cast<int>(element.size()) - 1);
  for (std::size_t g = 0; g < rule.size(); ++g) {
    const BarValues dN = bar_derivatives(element.size(), rule[g].xi);
    double along = 0;
    for (std::size_t a = 1; a < element.size(); ++a) along += dN[a] * dot(position(a) - first, chord);
    along /= least.scale;
    if (g == 0 || !(along >= least.value)) least = {along, static_cast<int>(g) + 1, least.scale};
  }
  return least;
}

LeastJacobian least_jacobian(const Mesh& mesh, ElementType type, ElementNodeList element) {
  if (type == ElementType::sphere) return {1, 0, 1};
  if (is_bar(type)) return least_jacobian_of_bar(mesh, type, element);
  return with_element(type, [&](auto kind) {
    using Element = decltype(kind);
    ElementNodes<Element> X;  // relative to the first corner, so that a mesh far from the origin loses no digits
    for (std::size_t a = 0; a < X.size(); ++a)
      for (std::size_t i = 0; i < 3; ++i)
        X[a][i] =
            mesh.coordinates[static_cast<std::size_t>(element[a])][i] - mesh.coordinates[static_cast<std::size_t>(element[0])][i];
    const double longest = longest_edge(mesh, type, element);
    LeastJacobian least{0, 0, longest * longest * longest / 8};
    for (std::size_t g = 0; g < Element::stiffness_rule.size(); ++g) {
      const double J = det(element_map<Element>(X, Element::stiffness_rule[g].xi));
      if (g == 0 || !(J >= least.value)) {
        least.value = J;
        least.gauss_point = static_cast<int>(g) + 1;
      }
    }
    return least;
  });
}

void check_coordinates(const Mesh& mesh, MeshErrors& errors) {
  Offenders not_finite, too_large;
  for (std::size_t a = 0; a < mesh.coordinates.size(); ++a) {
    const Point& x = mesh.coordinates[a];
    if (!finite(x)) {
      not_finite.note(a);
    } else if (!usable(x)) {
      too_large.note(a);
    }
  }
  const auto report = [&](const char* code, const Offenders& bad, const std::string& what) {
    if (bad.n == 0) return;
    const Point& x = mesh.coordinates[bad.first];
    errors.add(code, fmt::format("{} with coordinates that are {} (first: node {}, ({}, {}, {}))", count_of(bad.n, "node"), what,
                                 mesh.node_numbers[bad.first], x[0], x[1], x[2]));
  };
  report("M16", not_finite, "not finite");
  report("M18", too_large, fmt::format("too large - at most {:g}, or volumes overflow", largest_coordinate));
}

/// Elements of one block; `first` is the index of its first element over all blocks. Says whether the connectivity is sound.
bool check_block(const Mesh& mesh, const Block& block, std::size_t first, MeshErrors& errors) {
  Offenders out_of_range, repeated, inverted;
  LeastJacobian first_inverted{};
  for (std::size_t e = 0; e < block.elements.size(); ++e) {
    const Element element = block.elements[e];
    if (!has_all_nodes(mesh, element)) {
      out_of_range.note(e);
    } else if (has_a_node_twice(element)) {
      repeated.note(e);
    } else if (std::all_of(element.begin(), element.end(),
                           [&](int a) { return usable(mesh.coordinates[static_cast<std::size_t>(a)]); })) {
      const LeastJacobian least = least_jacobian(mesh, block.elements.type(), element);
      if (least.value > 1e-14 * least.scale) continue;  // below that the determinant is round-off of a flat element
      if (inverted.n == 0) first_inverted = least;
      inverted.note(e);
    }
  }
  const auto number = [&](const Offenders& o) { return mesh.element_numbers[first + o.first]; };
  if (out_of_range.n > 0) {
    const Element element = block.elements[out_of_range.first];
    const auto bad = std::find_if(element.begin(), element.end(), [&](int a) { return a < 0 || a >= n_nodes(mesh); });
    errors.add("M13", fmt::format("{}: {} with nodes out of range (first: element {}, entry {}: node {}) - nodes are 1 to {}",
                                  describe(block), count_of(out_of_range.n, "element"), number(out_of_range),
                                  bad - element.begin() + 1, static_cast<std::int64_t>(*bad) + 1, n_nodes(mesh)));
  }
  if (repeated.n > 0) {
    const Element element = block.elements[repeated.first];
    std::vector<int> sorted(element.begin(), element.end());
    std::sort(sorted.begin(), sorted.end());
    const int twice = *std::adjacent_find(sorted.begin(), sorted.end());
    errors.add("M14",
               fmt::format("{}: {} with a node twice (first: element {}, node {}) - a {} has {} different nodes", describe(block),
                           count_of(repeated.n, "element"), number(repeated), mesh.node_numbers[static_cast<std::size_t>(twice)],
                           topology(block.elements.type()).name, sorted.size()));
  }
  if (inverted.n > 0)
    errors.add(
        "M21",
        fmt::format("{}: {} inverted or flat (first: element {}, det dX/dxi = {:.3g} at Gauss point {}) - must be positive; "
                    "check node order",
                    describe(block), count_of(inverted.n, "element"), number(inverted), first_inverted.value,
                    first_inverted.gauss_point));
  return out_of_range.n == 0 && repeated.n == 0;
}

/// Precondition: sound connectivity.
void check_orphans(const Mesh& mesh, MeshErrors& errors) {
  std::vector<bool> used(mesh.coordinates.size(), false);
  for (const Block& block : mesh.blocks)
    for (const Element element : block.elements)
      for (int a : element) used[static_cast<std::size_t>(a)] = true;
  constexpr std::size_t n_listed = 5;
  std::size_t n = 0;
  std::vector<std::string> listed;
  for (std::size_t a = 0; a < used.size(); ++a)
    if (!used[a] && n++ < n_listed) listed.push_back(std::to_string(mesh.node_numbers[a]));
  if (n > 0)
    errors.add("M17", fmt::format("{} without element (first: {}) - remove them, they would have no equation",
                                  count_of(n, "node"), join(listed)));
}

void check_numbers(const std::vector<std::int64_t>& numbers, const char* code, const char* what, MeshErrors& errors) {
  const auto low = std::find_if(numbers.begin(), numbers.end(), [](std::int64_t n) { return n < 1; });
  if (low != numbers.end())
    errors.add(code, fmt::format("{} number map: entry {} is {} - numbers are positive", what, low - numbers.begin() + 1, *low));
  std::vector<std::int64_t> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return;
  const auto n_distinct = std::unique(sorted.begin(), sorted.end()) - sorted.begin();
  errors.add(code, fmt::format("{} number map: {} twice (first: {}) - each {} needs a number of its own", what,
                               count_of(numbers.size() - static_cast<std::size_t>(n_distinct), "number"), *twice, what));
}

/// Ids and names of blocks, side sets or node sets.
template <class Entity>
void check_names(const std::vector<Entity>& entities, MeshErrors& errors) {
  std::set<std::int64_t> ids;
  std::set<std::string> names;
  for (const Entity& entity : entities) {
    if (entity.id < 0) errors.add("M27", fmt::format("{}: the id is negative", describe(entity)));
    if (entity.name != printable(entity.name))
      errors.add("M28", fmt::format("{}: the name is not UTF-8 text, or has control characters (shown as ?)", describe(entity)));
    if (!ids.insert(entity.id).second)
      errors.add("M26", fmt::format("{}: the id stands twice - ids are unique", describe(entity)));
    if (!entity.name.empty() && !names.insert(entity.name).second)
      errors.add("M26", fmt::format("{}: the name stands twice - names are unique", describe(entity)));
  }
}

void check_side_set(const Mesh& mesh, const SideSet& set, int n_mesh_elements, MeshErrors& errors) {
  if (set.sides.empty()) errors.add("M31", fmt::format("{} is empty", describe(set)));
  Offenders elements, faces, repeated;
  std::set<std::pair<int, int>> seen;
  const auto n_faces = [&](int e) { return static_cast<int>(topology(element_type(mesh, e)).faces.size()); };
  for (std::size_t i = 0; i < set.sides.size(); ++i) {
    const Side& side = set.sides[i];
    if (side.element < 0 || side.element >= n_mesh_elements) {
      elements.note(i);
    } else if (side.face < 0 || side.face >= n_faces(side.element)) {
      faces.note(i);
    } else if (!seen.insert({side.element, side.face}).second) {
      repeated.note(i);
    }
  }
  if (elements.n > 0)
    errors.add("M32", fmt::format("{}: {} of elements out of range (first: entry {}, element {}) - elements are 1 to {}",
                                  describe(set), count_of(elements.n, "side"), elements.first + 1,
                                  static_cast<std::int64_t>(set.sides[elements.first].element) + 1, n_mesh_elements));
  const auto number = [&](const Offenders& o) {
    return mesh.element_numbers[static_cast<std::size_t>(set.sides[o.first].element)];
  };
  if (faces.n > 0)
    errors.add("M33", fmt::format("{}: {} that its element does not have (first: entry {}, side {} of element {}) - sides of a "
                                  "{} are 1 to {}",
                                  describe(set), count_of(faces.n, "side"), faces.first + 1,
                                  static_cast<std::int64_t>(set.sides[faces.first].face) + 1, number(faces),
                                  topology(element_type(mesh, set.sides[faces.first].element)).name,
                                  n_faces(set.sides[faces.first].element)));
  if (repeated.n > 0)
    errors.add("M35", fmt::format("{}: {} listed twice (first: entry {}, side {} of element {}) - each once", describe(set),
                                  count_of(repeated.n, "side"), repeated.first + 1, set.sides[repeated.first].face + 1,
                                  number(repeated)));
}

void check_node_set(const Mesh& mesh, const NodeSet& set, MeshErrors& errors) {
  if (set.nodes.empty()) errors.add("M31", fmt::format("{} is empty", describe(set)));
  Offenders bad;
  for (std::size_t i = 0; i < set.nodes.size(); ++i)
    if (set.nodes[i] < 0 || set.nodes[i] >= n_nodes(mesh)) bad.note(i);
  if (bad.n > 0)
    errors.add("M34", fmt::format("{}: {} out of range (first: entry {}, node {}) - nodes are 1 to {}", describe(set),
                                  count_of(bad.n, "node"), bad.first + 1, static_cast<std::int64_t>(set.nodes[bad.first]) + 1,
                                  n_nodes(mesh)));
}

}  // namespace

void MeshErrors::add(const std::string& code, const std::string& text) {
  messages_.push_back(fmt::format("{}: error[{}] {}", source_, code, text));
}

void MeshErrors::throw_if_any() const {
  if (!messages_.empty()) throw MeshError(messages_);
}

std::string describe(const Block& block) { return name_of("block", block.id, block.name); }
std::string describe(const SideSet& set) { return name_of("side set", set.id, set.name); }
std::string describe(const NodeSet& set) { return name_of("node set", set.id, set.name); }

void check_mesh(const Mesh& mesh) {
  MeshErrors errors(mesh.source);
  const int n_mesh_elements = n_elements(mesh);
  assert(mesh.node_numbers.size() == mesh.coordinates.size());
  assert(mesh.element_numbers.size() == static_cast<std::size_t>(n_mesh_elements));
  if (mesh.coordinates.empty()) errors.add("M03", "no nodes");
  if (n_mesh_elements == 0) errors.add("M03", "no elements");
  errors.throw_if_any();

  check_coordinates(mesh, errors);
  std::size_t first = 0;
  bool sound = true;
  for (const Block& block : mesh.blocks) {
    sound = check_block(mesh, block, first, errors) && sound;
    first += block.elements.size();
  }
  if (sound) check_orphans(mesh, errors);  // otherwise the nodes that the bad elements missed would be reported too
  check_numbers(mesh.node_numbers, "M24", "node", errors);
  check_numbers(mesh.element_numbers, "M25", "element", errors);
  check_names(mesh.blocks, errors);
  check_names(mesh.side_sets, errors);
  check_names(mesh.node_sets, errors);
  for (const SideSet& set : mesh.side_sets) check_side_set(mesh, set, n_mesh_elements, errors);
  for (const NodeSet& set : mesh.node_sets) check_node_set(mesh, set, errors);
  errors.throw_if_any();
}

}  // namespace mortise
