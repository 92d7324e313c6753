// Rigid obstacles and rods in dynamics: what each way of closing does to the energy, and constraints that keep it.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "support/moving_bars.hpp"

namespace mortise::test {
namespace {

struct ClosingCase {
  std::string scheme, closing;
  bool keeps_energy;
};
class EveryClosing : public testing::TestWithParam<ClosingCase> {};

TEST_P(EveryClosing, ClosesTheLedgerAndTellsWhatContactTook) {
  FlyingBar bar;
  bar.scheme = GetParam().scheme;
  bar.closing = GetParam().closing;
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_GT(greatest_of(run["contact_force_x.wall"]), 50);  // 300 per area for the wave alone
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  const auto energy = run["total_energy"];
  const double work = run["contact_work"].back();
  EXPECT_NEAR(energy.back(), energy.front() + work - run["algorithmic_dissipation"].back() + run["residual_work"].back(),
              1e-11 * energy.front());
  if (GetParam().scheme != "generalised alpha") {                         // which promises it without net load only
    EXPECT_LE(greatest_of(run["linear_momentum_mismatch"]), 1e-12 * 25);  // the wall's impulse is in the balance
  }
  EXPECT_NEAR(run["contact_work_closing"].back() + run["contact_work_resegmentation"].back(), work, 1e-2 * energy.front());
  if (GetParam().keeps_energy) {
    EXPECT_LE(std::abs(work), 1e-11 * energy.front());
  }
  const double lost = 1 - energy.back() / energy.front();
  if (GetParam().scheme == "energy momentum") {
    EXPECT_LE(std::abs(run["algorithmic_dissipation"].back()), 1e-12 * energy.front());
    EXPECT_EQ(std::abs(lost) < 1e-11, GetParam().keeps_energy) << lost;
  }
  EXPECT_GE(lost, -1e-11);
  EXPECT_GT(run["linear_momentum_x"].back(), 0.6 * std::abs(run["linear_momentum_x"].front()));  // it has turned round
}

INSTANTIATE_TEST_SUITE_P(
    Obstacles, EveryClosing,
    testing::Values(ClosingCase{"energy momentum", "position", false}, ClosingCase{"energy momentum", "modified", true},
                    ClosingCase{"energy momentum", "persistent", true}, ClosingCase{"energy momentum", "velocity update", true},
                    ClosingCase{"backward euler", "velocity update", true}, ClosingCase{"midpoint", "velocity update", true},
                    ClosingCase{"energy momentum midpoint contact", "persistent", true},
                    ClosingCase{"midpoint", "persistent", true}, ClosingCase{"midpoint", "position", false},
                    ClosingCase{"backward euler", "position", false}, ClosingCase{"generalised alpha", "position", false}));

// Nothing has to be stopped when it touches: the pressure is that of the wave without alternating, and the energy does not grow.
TEST(MassRedistribution, GivesAnAverageAccelerationThatIsStableInContact) {
  FlyingBar bar;
  bar.scheme = "newmark";
  bar.closing = "position";
  const std::string deck = with(std::string(bar), "\"lumped\"", "\"lumped off contact\"");
  const MarchedScene run(deck);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  const auto time = run["time"], force = run["contact_force_x.wall"], energy = run["total_energy"];
  EXPECT_LE(greatest_of(energy), (1 + 1e-9) * energy.front());
  EXPECT_GE(energy.back(), 0.99 * energy.front());  // of 20 elements
  int n = 0;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] > 0.65 && time[k] < 1.1) {
      EXPECT_NEAR(force[k], 300 * 0.25, 0.05 * 300 * 0.25) << time[k];
      ++n;
    }
  EXPECT_GT(n, 20);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  EXPECT_NEAR(run["linear_momentum_x"].front(), -10 * 10 * 0.25, 1e-12);
}

TEST(Obstacle, OfPositionsIsNeverEntered) {
  FlyingBar bar;
  bar.closing = "position";
  bar.scheme = "backward euler";
  const MarchedScene run{bar};
  const auto x = run.unknowns();
  ASSERT_EQ(run.summary.code, ExitCode::done);
  for (std::size_t k = 0; k < run.scene.n_positions(); k += 3) EXPECT_GE(x[k], -1e-9);
}

TEST(Obstacle, ThatEndsLetsTheBarPass) {
  FlyingBar bar;
  bar.end_of_wall = number("end", "0.4");
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_EQ(greatest_of(run["contact_force_x.wall"]), 0);
  EXPECT_NEAR(run["linear_momentum_x"].back(), run["linear_momentum_x"].front(), 1e-12);
}

// Where a node stays at its distance from the centre, the Jacobian at the mean position does no work either.
TEST(Obstacle, OfASphereKeepsTheEnergy) {
  for (const char* scheme : {"energy momentum", "energy momentum midpoint contact"}) {
    FlyingBar bar;
    bar.model = "neo-hookean";
    bar.obstacle = word("type", "sphere") + deck_parameter("centre", "Array(double)", "{-1, 0.2, 0.3}") + number("radius", "0.9");
    bar.scheme = scheme;
    const MarchedScene run{bar};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    EXPECT_GT(greatest_of(run["contact_force_x.wall"]), 10);
    EXPECT_LE(run.relative_mismatch(), 1e-13);
    EXPECT_LE(greatest_of(run["contact_work"]), 1e-11 * run["total_energy"][0]);
  }
}

/// A block that hangs by one corner on a rod and swings.
std::string swinging_block(const std::string& scheme, const std::string& step, const std::string& springs = "") {
  const std::string mesh = word("recipe", "block") + deck_parameter("origin", "Array(double)", "{1, 0, 0}");
  return list("block",
              list("meshes", list("block", mesh)) +
                  list("materials", list("rubber", word("model", "neo-hookean") + number("youngs modulus", "2000") +
                                                       number("poissons ratio", "0.3") + number("density", "1"))) +
                  list("bodies", list("block", word("mesh", "block") + word("material", "rubber"))) +
                  list("loads", list("gravity", word("type", "body force") + word("z", "-10"))) +
                  list("rods", list("rod", word("mesh", "block") + deck_parameter("nearest", "Array(double)", "{1, 0, 0}") +
                                               deck_parameter("anchor", "Array(double)", "{0, 0, 0.5}"))) +
                  springs + list("time", word("scheme", scheme) + number("step", step) + number("end", "1")));
}

TEST(Rod, KeepsItsLengthAndTheEnergy) {
  const MarchedScene run(swinging_block("energy momentum", "0.02"));
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  const auto x = run.unknowns();
  EXPECT_NEAR(std::hypot(x[0], x[1], x[2] - 0.5), std::hypot(1, 0.5), 1e-9);
  EXPECT_LE(x[2], -0.5);  // it has swung down
  const double moved = greatest_of(run["kinetic_energy"]);
  EXPECT_LE(greatest_of(run["contact_work"]), 1e-11 * moved);
  EXPECT_LE(greatest_of(run["algorithmic_dissipation"]), 1e-11 * moved);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  EXPECT_NEAR(run["total_energy"].back(), run["external_work"].back(), 1e-8 * moved);
  EXPECT_GT(greatest_of(run["contact_force_z.rod"]), 1);
  EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-12);
  EXPECT_LE(relative_to(run, "angular_momentum_mismatch", "angular_momentum"), 1e-12);
}

// Springs, a bedding, an anchor and a rod push from outside: with them the momenta are balanced too.
TEST(MomentumBalance, CountsWhatTheGroundPushesWith) {
  const std::string springs =
      list("springs", list("posts", word("type", "nodes") + word("set", "block/top") + number("x", "3") + number("z", "20")) +
                          list("bed", word("type", "bedding") + word("set", "block/left") + number("y", "30")));
  for (const char* scheme : {"midpoint", "trapezoidal", "energy momentum", "backward euler"}) {
    const MarchedScene run(swinging_block(scheme, "0.02", springs));
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    EXPECT_GT(greatest_of(run["linear_momentum_z"]), 0.1);
    EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-12) << scheme;
    if (scheme == std::string("midpoint") || scheme == std::string("energy momentum")) {
      EXPECT_LE(relative_to(run, "angular_momentum_mismatch", "angular_momentum"), 1e-12) << scheme;
    }
  }
}

// An index-3 constraint in the schemes: the order in the positions against a much finer run.
TEST(Rod, LeavesTheMidpointRuleItsOrder) {
  const auto end_of = [](const std::string& step) { return MarchedScene(swinging_block("midpoint", step)).unknowns(); };
  const auto exact = end_of("0.0005"), coarse = end_of("0.004"), fine = end_of("0.002");
  const double order = std::log2(relative_difference(coarse, exact, 0, 24) / relative_difference(fine, exact, 0, 24));
  EXPECT_NEAR(order, 2, 0.1);
}

}  // namespace
}  // namespace mortise::test
