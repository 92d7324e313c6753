// The work that cheap scenes take is that of tests/benchmarks/baseline.json: counts only, seconds never.
#include <gtest/gtest.h>

#include "support/baseline.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

using Lines = std::vector<std::string>;

/// Counts of a made-up run, every name with a value of its own.
Json some_counts() {
  Json counts;
  for (const auto* names : {&exact_counts, &near_counts})
    for (const auto& name : *names) counts[name] = 100 + 10 * counts.size();
  return counts;
}

class Baseline : public testing::TestWithParam<const char*> {};

TEST_P(Baseline, IsMetByTheCountsOfTheScene) {
  const std::string scene = GetParam();
  const auto file = std::string(MORTISE_SOURCE_DIR) + "/tests/benchmarks/baseline.json";
  const Json baseline = Json::parse(text_of(file));
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/" + scene + ".xml' --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json expected = baseline.at("scenes").at(scene).at("counts"),
             found = counts_of(Json::parse(text_of(folder / "out" / "summary.json")));
  EXPECT_EQ(differences(expected, found), Lines{}) << "if that is meant to be: tools/bench --save";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Baseline, testing::Values("ironing/frictionless", "patch_test/contact"));

TEST(BaselineComparison, AcceptsEqualCounts) { EXPECT_EQ(differences(some_counts(), some_counts()), Lines{}); }

TEST(BaselineComparison, FailsOnEveryWrongCountAndNamesIt) {
  for (const auto& name : exact_counts)
    for (int off : {-1, 1}) {
      Json found = some_counts();
      found[name] = found[name].get<int>() + off;
      const Lines lines = differences(some_counts(), found);
      ASSERT_EQ(lines.size(), 1u) << name << ' ' << off;
      EXPECT_EQ(lines[0], name + ": " + found[name].dump() + ", in the baseline " + some_counts()[name].dump());
    }
  for (const auto& name : near_counts)
    for (double share : {0.97, 0.985, 1.015, 1.03}) {
      Json found = some_counts();
      found[name] = share * found[name].get<double>();
      EXPECT_EQ(differences(some_counts(), found).size(), std::abs(share - 1) > near_share ? 1u : 0u) << name << ' ' << share;
    }
}

TEST(BaselineComparison, FailsOnAMissingCountOnEitherSide) {
  for (const auto* names : {&exact_counts, &near_counts})
    for (const auto& name : *names) {
      Json less = some_counts();
      less.erase(name);
      EXPECT_EQ(differences(less, some_counts()), Lines{name + ": not in the baseline"});
      EXPECT_EQ(differences(some_counts(), less), Lines{name + ": not in the run"});
      less[name] = nullptr;
      EXPECT_EQ(differences(less, some_counts()), Lines{name + ": not in the baseline"});
    }
}

TEST(BaselineComparison, FailsOnAnEmptyBaseline) {
  for (const Json& empty : {Json::object(), Json::array(), Json()})
    EXPECT_EQ(differences(empty, some_counts()).size(), exact_counts.size() + near_counts.size());
}

}  // namespace
}  // namespace mortise::test
