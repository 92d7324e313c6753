// The L of a foot and a leg.
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/data_check.hpp"
#include "mesh/recipes/lattice.hpp"

namespace mortise::recipes {

namespace {

/// Places of the nodes of two adjoining stretches, [0, inner] and [inner, outer], each in equal elements.
std::vector<double> two_stretches(double inner, double outer, int n_inner, int n_outer) {
  auto places = graded_axis(0, inner, n_inner, 1);
  const auto further = graded_axis(inner, outer, n_outer, 1);
  places.insert(places.end(), further.begin() + 1, further.end());
  return places;
}

}  // namespace

/// Three boxes with common keys: the corner, the rest of the foot and the rest of the leg.
Mesh make(const LBlock& o) {
  check_data(o);
  const auto [through_leg, along_foot, across, through_foot, along_leg] = o.elements;
  const auto x = two_stretches(o.thickness[0], o.size[0], through_leg, along_foot), y = graded_axis(0, o.size[1], across, 1),
             z = two_stretches(o.thickness[1], o.size[2], through_foot, along_leg);
  const auto box = [&, across = across](int first_i, int first_k, int ni, int nk, const std::array<std::string, 4>& sides) {
    return Lattice{{ni, across, nk},
                   [first_i, first_k](int i, int j, int k) {
                     return Key{first_i + i, j, first_k + k, 0};
                   },
                   {sides[0], sides[1], "front", "back", sides[2], sides[3]}};
  };
  return hexahedra(LBlock::name,
                   {box(0, 0, through_leg, through_foot, {"left", "", "bottom", ""}),
                    box(through_leg, 0, along_foot, through_foot, {"", "right", "bottom", "inner top"}),
                    box(0, through_foot, through_leg, along_leg, {"left", "inner right", "", "top"})},
                   [&](const Key& key) {
                     return Point{at(x, key[0]), at(y, key[1]), at(z, key[2])};
                   });
}

}  // namespace mortise::recipes
