// Spinning bodies of inputs/spinning_bar: the steady state of a bar against its closed form, the flips of a brick.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <iostream>

#include "support/program.hpp"

namespace mortise::test {
namespace {

constexpr double E = 1e6, rho = 1000, L = 1;  // of the bar

/// Stiffness dP/ds of a law without Poisson effect, by its stretch.
using Stiffness = std::function<double(double s)>;

/// Extension of a half bar that spins with w: x'' = -rho w^2 x / P'(x'), x(0) = 0, x'(L) = 1. Runge-Kutta, shooting from the
/// middle with the stretch there by the secant method.
double extension(const Stiffness& stiffness, double w) {
  constexpr int n = 2000;
  constexpr double h = L / n;
  const auto end_of = [&](double stretch_at_middle) {
    std::array<double, 2> y{0, stretch_at_middle};
    const auto slope = [&](const std::array<double, 2>& at) {
      return std::array<double, 2>{at[1], -rho * w * w * at[0] / stiffness(at[1])};
    };
    const auto moved = [&](const std::array<double, 2>& k, double by) {
      return std::array<double, 2>{y[0] + by * k[0], y[1] + by * k[1]};
    };
    for (int i = 0; i < n; ++i) {
      const auto k1 = slope(y), k2 = slope(moved(k1, h / 2)), k3 = slope(moved(k2, h / 2)), k4 = slope(moved(k3, h));
      for (std::size_t c = 0; c < 2; ++c) y[c] += h / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
    }
    return y;
  };
  double a = 1, b = 1.01, off_a = end_of(a)[1] - 1, off_b = end_of(b)[1] - 1;
  for (int i = 0; i < 50 && std::abs(off_b) > 1e-14 && off_a != off_b; ++i) {
    const double next = b - off_b * (b - a) / (off_b - off_a);
    a = b, off_a = off_b, b = next, off_b = end_of(b)[1] - 1;
  }
  return end_of(b)[0] - L;
}

double linear(double) { return E; }
double neo_hookean(double s) { return E / 2 * (1 + 1 / (s * s)); }
double saint_venant_kirchhoff(double s) { return E / 2 * (3 * s * s - 1); }

TEST(SpinningBarClosedForm, OfTheLinearLawIsTheKnownOne) {
  for (double w : {1., 10.}) {
    const double k = w * std::sqrt(rho / E);
    EXPECT_NEAR(extension(linear, w), std::sin(k * L) / (k * std::cos(k * L)) - L, 1e-12);
  }
}

Table finished_run(const std::string& deck) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  return read_history(folder / "out" / "history.csv");
}

struct Bar {
  std::string name;
  double free_from;  ///< [s]
  Stiffness stiffness;
};

class SpinningBar : public testing::TestWithParam<Bar> {};

TEST_P(SpinningBar, KeepsTheExtensionOfItsClosedForm) {
  const Bar& bar = GetParam();
  const Table table = finished_run(input_deck("spinning_bar/" + bar.name + ".xml"));  // energies: its expected values
  const auto time = table["time"], x = table["position_x.tip"], y = table["position_y.tip across"], T = table["kinetic_energy"],
             J = table["angular_momentum_z"];
  double least = INFINITY, most = 0, energy = 0, w = 0;
  int turns_of_20_steps = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] < bar.free_from - 1e-9) continue;
    least = std::min(least, std::hypot(x[k], y[k]));
    most = std::max(most, std::hypot(x[k], y[k]));
    energy = std::max(energy, table["total_energy"][k]);
    w = 2 * T[k] / J[k];
    ++turns_of_20_steps;
  }
  EXPECT_EQ(turns_of_20_steps, 201);  // ten of them
  EXPECT_LE(most / least - 1, 1e-8);
  const double half_section = 0.05, u = std::sqrt(most * most - half_section * half_section) - L,
               exact = extension(bar.stiffness, w);
  EXPECT_NEAR(u, exact, 0.01 * exact);
  EXPECT_LE(greatest_of(table["algorithmic_dissipation"]), 1e-11 * energy);
  EXPECT_LE(greatest_of(table["ledger_mismatch"]), 1e-11 * energy);
  EXPECT_LE(greatest_of(table["angular_momentum_mismatch"]), 1e-11 * greatest_of(J));
  std::cout << bar.name << ": w " << w << ", u(L) " << u << ", closed form " << exact << ", of the linear law "
            << extension(linear, w) << ", radius varies by " << most / least - 1 << '\n';
  if (w < 2) {
    EXPECT_NEAR(u, extension(linear, w), 0.01 * exact);
  }
}

INSTANTIATE_TEST_SUITE_P(Decks, SpinningBar,
                         testing::Values(Bar{"fast", 20, neo_hookean}, Bar{"slow", 200, saint_venant_kirchhoff}),
                         [](const auto& info) { return info.param.name; });

/// When the middle axis of the brick is at right angles to the angular momentum, which does not move.
std::vector<double> flips(const Table& table) {
  const std::array<double, 3> J{table["angular_momentum_x"][0], table["angular_momentum_y"][0], table["angular_momentum_z"][0]};
  const auto time = table["time"], x = table["position_x.pole"], y = table["position_y.pole along"],
             z = table["position_z.pole across"];
  std::vector<double> at;
  double before = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double now = J[0] * x[k] + J[1] * y[k] + J[2] * z[k];
    if (now * before < 0) at.push_back(time[k] - table["dt"][k] * now / (now - before));
    before = now;
  }
  return at;
}

// Euler's equations for I = (2.5, 5, 6.5): twice the time between flips is their period.
TEST(FlippingBrick, HasThePeriodOfEulersEquations) {
  const std::string deck = input_deck("spinning_bar/flipping_brick.xml");
  const Table table = finished_run(deck);
  const auto at = flips(table);
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(at[2] - at[0], 51.1015, 0.01 * 51.1015);
  EXPECT_LE(greatest_of(table["angular_momentum_mismatch"]), 1e-11 * 5);
  std::string calmer = without_list(with(deck, "{0.01, 1, 0.01}", "{0.001, 1, 0.001}"), "expected");
  calmer = with(with(calmer, "value=\"67.5\"", "value=\"56.25\""), "{27.84375, 53.40625}", "{27.84375}");
  const auto later = flips(finished_run(calmer));
  ASSERT_EQ(later.size(), 2U);
  EXPECT_NEAR(2 * (later[1] - later[0]), 70.278, 0.01 * 70.278);
  std::cout << "periods " << at[2] - at[0] << " (51.1015), " << 2 * (later[1] - later[0]) << " (70.2780)\n";
}

}  // namespace
}  // namespace mortise::test
