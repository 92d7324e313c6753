// What a secondary facet takes for the other surface: not what lies beyond its own body.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

/// Two hollow rings, the second one turned and behind the first.
std::string rings(const std::string& origin) {
  const std::string ring = word("recipe", "torus") + number("ring radius", "76") + number("inner radius", "19.5") +
                           number("outer radius", "24") + deck_parameter("elements", "Array(int)", "{24, 8, 1}");
  return list("rings", list("meshes", list("left", ring) +
                                          list("right", ring + deck_parameter("origin", "Array(double)", origin) +
                                                            deck_parameter("rotation", "Array(double)", "{0, 1, 0, -45}"))) +
                           list("materials", list("rubber", word("model", "neo-hookean") + number("youngs modulus", "2250") +
                                                                number("poissons ratio", "0.3") + number("density", "0.1"))) +
                           list("bodies", list("left", word("mesh", "left") + word("material", "rubber")) +
                                              list("right", word("mesh", "right") + word("material", "rubber"))) +
                           list("contact", list("pair", word("secondary", "left/outer") + word("primary", "right/outer"))) +
                           list("time", word("scheme", "midpoint") + number("step", "0.01") + number("end", "1")));
}

TEST(Search, DoesNotTakeWhatLiesBeyondABodyForWhatIsInsideIt) {
  const TestScene apart(rings("{100, 0, 100}"));  // 5 between their tubes
  for (double p : apart.gather(*apart.state.x)) EXPECT_TRUE(std::isfinite(p));
}

TEST(Search, SeesThatOneBodyIsInTheOther) {
  EXPECT_THROW(TestScene(rings("{58, 0, 67.8}")), MeshError);  // their tubes overlap by 13
}

}  // namespace
}  // namespace mortise::test
