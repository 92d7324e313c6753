// What a deck says about the start of a body.
#pragma once

#include <array>
#include <optional>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"

namespace mortise {

/// State of a body at time 0: v = velocity + angular velocity x (q - centre), beside what another run left.
struct InitialOptions {
  std::optional<std::string> state;  ///< Exodus file, or folder with results.e, relative to the deck
  std::array<double, 3> velocity{0, 0, 0};
  std::array<double, 3> angular_velocity{0, 0, 0};
  std::optional<std::array<double, 3>> centre;  ///< default: the centre of mass
  std::optional<std::array<double, 4>> rotation;
};

template <class Fields>
void describe(Fields& f, InitialOptions& o) {
  f.optional(
      "state", o.state, anything, "",
      "results of another run, whose last state is taken on: its folder, or an Exodus file with nodal displacement_x|y|z, "
      "and velocity_x|y|z where it moved; the path is relative to the deck. Element blocks are found by their names, "
      "mesh/block, and must have the same elements and reference positions; contact_pressure is taken on too, if it is there");
  f.optional("velocity", o.velocity, anything, "length/time", "of all of the body");
  f.optional("angular velocity", o.angular_velocity, anything, "1/time", "of the body as a rigid one, about its centre");
  f.optional("rotation", o.rotation, anything, "-, degrees",
             "axis x, y, z and angle by which the body is turned about its centre, without strain, before it moves");
  f.optional("centre", o.centre, anything, "length", "reference position about which it turns; default: its centre of mass");
  f.only_with({"centre"}, "angular velocity", o.rotation.has_value() || o.angular_velocity != std::array<double, 3>{},
              "\"angular velocity\" or \"rotation\"");
  f.rule("D08", {"rotation"}, !o.rotation || (*o.rotation)[0] != 0 || (*o.rotation)[1] != 0 || (*o.rotation)[2] != 0,
         "must have an axis that is not zero");
  f.rule("D19", {"rotation", "state"}, !o.rotation || !o.state, "cannot stand beside \"state\", which says where the body is");
}

}  // namespace mortise
