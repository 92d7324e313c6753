// What a secondary facet takes for the other surface: not what lies beyond its own body.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "assembly/vectors.hpp"
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

/// A block above the middle of a thin plate's face that has turned about y.
std::string above_a_turned_plate(double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  const std::string origin = fmt::format("{{{}, 0, {}}}", 0.5 - 0.5 * c - 0.1 * s, -0.55 + 0.5 * s - 0.1 * c);
  const auto block = [](const std::string& size, const std::string& place) {
    return word("recipe", "block") + deck_parameter("size", "Array(double)", size) +
           deck_parameter("elements", "Array(int)", "{2, 2, 1}") + place;
  };
  const std::string turned = deck_parameter("rotation", "Array(double)", fmt::format("{{0, 1, 0, {}}}", degrees)) +
                             deck_parameter("origin", "Array(double)", origin);
  const auto body = [](const std::string& mesh) { return list(mesh, word("mesh", mesh) + word("material", "rubber")); };
  const auto held = [](const std::string& set) {
    return list(set.substr(0, 5), word("set", set) + word("x", "0") + word("y", "0") + word("z", "0"));
  };
  return list("plate", list("meshes", list("block", block("{1, 1, 1}", "")) + list("plate", block("{1, 1, 0.1}", turned))) +
                           list("materials", list("rubber", word("model", "neo-hookean") + number("youngs modulus", "1") +
                                                                number("poissons ratio", "0.3"))) +
                           list("bodies", body("block") + body("plate")) +
                           list("supports", held("block/top") + held("plate/bottom")) +
                           list("contact", list("pair", word("secondary", "block/bottom") + word("primary", "plate/top"))) +
                           list("time", number("step", "1") + number("end", "1")));
}

/// Case A7: grazing faces and back faces do not meet; they are counted, and do no harm.
TEST(Search, TurnsAwayFacetsThatDoNotFaceEachOther) {
  for (const double degrees : {0.0, 45.0, 79.9, 80.1, 89.0, 89.9, 89.99, 90.0, 90.01, 135.0, 180.0}) {
    TestScene scene(above_a_turned_plate(degrees));
    const auto before = scene.problem.pairs()[0]->counts();
    const Evaluation at = scene.problem.evaluate(*scene.state.x);
    const auto after = scene.problem.pairs()[0]->counts();
    std::vector<long> counts{after.pairs - before.pairs, after.turned_away - before.turned_away};
    all_reduce(*world(), Teuchos::REDUCE_SUM, counts);
    EXPECT_GT(counts[0], 0) << degrees;
    EXPECT_EQ(counts[1], degrees < 80 ? 0 : counts[0]) << degrees;
    ASSERT_TRUE(at.admissible);
    for (double force : scene.gather(*at.residual)) EXPECT_TRUE(std::isfinite(force)) << degrees;
    EXPECT_EQ(at.n_closed, 0);
  }
}

TEST(Search, SeesThatOneBodyIsInTheOther) {
  EXPECT_THROW(TestScene(rings("{58, 0, 67.8}")), MeshError);  // their tubes overlap by 13
}

}  // namespace
}  // namespace mortise::test
