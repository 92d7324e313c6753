// Decks of one bar: what a test adds is all that differs.
#pragma once

#include <string>

#include "support/text.hpp"

namespace mortise::test {

inline std::string vector_of(const std::string& x, const std::string& y, const std::string& z) {
  return word("x", x) + word("y", y) + word("z", z);
}

/// A bar of 2 x 3 x 10 with its length along z and one corner at the origin.
struct BarDeck {
  std::string elements = "{2, 2, 4}";
  std::string model = "linear elastic";
  std::string youngs_modulus = "1000", poissons_ratio = "0", density = "0.01";
  std::string body;   ///< further parameters
  std::string lists;  ///< supports, loads, springs, probes ...
  std::string end = "1", step = "0.25", stops;

  operator std::string() const {
    const std::string rubber = word("model", model) + number("youngs modulus", youngs_modulus) +
                               number("poissons ratio", poissons_ratio) + (density.empty() ? "" : number("density", density));
    return list("bar",
                list("meshes", list("bar", word("recipe", "block") + deck_parameter("size", "Array(double)", "{2, 3, 10}") +
                                               deck_parameter("elements", "Array(int)", elements))) +
                    list("materials", list("rubber", rubber)) +
                    list("bodies", list("bar", word("mesh", "bar") + word("material", "rubber") + body)) + lists +
                    list("time", number("end", end) + number("step", step) + number("largest step", step) +
                                     (stops.empty() ? "" : deck_parameter("stops", "Array(double)", stops))) +
                    list("probes", list("top", word("quantity", "displacement_z") + word("mesh", "bar") +
                                                   deck_parameter("nearest", "Array(double)", "{0, 0, 10}"))));
  }
};

/// Rollers on three sides that meet in a corner: the bar may stretch and thin freely.
inline std::string rollers() {
  return list("bottom", word("set", "bar/bottom") + word("z", "0")) + list("left", word("set", "bar/left") + word("x", "0")) +
         list("front", word("set", "bar/front") + word("y", "0"));
}

}  // namespace mortise::test
