// The spring pendulum of thesis 6.1 as a deck.
#pragma once

#include <string>

#include "support/text.hpp"

namespace mortise::test {

/// A mass on a spring whose other end is fixed at the origin, with the data of the errata page.
struct SpringPendulum {
  std::string scheme = "energy momentum", parameters;  ///< of list `time`
  std::string stiffness = "1e6", law = "saint venant", formulation = "displacement", step = "5e-4", end = "0.63";
  std::string rest_length = "1", mass = "1", at = "{0.565685424949238, 0, 0.565685424949238}", velocity = "{0, -12.5, 0}";
  std::string tolerance = "1e-14";
  std::string smallest_step;  ///< empty: the step, so that it is never cut

  operator std::string() const {
    const std::string spring = word("type", "between") + word("from", "ball/1") +
                               deck_parameter("anchor", "Array(double)", "{0, 0, 0}") + number("rest length", rest_length) +
                               number("stiffness", stiffness) + word("law", law) + word("formulation", formulation);
    std::string probes;
    for (const char* axis : {"x", "y", "z"})
      probes += list(
          axis, word("quantity", std::string("position_") + axis) + word("mesh", "ball") + deck_parameter("node", "int", "1"));
    return list("spring pendulum",
                list("meshes", list("ball", word("recipe", "points") + deck_parameter("coordinates", "Array(double)", at))) +
                    list("masses", list("ball", word("set", "ball") + number("mass", mass))) +
                    list("springs", list("spring", spring)) +
                    list("initial conditions", list("ball", deck_parameter("velocity", "Array(double)", velocity))) +
                    list("time", word("scheme", scheme) + parameters + number("step", step) +
                                     number("smallest step", smallest_step.empty() ? step : smallest_step) + number("end", end)) +
                    list("solver", number("tolerance", tolerance) + deck_parameter("newton iterations", "int", "60")) +
                    list("probes", probes));
  }
};

}  // namespace mortise::test
