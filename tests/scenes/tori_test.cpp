// The two tori of inputs/tori: an impact with facets that come and go at every angle, without a cut, and both momenta kept.
#include <gtest/gtest.h>

#include <cstdlib>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mortise::test {
namespace {

/// Runs a deck up to a time, its end or before.
void expect_no_cut(const std::string& name, const std::string& end) {
  std::string deck = input_deck("tori/" + name + ".xml");
  for (int k = count_of(deck, "value=\"2.6\""); k > 0; --k) deck = with(deck, "value=\"2.6\"", "value=\"" + end + "\" ");
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(count_of(run.out, ": met"), 2) << run.out;
  const auto summary = nlohmann::json::parse(text_of(folder / "out" / "summary.json"));
  EXPECT_EQ(summary["cuts"], 0);
  const Table table = read_history(folder / "out" / "history.csv");
  EXPECT_GE(greatest_of(table["active"]), 20);
  const double energy = table["total_energy"].front();
  EXPECT_LE(greatest_of(table["algorithmic_dissipation"]), 1e-11 * energy);
  EXPECT_LE(greatest_of(table["ledger_mismatch"]), 1e-11 * energy);
  const auto lost = table["friction_dissipation"];
  for (std::size_t k = 1; k < lost.size(); ++k) EXPECT_GE(lost[k] - lost[k - 1], -1e-12 * energy);
  std::cout << name << " to t = " << end << ": " << summary["steps"] << " steps, " << summary["newton_iterations"]
            << " Newton iterations\n";
}

TEST(Tori, MeetWithoutACut) { expect_no_cut("mortar_frictionless", "0.8"); }

TEST(Tori, MeetAndPart) {
  if (std::getenv("MORTISE_LONG") == nullptr) GTEST_SKIP() << "takes some minutes: set MORTISE_LONG";
  expect_no_cut("mortar_frictionless", "2.6");
}

TEST(Tori, RubWithoutACut) {
  if (std::getenv("MORTISE_LONG") == nullptr) GTEST_SKIP() << "takes some minutes: set MORTISE_LONG";
  expect_no_cut("mortar_frictional", "1.4");
}

}  // namespace
}  // namespace mortise::test
