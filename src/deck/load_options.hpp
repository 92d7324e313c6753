// What a deck says about loads: each kind with the parameters that it has.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "deck/activity.hpp"

namespace mortise {

/// Formulas of the components x, y, z.
using VectorFormula = std::array<std::optional<std::string>, 3>;

namespace loads {

/// Side set and formulas of a traction.
struct OnSides {
  std::string set;
  VectorFormula traction;
};

struct Traction : OnSides {
  static constexpr const char* name = "traction";
  static constexpr const char* help = "force per reference area, of fixed direction: a dead load";
};

struct CauchyTraction : OnSides {
  static constexpr const char* name = "cauchy traction";
  static constexpr const char* help = "force per current area, of fixed direction (thesis eq. 4.17)";
};

struct Pressure {
  static constexpr const char* name = "pressure";
  static constexpr const char* help = "force per current area that stays normal to the sides and pushes against them";
  std::string set;
  std::optional<std::string> pressure;
};

struct BodyForce {
  static constexpr const char* name = "body force";
  static constexpr const char* help = "force per mass, such as gravity; needs the density of the material";
  std::optional<std::string> body;
  VectorFormula acceleration;
};

struct PointForce {
  static constexpr const char* name = "point force";
  static constexpr const char* help = "a force on one node, or the same on each node of a set";
  std::optional<std::string> set;
  std::optional<std::string> mesh;
  std::optional<int> node;
  std::optional<std::array<double, 3>> nearest;
  VectorFormula force;
};

}  // namespace loads

using LoadKind = std::variant<loads::Traction, loads::CauchyTraction, loads::Pressure, loads::BodyForce, loads::PointForce>;

/// One entry of `loads`.
struct LoadOptions {
  std::optional<LoadKind> kind;  ///< always set once the deck has been read
  Activity activity;
};

}  // namespace mortise
