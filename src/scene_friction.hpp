// Friction of a pair as a scene has it: its laws with their numbers and formulas.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "contact/laws/friction_bound.hpp"
#include "deck/friction_options.hpp"
#include "physics/time_scheme.hpp"
#include "scene_loads.hpp"

namespace mortise {

namespace friction {

/// Coulomb's: the bound is mu p.
struct Coulomb {
  std::variant<double, PlacedFormula> coefficient;  ///< mu [-]; of t, p, v
};
/// Tresca's: the bound is the same at all pressures.
struct Tresca {
  std::variant<double, PlacedFormula> bound;  ///< [Pa]; of t
};

}  // namespace friction

struct Friction {
  std::variant<friction::Coulomb, friction::Tresca> law;
  std::optional<double> penalty;         ///< of stick [Pa/m]; none: exact stick
  std::optional<double> regularisation;  ///< v0 of the law without stick [m/s]; none: stick and slip
  SlipForm slip = SlipForm::automatic;

  /// Part of the traction at the end of a step in what acts in it, the rest being that at its start (thesis eq. 5.113).
  double theta_of(const TimeScheme& scheme) const { return penalty && scheme.constraint_theta < 1 ? 0.5 : 1; }
  bool is_moment_free(const TimeScheme& scheme) const {
    return slip == SlipForm::moment_free || (slip == SlipForm::automatic && scheme.constraint_theta < 1);
  }
};

/// mu and its derivatives at a time, pressure [Pa] and slip speed [m/s]. Formulas know no derivative: theirs are differences over
/// a ten-thousandth of p and v, central ones of fourth order unless they would reach below 0. Below p = 0 it is that at 0.
/// @param no_speed a speed that is next to nothing [m/s]: the least of which a difference takes its ten-thousandth
/// @param fault gets a message where the formula's value is negative or not finite, if it holds none yet
FrictionCoefficient coefficient_at(const friction::Coulomb& law, double t, double p, double v, double no_speed,
                                   std::string& fault);

/// Tresca's bound at a time [Pa]. @param fault as above
double bound_at(const friction::Tresca& law, double t, std::string& fault);

/// Looks whether a law can be at a time, at rest and without pressure. @param fault as above
void check(const Friction& friction, double t, std::string& fault);

/// The law in words, for the manifest.
std::string in_words(const Friction& friction);

}  // namespace mortise
