// The block between eight given corners.
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"
#include "physics/elements/hexahedra.hpp"

namespace mortise::recipes {

/// X = sum_a N_a(xi) X_a with the trilinear shape functions of the corners.
Mesh make(const Hexahedron& o) {
  check_data(o);
  std::array<std::vector<double>, 3> axis;
  for (std::size_t i = 0; i < 3; ++i) axis[i] = graded_axis(-1, 1, o.elements[i], o.grading[i]);
  return hexahedra(Hexahedron::name, {box_lattice(o.elements)}, [&](const Key& key) {
    const LocalPoint xi{at(axis[0], key[0]), at(axis[1], key[1]), at(axis[2], key[2])};
    Point X{0, 0, 0};
    for (int a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < 3; ++i) X[i] += Hex8::N(a, xi) * o.corners[3 * static_cast<std::size_t>(a) + i];
    return X;
  });
}

}  // namespace mortise::recipes
