// What a deck says about the mass of a body's elements and about Rayleigh damping.
#pragma once

#include "deck/bounds.hpp"
#include "deck/fields.hpp"

namespace mortise {

/// Mass matrix of an element: by a rule that is exact for straight edges, by the rule of its stiffness (the thesis' 2 x 2 x 2
/// points for hex8), lumped to the diagonal, or lumped off the nodes that have contact pressures (mass redistribution).
enum class MassKind { consistent, stiffness_rule, lumped, redistributed };

inline const Choices<MassKind> mass_names{{"consistent", MassKind::consistent},
                                          {"consistent 2x2x2", MassKind::stiffness_rule},
                                          {"lumped", MassKind::lumped},
                                          {"lumped off contact", MassKind::redistributed}};

/// Damping force (a M + b K_0) v of a body.
struct RayleighOptions {
  double mass = 0;       ///< a [1/time]
  double stiffness = 0;  ///< b [time]

  bool exists() const { return mass > 0 || stiffness > 0; }
};

template <class Fields>
void describe(Fields& f, RayleighOptions& o) {
  f.optional("rayleigh mass", o.mass, at_least(0), "1/time",
             "a of the damping force (a M + b K) v, K the stiffness at rest; needs the density of the material");
  f.optional("rayleigh stiffness", o.stiffness, at_least(0), "time", "b of the damping force");
}

}  // namespace mortise
