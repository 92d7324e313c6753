// The ironing as a user runs it: on 1, 2 and 4 ranks, from recipes and from Exodus meshes, other materials and depths.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string force = "contact_force_z.indenter on slab";

nlohmann::json summary_of(const std::filesystem::path& folder) { return nlohmann::json::parse(text_of(folder / "summary.json")); }

double greatest_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (b[k] != 0) most = std::max(most, std::abs(a[k] / b[k]));
  return most;
}

// What holds for every ironing: steps, ledger, closure. Forces across the pressing one are returned: x and y, the greatest of all
// steps.
std::array<double, 2> expect_sound(const Table& table, const nlohmann::json& summary) {
  EXPECT_EQ(summary["exit_code"], 0);
  EXPECT_EQ(summary["end_time"], 20);
  EXPECT_LE(summary["steps"], 48);
  const double ledger = greatest_of(table["ledger_mismatch"]) / greatest_of(table["total_energy"]),
               closure = greatest_of(table["closure_error.indenter on slab"]);
  EXPECT_LE(ledger, 1e-11);
  EXPECT_LE(closure, 2e-12 * (1 + 9 / (100 * 0.25)));  // |x| is at most 9, facets are 1/4 wide
  const auto z = table[force];
  const std::array<double, 2> across{greatest_ratio(table["contact_force_x.indenter on slab"], z),
                                     greatest_ratio(table["contact_force_y.indenter on slab"], z)};
  const double mean = mean_from(table, force, 5),
               mean_x = std::abs(mean_from(table, "contact_force_x.indenter on slab", 5) / mean);
  EXPECT_LE(mean_x, 5e-3);
  EXPECT_LE(across[1], 5e-3);
  std::cout << summary["steps"] << " steps, " << summary["cuts"] << " cuts, " << summary["newton_iterations"]
            << " Newton iterations, mean force " << mean << ", |Fx/Fz| <= " << across[0] << " (mean " << mean_x
            << "), |Fy/Fz| <= " << across[1] << ", ledger " << ledger << ", closure " << closure << '\n';
  return across;
}

std::string deck(const std::string& name) { return "'" + std::string(MORTISE_SOURCE_DIR) + "/inputs/ironing/" + name + ".xml'"; }

TEST(Ironing, MeetsItsExpectedForcesAndIsTheSameOnOneTwoAndFourRanks) {
  const ScratchFolder folder;
  std::vector<double> first;
  for (int ranks : {1, 2, 4}) {
    const std::string name = std::to_string(ranks);
    const auto run = run_mortise(folder, "run " + deck("frictionless") + " --quiet -o " + name, ranks);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(count_of(run.out, ": met"), 2);
    const auto table = read_history(folder / name / "history.csv");
    EXPECT_LE(expect_sound(table, summary_of(folder / name))[0], 5e-3);
    const auto forces = table[force];
    if (first.empty()) first = forces;
    ASSERT_EQ(forces.size(), first.size());
    double difference = 0;
    for (std::size_t k = 0; k < forces.size(); ++k)
      difference = std::max(difference, std::abs(forces[k] - first[k]) / greatest_of(first));
    EXPECT_LE(difference, 1e-8) << ranks << " ranks";
    std::cout << ranks << " ranks: forces differ by " << difference << '\n';
  }
}

TEST(Ironing, OnExodusMeshesIsTheSame) {
  const ScratchFolder folder;
  for (const std::string mesh : {"slab", "indenter"}) {
    const auto made = run_mortise(folder, "mesh " + deck(mesh + "_recipe") + " -o " + mesh + ".e");
    ASSERT_EQ(made.code, 0) << made.err;
  }
  const std::string shorter_from = "name=\"end\"          type=\"double\" value=\"20\"",
                    shorter_to = "name=\"end\" type=\"double\" value=\"3\"";
  std::vector<std::vector<double>> forces;
  for (const std::string name : {"frictionless_exodus", "frictionless"}) {
    folder.write(name + ".xml", with(without_list(input_deck("ironing/" + name + ".xml"), "expected"), shorter_from, shorter_to));
    const auto run = run_mortise(folder, "run " + name + ".xml --quiet", 2);
    ASSERT_EQ(run.code, 0) << run.err;
    forces.push_back(read_history(folder / name / "history.csv")[force]);
  }
  ASSERT_EQ(forces[0].size(), forces[1].size());
  for (std::size_t k = 0; k < forces[0].size(); ++k) EXPECT_NEAR(forces[0][k], forces[1][k], 1e-8);
}

TEST(Ironing, WithTheSplitEnergyMeetsTheForcesOfOtherCodes) {
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run " + deck("frictionless_split") + " --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  expect_sound(read_history(folder / "out" / "history.csv"), summary_of(folder / "out"));
}

TEST(Ironing, DeeperFinishes) {
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run " + deck("deeper") + " --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  expect_sound(read_history(folder / "out" / "history.csv"), summary_of(folder / "out"));
}

class FrictionalIroning : public testing::TestWithParam<const char*> {};

TEST_P(FrictionalIroning, MeetsItsExpectedForcesAndSlidesAtTheBound) {
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run " + deck(GetParam()) + " --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const auto table = read_history(folder / "out" / "history.csv");
  const auto summary = summary_of(folder / "out");
  EXPECT_LE(summary["cuts"], 2);
  const auto time = table["time"], x = table["contact_force_x.indenter on slab"], z = table[force],
             lost = table["friction_dissipation"];
  double least = 1, most = 0;
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k] < 5) continue;
    least = std::min(least, std::abs(x[k] / z[k]));
    most = std::max(most, std::abs(x[k] / z[k]));
    EXPECT_GE(lost[k] - lost[k - 1], 0) << time[k];
    EXPECT_GT(table["slip"][k], 0);
  }
  EXPECT_GE(least, 0.485);
  EXPECT_LE(most, 0.503);
  const double ledger = greatest_of(table["ledger_mismatch"]) / greatest_of(table["total_energy"]);
  EXPECT_LE(ledger, 1e-11);
  std::cout << summary["steps"] << " steps, " << summary["newton_iterations"] << " Newton iterations, mean force "
            << mean_from(table, force, 5) << ", |Fx/Fz| from " << least << " to " << most << ", ledger " << ledger << '\n';
}

INSTANTIATE_TEST_SUITE_P(Decks, FrictionalIroning, testing::Values("frictional", "frictional_split", "frictional_penalty"));

}  // namespace
}  // namespace mortise::test
