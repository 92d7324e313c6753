// The brick, uniform or graded.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "mesh/checks.hpp"
#include "mesh/recipes/recipes.hpp"

namespace mortise {

namespace {

template <class T>
std::string text(const std::array<T, 3>& values) {
  return fmt::format("{{{}}}", fmt::join(values, ", "));
}

void check_data(const std::string& source, const std::array<double, 3>& size, const std::array<int, 3>& elements,
                const std::array<double, 3>& grading) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  MeshErrors errors(source);
  double n = 1;
  for (int count : elements) n *= static_cast<double>(count) + 1;
  if (!positive(size[0]) || !positive(size[1]) || !positive(size[2]))
    errors.add("M41", fmt::format("\"size\" = {} - must be positive", text(size)));
  if (elements[0] < 1 || elements[1] < 1 || elements[2] < 1)
    errors.add("M41", fmt::format("\"elements\" = {} - must be at least 1", text(elements)));
  else if (n > std::numeric_limits<int>::max())
    errors.add("M06", fmt::format("\"elements\" = {} makes {:.0f} nodes - at most {}", text(elements), n,
                                  std::numeric_limits<int>::max()));
  if (!positive(grading[0]) || !positive(grading[1]) || !positive(grading[2]))
    errors.add("M41", fmt::format("\"grading\" = {} - must be positive", text(grading)));
  errors.throw_if_any();
}

/// Positions of the n + 1 nodes along an axis of the given length; element sizes form a geometric sequence, last / first =
/// grading.
///   x_k = length (r^k - 1) / (r^n - 1),  r = grading^(1/(n-1)); both ends exact.
std::vector<double> graded_axis(double length, int n, double grading) {
  std::vector<double> x(static_cast<std::size_t>(n) + 1);
  const double log_r = n > 1 ? std::log(grading) / (n - 1) : 0.0;
  for (int k = 0; k < n; ++k)  // expm1 keeps its digits as r tends to 1
    x[static_cast<std::size_t>(k)] = log_r == 0.0 ? length * k / n : length * (std::expm1(k * log_r) / std::expm1(n * log_r));
  x.back() = length;
  return x;
}

}  // namespace

Mesh graded_block(const std::array<double, 3>& size, const std::array<int, 3>& elements, const std::array<double, 3>& grading) {
  Mesh mesh;
  mesh.source = grading == std::array<double, 3>{1, 1, 1} ? "recipe \"block\"" : "recipe \"graded block\"";
  check_data(mesh.source, size, elements, grading);
  const auto [nx, ny, nz] = elements;
  const std::vector<double> x = graded_axis(size[0], nx, grading[0]);
  const std::vector<double> y = graded_axis(size[1], ny, grading[1]);
  const std::vector<double> z = graded_axis(size[2], nz, grading[2]);
  for (double Z : z)
    for (double Y : y)
      for (double X : x) mesh.coordinates.push_back({X, Y, Z});

  // Sides in the order of their names; the face of each in the Exodus numbering, from 0.
  mesh.side_sets = {{1, "left", {}}, {2, "right", {}}, {3, "front", {}}, {4, "back", {}}, {5, "bottom", {}}, {6, "top", {}}};
  constexpr std::array<int, 6> face{3, 1, 0, 2, 4, 5};
  mesh.blocks = {{1, "block", {}}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int e = static_cast<int>(mesh.blocks[0].elements.size());
        const int a = (k * (ny + 1) + j) * (nx + 1) + i;
        const int b = a + nx + 1;            // one further in y
        const int up = (nx + 1) * (ny + 1);  // one further in z
        mesh.blocks[0].elements.push_back({a, a + 1, b + 1, b, a + up, a + up + 1, b + up + 1, b + up});
        const std::array<bool, 6> at_side{i == 0, i == nx - 1, j == 0, j == ny - 1, k == 0, k == nz - 1};
        for (std::size_t s = 0; s < 6; ++s)
          if (at_side[s]) mesh.side_sets[s].sides.push_back({e, face[s]});
      }

  for (const SideSet& set : mesh.side_sets) mesh.node_sets.push_back({set.id, set.name, {}});
  int a = 0;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i, ++a) {
        const std::array<bool, 6> at_side{i == 0, i == nx, j == 0, j == ny, k == 0, k == nz};
        for (std::size_t s = 0; s < 6; ++s)
          if (at_side[s]) mesh.node_sets[s].nodes.push_back(a);
      }

  for (int n = 1; n <= n_nodes(mesh); ++n) mesh.node_numbers.push_back(n);
  for (int n = 1; n <= n_elements(mesh); ++n) mesh.element_numbers.push_back(n);
  check_mesh(mesh);  // an extreme grading makes flat elements
  return mesh;
}

Mesh block(const std::array<double, 3>& size, const std::array<int, 3>& elements) {
  return graded_block(size, elements, {1, 1, 1});
}

}  // namespace mortise
