// Two bars that meet end to end (inputs/bars_impact): what each scheme makes of the stress, the time and the energy of the
// impact.
#include <gtest/gtest.h>

#include <iostream>

#include "support/program.hpp"

namespace mortise::test {
namespace {

// Of the waves in two equal bars that meet with v = 1 m/s: rho c v/2 for 2 L/c from when they meet.
constexpr double stress = 20.30e6, duration = 386.68e-6, meeting = 10e-6;       // [Pa], [s]
constexpr double section = 1e-4, momentum = 0.785, energy = 0.3925, dt = 2e-6;  // [m^2], [kg m/s], [J], [s]

class BarsImpact : public testing::TestWithParam<const char*> {};

TEST_P(BarsImpact, HasTheStressAndTheDurationOfTheWaves) {
  const std::string scheme = GetParam();
  const bool keeps_energy = scheme == "energy momentum midpoint contact";
  const ScratchFolder folder;
  std::string deck = input_deck("bars_impact/energy_momentum.xml");
  if (!keeps_energy) deck = with(without_list(deck, "expected"), "energy momentum midpoint contact", scheme);
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const Table table = read_history(folder / "out" / "history.csv");
  const auto time = table["time"], force = table["contact_force_x.ends"], total = table["total_energy"];
  double sum = 0, begin = 0, end = 0;
  int n = 0, openings = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double since = time[k] - meeting;
    if (force[k] != 0) {
      if (end == 0) begin = time[k - 1];
      end = time[k];
    } else if (since > 2 * dt && since < duration - 2 * dt) {
      ++openings;
    }
    if (since < 0.1 * duration || since > 0.9 * duration) continue;
    sum += std::abs(force[k]) / section;
    ++n;
  }
  ASSERT_GT(n, 100);
  EXPECT_NEAR(sum / n, stress, 0.01 * stress);
  EXPECT_NEAR(end - begin, duration, 2 * dt);
  EXPECT_EQ(openings, 0);
  EXPECT_LE(greatest_of(table["linear_momentum_mismatch"]), 1e-11 * momentum);
  EXPECT_LE(greatest_of(table["ledger_mismatch"]), 1e-11 * energy);
  EXPECT_LE(total.back(), energy);
  const double algorithmic = greatest_of(table["algorithmic_dissipation"]), closing = table["contact_work_closing"].back();
  if (keeps_energy) {
    EXPECT_LE(algorithmic, 1e-11 * energy);
    EXPECT_NEAR(energy - total.back(), -closing, 1e-9 * energy);  // all that is lost is lost when the ends meet
  }
  std::cout << scheme << ": mean stress " << sum / n << ", duration " << end - begin << ", energy kept " << total.back() / energy
            << ", at closing " << closing / energy << ", by the scheme " << algorithmic / energy << '\n';
}

INSTANTIATE_TEST_SUITE_P(Schemes, BarsImpact,
                         testing::Values("backward euler", "generalised alpha", "midpoint", "energy momentum midpoint contact"));

}  // namespace
}  // namespace mortise::test
