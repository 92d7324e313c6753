// What a deck says about point masses and strings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "physics/stretch_laws.hpp"

namespace mortise {

inline const Choices<StretchLaw> stretch_law_names{{"saint venant", StretchLaw::saint_venant},
                                                   {"neo-hookean", StretchLaw::neo_hookean},
                                                   {"logarithmic", StretchLaw::logarithmic}};

/// Unknowns of a spring: those of its ends, or its squared stretch and a multiplier beside them.
enum class SpringFormulation { displacement, augmented };

inline const Choices<SpringFormulation> spring_formulation_names{{"displacement", SpringFormulation::displacement},
                                                                 {"augmented", SpringFormulation::augmented}};

template <class Fields>
void describe_stretch_law(Fields& f, StretchLaw& law, const std::string& scale) {
  f.choice("law", law, stretch_law_names, Presence::optional,
           "energy over " + scale +
               ", nu = stretch: saint venant (nu^2 - 1)^2/8 (thesis eq. 6.3); neo-hookean (nu^2 - 1/nu^2)^2/8, four times as "
               "stiff at small strain (after 6.8); logarithmic (nu^2 - 1 - ln nu^2)/4, the force (nu - 1/nu)/2 of 2.10");
}

/// One entry of `masses`.
struct MassOptions {
  std::string set;  ///< mesh name / node or side set, or the name of a mesh
  double mass = 0;
};

template <class Fields>
void describe(Fields& f, MassOptions& o) {
  f.required("set", o.set, anything, "", "mesh name / node set or side set (name or number), or a mesh: all of its nodes");
  f.required("mass", o.mass, positive, "mass", "of each node, in addition to that of bodies and strings there");
}

/// One entry of `strings`.
struct StringOptions {
  std::string mesh;
  std::vector<std::string> blocks;  ///< names or numbers; empty: all of bars
  double area = 0;
  double youngs_modulus = 0;
  std::optional<double> density;
  StretchLaw law = StretchLaw::saint_venant;
};

template <class Fields>
void describe(Fields& f, StringOptions& o) {
  f.required("mesh", o.mesh, anything, "", "name of an entry of `meshes`");
  f.optional("blocks", o.blocks, anything, "",
             "blocks of bars with 2, 3 or 4 nodes, by name or number; default: all of the mesh");
  f.required("area", o.area, positive, "length^2", "A of the cross-section where nothing is stretched");
  f.required("youngs modulus", o.youngs_modulus, positive, "force/length^2",
             "E of the energy EA w per length, w being the law's");
  f.optional("density", o.density, positive, "mass/length^3", "mass per reference volume; needed by dynamics and body forces");
  describe_stretch_law(f, o.law, "EA");
}

}  // namespace mortise
