// The brick, uniform or graded.
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

namespace {

/// X = (x_i, y_j, z_k).
Mesh brick(const std::string& name, const std::array<double, 3>& size, const std::array<int, 3>& elements,
           const std::array<double, 3>& grading) {
  const auto x = graded_axis(0, size[0], elements[0], grading[0]), y = graded_axis(0, size[1], elements[1], grading[1]),
             z = graded_axis(0, size[2], elements[2], grading[2]);
  return hexahedra(name, {box_lattice(elements)}, [&](const Key& key) {
    return Point{at(x, key[0]), at(y, key[1]), at(z, key[2])};
  });
}

}  // namespace

Mesh make(const Block& o) {
  check_data(o);
  return brick(Block::name, o.size, o.elements, {1, 1, 1});
}

Mesh make(const GradedBlock& o) {
  check_data(o);
  Mesh mesh = brick(GradedBlock::name, o.size, o.elements, o.grading);
  mesh.blocks.front().name = Block::name;  // decks call it so in either recipe
  return mesh;
}

}  // namespace mortise::recipes
