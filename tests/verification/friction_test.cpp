// Coulomb's friction of mortar pairs: what holds in statics, what is kept and lost in dynamics, on any number of ranks.
#include <gtest/gtest.h>

#include <iostream>

#include "support/drawn_block.hpp"
#include "support/moving_bars.hpp"

namespace mortise::test {
namespace {

class FrictionInStatics : public testing::TestWithParam<std::string> {};

// The forces in x and z are those of a surface that tilts under the block: within 2 % of mu.
TEST_P(FrictionInStatics, SticksThenSlidesAtTheBound) {
  DrawnBlock deck;
  deck.friction = GetParam();
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto fx = run["contact_force_x.pair"], fz = run["contact_force_z.pair"], slip = run["slip"], active = run["active"];
  EXPECT_GT(fz.back(), 0.5);
  EXPECT_EQ(slip.back(), active.back());  // all of them slide
  EXPECT_NEAR(fx.back() / fz.back(), -0.4, 0.02 * 0.4);
  const auto x = run.unknowns();
  for (std::size_t at = run.scene.n_positions(); at < x.size(); at += 4)  // pressure, traction
    EXPECT_NEAR(std::hypot(x[at + 1], x[at + 2], x[at + 3]), 0.4 * std::max(x[at], 0.0), 1e-8);
  for (std::size_t k = 1; k < fx.size(); ++k) {
    EXPECT_LE(std::abs(fx[k]), 0.4 * fz[k] * (1 + 1e-9));
    EXPECT_EQ(slip[k] + run["stick"][k], active[k]);
  }
  const auto lost = run["friction_dissipation"];
  for (std::size_t k = 1; k < lost.size(); ++k) EXPECT_GE(lost[k] - lost[k - 1], -1e-12);
  EXPECT_GT(lost.back(), 0.02);
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Forms, FrictionInStatics,
                         testing::Values("", word("slip", "moment free"), number("tangential penalty", "1e3"),
                                         number("tangential penalty", "1e3") + word("slip", "moment free")));

TEST(Friction, HoldsWhatIsDrawnLessThanTheBound) {
  DrawnBlock deck;
  deck.mu = "5";
  deck.drawn = "0.02*max(t-1,0)";
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_EQ(run["slip"].back(), 0);
  EXPECT_GT(std::abs(run["contact_force_x.pair"].back()), 0.1);
  EXPECT_LE(std::abs(run["friction_dissipation"].back()), 1e-12);
  EXPECT_EQ(run["stick_energy"].back(), 0);
}

TEST(Friction, OfZeroIsNoFriction) {
  DrawnBlock without;
  without.mu = "0";
  const MarchedScene zero{without};
  const MarchedScene none{with(std::string(without), number("friction coefficient", "0"), "")};
  ASSERT_EQ(zero.summary.code, ExitCode::done) << zero.summary.cause;
  EXPECT_NEAR(zero["contact_force_z.pair"].back(), none["contact_force_z.pair"].back(), 1e-9);
  const auto x = zero.unknowns(), y = none.unknowns();
  for (std::size_t k = 0; k < zero.scene.n_positions(); ++k) EXPECT_NEAR(x[k], y[k], 1e-9);
}

TEST(Friction, TurnsRoundWithTheDrawingAndClosesItsLoop) {
  DrawnBlock deck;
  deck.drawn = "0.2*sin(6.283185307179586*max(t-1,0))";
  deck.end = "4";
  deck.step = "0.05";
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto lost = run["friction_dissipation"];
  const auto at = [&](double t) { return run.at(t, "friction_dissipation"); };
  EXPECT_NEAR(at(4) - at(3), at(3) - at(2), 1e-3 * (at(4) - at(3)));  // one loop after the other
  EXPECT_GT(at(4) - at(3), 0.02);
}

TEST(Friction, IsTheSameOnEveryNumberOfRanks) {
  for (const std::string& friction : {std::string(), number("tangential penalty", "1e3")}) {
    DrawnBlock deck;
    deck.friction = friction;
    const std::string exact = with_lists(deck, list("solver", deck_parameter("further iterations", "int", "1")));
    const MarchedScene shared{exact}, alone_one(exact, alone());
    EXPECT_LE(relative_difference(shared.unknowns(), alone_one.unknowns(), 0, shared.scene.n_positions()), 1e-10);
    const auto a = shared["contact_force_x.pair"], b = alone_one["contact_force_x.pair"];
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-10);
  }
}

// Tractions and what stick has stored are in the checkpoint: the run goes on to the same bits.
TEST(Friction, GoesOnFromACheckpointAsIfNothingHadBeen) {
  if (world()->getSize() > 1) GTEST_SKIP() << "bit for bit is promised on one rank";
  for (const std::string& friction : {std::string(), number("tangential penalty", "1e3")}) {
    DrawnBlock deck;
    deck.friction = friction;
    const MarchedScene whole(deck, alone()), first(deck, alone(), 6), rest(deck, alone(), to_the_end, &first);
    EXPECT_EQ(first.summary.code, ExitCode::terminated);
    EXPECT_EQ(whole.unknowns(), rest.unknowns());
    EXPECT_EQ(whole["friction_dissipation"], rest["friction_dissipation"]);
    EXPECT_EQ(whole["stick_energy"], rest["stick_energy"]);
  }
}

// Pairs without friction have one unknown at a node and no traction, whatever other pairs have.
TEST(Friction, CostsNothingWhereThereIsNone) {
  const DrawnBlock with_it;
  const std::string without_it = with(std::string(with_it), number("friction coefficient", "0.4"), "");
  const TestScene frictional(with_it), frictionless(without_it);
  const int n = static_cast<int>(frictional.scene.pairs[0].secondary_nodes.size());
  EXPECT_EQ(frictional.problem.dofs().n_unknowns() - frictionless.problem.dofs().n_unknowns(), 3 * n);
  EXPECT_FALSE(frictionless.scene.has_friction());
  const MarchedScene run{without_it};
  EXPECT_EQ(greatest_of(run["friction_dissipation"]), 0);
  EXPECT_EQ(greatest_of(run["stick"]) + greatest_of(run["slip"]), 0);
}

// Each pair has its own unknowns and its own memory for them.
TEST(Friction, ActsInItsOwnPairAlone) {
  const std::string block = word("recipe", "block") + deck_parameter("elements", "Array(int)", "{3, 3, 1}") +
                            deck_parameter("origin", "Array(double)", "{2.6, 1.7, 1}");
  const std::string hand = word("set", "other/top") + word("x", "0.3*max(t-1,0)") + word("y", "0") + word("z", "-0.1*min(t,1)");
  const auto with_entry = [](const std::string& deck, const std::string& of, const std::string& entry) {
    const std::string begin = "<ParameterList name=\"" + of + "\">\n";
    return with(deck, begin, begin + entry);
  };
  std::string deck = DrawnBlock();
  deck = with_entry(deck, "meshes", list("other", block));
  deck = with_entry(deck, "bodies", list("other", word("mesh", "other") + word("material", "stiff")));
  deck = with_entry(deck, "supports", list("other hand", hand));
  deck = with_entry(deck, "contact", list("smooth", word("secondary", "other/bottom") + word("primary", "slab/top")));
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto x = run.unknowns();
  const DofSpace& dofs = run.scene.problem.dofs();
  const auto &smooth = *run.scene.problem.pairs()[0], &rubbing = *run.scene.problem.pairs()[1];
  for (std::size_t k = 0; k < rubbing.pair().secondary_nodes.size(); ++k) {
    const double* at = &x[static_cast<std::size_t>(dofs.global(rubbing.pressure_point(k)))];
    EXPECT_NEAR(std::hypot(at[1], at[2], at[3]), 0.4 * std::max(at[0], 0.0), 1e-8);
    EXPECT_EQ(dofs.size(smooth.pressure_point(k)), 1);
  }
  EXPECT_GT(run["contact_force_z.smooth"].back(), 0.5);
}

// What supports hold on both sides exact stick need not hold: no row without a pivot.
TEST(Friction, SticksInPlaneStrain) {
  DrawnBlock deck;
  deck.mu = "5";
  deck.drawn = "0.02*max(t-1,0)";
  std::string plane = with(with(deck, "{5, 4, 1}", "{5, 1, 1}"), "{3, 3, 1}", "{3, 1, 1}"), held;
  for (const char* side : {"slab/front", "slab/back", "block/front", "block/back"}) {
    std::string name = side;
    std::replace(name.begin(), name.end(), '/', ' ');
    held += list(name, word("set", side) + word("y", "0"));
  }
  const std::string supports = "<ParameterList name=\"supports\">\n";
  plane = with(plane, supports, supports + held);
  const MarchedScene run{plane};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_GT(run["stick"].back(), run["slip"].back());
  EXPECT_GT(std::abs(run["contact_force_x.pair"].back()), 0.1);
}

// At nodes that a support holds along their normals, beside free ones, it alone pushes (case A13).
TEST(HeldNodes, HaveNoPressureAlongTheirSupport) {
  DrawnBlock deck;
  deck.law = " ";
  deck.drawn = "0";
  const std::string supports = "<ParameterList name=\"supports\">\n";
  const std::string edge = list("edge", word("set", "block/left") + word("z", deck.pressed));
  const MarchedScene run{with(deck, supports, supports + edge)};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const MortarTerm& pair = *run.scene.problem.pairs()[0];
  const auto x = run.unknowns();
  int n_held = 0, n_pressing = 0;
  for (std::size_t k = 0; k < pair.pair().secondary_nodes.size(); ++k) {
    const double pressure = x[static_cast<std::size_t>(run.scene.problem.dofs().global(pair.pressure_point(k)))];
    n_held += pair.is_held(k);
    n_pressing += pressure > 0;
    if (pair.is_held(k)) {
      EXPECT_EQ(pressure, 0);
    }
  }
  EXPECT_EQ(n_held, 4);
  EXPECT_GT(n_pressing, 0);
}

/// Two free blocks, the upper one flies onto the lower one, slides, and both spin away.
struct FlyingBlocks {
  std::string scheme = "energy momentum midpoint contact", friction, step = "0.01", end = "0.4";

  operator std::string() const {
    const std::string lower = word("recipe", "block") + deck_parameter("size", "Array(double)", "{3, 3, 1}") +
                              deck_parameter("elements", "Array(int)", "{3, 3, 1}"),
                      upper = word("recipe", "block") + deck_parameter("size", "Array(double)", "{1.5, 1.5, 1}") +
                              deck_parameter("elements", "Array(int)", "{2, 2, 1}") +
                              deck_parameter("origin", "Array(double)", "{0.4, 0.8, 1.05}");
    return list("flying blocks",
                list("meshes", list("lower", lower) + list("upper", upper)) +
                    list("materials", list("rubber", word("model", "neo-hookean") + number("youngs modulus", "1000") +
                                                         number("poissons ratio", "0.3") + number("density", "1"))) +
                    list("bodies", list("lower", word("mesh", "lower") + word("material", "rubber")) +
                                       list("upper", word("mesh", "upper") + word("material", "rubber"))) +
                    list("initial conditions", list("upper", deck_parameter("velocity", "Array(double)", "{4, 0.5, -2}"))) +
                    list("contact", list("pair", word("secondary", "upper/bottom") + word("primary", "lower/top") +
                                                     number("friction coefficient", "0.3") + friction)) +
                    list("time", word("scheme", scheme) + number("step", step) + number("end", end)));
  }
};

class FrictionInDynamics : public testing::TestWithParam<std::string> {};

TEST_P(FrictionInDynamics, BalancesEnergyAndMomenta) {
  FlyingBlocks deck;
  deck.friction = GetParam();
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const double energy = run["total_energy"].front(), lost = run["friction_dissipation"].back();
  EXPECT_GT(lost, 0.02 * energy);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  EXPECT_LE(greatest_of(run["algorithmic_dissipation"]), 1e-11 * energy);
  EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-11);
  const double turned = relative_to(run, "angular_momentum_mismatch", "angular_momentum");
  const bool is_thesis = GetParam().find("thesis") != std::string::npos;
  if (!is_thesis) {
    EXPECT_LE(turned, 1e-11);
  }
  if (world()->getRank() == 0)
    std::cout << "friction took " << lost / energy << ", contact " << run["contact_work"].back() / energy
              << " of the energy; angular momentum missed by " << turned << '\n';
}

INSTANTIATE_TEST_SUITE_P(Forms, FrictionInDynamics,
                         testing::Values("", word("slip", "thesis"), number("tangential penalty", "1e4"),
                                         number("tangential penalty", "1e4") + word("slip", "thesis")));

// What contact took at closing is the work of pressures: no traction of the step before enters, and the velocity update gives
// back nothing of what friction took.
TEST(FrictionOfFlyingBlocks, IsKeptApartFromTheWorkOfPressures) {
  FlyingBlocks deck;
  deck.friction = number("tangential penalty", "1e4");
  const MarchedScene penalised{deck};
  const auto active = penalised["active"], closing = penalised["contact_work_closing"];
  int n = 0;
  for (std::size_t k = 1; k < active.size(); ++k)
    if (active[k] == 9 && active[k - 1] == 9) {  // none of them closes in the step
      EXPECT_EQ(closing[k], closing[k - 1]) << k;
      ++n;
    }
  EXPECT_GT(n, 1);

  deck.friction = word("closing", "velocity update");
  const MarchedScene updated{deck};
  ASSERT_EQ(updated.summary.code, ExitCode::done) << updated.summary.cause << updated.log;
  const auto energy = updated["total_energy"];
  EXPECT_LE(std::abs(updated["contact_work"].back()), 1e-11 * energy.front());
  EXPECT_GT(updated["friction_dissipation"].back(), 0.02 * energy.front());
  EXPECT_NEAR(energy.back(), energy.front() - updated["friction_dissipation"].back(), 1e-9 * energy.front());
  EXPECT_LE(updated.relative_mismatch(), 1e-13);
  EXPECT_LE(relative_to(updated, "linear_momentum_mismatch", "linear_momentum"), 1e-11);
}

}  // namespace
}  // namespace mortise::test
