// The descriptions of all loads: their parameters in a deck, with units and help (see fields.hpp).
#pragma once

#include "deck/fields.hpp"
#include "deck/load_options.hpp"

namespace mortise {

namespace loads {

template <class Fields>
void describe_components(Fields& f, VectorFormula& components, const std::string& unit) {
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    f.formula(axis, components[i], unit, "component in " + axis + "; left out: 0");
  }
  f.at_least_one_of({"x", "y", "z"});
}

template <class Fields>
void describe(Fields& f, OnSides& o) {
  f.required("set", o.set, anything, "", "mesh name / side set (name or number)");
  describe_components(f, o.traction, "force/length^2");
}

template <class Fields>
void describe(Fields& f, Pressure& o) {
  f.required("set", o.set, anything, "", "mesh name / side set (name or number)");
  f.formula("pressure", o.pressure, "force/length^2", "positive: pushes against the outward normal");
  f.at_least_one_of({"pressure"});
}

template <class Fields>
void describe(Fields& f, BodyForce& o) {
  f.optional("body", o.body, anything, "", "name of an entry of `bodies`, `masses` or `strings`; left out: all of them");
  describe_components(f, o.acceleration, "length/time^2");
}

template <class Fields>
void describe(Fields& f, PointForce& o) {
  f.optional("set", o.set, anything, "", "mesh name / node set or side set (name or number): the force acts on each node");
  f.optional("mesh", o.mesh, anything, "", "name of an entry of `meshes`, for \"node\" or \"nearest\"");
  f.optional("node", o.node, at_least(1), "-", "the node's own number in the mesh");
  f.optional("nearest", o.nearest, anything, "length", "the node nearest to this reference position, as placed");
  f.exactly_one_of({"set", "node", "nearest"});
  f.only_with({"mesh"}, "set", !o.set, "\"node\" or \"nearest\"");
  f.rule("D07", {"mesh"}, o.mesh || !(o.node || o.nearest), "is missing: \"node\" and \"nearest\" are of a mesh");
  describe_components(f, o.force, "force");
}

}  // namespace loads

template <class Fields>
void describe(Fields& f, LoadOptions& o) {
  f.kind("type", o.kind, Presence::required, "what pushes, and how it is measured");
  describe(f, o.activity);
}

}  // namespace mortise
