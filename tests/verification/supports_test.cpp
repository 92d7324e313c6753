// Supports and damping on a bar: prescribed motions, their times, viscous relaxation, and all of it after a restart.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "support/bar_deck.hpp"
#include "support/free_bodies.hpp"
#include "support/marched_scene.hpp"

namespace mortise::test {
namespace {

constexpr double length = 10, modulus = 1000;

std::string supports(const std::string& entries) { return list("supports", entries); }

// Turned at one end only: the rest follows, as nothing holds it back.
TEST(Rotation, OfOneEndByAQuarterTurnTurnsTheBarWithoutStress) {
  BarDeck deck;
  deck.model = "neo-hookean";
  deck.poissons_ratio = "0.3";
  deck.step = "0.05";
  const std::string centre = deck_parameter("point", "Array(double)", "{1, 2, 3}");
  deck.lists = supports(list("end", word("type", "rotation") + word("set", "bar/bottom") +
                                        deck_parameter("axis", "Array(double)", "{0, 2, 0}") + centre + word("angle", "90*t") +
                                        word("y", "0.5*t")));
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  const auto x = run.unknowns();
  double error = 0;
  const auto& X = run.scene.scene.mesh.mesh.coordinates;
  for (std::size_t n = 0; n < X.size(); ++n) {  // about y a quarter turn takes z to x and x to -z
    const double exact[3] = {1 + (X[n][2] - 3), X[n][1] + 0.5, 3 - (X[n][0] - 1)};
    for (int i = 0; i < 3; ++i) error = std::max(error, std::abs(x[3 * n + i] - exact[i]));
  }
  EXPECT_LE(error, 1e-10 * length);
  double stress = 0;
  const auto q = run.scene.problem.to_overlap(*run.scene.state.x);
  for (const auto& body : run.scene.problem.bodies())
    body->sample(q->getData().getRawPtr(), [&](const PointSample& at) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) stress = std::max(stress, std::abs(at.state.P(i, j)));
    });
  EXPECT_LE(stress, 1e-9 * modulus);
  EXPECT_LE(std::abs(run["strain_energy"].back()), 1e-12 * modulus);
}

// v = -0.3 t^2 sin(x) + 0.1 t moves by -0.1 t^3 sin(x) + 0.05 t^2: three Gauss points integrate it exactly, step by step.
TEST(Velocity, MovesLikeTheDisplacementThatIsItsIntegral) {
  BarDeck by_velocity, by_displacement;
  const std::string ground = list("bottom", word("set", "bar/bottom") + vector_of("0", "0", "0"));
  by_velocity.lists =
      supports(ground + list("top", word("type", "velocity") + word("set", "bar/top") + word("z", "-0.3*t^2*sin(x) + 0.1*t")));
  by_displacement.lists = supports(ground + list("top", word("set", "bar/top") + word("z", "-0.1*t^3*sin(x) + 0.05*t^2")));
  by_velocity.model = by_displacement.model = "neo-hookean";
  by_velocity.poissons_ratio = by_displacement.poissons_ratio = "0.3";
  const MarchedScene a(by_velocity), b(by_displacement);
  ASSERT_EQ(a.summary.code, ExitCode::done) << a.log;
  const auto x = a.unknowns();
  EXPECT_LE(relative_difference(x, b.unknowns(), 0, x.size()), 1e-13);
  EXPECT_NEAR(a["displacement_z.top"].back(), 0.05, 1e-14);
  EXPECT_NEAR(a["reaction_z.top"].back(), b["reaction_z.top"].back(), 1e-9);
  EXPECT_LE(a.relative_mismatch(), 1e-11);
}

// From 0.5 on the end moves on from where the load has put it.
TEST(Velocity, StartsFromWhereTheNodesAre) {
  BarDeck deck;
  deck.lists = supports(rollers() + list("top", word("type", "velocity") + word("set", "bar/top") + word("z", "0.2") +
                                                    number("start", "0.5"))) +
               list("loads", list("load", word("type", "traction") + word("set", "bar/top") + word("z", "-7")));
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_NEAR(run.at(0.5, "displacement_z.top"), -0.07, 1e-12);
  EXPECT_NEAR(run.at(0.75, "displacement_z.top"), -0.07 + 0.05, 1e-12);
  EXPECT_NEAR(run.at(1, "displacement_z.top"), -0.07 + 0.1, 1e-12);
  EXPECT_EQ(run.at(0.5, "reaction_z.top"), 0);
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

// Held from 0.3 to 0.6, free before and after.
TEST(Supports, ActBetweenTheirStartAndTheirEnd) {
  for (const std::string& kind : {word("z", "-0.1"), word("type", "displacement") + word("z", "-0.1")}) {
    BarDeck deck;
    deck.step = "0.4";
    deck.lists = supports(rollers() + list("top", kind + word("set", "bar/top") + number("start", "0.3") + number("end", "0.6")));
    const MarchedScene run(deck);
    ASSERT_EQ(run["time"], (std::vector<double>{0, 0.3, 0.6, 1})) << run.log;
    const auto top = run["displacement_z.top"], held = run["reaction_z.top"], ground = run["reaction_z.bottom"];
    EXPECT_EQ(held[1], 0);
    EXPECT_NEAR(top[2], -0.1, 1e-14);
    EXPECT_NEAR(held[2], -0.1 / length * modulus * 6, 1e-9);
    EXPECT_NEAR(ground[2], -held[2], 1e-9);
    EXPECT_NEAR(top[3], 0, 1e-12);
    EXPECT_EQ(held[3], 0);
    EXPECT_LE(run.relative_mismatch(), 1e-11);
  }
}

// One support hands over to another: never two at once, so they may say different things.
TEST(Supports, MayFollowOneAnother) {
  BarDeck deck;
  deck.lists = supports(rollers() + list("first", word("set", "bar/top") + word("z", "-0.1*t") + number("end", "0.5")) +
                        list("then", word("set", "bar/top") + word("z", "0.2") + number("start", "0.5")));
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_NEAR(run.at(0.5, "displacement_z.top"), -0.05, 1e-14);
  EXPECT_NEAR(run.at(0.75, "displacement_z.top"), 0.2, 1e-14);
  EXPECT_GT(std::abs(run.at(0.5, "reaction_z.first")), 1);
  EXPECT_EQ(run.at(0.75, "reaction_z.first"), 0);
  EXPECT_GT(std::abs(run.at(0.75, "reaction_z.then")), 1);
}

TEST(Supports, ThatContradictWhileBothActAreRefused) {
  BarDeck deck;
  deck.lists = supports(rollers() + list("first", word("set", "bar/top") + word("z", "0") + number("end", "0.6")) +
                        list("then", word("set", "bar/top") + word("z", "0.2") + number("start", "0.5")));
  try {
    scene_of(deck);
    FAIL() << "was accepted";
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("error[D21] supports > then > \"z\" = \"0.2\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("at t = 0.6"), std::string::npos) << error.what();
  }
}

TEST(Symmetry, HoldsTheComponentNormalToItsSide) {
  BarDeck rolled, mirrored;
  const std::string load =
      list("loads", list("load", word("type", "pressure") + word("set", "bar/top") + word("pressure", "9*t")));
  rolled.lists = supports(rollers()) + load;
  std::string planes;
  for (const std::string side : {"bottom", "left", "front"})
    planes += list(side, word("type", "symmetry") + word("set", "bar/" + side));
  mirrored.lists = supports(planes) + load;
  const MarchedScene a(rolled), b(mirrored);
  EXPECT_EQ(a.unknowns(), b.unknowns());
  EXPECT_EQ(a["reaction_z.bottom"], b["reaction_z.bottom"]);
  EXPECT_GT(a["reaction_z.bottom"].back(), 50);
}

void expect_refused(const std::string& deck, const std::string& words) {
  try {
    scene_of(deck);
    FAIL() << "was accepted, not refused with: " << words;
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Symmetry, RefusesSidesThatAreCurvedSlantedOrNone) {
  BarDeck deck;
  deck.lists = supports(list("plane", word("type", "symmetry") + word("set", "bar/left")));
  const std::string block = word("recipe", "block") + deck_parameter("size", "Array(double)", "{2, 3, 10}");
  const std::string turned = with(deck, block, block + deck_parameter("rotation", "Array(double)", "{0, 0, 1, 30}"));
  expect_refused(turned, "is normal to (-0.866025, -0.5, 0) - a symmetry plane must be normal to x, y or z: turn the mesh");
  const std::string tube =
      word("recipe", "hollow cylinder") + number("inner radius", "1") + number("outer radius", "2") + number("height", "3");
  expect_refused(with(with(deck, block + deck_parameter("elements", "Array(int)", "{2, 2, 4}"), tube), "bar/left", "bar/outer"),
                 "is not flat - a symmetry plane is needed");
}

// ---- damping ----------------------------------------------------------------------------------------------------------

// (K + b K/dt) u_{n+1} = f + b K u_n/dt, so that u_{n+1} - u_s = (u_n - u_s) / (1 + dt/b) with the static u_s: backward Euler.
TEST(RayleighDamping, RelaxesABarAsBackwardEulerDoes) {
  BarDeck deck;
  deck.body = number("rayleigh stiffness", "0.4");
  deck.lists =
      supports(rollers()) + list("loads", list("load", word("type", "traction") + word("set", "bar/top") + word("z", "-7")));
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  const auto top = run["displacement_z.top"];
  const double u_s = -7 * length / modulus;
  for (int n = 1; n <= 4; ++n) EXPECT_NEAR(top[n], u_s * (1 - std::pow(1 + 0.25 / 0.4, -n)), 1e-12) << "step " << n;
  EXPECT_LE(run.relative_mismatch(), 1e-11);
  // What the load has done and the bar has not stored has gone into the damping, but for the steps' own error.
  EXPECT_NEAR(run["damping_dissipation"].back() + run["strain_energy"].back() + run["algorithmic_dissipation"].back(),
              run["external_work"].back(), 1e-11 * run["external_work"].back());
  EXPECT_GT(run["damping_dissipation"].back(), 0.3 * run["external_work"].back());
}

// A body that only its own mass damping holds falls at g/a, whatever its mass matrix: M g = a M v.
TEST(RayleighDamping, LetsAFreeBodyFallAtTheSpeedThatItsMassDampingAllows) {
  for (const std::string mass : {"consistent", "consistent 2x2x2", "lumped"}) {
    BarDeck deck;
    deck.body = number("rayleigh mass", "20") + word("mass", mass);
    deck.lists = list("loads", list("gravity", word("type", "body force") + word("z", "-10")));
    const MarchedScene run(deck);
    ASSERT_EQ(run.summary.code, ExitCode::done) << mass << run.log;
    EXPECT_NEAR(run["displacement_z.top"].back(), -10.0 / 20, 1e-9) << mass;
    EXPECT_LE(run.relative_mismatch(), 1e-11) << mass;
  }
}

// ---- rigid modes ------------------------------------------------------------------------------------------------------

TEST(RigidModes, AreHeldBySpringsMassDampingAndSupportsThatActFromTheStart) {
  BarDeck deck;
  EXPECT_NE(free_at_the_start(deck).find("error[D22]"), std::string::npos);
  deck.lists = list("springs", list("ground", word("type", "bedding") + word("set", "bar/bottom") + number("x", "1") +
                                                  number("y", "1") + number("z", "1")));
  EXPECT_EQ(free_at_the_start(deck), "");
  deck.lists = with(deck.lists, number("z", "1"), "");
  EXPECT_NE(free_at_the_start(deck).find("translation z"), std::string::npos);
  const std::string held = word("set", "bar/bottom") + vector_of("0", "0", "0");
  deck.lists = supports(list("bottom", held + number("start", "0")));
  EXPECT_EQ(free_at_the_start(deck), "");
  deck.lists = supports(list("bottom", held + number("start", "0.5")));
  EXPECT_NE(free_at_the_start(deck).find("error[D22]"), std::string::npos);
  deck.body = number("rayleigh mass", "1");
  EXPECT_EQ(free_at_the_start(deck), "");
}

// ---- restart ----------------------------------------------------------------------------------------------------------

TEST(Restart, InTheMiddleOfAVelocitySupportAndDampingGivesTheSameNumbers) {
  BarDeck deck;
  deck.model = "neo-hookean";
  deck.poissons_ratio = "0.3";
  deck.body = number("rayleigh stiffness", "0.3") + number("rayleigh mass", "0.2");
  deck.step = "0.125";
  deck.lists =
      supports(list("bottom", word("set", "bar/bottom") + vector_of("0", "0", "0")) +
               list("top", word("type", "velocity") + word("set", "bar/top") + word("z", "-sin(7*t)") + word("y", "t"))) +
      list("springs",
           list("ground", word("type", "bedding") + word("set", "bar/left") + number("x", "5") + number("start", "0.3"))) +
      list("loads",
           list("blown", word("type", "pressure") + word("set", "bar/right") + word("pressure", "8*t") + number("end", "0.8")));
  const MarchedScene whole(deck);
  ASSERT_EQ(whole.summary.code, ExitCode::done) << whole.log;
  for (int k : {1, 3, 5}) {
    const MarchedScene part(deck, world(), k), rest(deck, world(), to_the_end, &part);
    ASSERT_EQ(part.summary.code, ExitCode::terminated);
    EXPECT_EQ(rest.unknowns(), whole.unknowns()) << k;
    for (const char* column : {"strain_energy", "external_work", "damping_dissipation", "reaction_z.top", "reaction_y.bottom"})
      EXPECT_EQ(rest[column], whole[column]) << k << " " << column;
  }
  EXPECT_GT(greatest_of(whole["damping_dissipation"]), 0);
}

}  // namespace
}  // namespace mortise::test
