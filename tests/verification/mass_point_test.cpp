// Single masses: on the ground (thesis 5.4) against independent values, on a rigid rod (C.2) against its index-reduced equations.
// One element: both run on one rank.
#include <gtest/gtest.h>

#include "support/moving_bars.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

std::string deck_with_step(const std::string& deck, const std::string& old_step, const std::string& step) {
  return with(deck, "name=\"step\" type=\"double\" value=\"" + old_step + "\"",
              "name=\"step\" type=\"double\" value=\"" + step + "\"");
}

class MassPoint : public testing::TestWithParam<const char*> {};

TEST_P(MassPoint, FollowsTheIndependentTrajectory) {
  if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only";
  if (!have_reference("mass_point.json")) GTEST_SKIP() << no_reference("mass_point.json");
  const auto results = reference("mass_point.json").at("results");
  const std::string closing = GetParam();
  const auto& known = results.at("r04_masspoint_" + closing + "_dt0.05.csv");
  const MarchedScene run(input_deck("mass_point/" + closing + ".xml"));
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  // An impact that stops at the ground turns the round-off of the position before it into 2/dt = 40 times as much velocity, and
  // two seconds of flight that into position again.
  double round_off = 1e-12 * 15;
  ASSERT_FALSE(known.at("contacts").empty());
  for (const auto& contact : known.at("contacts")) {
    const double t = std::round(contact[0].get<double>() * 1000) / 1000;
    EXPECT_NEAR(run.at(t, "position_z.height"), contact[1], round_off) << "t = " << t;
    EXPECT_NEAR(run.at(t, "velocity_z.speed"), contact[2], 40 * round_off) << "t = " << t;
    if (closing == "standard" && t < 2) round_off *= 40;
  }
  EXPECT_NEAR(run["position_z.height"].back(), known.at("x_end"), 2 * round_off);
  EXPECT_NEAR(run["velocity_z.speed"].back(), known.at("v_end"), round_off);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  const double energy = run["total_energy"].back() - run["external_work"].back();
  EXPECT_NEAR(energy + 9.81 * 15, known.at("E_end"), 1e-10 * 159.65);
}

INSTANTIATE_TEST_SUITE_P(ClosedBy, MassPoint, testing::Values("standard", "modified"));

/// The flat pendulum with its multiplier as a fourth unknown of an ODE (thesis C.26-C.29 with the errata), by the classical
/// Runge-Kutta method with small steps.
std::array<double, 2> index_reduced_pendulum(double end) {
  using Five = std::array<double, 5>;  // x1, x2, v1, v2, lambda
  const auto rate = [](const Five& y) { return Five{y[2], y[3], 2 * y[4] * y[0], 2 * y[4] * y[1] - 1, 1.5 * y[3]}; };
  const int n = 4000;
  const double h = end / n;
  Five y{1, 0, 0, 0, 0};
  const auto moved = [](Five a, const Five& k, double s) {
    for (int i = 0; i < 5; ++i) a[i] += s * k[i];
    return a;
  };
  for (int step = 0; step < n; ++step) {
    const Five a = rate(y), b = rate(moved(y, a, h / 2)), c = rate(moved(y, b, h / 2)), d = rate(moved(y, c, h));
    for (int i = 0; i < 5; ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return {y[0], y[1]};
}

TEST(FlatPendulum, ConvergesToItsIndexReducedEquations) {
  if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only";
  const auto exact = index_reduced_pendulum(2);
  EXPECT_NEAR(std::hypot(exact[0], exact[1]), 1, 1e-12);
  const std::string deck = input_deck("flat_pendulum/energy_momentum.xml");
  double errors[2];
  int k = 0;
  for (const char* step : {"0.01", "0.005"}) {
    const std::string short_deck = without_list(
        with(deck_with_step(deck, "0.01", step), "value=\"7.41629870920549\"/>  <!--", "value=\"2\"/>  <!--"), "expected");
    const MarchedScene run(short_deck);
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    const double x = run["position_x.x"].back(), y = run["position_y.y"].back();
    EXPECT_NEAR(std::hypot(x, y), 1, 1e-10);
    EXPECT_LE(greatest_of(run["contact_work"]), 1e-12);
    EXPECT_LE(greatest_of(run["algorithmic_dissipation"]), 1e-12);
    errors[k++] = std::hypot(x - exact[0], y - exact[1]);
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.02);
}

TEST(FlatPendulum, IsBackAfterAPeriod) {
  if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only";
  const MarchedScene run(input_deck("flat_pendulum/energy_momentum.xml"));
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  EXPECT_NEAR(run["position_x.x"].back(), 1, 1e-6);
}

}  // namespace
}  // namespace mortise::test
