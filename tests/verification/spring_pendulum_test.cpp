// The spring pendulum of thesis 6.1 by every scheme, against independent reference values. One element: it runs on one rank.
#include <gtest/gtest.h>

#include <sstream>

#include "support/moving_bars.hpp"
#include "support/references.hpp"
#include "support/spring_pendulum.hpp"

namespace mortise::test {
namespace {

/// A scheme of ours and its name in the references.
struct SchemeCase {
  std::string scheme, parameters, reference;
  int order = 2;
  /// Of the stiff spring at dt = 5e-4, to the digits of the errata page, part C; the greatest is the start where none is given.
  double least = 0, most = 0, end = 0;
};

const std::string four_numbers = number("alpha m", "0.23529411764705882") + number("alpha f", "0.41176470588235292") +
                                 number("beta", "0.33823529411764705") + number("gamma", "0.67647058823529416");
const std::vector<SchemeCase> cases{
    {"forward euler", "", "forward_euler", 1},
    {"backward euler", "", "backward_euler", 1, 0, 0, 48.8340278},
    {"trapezoidal", "", "trapezoidal", 2, 15830.857, 16278.232},
    {"midpoint", "", "midpoint", 2, 16278.0717, 16508.8578},
    {"variational midpoint", "", "variational_midpoint", 2, 16278.0717, 16508.8578},
    {"generalised alpha", number("spectral radius", "0.7"), "gen_alpha", 2, 0, 0, 10974.159},
    {"generalised alpha", four_numbers, "gen_alpha_betamin", 2, 0, 0, 12095.878},
    {"generalised alpha", number("spectral radius", "0.7") + word("forces", "mean"), "gen_alpha_trapF"},
    {"energy momentum", "", "ems"},
};

std::string name_of_case(const testing::TestParamInfo<SchemeCase>& info) { return info.param.reference; }

class SpringPendulumBy : public testing::TestWithParam<SchemeCase> {
 protected:
  void SetUp() override {
    if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only";
    if (!have_reference("spring_summary.json")) GTEST_SKIP() << no_reference("spring_summary.json");
  }

  SpringPendulum pendulum() const {
    SpringPendulum deck;
    deck.scheme = GetParam().scheme;
    deck.parameters = GetParam().parameters;
    return deck;
  }
};

std::array<double, 3> end_position(const MarchedScene& run) {
  return {run["position_x.x"].back(), run["position_y.y"].back(), run["position_z.z"].back()};
}

/// End position and energies of a run against the independent ones.
std::vector<double> expect_reference(const SpringPendulum& deck, const nlohmann::json& known, const std::string& label) {
  const MarchedScene run{deck};
  EXPECT_EQ(run.summary.code, ExitCode::done) << label << run.summary.cause << run.log;
  const auto energy = run["total_energy"];
  const auto [least, most] = std::minmax_element(energy.begin(), energy.end());
  const double E_0 = known.at("E0");
  EXPECT_NEAR(energy.front(), E_0, 1e-12 * E_0) << label;
  EXPECT_NEAR(energy.back(), known.at("E_end").get<double>(), 1e-11 * *most) << label;
  EXPECT_NEAR(*least, known.at("E_min").get<double>(), 1e-11 * *most) << label;
  EXPECT_NEAR(*most, known.at("E_max").get<double>(), 1e-11 * *most) << label;
  const auto q = end_position(run);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(q[i], known.at("q_end").at(i).get<double>(), 1e-10) << label;
  EXPECT_LE(run.relative_mismatch(), 1e-11) << label;
  if (deck.scheme != "generalised alpha") {  // the spring's anchor is in the balance
    EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-11) << label;
  }
  return energy;
}

TEST_P(SpringPendulumBy, EndsWhereTheReferenceDoesWithItsEnergies) {
  const auto known = reference("spring_summary.json");
  for (const auto& [stiffness, step] :
       {std::pair<std::string, std::string>{"1000", "0.0005"}, {"1000", "0.01"}, {"1e+06", "0.0005"}}) {
    const std::string label = "c=" + stiffness + "|dt=" + step + "|" + GetParam().reference;
    const auto& values = known.at("A_m1_L1_p12.5|" + label);
    if (values.at("newton_failures").get<int>() > 0) continue;  // forward Euler has blown up
    SpringPendulum deck = pendulum();
    deck.stiffness = stiffness;
    deck.step = step;
    const auto energy = expect_reference(deck, values, label);
    if (stiffness == "1000") continue;
    const auto [least, most] = std::minmax_element(energy.begin(), energy.end());
    const SchemeCase& known_digits = GetParam();
    if (known_digits.least > 0) {
      EXPECT_NEAR(*least, known_digits.least, known_digits.least > 16000 ? 5e-5 : 5e-4) << label;
    }
    if (known_digits.most > 0) {
      EXPECT_NEAR(*most, known_digits.most, known_digits.least > 16000 ? 5e-5 : 5e-4) << label;
    }
    if (known_digits.end > 0) {
      EXPECT_NEAR(energy.back(), known_digits.end, known_digits.end < 100 ? 5e-8 : 5e-4) << label;
    }
  }
}

TEST_P(SpringPendulumBy, HasItsOrderAndTheErrorsOfTheReference) {
  const auto known = reference("spring_reference.json");
  const auto& exact = known.at("reference").at("c=1000|T=0.1").at("q_DOP853");
  const auto& convergence = known.at("convergence").at(GetParam().reference);
  const auto error = [&](const std::string& step) {
    SpringPendulum deck = pendulum();
    deck.stiffness = "1000";
    deck.step = step;
    deck.end = "0.1";
    const auto q = end_position(MarchedScene{deck});
    double squares = 0, whole = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      squares += std::pow(q[i] - exact.at(i).get<double>(), 2);
      whole += std::pow(exact.at(i).get<double>(), 2);
    }
    return std::sqrt(squares / whole);
  };
  const auto steps = convergence.at("dt").get<std::vector<double>>();
  const auto at = std::find(steps.begin(), steps.end(), 1e-3) - steps.begin();
  const double coarse = error("1e-3");
  EXPECT_NEAR(coarse, convergence.at("err").at(at).get<double>(), 1e-4 * coarse);
  const bool is_first = GetParam().order == 1;
  const double order = is_first ? std::log2(error("2e-4") / error("1e-4")) : std::log2(coarse / error("5e-4"));
  EXPECT_NEAR(order, GetParam().order, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SpringPendulumBy, testing::ValuesIn(cases), name_of_case);

class SpringPendulumAlone : public testing::Test {
 protected:
  void SetUp() override {
    if (world()->getSize() > 1) GTEST_SKIP() << "one element runs on one rank only";
  }
};

/// Trajectories of the references, step by step.
TEST_F(SpringPendulumAlone, FollowsTheTrajectoriesOfTheReferences) {
  for (const SchemeCase& c : cases) {
    const std::string file = "spring_c1000_dt0.01_" + c.reference + ".csv";
    if (c.reference != "backward_euler" && c.reference != "trapezoidal" && c.reference != "midpoint" &&
        c.reference != "gen_alpha" && c.reference != "ems")
      continue;
    if (!have_reference(file)) GTEST_SKIP() << no_reference(file);
    SpringPendulum deck;
    deck.scheme = c.scheme;
    deck.parameters = c.parameters;
    deck.stiffness = "1000";
    deck.step = "0.01";
    const MarchedScene run{deck};
    const auto x = run["position_x.x"], y = run["position_y.y"], z = run["position_z.z"], E = run["total_energy"];
    std::ifstream in(reference_path(file));
    std::string line;
    std::getline(in, line);
    std::size_t k = 0;
    for (; std::getline(in, line); ++k) {
      std::vector<double> row;
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
      ASSERT_LT(k, x.size());
      EXPECT_NEAR(x[k], row[1], 1e-11) << file << k;
      EXPECT_NEAR(y[k], row[2], 1e-11) << file << k;
      EXPECT_NEAR(z[k], row[3], 1e-11) << file << k;
      EXPECT_NEAR(E[k], row[9], 1e-9) << file << k;
    }
    EXPECT_EQ(k, x.size());
  }
}

/// The digits of the errata page, part C.
TEST_F(SpringPendulumAlone, KeepsItsEnergyAtBothStepsByEnergyMomentum) {
  for (const char* step : {"5e-4", "1e-2"}) {
    SpringPendulum deck;
    deck.step = step;
    const MarchedScene run{deck};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
    for (double E : run["total_energy"]) EXPECT_NEAR(E, 16278.125, 1e-8);
    for (double L : run["angular_momentum_x"]) EXPECT_NEAR(L, 10 / std::sqrt(2), 1e-9);
  }
}

/// At dt = 0.01 of the stiff spring the equations have several roots: blow-up or not is what can be compared.
TEST_F(SpringPendulumAlone, BlowsUpByMidpointAtGreatSteps) {
  SpringPendulum deck;
  deck.scheme = "midpoint";
  deck.step = "1e-2";
  const MarchedScene run{deck};
  const auto E = run["total_energy"];
  EXPECT_TRUE(run.summary.code != ExitCode::done || *std::max_element(E.begin(), E.end()) > 2 * 16278.125);
}

/// The stiff pendulum at dt = 0.2, about 3 periods of the spring, for 2000 steps. Newton, which starts from the old state, does
/// not find every step: those are cut.
SpringPendulum hard_case(const std::string& scheme) {
  SpringPendulum deck;
  deck.scheme = scheme;
  deck.stiffness = "1e4";
  deck.at = "{1.01, 0, 0}";
  deck.velocity = "{0, 1, 0}";
  deck.step = "0.2";
  deck.smallest_step = "1e-3";
  deck.end = "400";
  return deck;
}

TEST_F(SpringPendulumAlone, KeepsItsEnergyFor2000GreatStepsByEnergyMomentum) {
  const MarchedScene run{hard_case("energy momentum")};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto E = run["total_energy"];
  EXPECT_GE(E.size(), 2000U);
  for (double now : E) EXPECT_NEAR(now, E.front(), 1e-10 * E.front());
  const auto dissipated = run["algorithmic_dissipation"];
  EXPECT_LE(std::abs(dissipated.back()), 1e-11 * E.front());
}

TEST_F(SpringPendulumAlone, LosesItsEnergyForGreatStepsByMidpointAndTrapezoid) {
  for (const char* scheme : {"midpoint", "trapezoidal"}) {
    SpringPendulum deck = hard_case(scheme);
    deck.smallest_step = deck.step;
    const MarchedScene run{deck};
    const auto E = run["total_energy"];
    EXPECT_TRUE(run.summary.code != ExitCode::done || *std::max_element(E.begin(), E.end()) > 2 * E.front()) << scheme;
  }
}

/// Any law, any tolerance of Newton: the ledger closes, and what energy momentum keeps is not the residual's.
TEST_F(SpringPendulumAlone, ClosesTheLedgerForEveryLawAndTolerance) {
  for (const char* law : {"saint venant", "neo-hookean", "logarithmic"})
    for (const char* tolerance : {"1e-1", "1e-4", "1e-10"}) {
      SpringPendulum deck;
      deck.law = law;
      deck.tolerance = tolerance;
      deck.stiffness = "1000";
      deck.step = "5e-3";
      const MarchedScene run{deck};
      ASSERT_EQ(run.summary.code, ExitCode::done) << law << tolerance << run.summary.cause;
      EXPECT_LE(run.relative_mismatch(), 1e-12) << law << tolerance;
      EXPECT_LE(std::abs(run["algorithmic_dissipation"].back()), 1e-12 * run["total_energy"].front()) << law << tolerance;
    }
}

}  // namespace
}  // namespace mortise::test
