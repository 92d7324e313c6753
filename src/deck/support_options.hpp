// What a deck says about supports and springs: each kind with the parameters that it has.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "deck/activity.hpp"
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

/// Stiffness of each component.
struct Stiffness {
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

}  // namespace springs

using SpringKind = std::variant<springs::Nodes, springs::Bedding>;

/// One entry of `springs`.
struct SpringOptions {
  std::string set;
  std::optional<SpringKind> kind;  ///< always set once the deck has been read
  Activity activity;
};

}  // namespace mortise
