// Time schemes on a free elastic bar that is thrown and spun: what each keeps, its order, and the ledger of all.
#include <gtest/gtest.h>

#include "support/moving_bars.hpp"

namespace mortise::test {
namespace {

struct SchemeCase {
  std::string scheme, parameters;
  bool keeps_angular;
  double order;
  bool is_stable = true;  ///< at great steps
};

const std::vector<SchemeCase> scheme_cases{
    {"forward euler", "", false, 1, false},
    {"backward euler", "", false, 1},
    {"trapezoidal", "", false, 2},
    {"midpoint", "", true, 2},
    {"generalised alpha", number("spectral radius", "0.7"), false, 2},
    {"generalised alpha", number("spectral radius", "0.7") + word("forces", "mean"), false, 2},
    {"newmark", "", false, 2},
    {"hht", number("alpha", "0.1"), false, 2},
    {"wbz", number("alpha", "0.1"), false, 2},
    {"variational midpoint", "", true, 2},
    {"variational midpoint", number("alpha", "0.3"), true, 1, false},
    {"energy momentum", "", true, 2},
    {"energy momentum midpoint contact", "", true, 2},
};

class EveryScheme : public testing::TestWithParam<SchemeCase> {};

TEST_P(EveryScheme, ClosesTheLedgerAndKeepsWhatItPromises) {
  const SchemeCase& c = GetParam();
  FreeBar bar;
  bar.scheme = c.scheme;
  bar.parameters = c.parameters;
  if (!c.is_stable) {
    bar.step = "1e-4";
    bar.end = "2e-3";
  }
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  EXPECT_GT(run["kinetic_energy"][0], 1e-3);
  EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-12);
  const double drift = relative_to(run, "angular_momentum_mismatch", "angular_momentum");
  EXPECT_EQ(drift <= 1e-12, c.keeps_angular) << drift;
  if (world()->getRank() == 0 && world()->getSize() == 1)
    std::cout << c.scheme << " " << c.parameters << ": energy " << run["total_energy"].front() << " -> "
              << run["total_energy"].back() << ", angular drift " << drift << ", algorithmic dissipation "
              << run["algorithmic_dissipation"].back() << "\n";
}

// Of velocities, against a run with much shorter steps: halving the step divides the error by 2^order.
TEST_P(EveryScheme, HasItsOrder) {
  const SchemeCase& c = GetParam();
  const auto end_of = [&](const std::string& step, const std::string& scheme, const std::string& parameters) {
    FreeBar bar;
    bar.scheme = scheme;
    bar.parameters = parameters;
    bar.step = step;
    bar.end = "0.016";
    const MarchedScene run{bar};
    EXPECT_EQ(run.summary.code, ExitCode::done) << run.summary.cause;
    return run.scene.gather(*run.scene.state.v);
  };
  static const auto exact = end_of("2.5e-5", "midpoint", "");
  const auto coarse = end_of(c.order == 2 ? "5e-4" : "1e-4", c.scheme, c.parameters),
             fine = end_of(c.order == 2 ? "2.5e-4" : "5e-5", c.scheme, c.parameters);
  const double order =
      std::log2(relative_difference(coarse, exact, 0, exact.size()) / relative_difference(fine, exact, 0, exact.size()));
  EXPECT_NEAR(order, c.order, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Dynamics, EveryScheme, testing::ValuesIn(scheme_cases));

// Velocities come from increments of positions, not from positions, whose round-off a short step would magnify. (The alpha
// schemes carry accelerations on, and with them the round-off of increments over dt^2.)
TEST(VeryShortSteps, KeepTheMomentum) {
  for (const char* scheme :
       {"forward euler", "backward euler", "trapezoidal", "midpoint", "variational midpoint", "energy momentum"}) {
    SCOPED_TRACE(scheme);
    FreeBar bar;
    bar.scheme = scheme;
    bar.step = "1e-7";
    bar.end = "2e-6";
    const MarchedScene run{bar};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
    EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-14);
  }
}

class EnergyMomentum : public testing::TestWithParam<const char*> {};

// Whatever Newton leaves is in `residual_work`: what the scheme itself adds is round-off.
TEST_P(EnergyMomentum, KeepsTheEnergyAtAnyToleranceAndAnyStep) {
  for (const char* tolerance : {"1e-2", "1e-6", "1e-10"})
    for (const char* step : {"0.005", "0.02", "0.05"}) {
      FreeBar bar;
      bar.scheme = "energy momentum";
      bar.model = GetParam();
      bar.tolerance = tolerance;
      bar.step = step;
      const MarchedScene run{bar};
      ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause;
      const double energy = run["total_energy"][0];
      EXPECT_LE(greatest_of(run["algorithmic_dissipation"]), 1e-13 * energy) << tolerance << " " << step;
      EXPECT_LE(run.relative_mismatch(), 1e-13);
      EXPECT_LE(relative_to(run, "angular_momentum_mismatch", "angular_momentum"), 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(Materials, EnergyMomentum, testing::Values("neo-hookean", "saint venant-kirchhoff", "linear elastic"));

}  // namespace
}  // namespace mortise::test
