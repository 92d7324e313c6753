// The spherical shell, cubed.
#include <utility>

#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/cube_direction.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

/// Lattice points c of the surface of the cube max |c_i| = n, one lattice per face, blown up:
///   X = r_k d(c),  d the equiangular direction through c (cube_direction.hpp).
Mesh make(const HollowSphere& o) {
  check_data(o);
  const auto [n, layers] = o.elements;
  std::vector<Lattice> faces;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int outwards : {1, -1}) {
      std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
      if (outwards < 0) std::swap(first, second);  // i, j, k stay right-handed
      const auto key = [=, n = n](int i, int j, int k) {
        Key c{};
        c[axis] = outwards * n;
        c[first] = 2 * i - n;
        c[second] = 2 * j - n;
        c[3] = k;
        return c;
      };
      faces.push_back({{n, n, layers}, key, {"", "", "", "", "inner", "outer"}});
    }
  const auto r = graded_axis(o.inner_radius, o.outer_radius, layers, o.grading);
  return hexahedra(HollowSphere::name, faces, [&, n = n](const Key& key) {
    const auto d = cube_direction<3>({key[0], key[1], key[2]}, n);
    const double radius = at(r, key[3]);
    return Point{radius * d[0], radius * d[1], radius * d[2]};
  });
}

}  // namespace mortise::recipes
