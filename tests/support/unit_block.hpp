// A unit block of any element and formulation as a deck, its interior distorted.
#pragma once

#include <fmt/format.h>

#include "assembly/formulations.hpp"
#include "deck/names.hpp"
#include "support/elements.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {

/// A formulation on an element type that has it.
struct ElementCase {
  FormulationKind formulation;
  ElementType type;
  std::string name() const { return word_for(formulation_names, formulation) + " " + topology(type).name; }
  bool is_mixed() const { return formulation == FormulationKind::mixed; }
  int order() const { return topology(type).n_nodes > 8 ? 2 : 1; }  ///< of its displacements
};

/// Every combination that exists.
inline std::vector<ElementCase> element_cases() {
  std::vector<ElementCase> cases;
  for (const auto& [word, formulation] : formulation_names)
    for (ElementType type : element_types)
      if (with_formulation(formulation, type, [](auto) {})) cases.push_back({formulation, type});
  return cases;
}

/// For test names: letters and digits only.
inline std::string name_of_case(const testing::TestParamInfo<ElementCase>& info) {
  std::string name = info.param.name();
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }),
             name.end());
  return name;
}

using Formulas = std::array<std::string, 3>;
inline std::string components(const Formulas& of) { return word("x", of[0]) + word("y", of[1]) + word("z", of[2]); }

/// The block [0, 1]^3 with n^3 bricks, cut as the type asks; the displacement of the sides but the top is given, on the top
/// displacement or (if not empty) traction.
inline std::string unit_block(const ElementCase& of, int n, const std::string& material, const Formulas& displacement,
                              const Formulas& traction) {
  const std::string mesh = word("recipe", "block") +
                           deck_parameter("elements", "Array(int)", fmt::format("{{{0}, {0}, {0}}}", n)) +
                           word("element type", topology(of.type).name);
  std::string supports, loads;
  for (const char* side : {"left", "right", "front", "back", "bottom"})
    supports += list(side, word("set", fmt::format("block/{}", side)) + components(displacement));
  const std::string top = word("set", "block/top");
  if (traction[0].empty()) {
    supports += list("top", top + components(displacement));
  } else {
    loads = list("loads", list("top", word("type", "traction") + top + components(traction)));
  }
  return list("unit block",
              list("meshes", list("block", mesh)) + list("materials", list("solid", material)) +
                  list("bodies", list("block", word("mesh", "block") + word("material", "solid") +
                                                   word("formulation", word_for(formulation_names, of.formulation)))) +
                  list("supports", supports) + loads + list("time", number("end", "1") + number("step", "1")));
}

/// Moves the corners that are inside of the unit block by up to `size`, and other nodes to where straight edges have them.
inline void distort_inside(Mesh& mesh, double size) {
  Random random(1);
  std::vector<char> is_corner(mesh.coordinates.size(), 0);
  for (const Block& block : mesh.blocks)
    for (const auto& element : block.elements)
      for (int a = 0; a < topology(block.elements.type()).n_corners; ++a) is_corner[element[a]] = 1;
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) {
    Point& X = mesh.coordinates[k];
    const Point before = X;
    const bool inside = std::all_of(before.begin(), before.end(), [](double x) { return x > 1e-9 && x < 1 - 1e-9; });
    for (double& x : X)
      if (is_corner[k] && inside) x += random.in(-size, size);
  }
  for (const Block& block : mesh.blocks)
    with_element(block.elements.type(), [&](auto kind) {
      using Element = decltype(kind);
      using Linear = typename CornersOf<Element>::type;
      for (const auto& element : block.elements)
        for (int a = Linear::n_nodes; a < Element::n_nodes; ++a) {
          Point X{0, 0, 0};
          for (int b = 0; b < Linear::n_nodes; ++b)
            for (int i = 0; i < 3; ++i)
              X[i] +=
                  Linear::N(b, {Element::node[a][0], Element::node[a][1], Element::node[a][2]}) * mesh.coordinates[element[b]][i];
          mesh.coordinates[element[a]] = X;
        }
    });
}

}  // namespace mortise::test
