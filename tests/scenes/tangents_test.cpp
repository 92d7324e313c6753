// `mortise tangents` as a user meets it.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace mortise::test {
namespace {

std::string deck(const std::string& name) { return std::string("'") + MORTISE_SOURCE_DIR + "/inputs/" + name + "'"; }

/// The table without the times, which differ from run to run, and the differences of whole steps, which are round-off.
std::vector<std::vector<std::string>> figures(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    const std::size_t name_end = line.rfind('"') == std::string::npos ? 0 : line.rfind('"') + 1;
    std::vector<std::string> cells{line.substr(0, name_end)};
    std::stringstream rest(line.substr(name_end));
    for (std::string cell; std::getline(rest, cell, ',') && cells.size() < 10;) cells.push_back(cell);
    if (cells.size() > 7 && cells[3] == "whole step") {
      EXPECT_LE(std::stod(cells[7]), 1e-8) << line;
      cells[7] = "";
    }
    rows.push_back(cells);
  }
  return rows;
}

TEST(Tangents, OfTheIroningSceneAgreeOnOneTwoAndFourRanks) {
  const ScratchFolder folder;
  for (int ranks : {1, 2, 4}) {
    const std::string file = "t" + std::to_string(ranks) + ".csv";
    const auto done = run_mortise(folder, "tangents " + deck("ironing/frictionless.xml") + " --most 20 -o " + file, ranks);
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NE(done.out.find("body \"slab\" (hex8, standard, neo-hookean): 20 of 300 elements"), std::string::npos) << done.out;
    EXPECT_EQ(count_of(done.out, "all tangents agree"), 1);
    const auto rows = figures(folder / file);
    ASSERT_EQ(rows.size(), 1U + 2 * (7 + 7 + 6) + 1);  // two bodies and one pair at two states, a step
    EXPECT_EQ(rows, figures(folder / "t1.csv"));
  }
}

TEST(Tangents, OfConformingSurfacesAreJudgedAwayFromKinks) {
  const ScratchFolder folder;
  const auto done = run_mortise(folder, "tangents " + deck("patch_test/contact.xml"));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("at 0 of them a kink is too near"), std::string::npos) << done.out;
}

TEST(Tangents, DoNotOverwriteAFileUnasked) {
  const ScratchFolder folder;
  folder.write("t.csv", "mine");
  const auto refused = run_mortise(folder, "tangents --study -o t.csv");
  EXPECT_EQ(refused.code, 5);
  EXPECT_EQ(refused.err, "t.csv: error[I05] exists already - use --overwrite, or another file with -o\n");
  EXPECT_EQ(text_of(folder / "t.csv"), "mine");
  EXPECT_EQ(run_mortise(folder, "tangents --study -o t.csv --overwrite").code, 0);
  EXPECT_EQ(text_of(folder / "t.csv").find("step,forward_differences"), 0U);
}

TEST(Tangents, NeedADeckOrTheStudy) {
  const ScratchFolder folder;
  EXPECT_EQ(run_mortise(folder, "tangents").code, 1);
  EXPECT_EQ(run_mortise(folder, "tangents " + deck("patch_test/contact.xml") + " --study").code, 1);
}

}  // namespace
}  // namespace mortise::test
