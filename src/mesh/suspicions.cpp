// What is allowed in a mesh, but seldom meant.
#include "mesh/suspicions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mortise {

namespace {

constexpr double coincidence = 1e-6;  ///< distance over element size below which two nodes are in one place
constexpr double size_ratio = 1e4;

/// Longest edge of each element, over all blocks.
std::vector<double> element_sizes(const Mesh& mesh) {
  std::vector<double> sizes;
  for (const Block& block : mesh.blocks)
    for (const auto& element : block.elements) sizes.push_back(longest_edge(mesh, block.elements.type(), element));
  return sizes;
}

/// Size of the smallest element at each node.
std::vector<double> node_sizes(const Mesh& mesh, const std::vector<double>& element_size) {
  std::vector<double> sizes(mesh.coordinates.size(), std::numeric_limits<double>::infinity());
  auto size = element_size.begin();
  for (const Block& block : mesh.blocks)
    for (const auto& element : block.elements) {
      for (int a : element) {
        double& at_node = sizes[static_cast<std::size_t>(a)];
        at_node = std::min(at_node, *size);
      }
      ++size;
    }
  return sizes;
}

/// Sorts the nodes along a direction in which no two of a regular mesh coincide, then compares neighbours only.
void find_coincident_nodes(const Mesh& mesh, const std::vector<double>& element_size, std::vector<std::string>& warnings) {
  const Point direction{std::sqrt(1.0 / 6), std::sqrt(2.0 / 6), std::sqrt(3.0 / 6)};
  const std::vector<double> size = node_sizes(mesh, element_size);
  std::vector<std::pair<double, int>> along;  // position, node
  for (int a = 0; a < n_nodes(mesh); ++a) {
    const Point& X = mesh.coordinates[static_cast<std::size_t>(a)];
    along.emplace_back(X[0] * direction[0] + X[1] * direction[1] + X[2] * direction[2], a);
  }
  std::sort(along.begin(), along.end());

  std::size_t n_pairs = 0;
  std::pair<int, int> first{n_nodes(mesh), 0};
  for (auto a = along.begin(); a != along.end(); ++a)
    for (auto b = a + 1; b != along.end() && b->first - a->first <= coincidence * size[static_cast<std::size_t>(a->second)];
         ++b) {
      const auto i = static_cast<std::size_t>(a->second), j = static_cast<std::size_t>(b->second);
      const Point &X = mesh.coordinates[i], &Y = mesh.coordinates[j];
      if (std::hypot(Y[0] - X[0], Y[1] - X[1], Y[2] - X[2]) > coincidence * std::min(size[i], size[j])) continue;
      ++n_pairs;
      const std::pair<int, int> nodes = std::minmax(a->second, b->second);
      first = std::min(first, nodes);
    }
  if (n_pairs == 0) return;
  const auto number = [&](int a) { return mesh.node_numbers[static_cast<std::size_t>(a)]; };
  warnings.push_back(
      fmt::format("{}: {} pair{} of nodes in one place (first: nodes {} and {}) - their elements are not joined; right where "
                  "surfaces touch at the start, otherwise merge them",
                  mesh.source, n_pairs, n_pairs == 1 ? "" : "s", number(first.first), number(first.second)));
}

void compare_sizes(const Mesh& mesh, const std::vector<double>& element_size, std::vector<std::string>& warnings) {
  const auto is_smaller = [](double a, double b) { return a > 0 && (!(b > 0) || a < b); };  // points have no size
  const auto least = std::min_element(element_size.begin(), element_size.end(), is_smaller);
  const auto most = std::max_element(element_size.begin(), element_size.end());
  if (*most <= size_ratio * *least) return;
  const auto number = [&](auto size) { return mesh.element_numbers[static_cast<std::size_t>(size - element_size.begin())]; };
  warnings.push_back(
      fmt::format("{}: the longest edges of elements {} and {} are {:.3g} and {:.3g} - sizes so different make a "
                  "badly conditioned system; is one of them meant in another unit?",
                  mesh.source, number(least), number(most), *least, *most));
}

}  // namespace

std::vector<std::string> mesh_warnings(const Mesh& mesh) {
  const std::vector<double> sizes = element_sizes(mesh);
  std::vector<std::string> warnings;
  find_coincident_nodes(mesh, sizes, warnings);
  compare_sizes(mesh, sizes, warnings);
  return warnings;
}

}  // namespace mortise
