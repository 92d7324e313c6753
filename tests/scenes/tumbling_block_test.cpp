// The tumbling block of inputs/tumbling_block: what energy momentum keeps at great steps, where other schemes blow up.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mortise::test {
namespace {

/// A deck of the scene, and how long it is run where time is no matter.
struct Block {
  std::string name;
  std::string step;
  int long_steps;
};

const Block neo_hookean{"neo_hookean", "0.75", 10000};

std::string deck_of(const Block& block) { return input_deck("tumbling_block/" + block.name + ".xml"); }

/// The deck without expected values, run for other numbers of steps.
std::string deck_of(const Block& block, int steps) {
  const std::string end = "name=\"end\"           type=\"double\" value=\"";
  const std::string text = without_list(deck_of(block), "expected");
  const std::string was = text.substr(text.find(end), text.find("\"/>", text.find(end)) - text.find(end));
  return with(text, was, end + std::to_string(steps * std::stod(block.step)));
}

/// What a run of the block shows once the loads have ended.
struct Free {
  int code, steps = 0;
  double newton = 0;                               ///< greatest number of iterations in a step
  double energy = 0;                               ///< E0, when it is left to itself [J]
  double greatest_energy = 0;                      ///< later [E0]
  double algorithmic = 0, ledger = 0;              ///< greatest magnitudes at any time [E0]
  double linear_balance = 0, angular_balance = 0;  ///< greatest mismatch [greatest momentum]
};

double greatest_length(const Table& table, const std::string& vector) {
  const auto x = table[vector + "_x"], y = table[vector + "_y"], z = table[vector + "_z"];
  double most = 0;
  for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::hypot(x[k], y[k], z[k]));
  return most;
}

/// @param end_of_loads [s]
Free run_free(const std::string& deck, double end_of_loads, int ranks = 1) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  Free found{run_mortise(folder, "run deck.xml -o out --quiet", ranks).code};
  const Table table = read_history(folder / "out" / "history.csv");
  found.steps = static_cast<int>(table.n_rows()) - 1;
  const auto time = table["time"], energy = table["total_energy"];
  std::size_t k = 0;
  while (k + 1 < time.size() && time[k] < end_of_loads - 1e-9) ++k;
  found.energy = energy[k];
  for (; k < time.size(); ++k) found.greatest_energy = std::max(found.greatest_energy, energy[k] / found.energy);
  found.newton = greatest_of(table["newton_iterations"]);
  found.algorithmic = greatest_of(table["algorithmic_dissipation"]) / found.energy;
  found.ledger = greatest_of(table["ledger_mismatch"]) / found.energy;
  found.linear_balance = greatest_of(table["linear_momentum_mismatch"]) / greatest_length(table, "linear_momentum");
  found.angular_balance = greatest_of(table["angular_momentum_mismatch"]) / greatest_length(table, "angular_momentum");
  std::cout << found.steps << " steps, code " << found.code << ": Newton <= " << found.newton << ", E0 " << found.energy
            << ", later up to " << found.greatest_energy << " E0, algorithmic dissipation " << found.algorithmic << " E0, ledger "
            << found.ledger << " E0, balance of momenta " << found.linear_balance << ", " << found.angular_balance << '\n';
  return found;
}

double end_of_loads(const Block& block) { return block.step == "0.75" ? 7.5 : 75; }

class TumblingBlock : public testing::TestWithParam<Block> {};

TEST_P(TumblingBlock, KeepsItsEnergyAndItsMomentaForEver) {
  const Block& block = GetParam();
  const bool is_long = std::getenv("MORTISE_LONG") != nullptr;
  const Free found = run_free(is_long ? deck_of(block, block.long_steps) : deck_of(block), end_of_loads(block));
  EXPECT_EQ(found.code, 0);  // short: the expected values of the deck are met
  EXPECT_EQ(found.steps, is_long ? block.long_steps : 100);
  EXPECT_LE(found.newton, 6);
  EXPECT_LE(found.algorithmic, 1e-11);
  EXPECT_LE(found.ledger, 1e-11);
  EXPECT_LE(found.linear_balance, 1e-11);
  EXPECT_LE(found.angular_balance, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Decks, TumblingBlock,
                         testing::Values(neo_hookean, Block{"saint_venant_kirchhoff", "0.75", 1000},
                                         Block{"mooney_rivlin", "0.75", 1000}, Block{"ogden", "0.75", 1000},
                                         Block{"large_steps", "3.75", 10000}),
                         [](const auto& info) { return info.param.name; });

// What the same toss does to schemes that keep no energy: they win it until Newton's method finds no further step.
TEST(TumblingBlockOtherSchemes, WinTwiceTheirEnergyAndStop) {
  for (const Block& block : {neo_hookean, Block{"large_steps", "3.75", 0}})
    for (const std::string scheme : {"midpoint", "trapezoidal"}) {
      SCOPED_TRACE(block.name + ", " + scheme);
      const Free found = run_free(with(deck_of(block, 200), "energy momentum", scheme), end_of_loads(block));
      EXPECT_EQ(found.code, 4);
      EXPECT_GE(found.greatest_energy, 2);
      EXPECT_LE(found.ledger, 1e-11);  // and all of it is booked
      EXPECT_LE(found.linear_balance, 1e-11);
      if (scheme == "midpoint") {
        EXPECT_LE(found.angular_balance, 1e-11);
      } else {
        EXPECT_GE(found.angular_balance, 1e-2);
      }
    }
}

// However roughly a step is solved, what Newton leaves is booked as its own work, and the scheme adds nothing.
TEST(TumblingBlockLedger, ClosesAtAnyNewtonTolerance) {
  for (const std::string tolerance : {"1e-1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10"}) {
    SCOPED_TRACE(tolerance);
    const std::string solver = list("solver", number("tolerance", tolerance));
    const Free found = run_free(with_lists(deck_of(neo_hookean, 40), solver), 7.5);
    EXPECT_EQ(found.code, 0);
    EXPECT_EQ(found.steps, 40);
    EXPECT_LE(found.algorithmic, 1e-11);
    EXPECT_LE(found.ledger, 1e-11);
    EXPECT_LE(found.linear_balance, 1e-11);
    EXPECT_LE(found.angular_balance, 1e-11);
  }
}

/// Evaluations of a run, from its summary.
struct Evaluations {
  int steps, iterations, residuals, tangents, element_tangents;
};

/// The block held at its foot and pulled a little, while the loads act.
Evaluations evaluations_of(const std::string& scheme) {
  std::string deck = without_list(deck_of(neo_hookean, 10), "initial conditions");
  deck = with(with(deck, "-6*", "-0.6*"), "\"6*", "\"0.6*");
  const std::string foot = word("set", "block/bottom") + word("x", "0") + word("y", "0") + word("z", "0");
  const ScratchFolder folder;
  folder.write("deck.xml", with_lists(with(deck, "energy momentum", scheme), list("supports", list("foot", foot))));
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  const auto summary = nlohmann::json::parse(text_of(folder / "out" / "summary.json"));
  const auto& counts = summary["counts"];
  return {summary["steps"], summary["newton_iterations"], counts["residuals"], counts["tangents"], counts["element_tangents"]};
}

// What a step costs besides the mass: the same number of evaluations per Newton iteration, and per step.
TEST(TumblingBlockCost, HasAsManyEvaluationsOfElementsAsAStaticStep) {
  const Evaluations at_rest = evaluations_of("static");
  for (const std::string scheme : {"midpoint", "energy momentum", "energy momentum midpoint contact"}) {
    SCOPED_TRACE(scheme);
    const Evaluations moving = evaluations_of(scheme);
    ASSERT_EQ(moving.steps, at_rest.steps);
    EXPECT_EQ(moving.residuals - 2 * moving.iterations, at_rest.residuals - 2 * at_rest.iterations);
    EXPECT_EQ(moving.tangents, moving.iterations);
    EXPECT_EQ(moving.element_tangents, 32 * moving.tangents);
  }
  EXPECT_EQ(at_rest.tangents, at_rest.iterations);
}

TEST(TumblingBlockOnRanks, KeepsTheSame) {
  for (int ranks : {2, 4}) {
    const Free found = run_free(deck_of(neo_hookean, 30), 7.5, ranks);
    EXPECT_EQ(found.code, 0);
    EXPECT_LE(found.algorithmic, 1e-11);
    EXPECT_LE(found.angular_balance, 1e-11);
  }
}

}  // namespace
}  // namespace mortise::test
