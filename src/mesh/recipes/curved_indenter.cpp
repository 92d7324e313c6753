// The block with a cylindrical or spherical lower face.
#include <cmath>

#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

namespace {

/// Places of the n + 1 nodes along an edge, seen from the crown: at its end if `from_crown`, else in its middle.
std::vector<double> places(bool from_crown, double length, int n, double grading) {
  return from_crown ? graded_axis(0, length, n, grading) : axis_graded_from_middle(0.5 * length, n, grading);
}

}  // namespace

/// Columns of elements between the curved face and the plane z = h, with (a, b) the place seen from the crown c:
///   X = (c_x + a, c_y + b, s + zeta (h - s)),  s = R - sqrt(R^2 - d^2),  d^2 = a^2 (cylinder) or a^2 + b^2 (sphere).
Mesh make(const CurvedIndenter& o) {
  check_data(o);
  const auto [length, width, height] = o.size;
  const bool from_x = o.part != CurvedIndenter::Part::whole, from_y = o.part == CurvedIndenter::Part::quarter;
  const auto a = places(from_x, length, o.elements[0], o.grading[0]), b = places(from_y, width, o.elements[1], o.grading[1]),
             zeta = graded_axis(0, 1, o.elements[2], o.grading[2]);
  const double c_x = from_x ? 0 : 0.5 * length, c_y = from_y ? 0 : 0.5 * width;
  return hexahedra(CurvedIndenter::name, {box_lattice(o.elements)}, [&, height = height](const Key& key) {
    const double da = at(a, key[0]), db = at(b, key[1]);
    const double s = sagitta(o.radius, o.shape == CurvedIndenter::Shape::sphere ? std::hypot(da, db) : std::abs(da));
    return Point{c_x + da, c_y + db, s + at(zeta, key[2]) * (height - s)};
  });
}

}  // namespace mortise::recipes
