// The descriptions of supports and springs: their parameters in a deck, with units and help (see fields.hpp).
#pragma once

#include <algorithm>

#include "deck/fields.hpp"
#include "deck/support_options.hpp"

namespace mortise {

namespace supports {

template <class Fields>
void describe_motion(Fields& f, VectorFormula& components, const std::string& unit, const std::string& what,
                     const std::string& left_out) {
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    f.formula(axis, components[i], unit, what + " in " + axis + "; left out: " + left_out);
  }
}

template <class Fields>
void describe(Fields& f, Displacement& o) {
  describe_motion(f, o.displacement, "length", "displacement", "free");
  f.at_least_one_of({"x", "y", "z"});
}

template <class Fields>
void describe(Fields& f, Velocity& o) {
  describe_motion(f, o.velocity, "length/time", "velocity", "free");
  f.at_least_one_of({"x", "y", "z"});
}

template <class Fields>
void describe(Fields& f, Rotation& o) {
  f.required("axis", o.axis, anything, "-", "direction of the axis; the angle counts as a right-hand screw along it");
  f.optional("point", o.point, anything, "length", "a point of the axis");
  f.formula("angle", o.angle, "degrees", "angle of rotation from the reference position");
  f.at_least_one_of({"angle"});
  f.rule("D08", {"axis"}, std::any_of(o.axis.begin(), o.axis.end(), [](double a) { return a != 0; }), "must not be zero");
  describe_motion(f, o.displacement, "length", "displacement after the rotation", "0");
}

template <class Fields>
void describe(Fields&, Symmetry&) {}

}  // namespace supports

template <class Fields>
void describe(Fields& f, SupportOptions& o) {
  f.required("set", o.set, anything, "", "mesh name / side set or node set (name or number)");
  f.kind("type", o.kind, Presence::optional, "how the set moves; left out: \"displacement\"");
  describe(f, o.activity);
}

namespace springs {

template <class Fields>
void describe_stiffness(Fields& f, Stiffness& o, const std::string& unit) {
  f.required("set", o.set, anything, "", "mesh name / side set, or node set for springs at nodes (name or number)");
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    f.optional(axis, o.stiffness[i], positive, unit, "stiffness in " + axis + "; left out: 0");
  }
  f.at_least_one_of({"x", "y", "z"});
}

template <class Fields>
void describe(Fields& f, Nodes& o) {
  describe_stiffness(f, o, "force/length");
}

template <class Fields>
void describe(Fields& f, Bedding& o) {
  describe_stiffness(f, o, "force/length^3");
}

template <class Fields>
void describe(Fields& f, Between& o) {
  f.required("from", o.from, anything, "", "mesh name / node set of one node (name or number)");
  f.optional("to", o.to, anything, "", "mesh name / node set of one other node (name or number)");
  f.optional("anchor", o.anchor, anything, "length", "a fixed point instead of \"to\"");
  f.exactly_one_of({"to", "anchor"});
  f.optional("rest length", o.rest_length, positive, "length", "length L without force; default: the reference distance");
  f.required("stiffness", o.stiffness, positive, "force/length", "c of the energy c L^2 w, w being the law's");
  describe_stretch_law(f, o.law, "c L^2");
  f.choice("formulation", o.formulation, spring_formulation_names, Presence::optional,
           "displacement: the force is that of the positions; augmented: nu^2 and the multiplier that ties it to the positions "
           "are unknowns too (redundant formulation, coordinate augmentation, thesis eqs. 6.37-6.43). Both move alike by "
           "static, backward euler and energy momentum; with the law saint venant, augmented makes midpoint and trapezoidal "
           "energy momentum. Needs the direct solver");
}

}  // namespace springs

template <class Fields>
void describe(Fields& f, SpringOptions& o) {
  f.kind("type", o.kind, Presence::required, "springs to the ground, or between two points");
  describe(f, o.activity);
}

}  // namespace mortise
