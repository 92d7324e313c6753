// The tube, whole or a sector of it.
#include "mesh/angles.hpp"
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

/// One lattice outwards, around, along, closed around:
///   X = (r_i cos theta_j, r_i sin theta_j, z_k),  theta_j = 2 pi j / n.
Mesh make(const HollowCylinder& o) {
  check_data(o);
  const auto [around, layers, along] = o.elements;
  const auto key = [n = around](int i, int j, int k) { return Key{i, j % n, k, 0}; };
  const auto r = graded_axis(o.inner_radius, o.outer_radius, layers, o.grading[0]),
             z = graded_axis(0, o.height, along, o.grading[1]);
  const Lattice lattice{{layers, around, along}, key, {"inner", "outer", "", "", "bottom", "top"}};
  return hexahedra(HollowCylinder::name, {lattice}, [&, n = around](const Key& node) {
    const auto theta = point_on_circle(node[1], n);
    const double radius = at(r, node[0]);
    return Point{radius * theta[0], radius * theta[1], at(z, node[2])};
  });
}

/// As the hollow cylinder, theta from 0 to the angle.
Mesh make(const RingSector& o) {
  check_data(o);
  const auto [around, layers, along] = o.elements;
  const auto key = [](int i, int j, int k) { return Key{i, j, k, 0}; };
  const auto degrees = graded_axis(0, o.angle, around, o.grading[0]),
             r = graded_axis(o.inner_radius, o.outer_radius, layers, o.grading[1]),
             z = graded_axis(0, o.height, along, o.grading[2]);
  const Lattice lattice{{layers, around, along}, key, {"inner", "outer", "start", "end", "bottom", "top"}};
  return hexahedra(RingSector::name, {lattice}, [&](const Key& node) {
    const auto [sine, cosine] = sine_cosine(at(degrees, node[1]));
    const double radius = at(r, node[0]);
    return Point{radius * cosine, radius * sine, at(z, node[2])};
  });
}

}  // namespace mortise::recipes
