// Loads and springs on a bar: closed forms, their tangent as a whole, their times, the same on any number of ranks.
#include <gtest/gtest.h>

#include <iostream>

#include "support/bar_deck.hpp"
#include "support/gradient_check.hpp"
#include "support/marched_scene.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

constexpr double area = 6, length = 10, modulus = 1000, density = 0.01;

/// Every load, spring and damping at once, some for a while only; the bar bends and twists.
BarDeck everything() {
  BarDeck deck;
  deck.model = "neo-hookean";
  deck.poissons_ratio = "0.3";
  deck.body = number("rayleigh mass", "0.4") + number("rayleigh stiffness", "0.05");
  deck.lists =
      list("supports", list("bottom", word("set", "bar/bottom") + vector_of("0", "0", "0"))) +
      list("springs",
           list("at the top", word("type", "nodes") + word("set", "bar/top") + number("x", "2") + number("z", "1")) +
               list("on the left", word("type", "bedding") + word("set", "bar/left") + number("y", "3") + number("end", "0.6"))) +
      list("loads",
           list("dead", word("type", "traction") + word("set", "bar/top") + word("z", "-2*t*(1+0.1*x)")) +
               list("cauchy", word("type", "cauchy traction") + word("set", "bar/right") + vector_of("0", "0.5*t", "-0.1*z*t")) +
               list("blown", word("type", "pressure") + word("set", "bar/back") + word("pressure", "(1+0.1*z)*t") +
                                 number("start", "0.3")) +
               list("gravity", word("type", "body force") + word("z", "-9*(1+0.2*x*y)") + word("x", "20*t")) +
               list("push", word("type", "point force") + word("mesh", "bar") +
                                deck_parameter("nearest", "Array(double)", "{2, 3, 10}") + word("y", "5*t")));
  return deck;
}

TEST(Loads, TangentOfAllTogetherIsTheDerivativeOfTheResidual) {
  BarDeck deck = everything();
  deck.elements = "{1, 2, 2}";
  TestScene s(deck);
  ASSERT_EQ(s.problem.begin_step(s.state, 0.5), "");
  Random random(5);
  const auto x = s.random_state(random, 0.05, 0, 0);
  RCP<Matrix> K;
  ASSERT_TRUE(s.problem.linearise(*s.scatter(x), K).admissible);
  GradientCheck check;
  check.first_step = 1e-3;
  EXPECT_TRUE(is_derivative(
      s.dense(*K), [&](const auto& y) { return s.gather(*s.problem.evaluate(*s.scatter(y)).residual); }, x, check));
}

TEST(Loads, GiveTheSameOnOneRankAndOnAllAndALedgerThatCloses) {
  const MarchedScene all(everything()), one(everything(), alone());
  ASSERT_EQ(all.summary.code, ExitCode::done) << all.log;
  const auto x = all.unknowns();
  const double difference = relative_difference(x, one.unknowns(), 0, x.size());
  EXPECT_LE(difference, 1e-10);
  for (const char* column : {"strain_energy", "external_work", "damping_dissipation", "reaction_z.bottom"})
    EXPECT_NEAR(all[column].back(), one[column].back(), 1e-10 * std::abs(one[column].back())) << column;
  EXPECT_GT(all["damping_dissipation"].back(), 0.01 * all["external_work"].back());
  EXPECT_GT(all["strain_energy"].back(), 0.1) << "nothing was pressed";
  EXPECT_EQ(all["time"], (std::vector<double>{0, 0.25, 0.3, 0.55, 0.6, 0.85, 1})) << "starts and ends are stops";
  EXPECT_LE(all.relative_mismatch(), 1e-11);
  if (world()->getRank() == 0)
    std::cout << world()->getSize() << " ranks against one: " << difference << "; ledger mismatch " << all.relative_mismatch()
              << '\n';
}

// u(z) = p z/E under a traction, (rho g/E)(L z - z^2/2) under the bar's own weight: exact at the nodes of linear elements.
TEST(Loads, ColumnsOfLinearElasticMaterialMeetTheirClosedForms) {
  BarDeck deck;
  const auto top = [&](const std::string& load) {
    deck.lists = list("supports", rollers()) + list("loads", list("load", load));
    const MarchedScene run(deck);
    EXPECT_EQ(run.summary.code, ExitCode::done) << run.log;
    EXPECT_LE(run.relative_mismatch(), 1e-11);
    return run["displacement_z.top"].back();
  };
  EXPECT_NEAR(top(word("type", "traction") + word("set", "bar/top") + word("z", "-7*t")), -7 * length / modulus, 1e-12);
  EXPECT_NEAR(top(word("type", "body force") + word("body", "bar") + word("z", "-9.81*t")),
              -density * 9.81 * length * length / (2 * modulus), 1e-12);
  EXPECT_NEAR(top(word("type", "body force") + word("z", "-0.3*z")), -density * 0.3 * std::pow(length, 3) / (3 * modulus), 1e-11);
  deck.elements = "{1, 1, 4}";  // four corners at the top: the same force on each presses evenly
  EXPECT_NEAR(top(word("type", "point force") + word("set", "bar/top") + word("z", "-15*t")), -4 * 15 * length / (modulus * area),
              1e-12);
}

TEST(Springs, InSeriesWithABarMeetTheirClosedForm) {
  BarDeck deck;
  deck.elements = "{1, 1, 4}";
  const std::string sides =
      list("left", word("set", "bar/left") + word("x", "0")) + list("front", word("set", "bar/front") + word("y", "0"));
  const double force = 7 * area, in_bar = -7 * length / modulus;
  const auto on = [&](const std::string& spring) -> std::string {
    deck.lists = list("supports", sides) + list("springs", list("ground", word("set", "bar/bottom") + spring)) +
                 list("loads", list("load", word("type", "traction") + word("set", "bar/top") + word("z", "-7*t")));
    return deck;
  };
  const MarchedScene bedding(on(word("type", "bedding") + number("z", "2")));
  EXPECT_NEAR(bedding["displacement_z.top"].back(), in_bar - force / (2 * area), 1e-12);
  EXPECT_NEAR(bedding["strain_energy"].back(), 0.5 * force * (force / (2 * area) - in_bar), 1e-10) << "the spring's is in it";
  EXPECT_LE(bedding.relative_mismatch(), 1e-11);
  const MarchedScene nodes(on(word("type", "nodes") + number("z", "3")));
  EXPECT_NEAR(nodes["displacement_z.top"].back(), in_bar - force / (4 * 3), 1e-12);
  EXPECT_LE(nodes.relative_mismatch(), 1e-11);
}

// Each for t in (0.3, 0.6] only, on a bar that springs back at once.
TEST(Loads, ActBetweenTheirStartAndTheirEnd) {
  BarDeck deck;
  deck.step = "0.4";
  const std::string times = number("start", "0.3") + number("end", "0.6");
  const std::vector<std::string> kinds{
      word("type", "traction") + word("set", "bar/top") + word("z", "-7"),
      word("type", "cauchy traction") + word("set", "bar/top") + word("z", "-7"),
      word("type", "pressure") + word("set", "bar/top") + word("pressure", "7"),
      word("type", "body force") + word("z", "-9.81"),
      word("type", "point force") + word("set", "bar/top") + word("z", "-1"),
  };
  for (const auto& kind : kinds) {
    deck.lists = list("supports", rollers()) + list("loads", list("load", kind + times));
    const MarchedScene run(deck);
    ASSERT_EQ(run["time"], (std::vector<double>{0, 0.3, 0.6, 1})) << kind;
    const auto top = run["displacement_z.top"], reaction = run["reaction_z.bottom"];
    EXPECT_NEAR(top[1], 0, 1e-12) << kind;
    EXPECT_LT(top[2], -1e-3) << kind;
    EXPECT_NEAR(top[3], 0, 1e-12) << kind;
    EXPECT_GT(reaction[2], 1) << kind;
    EXPECT_NEAR(reaction[3], 0, 1e-9) << kind;
    EXPECT_LE(run.relative_mismatch(), 1e-11) << kind;
  }
}

TEST(Springs, ActBetweenTheirStartAndTheirEnd) {
  BarDeck deck;
  deck.step = "0.4";
  deck.lists = list("supports", rollers()) +
               list("springs", list("ground", word("type", "bedding") + word("set", "bar/top") + number("z", "100") +
                                                  number("start", "0.3") + number("end", "0.6"))) +
               list("loads", list("load", word("type", "traction") + word("set", "bar/top") + word("z", "-7")));
  const MarchedScene run(deck);
  ASSERT_EQ(run["time"], (std::vector<double>{0, 0.3, 0.6, 1}));
  const auto top = run["displacement_z.top"];
  EXPECT_NEAR(top[1], -7 * length / modulus, 1e-12);
  EXPECT_NEAR(top[2], -7 / (modulus / length + 100), 1e-12);  // bar and bedding side by side
  EXPECT_NEAR(top[3], -7 * length / modulus, 1e-12);
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

// A bar that is blown up on all sides: a pressure that follows keeps its force and moment at zero, so nothing else is needed to
// hold it but what takes its rigid motions, and that feels nothing.
TEST(Loads, PressureOnAllSidesNeedsNoReaction) {
  BarDeck deck;
  deck.model = "neo-hookean";
  deck.poissons_ratio = "0.3";
  std::string blown;
  for (const std::string side : {"left", "right", "front", "back", "bottom", "top"})
    blown += list("on the " + side, word("type", "pressure") + word("set", "bar/" + side) + word("pressure", "-150*t"));
  deck.lists = list("supports", rollers()) + list("loads", blown);
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_GT(run["displacement_z.top"].back(), 0.3);
  for (const char* column : {"reaction_z.bottom", "reaction_x.left", "reaction_y.front"})
    EXPECT_NEAR(run[column].back(), 0, 1e-6 * 150 * area) << column;
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

// ---- thesis 6.3.1 -----------------------------------------------------------------------------------------------------

struct Stretches {
  double axial, lateral;
};

Stretches pressed(const std::string& deck) {
  MarchedScene run(deck);
  EXPECT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_LE(run.relative_mismatch(), 1e-11);
  return {1 + run["displacement_z.top"].back() / 120, 1 + run["displacement_x.side"].back() / 60};
}

TEST(MooneyRivlinBlocks, DeadAndFollowingLoadsGiveTheirStretches) {
  const std::string name = "patch_and_hertz.json";
  if (!have_reference(name)) GTEST_SKIP() << no_reference(name);
  const std::string material = "MR (stress-free: +c2, d=2(c1+2c2)) | ";
  const auto states = reference(name);
  const auto dead = states.at(material + "dead nominal P=-1e5"),
             follower = states.at(material + "Cauchy/follower sigma=-1e5 (= thesis (4.17)/(4.18))");
  const std::string pressure = input_deck("patch_test/mooney_rivlin_follower.xml");
  const std::string cauchy =
      with(with(pressure, "value=\"pressure\"", "value=\"cauchy traction\""), "name=\"pressure\" type=\"string\" value=\"1e5*t\"",
           "name=\"z\" type=\"string\" value=\"-1e5*t\"");
  const auto expect = [](const Stretches& found, const nlohmann::json& exact) {
    EXPECT_NEAR(found.axial, std::stod(exact.at("lambda_axial").get<std::string>()), 1e-10);
    EXPECT_NEAR(found.lateral, std::stod(exact.at("lambda_lateral").get<std::string>()), 1e-10);
    if (world()->getRank() == 0) std::cout.precision(15);
    if (world()->getRank() == 0) std::cout << "stretches " << found.axial << ", " << found.lateral << '\n';
  };
  expect(pressed(input_deck("patch_test/mooney_rivlin_dead.xml")), dead);
  expect(pressed(pressure), follower);
  expect(pressed(cauchy), follower);
}

}  // namespace
}  // namespace mortise::test
