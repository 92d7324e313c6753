// The full cylinder: a core of squares within round shells.
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"
#include "mesh/recipes/round_core.hpp"

namespace mortise::recipes {

namespace {

constexpr double core_share = 0.6;  // of the radius, to the corners of the core: its elements and the shells are then alike

/// Lattice point p of the rim of the square max |c_i| = n, counter-clockwise from the corner (n, -n), in steps of 2.
std::array<int, 2> on_rim(int p, int n) {
  const int side = p / n % 4, along = 2 * (p % n) - n;
  switch (side) {
    case 0:
      return {n, along};
    case 1:
      return {-along, n};
    case 2:
      return {-n, -along};
    default:
      return {along, -n};
  }
}

}  // namespace

/// With c the lattice point in the square, the core is  X = 0.6 R P(c),  and from its rim the shells lead straight out to the
/// circle, zeta from 0 to 1:
///   X = (1 - zeta) 0.6 R P(c) + zeta R d(c).
Mesh make(const Cylinder& o) {
  check_data(o);
  const auto [n, shells, along] = o.elements;
  const auto core = [n = n](int i, int j, int k) { return Key{2 * i - n, 2 * j - n, 0, k}; };
  const auto shell = [n = n](int i, int j, int k) {
    const auto c = on_rim(j, n);
    return Key{c[0], c[1], i, k};
  };
  const auto zeta = graded_axis(0, 1, shells, o.grading[0]), z = graded_axis(0, o.height, along, o.grading[1]);
  const std::vector<Lattice> lattices{{{n, n, along}, core, {"", "", "", "", "bottom", "top"}},
                                      {{shells, 4 * n, along}, shell, {"", "outer", "", "", "bottom", "top"}}};
  return hexahedra(Cylinder::name, lattices, [&, n = n](const Key& key) {
    const std::array<int, 2> c{key[0], key[1]};
    const double share = at(zeta, key[2]);
    Point X{0, 0, at(z, key[3])};
    const auto P = in_core(c, n);
    for (std::size_t i = 0; i < 2; ++i) X[i] = (1 - share) * core_share * o.radius * P[i];
    if (share == 0) return X;
    const auto d = cube_direction(c, n);
    for (std::size_t i = 0; i < 2; ++i) X[i] += share * o.radius * d[i];
    return X;
  });
}

}  // namespace mortise::recipes
