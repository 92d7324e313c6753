// The block with a cylindrical or spherical lower face.
#include <cmath>

#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

/// Columns of elements between the curved face and the plane z = h, with (a, b) the place seen from the crown:
///   X = (l/2 + a, w/2 + b, s + zeta (h - s)),  s = R - sqrt(R^2 - d^2),  d^2 = a^2 (cylinder) or a^2 + b^2 (sphere).
Mesh make(const CurvedIndenter& o) {
  check_data(o);
  const auto [length, width, height] = o.size;
  const auto a = axis_graded_from_middle(0.5 * length, o.elements[0], o.grading[0]),
             b = axis_graded_from_middle(0.5 * width, o.elements[1], o.grading[1]),
             zeta = graded_axis(0, 1, o.elements[2], o.grading[2]);
  return hexahedra(
      CurvedIndenter::name, {box_lattice(o.elements)}, [&, length = length, width = width, height = height](const Key& key) {
        const double da = at(a, key[0]), db = at(b, key[1]);
        const double s = sagitta(o.radius, o.shape == CurvedIndenter::Shape::sphere ? std::hypot(da, db) : std::abs(da));
        return Point{0.5 * length + da, 0.5 * width + db, s + at(zeta, key[2]) * (height - s)};
      });
}

}  // namespace mortise::recipes
