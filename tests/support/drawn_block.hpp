// A block that is pressed on a slab and drawn along it, as a deck.
#pragma once

#include "support/marched_scene.hpp"

namespace mortise::test {

/// A block of 2 x 2 x 1 elements on a slab whose mesh does not match; the block's top is pressed down and then drawn along x.
struct DrawnBlock {
  std::string mu = "0.4", friction, drawn = "0.3*max(t-1,0)", pressed = "-0.1*min(t,1)";
  std::string law;  ///< parameters in place of the coefficient mu
  std::string end = "2", step = "0.25";

  operator std::string() const {
    const std::string slab = word("recipe", "block") + deck_parameter("size", "Array(double)", "{4, 3, 1}") +
                             deck_parameter("elements", "Array(int)", "{5, 4, 1}"),
                      block = word("recipe", "block") + deck_parameter("size", "Array(double)", "{1, 1, 1}") +
                              deck_parameter("elements", "Array(int)", "{3, 3, 1}") +
                              deck_parameter("origin", "Array(double)", "{0.9, 0.8, 1}");
    const auto rubber = [](const std::string& E) {
      return word("model", "neo-hookean") + number("youngs modulus", E) + number("poissons ratio", "0.3");
    };
    const auto held = [](const std::string& set, const std::string& x, const std::string& z) {
      return word("set", set) + word("x", x) + word("y", "0") + word("z", z);
    };
    return list(
        "drawn block",
        list("meshes", list("slab", slab) + list("block", block)) +
            list("materials", list("soft", rubber("10")) + list("stiff", rubber("100"))) +
            list("bodies", list("slab", word("mesh", "slab") + word("material", "soft")) +
                               list("block", word("mesh", "block") + word("material", "stiff"))) +
            list("supports", list("ground", held("slab/bottom", "0", "0")) + list("hand", held("block/top", drawn, pressed))) +
            list("contact", list("pair", word("secondary", "block/bottom") + word("primary", "slab/top") +
                                             (law.empty() ? number("friction coefficient", mu) : law) + friction)) +
            list("time", number("step", step) + number("end", end)));
  }
};

}  // namespace mortise::test
