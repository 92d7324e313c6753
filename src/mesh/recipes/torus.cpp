// The hollow torus.
#include "mesh/angles.hpp"
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

/// One lattice, closed around the ring (theta) and around the tube (phi):
///   X = ((R + r cos phi) cos theta, (R + r cos phi) sin theta, r sin phi).
Mesh make(const Torus& o) {
  check_data(o);
  const auto [around, around_tube, layers] = o.elements;
  const auto key = [around = around, around_tube = around_tube](int i, int j, int k) {
    return Key{i % around, j % around_tube, k, 0};
  };
  const auto r = graded_axis(o.inner_radius, o.outer_radius, layers, o.grading);
  return hexahedra(Torus::name, {{o.elements, key, {"", "", "", "", "inner", "outer"}}}, [&](const Key& node) {
    const auto theta = point_on_circle(node[0], o.elements[0]), phi = point_on_circle(node[1], o.elements[1]);
    const double radius = at(r, node[2]), from_axis = o.ring_radius + radius * phi[0];
    return Point{from_axis * theta[0], from_axis * theta[1], radius * phi[1]};
  });
}

}  // namespace mortise::recipes
