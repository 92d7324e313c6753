// Bodies in plane strain: the closed forms of a stretched block, the same block between two planes of symmetry, and refusals.
#include <gtest/gtest.h>

#include "assembly/vectors.hpp"
#include "errors.hpp"
#include "support/bar_deck.hpp"
#include "support/free_bodies.hpp"
#include "support/marched_scene.hpp"

namespace mortise::test {
namespace {

constexpr double E = 1000, nu = 0.3;
constexpr double width = 2, side_area = 3 * 10, face_area = 2 * 3;  // of the bar 2 x 3 x 10 along x, its side at x, its face at z
const std::string plane = word("kinematics", "plane strain");
const std::string plane_forces = "reaction_z.plane strain of bar";

/// The bar is drawn along x to a stretch and may thin in y.
BarDeck stretched(const std::string& model, double stretch) {
  BarDeck deck;
  deck.model = model;
  deck.poissons_ratio = "0.3";
  deck.lists =
      list("supports", list("left", word("set", "bar/left") + word("x", "0")) +
                           list("right", word("set", "bar/right") + word("x", fmt::format("{}*t", width * (stretch - 1)))) +
                           list("front", word("set", "bar/front") + word("y", "0")));
  return deck;
}

/// Greatest distance of a diagonal of first Piola stresses [Pa] from that at any Gauss point, other components included.
double stress_error(const MarchedScene& run, const Vec3<double>& P) {
  double error = 0;
  const auto q = run.scene.problem.to_overlap(*run.scene.state.x);
  for (const auto& body : run.scene.problem.bodies())
    body->sample(q->getData().getRawPtr(), [&](const PointSample& at) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) error = std::max(error, std::abs(at.state.P(i, j) - (i == j ? P[i] : 0)));
    });
  return all_reduced(*run.scene.problem.dofs().comm(), Teuchos::REDUCE_MAX, error);
}

void expect_stretched(BarDeck deck, const Vec3<double>& P) {
  for (const std::string elements : {"{2, 2, 1}", "{3, 2, 4}"}) {  // any number of layers
    deck.elements = elements;
    deck.body = plane;
    const MarchedScene run(deck);
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    EXPECT_LE(stress_error(run, P), 1e-11 * E) << elements;
    EXPECT_NEAR(run["reaction_x.right"].back(), P[0] * side_area, 1e-9 * E) << elements;
    EXPECT_NEAR(run[plane_forces].back(), 0, 1e-9 * E) << "both faces together";
    EXPECT_LE(run.relative_mismatch(), 1e-11);
  }
}

// Hooke with eps_z = 0 and sigma_y = 0: sigma_x = E/(1 - nu^2) eps_x, sigma_z = nu sigma_x (Timoshenko & Goodier, section 17).
TEST(PlaneStrain, OfAHookeanBlockGivesItsPlaneModulus) {
  const double stress = E / (1 - nu * nu) * 0.01;
  expect_stretched(stretched("linear elastic", 1.01), {stress, 0, nu * stress});
}

/// Thesis 3.130 in principal stretches: P_i = mu (l_i - 1/l_i) + lambda ln J / l_i with l_z = 1; l_y makes P_y zero.
Vec3<double> neo_hookean(double l_x) {
  const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const auto P = [&](double l, double J) { return mu * (l - 1 / l) + lambda * std::log(J) / l; };
  double l = 1;
  for (int k = 0; k < 20; ++k) {
    const double slope = mu * (1 + 1 / (l * l)) + lambda * (1 - std::log(l_x * l)) / (l * l);
    l -= P(l, l_x * l) / slope;
  }
  return {P(l_x, l_x * l), 0, P(1, l_x * l)};
}

TEST(PlaneStrain, OfANeoHookeanBlockIsItsClosedForm) {
  const Vec3<double> P = neo_hookean(1.5);
  EXPECT_GT(P[2], 0.1 * P[0]);
  expect_stretched(stretched("neo-hookean", 1.5), P);
}

/// Clamped on the left and sheared on the right: nothing is uniform.
BarDeck sheared(const std::string& elements) {
  BarDeck deck;
  deck.model = "neo-hookean";
  deck.poissons_ratio = "0.3";
  deck.elements = elements;
  deck.lists = list("loads", list("shear", word("type", "traction") + word("set", "bar/right") + word("y", "60*t")));
  return deck;
}
const std::string clamp = list("left", word("set", "bar/left") + word("x", "0") + word("y", "0"));
const std::string planes = list("bottom", word("type", "symmetry") + word("set", "bar/bottom")) +
                           list("top", word("type", "symmetry") + word("set", "bar/top"));

TEST(PlaneStrain, IsTheSameAsSymmetryOnBothFaces) {
  for (const std::string elements : {"{4, 3, 1}", "{4, 3, 3}"}) {
    BarDeck held = sheared(elements), mirrored = held, both = held;
    held.body = both.body = plane;
    held.lists += list("supports", clamp);
    mirrored.lists += list("supports", clamp + planes);
    both.lists += list("supports", clamp + planes);
    const MarchedScene a(held), b(mirrored), c(both);
    ASSERT_EQ(a.summary.code, ExitCode::done) << a.log;
    const auto x = a.unknowns();
    EXPECT_LE(relative_difference(x, b.unknowns(), 0, x.size()), 1e-12);
    EXPECT_LE(relative_difference(x, c.unknowns(), 0, x.size()), 1e-12);
    EXPECT_NEAR(a["reaction_y.left"].back(), -60 * side_area, 1e-8 * E);
    // The forces of nodes that the deck holds in z are its supports'; the body's own keep the rest, nothing here.
    EXPECT_GT(std::abs(b["reaction_z.top"].back()), 1e-3 * E * face_area);
    for (const char* face : {"reaction_z.top", "reaction_z.bottom"})
      EXPECT_NEAR(c[face].back(), b[face].back(), 1e-8 * E) << face;
    EXPECT_NEAR(c[plane_forces].back(), 0, 1e-8 * E);
    EXPECT_NEAR(a[plane_forces].back(), 0, 1e-8 * E);
  }
}

// ---- with other supports and loads ------------------------------------------------------------------------------------

TEST(PlaneStrain, CarriesWhatLoadsPushInZ) {
  BarDeck deck = sheared("{4, 3, 1}");
  deck.body = plane;
  deck.lists = with(deck.lists, word("y", "60*t"), word("z", "60*t")) + list("supports", clamp);
  const MarchedScene run(deck);
  EXPECT_NEAR(run[plane_forces].back(), -60 * side_area, 1e-9 * E);
}

void expect_refused(const std::string& deck, const std::vector<std::string>& words) {
  try {
    scene_of(deck);
    FAIL() << "was accepted, not refused with: " << words[0];
  } catch (const DeckError& error) {
    for (const auto& text : words) EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(PlaneStrain, RefusesSupportsThatMoveZ) {
  BarDeck deck = sheared("{4, 3, 1}");
  deck.body = plane;
  const std::string body = deck.lists;
  deck.lists = body + list("supports", clamp + list("top", word("set", "bar/top") + word("z", "0.1*t")));
  expect_refused(deck, {"error[D21] bodies > bar > \"kinematics\" = \"plane strain\"",
                        "component z, is moved by 0 here and by 0.1 in \"top\" at t = 1 - one value is needed"});
  // What a velocity gives is known at the first step only.
  deck.lists = body + list("supports", clamp + list("top", word("type", "velocity") + word("set", "bar/top") + word("z", "0.1")));
  const MarchedScene run(deck);
  EXPECT_EQ(run.summary.code, ExitCode::deck);
  EXPECT_NE(run.summary.cause.find("error[D21] bodies > bar > \"kinematics\""), std::string::npos) << run.summary.cause;
}

TEST(PlaneStrain, RefusesAnotherSupportOfTheNameThatItsOwnHas) {
  BarDeck deck = sheared("{4, 3, 1}");
  deck.lists += list("supports", clamp + list("plane strain of bar", word("set", "bar/top") + word("z", "0")));
  EXPECT_NO_THROW(scene_of(deck));
  deck.body = plane;
  expect_refused(deck, {"error[D11] supports > plane strain of bar", "this is the name of the support that"});
}

TEST(PlaneStrain, GivesExpectedValuesTheColumnOfItsSupport) {
  BarDeck deck = sheared("{4, 3, 1}");
  deck.lists +=
      list("supports", clamp) + list("expected", list("z forces", word("quantity", plane_forces) + number("at time", "1") +
                                                                      number("value", "0") + number("tolerance", "1e-6")));
  expect_refused(deck, {"error[D14] expected > z forces > \"quantity\""});
  deck.body = plane;
  EXPECT_NO_THROW(scene_of(deck));
}

TEST(PlaneStrain, HoldsThreeRigidModesByItself) {
  BarDeck deck;
  deck.body = plane;
  const std::string told = free_at_the_start(deck);
  EXPECT_NE(told.find("3 free rigid modes"), std::string::npos) << told;
  for (const char* free : {"translation x", "translation y", "rotation z"}) EXPECT_NE(told.find(free), std::string::npos) << told;
  for (const char* held : {"translation z", "rotation x", "rotation y"}) EXPECT_EQ(told.find(held), std::string::npos) << told;
}

}  // namespace
}  // namespace mortise::test
