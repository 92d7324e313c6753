// The block with an inclined top face.
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

/// Columns of elements below the plane z = h + slope x:
///   X = (x, y, zeta (h + slope x)).
Mesh make(const Wedge& o) {
  check_data(o);
  const auto x = graded_axis(0, o.size[0], o.elements[0], o.grading[0]),
             y = graded_axis(0, o.size[1], o.elements[1], o.grading[1]), zeta = graded_axis(0, 1, o.elements[2], o.grading[2]);
  return hexahedra(Wedge::name, {box_lattice(o.elements)}, [&](const Key& key) {
    const double at_x = at(x, key[0]);
    return Point{at_x, at(y, key[1]), at(zeta, key[2]) * (o.size[2] + o.slope * at_x)};
  });
}

}  // namespace mortise::recipes
