// Springs in the redundant formulation (thesis eqs. 6.37-6.43) beside the same springs in that of positions.
#include <gtest/gtest.h>

#include "support/moving_bars.hpp"
#include "support/spring_pendulum.hpp"

namespace mortise::test {
namespace {

SpringPendulum formulated(SpringPendulum deck, const std::string& formulation) {
  deck.formulation = formulation;
  return deck;
}

/// A pendulum marched to its end on this rank alone; its ledger closes.
struct Swing : MarchedScene {
  Swing(const SpringPendulum& deck, const std::string& formulation) : MarchedScene(formulated(deck, formulation), alone()) {
    EXPECT_EQ(summary.code, ExitCode::done) << deck.scheme << deck.law << formulation << summary.cause;
    EXPECT_LE(relative_mismatch(), 1e-11) << deck.scheme << deck.law << formulation;
  }
};

/// Greatest difference of positions at any time over the greatest position.
double difference(const MarchedScene& a, const MarchedScene& b) {
  double worst = 0, greatest = 0;
  for (const char* column : {"position_x.x", "position_y.y", "position_z.z"}) {
    const auto p = a[column], q = b[column];
    EXPECT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < std::min(p.size(), q.size()); ++k) {
      worst = std::max(worst, std::abs(p[k] - q[k]));
      greatest = std::max(greatest, std::abs(q[k]));
    }
  }
  return worst / greatest;
}

SpringPendulum pendulum(const std::string& scheme, const std::string& stiffness, const std::string& step) {
  SpringPendulum deck;
  deck.scheme = scheme;
  deck.stiffness = stiffness;
  deck.step = step;
  return deck;
}

class AugmentedSpring : public testing::Test {
 protected:
  void SetUp() override {
    if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only; rings of springs run on all";
  }
};

/// V' by the discrete gradient of v is the discrete gradient of positions: thesis eqs. 6.36 and 6.43.
TEST_F(AugmentedSpring, FollowsTheEnergyMomentumTrajectory) {
  for (const char* stiffness : {"1e3", "1e6"})
    for (const char* step : {"5e-4", "1e-2"}) {
      const SpringPendulum deck = pendulum("energy momentum", stiffness, step);
      const Swing augmented(deck, "augmented");
      EXPECT_LE(difference(augmented, Swing(deck, "displacement")), 1e-11) << stiffness << step;
      if (std::string(stiffness) == "1e3") continue;
      for (double E : augmented["total_energy"]) EXPECT_NEAR(E, 16278.125, 1e-8) << step;
      for (double L : augmented["angular_momentum_x"]) EXPECT_NEAR(L, 10 / std::sqrt(2), 1e-9) << step;
      EXPECT_LE(relative_to(augmented, "linear_momentum_mismatch", "linear_momentum"), 1e-11) << step;
      EXPECT_LE(std::abs(augmented["algorithmic_dissipation"].back()), 1e-11 * 16278.125) << step;
    }
}

TEST_F(AugmentedSpring, FollowsTheEnergyMomentumTrajectoryForEveryLaw) {
  for (const char* law : {"neo-hookean", "logarithmic"})
    for (const char* scheme : {"energy momentum", "energy momentum midpoint contact"}) {
      SpringPendulum deck = pendulum(scheme, "1e3", "1e-2");
      deck.law = law;
      const Swing augmented(deck, "augmented");
      EXPECT_LE(difference(augmented, Swing(deck, "displacement")), 1e-11) << law << scheme;
      const auto E = augmented["total_energy"];
      for (double now : E) EXPECT_NEAR(now, E.front(), 1e-11 * E.front()) << law << scheme;
    }
}

/// A quadratic V has V'((v_n + v_n+1)/2) = (V'(v_n) + V'(v_n+1))/2 = the discrete gradient.
TEST_F(AugmentedSpring, MakesSecondOrderSchemesEnergyMomentumOnesForSaintVenant) {
  for (const auto& [stiffness, step] : {std::pair<const char*, const char*>{"1e3", "1e-2"}, {"1e6", "5e-4"}, {"1e6", "1e-2"}}) {
    const auto by = [&, stiffness = stiffness, step = step](const std::string& scheme) {
      SpringPendulum deck = pendulum(scheme, stiffness, step);
      if (deck.step == "5e-4") deck.end = "0.1";
      return deck;
    };
    const Swing exact(by("energy momentum"), "displacement");
    for (const char* scheme : {"midpoint", "trapezoidal", "variational midpoint"}) {
      const Swing run(by(scheme), "augmented");
      EXPECT_LE(difference(run, exact), 1e-11) << scheme << stiffness << step;
    }
  }
}

/// The same V is not quadratic for the other laws: what is kept is angular momentum, and the order is 2.
TEST_F(AugmentedSpring, IsASchemeOfItsOwnByMidpointForOtherLaws) {
  for (const char* scheme : {"midpoint", "trapezoidal", "variational midpoint"}) {
    SpringPendulum deck = pendulum(scheme, "1e3", "1e-2");
    deck.law = "logarithmic";
    deck.end = "0.1";
    const Swing run(deck, "augmented");
    EXPECT_GE(difference(run, Swing(deck, "displacement")), 1e-4) << scheme;
    for (double L : run["angular_momentum_x"]) EXPECT_NEAR(L, 10 / std::sqrt(2), 1e-10) << scheme;
    const auto y_by = [&](const char* step) {
      deck.step = step;
      return Swing(deck, "augmented")["position_y.y"].back();
    };
    const double coarse = y_by("4e-4"), middle = y_by("2e-4"), fine = y_by("1e-4");
    EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 2, 0.02) << scheme;
  }
}

/// All at the end of the step: the unknowns v and lambda can be eliminated.
TEST_F(AugmentedSpring, ChangesNothingByBackwardEuler) {
  for (const char* law : {"saint venant", "neo-hookean", "logarithmic"})
    for (const char* stiffness : {"1e3", "1e6"}) {
      SpringPendulum deck = pendulum("backward euler", stiffness, "1e-2");
      deck.law = law;
      EXPECT_LE(difference(Swing(deck, "augmented"), Swing(deck, "displacement")), 1e-11) << law << stiffness;
    }
}

/// The spring lets go, and the mass flies straight on; a spring that starts later finds the stretch that it has then.
TEST_F(AugmentedSpring, EndsAndStartsWithItsTimes) {
  for (const auto& [scheme, when] :
       std::vector<std::pair<std::string, std::string>>{{"energy momentum", number("end", "0.1")},
                                                        {"energy momentum", number("start", "0.1")},
                                                        {"backward euler", number("start", "0.1") + number("end", "0.2")}}) {
    SpringPendulum deck = pendulum(scheme, "1e3", "5e-3");
    deck.end = "0.3";
    const auto marched_with = [&](const std::string& formulation) {
      deck.formulation = formulation;
      return MarchedScene(with(deck, word("law", deck.law), word("law", deck.law) + when), alone());
    };
    const MarchedScene augmented = marched_with("augmented"), direct = marched_with("displacement");
    ASSERT_EQ(augmented.summary.code, ExitCode::done) << scheme << when << augmented.summary.cause;
    EXPECT_LE(difference(augmented, direct), 1e-11) << scheme << when;
    EXPECT_LE(augmented.relative_mismatch(), 1e-11) << scheme << when;
    const auto p = augmented["linear_momentum_x"];
    const bool starts = when.find("\"start\"") != std::string::npos, ends = when.find("\"end\"") != std::string::npos;
    EXPECT_EQ(starts, std::abs(p[5] - p.front()) < 1e-12) << scheme << when;
    EXPECT_EQ(ends, std::abs(p[p.size() - 5] - p.back()) < 1e-12) << scheme << when;
  }
}

TEST_F(AugmentedSpring, StartsWithTheStretchOfATurnedBody) {
  const SpringPendulum straight = pendulum("energy momentum", "1e3", "1e-2");
  const auto start_of = [&](const std::string& formulation) {
    const SpringPendulum deck = formulated(straight, formulation);
    const std::string velocity = deck_parameter("velocity", "Array(double)", deck.velocity);
    return MarchedScene(with(deck, velocity,
                             velocity + deck_parameter("rotation", "Array(double)", "{0, 1, 0, 180}") +
                                 deck_parameter("centre", "Array(double)", "{0.7, 0, 0.5}")),
                        alone(), 5);
  };
  const MarchedScene augmented = start_of("augmented"), direct = start_of("displacement");
  EXPECT_LE(difference(augmented, direct), 1e-12);
  EXPECT_GT(std::abs(augmented["strain_energy"].front() - Swing(straight, "augmented")["strain_energy"].front()), 1);
}

/// v and lambda are in the checkpoint: the run goes on to the same bits.
TEST_F(AugmentedSpring, GoesOnFromACheckpointAsIfNothingHadBeen) {
  for (const char* law : {"saint venant", "neo-hookean"}) {
    SpringPendulum deck = pendulum("energy momentum", "1e6", "1e-2");
    deck.formulation = "augmented";
    deck.law = law;
    const MarchedScene whole(deck, alone()), first(deck, alone(), 20), rest(deck, alone(), to_the_end, &first);
    EXPECT_EQ(first.summary.code, ExitCode::terminated);
    EXPECT_EQ(whole.unknowns(), rest.unknowns()) << law;
    EXPECT_EQ(whole["total_energy"], rest["total_energy"]) << law;
  }
}

/// Any tolerance of Newton: the ledger closes.
TEST_F(AugmentedSpring, ClosesTheLedgerForEveryTolerance) {
  for (const char* tolerance : {"1e-1", "1e-4", "1e-10"}) {
    SpringPendulum deck = pendulum("energy momentum", "1e3", "5e-3");
    deck.tolerance = tolerance;
    const Swing run(deck, "augmented");
  }
}

}  // namespace
}  // namespace mortise::test
