// The quarter of a round block with a spherical lower face: a core of squares within round shells.
#include <algorithm>
#include <cmath>

#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"
#include "mesh/recipes/round_core.hpp"

namespace mortise::recipes {

namespace {

/// Lattice point p of the rim of the quarter 0 <= c_i <= n, from (n, 0) to (0, n).
std::array<int, 2> on_rim(int p, int n) { return p <= n ? std::array<int, 2>{n, p} : std::array<int, 2>{2 * n - p, n}; }

}  // namespace

/// With c the lattice point in the quarter of the square, x = (X, Y) is  r_c P(c)  in the core of radius r_c to its corner, and
/// from its rim the shells lead straight out to the circle of radius r, xi from 0 to 1:
///   x = (1 - xi) r_c P(c) + xi r d(c),  Z = s + zeta (h - s),  s = R - sqrt(R^2 - |x|^2).
Mesh make(const QuarterIndenter& o) {
  check_data(o);
  const auto [n, shells, along] = o.elements;
  const auto core = [](int i, int j, int k) { return Key{i, j, 0, k}; };
  const auto shell = [n = n](int i, int j, int k) {
    const auto c = on_rim(j, n);
    return Key{c[0], c[1], i, k};
  };
  const auto xi = graded_axis(0, 1, shells, o.grading[0]), zeta = graded_axis(0, 1, along, o.grading[1]);
  const std::vector<Lattice> lattices{{{n, n, along}, core, {"left", "", "front", "", "bottom", "top"}},
                                      {{shells, 2 * n, along}, shell, {"", "outer", "front", "left", "bottom", "top"}}};
  return hexahedra(QuarterIndenter::name, lattices, [&, n = n](const Key& key) {
    const std::array<int, 2> c{key[0], key[1]};
    const double share = at(xi, key[2]);
    const auto P = in_core(c, n);
    std::array<double, 2> x{(1 - share) * o.core_radius * P[0], (1 - share) * o.core_radius * P[1]};
    if (share > 0) {
      const auto d = cube_direction(c, n);
      for (std::size_t i = 0; i < 2; ++i) x[i] += share * o.rim_radius * d[i];
    }
    const double s = sagitta(o.radius, std::min(std::hypot(x[0], x[1]), o.rim_radius));
    return Point{x[0], x[1], s + at(zeta, key[3]) * (o.height - s)};
  });
}

}  // namespace mortise::recipes
