// What a deck says about supports and springs: each kind with the parameters that it has.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "deck/activity.hpp"
#include "deck/discrete_options.hpp"
#include "deck/load_options.hpp"

namespace mortise {

namespace supports {

struct Displacement {
  static constexpr const char* name = "displacement";
  static constexpr const char* help = "moved by u(t) from the reference position; a component left out is free";
  VectorFormula displacement;
};

struct Velocity {
  static constexpr const char* name = "velocity";
  static constexpr const char* help =
      "moves on from where it is by the integral of v over each step (three Gauss points); a component left out is free";
  VectorFormula velocity;
};

struct Rotation {
  static constexpr const char* name = "rotation";
  static constexpr const char* help = "turned about an axis, then moved: q = c + R(angle) (X - c) + u; holds all components";
  std::array<double, 3> axis{0, 0, 0};
  std::array<double, 3> point{0, 0, 0};
  std::optional<std::string> angle;
  VectorFormula displacement;
};

struct Symmetry {
  static constexpr const char* name = "symmetry";
  static constexpr const char* help = "no motion normal to a flat side set, whose normal must be x, y or z";
};

}  // namespace supports

using SupportKind = std::variant<supports::Displacement, supports::Velocity, supports::Rotation, supports::Symmetry>;

/// One entry of `supports`.
struct SupportOptions {
  std::string set;  ///< mesh name / side or node set (name or number)
  SupportKind kind;
  Activity activity;
};

namespace springs {

/// A set, and the stiffness of each component.
struct Stiffness {
  std::string set;
  std::array<std::optional<double>, 3> stiffness;
};

struct Nodes : Stiffness {
  static constexpr const char* name = "nodes";
  static constexpr const char* help = "a spring at each node of a set, from its reference position: force -k (q - X)";
};

struct Bedding : Stiffness {
  static constexpr const char* name = "bedding";
  static constexpr const char* help = "an elastic bedding of a side set: force -k (q - X) per reference area";
};

/// Between two nodes, or a node and a point of space.
struct Between {
  static constexpr const char* name = "between";
  static constexpr const char* help = "one spring from a node to another node or to a fixed point, with a law in its stretch";
  std::string from;                             ///< a set of one node
  std::optional<std::string> to;                ///< likewise
  std::optional<std::array<double, 3>> anchor;  ///< instead
  std::optional<double> rest_length;            ///< default: the reference distance
  double stiffness = 0;
  StretchLaw law = StretchLaw::saint_venant;
  SpringFormulation formulation = SpringFormulation::displacement;
};

}  // namespace springs

using SpringKind = std::variant<springs::Nodes, springs::Bedding, springs::Between>;

/// One entry of `springs`.
struct SpringOptions {
  std::optional<SpringKind> kind;  ///< always set once the deck has been read
  Activity activity;
};

}  // namespace mortise
