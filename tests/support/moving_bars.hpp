// Bars in motion as decks: one in free flight, one that flies against an obstacle.
#pragma once

#include "support/marched_scene.hpp"

namespace mortise::test {

/// Greatest |column| over the greatest length of a vector of columns.
inline double relative_to(const MarchedScene& run, const std::string& column, const std::string& vector) {
  double size = 0;
  const auto x = run[vector + "_x"], y = run[vector + "_y"], z = run[vector + "_z"];
  for (std::size_t k = 0; k < x.size(); ++k) size = std::max(size, std::hypot(x[k], y[k], z[k]));
  return greatest_of(run[column]) / size;
}

/// A bar 1 x 0.3 x 0.2 in free flight.
struct FreeBar {
  std::string scheme = "midpoint", parameters;  ///< of list `time`
  std::string step = "0.02", end = "0.4";
  std::string model = "neo-hookean", body;
  std::string tolerance = "1e-10";

  operator std::string() const {
    const std::string mesh = word("recipe", "block") + deck_parameter("size", "Array(double)", "{1, 0.3, 0.2}") +
                             deck_parameter("elements", "Array(int)", "{4, 2, 1}");
    const std::string material =
        word("model", model) + number("youngs modulus", "1000") + number("poissons ratio", "0.3") + number("density", "1.2");
    const std::string motion = deck_parameter("velocity", "Array(double)", "{1, 2, -0.5}") +
                               deck_parameter("angular velocity", "Array(double)", "{3, 0.2, 8}");
    return list("free bar", list("meshes", list("bar", mesh)) + list("materials", list("rubber", material)) +
                                list("bodies", list("bar", word("mesh", "bar") + word("material", "rubber") + body)) +
                                list("initial conditions", list("bar", motion)) +
                                list("time", word("scheme", scheme) + parameters + number("step", step) + number("end", end)) +
                                list("solver", number("tolerance", tolerance)));
  }
};

/// Supports that keep a bar along x straight: the sides of mesh "bar" slide in their planes.
inline std::string straight_sides() {
  std::string supports;
  for (const char* side : {"front", "back", "bottom", "top"})
    supports += list(side, word("type", "symmetry") + word("set", "bar/" + std::string(side)));
  return supports;
}

/// A bar of 20 elements along x that flies against whatever its left end meets.
struct FlyingBar {
  std::string scheme = "energy momentum", closing = "persistent", model = "linear elastic";
  std::string obstacle = word("type", "plane") + deck_parameter("normal", "Array(double)", "{2, 0, 0}");
  std::string end_of_wall;  ///< parameters
  std::string step = "0.02", end = "1.6";

  operator std::string() const {
    const std::string mesh = word("recipe", "block") + deck_parameter("size", "Array(double)", "{10, 0.5, 0.5}") +
                             deck_parameter("elements", "Array(int)", "{20, 1, 1}") +
                             deck_parameter("origin", "Array(double)", "{5.05, 0, 0}");
    return list("bar",
                list("meshes", list("bar", mesh)) +
                    list("materials", list("elastic", word("model", model) + number("youngs modulus", "900") +
                                                          number("poissons ratio", "0") + number("density", "1"))) +
                    list("bodies", list("bar", word("mesh", "bar") + word("material", "elastic") + word("mass", "lumped"))) +
                    list("initial conditions", list("bar", deck_parameter("velocity", "Array(double)", "{-10, 0, 0}"))) +
                    list("supports", straight_sides()) +
                    list("obstacles", list("wall", obstacle + word("set", "bar/left") + word("closing", closing) + end_of_wall)) +
                    list("time", word("scheme", scheme) + number("step", step) + number("end", end)));
  }
};

}  // namespace mortise::test
