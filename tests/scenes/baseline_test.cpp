// The work that cheap scenes take is that of tests/benchmarks/baseline.json: counts only, seconds never.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/baseline.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

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
  EXPECT_THAT(differences(expected, found), IsEmpty()) << "if that is meant to be: tools/bench --save";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Baseline, testing::Values("ironing/frictionless", "patch_test/contact"));

TEST(BaselineComparison, AcceptsEqualCounts) { EXPECT_THAT(differences(some_counts(), some_counts()), IsEmpty()); }

TEST(BaselineComparison, FailsOnEveryWrongCountAndNamesIt) {
  for (const auto& name : exact_counts)
    for (int off : {-1, 1}) {
      Json found = some_counts();
      found[name] = found[name].get<int>() + off;
      EXPECT_THAT(differences(some_counts(), found), ElementsAre(testing::StartsWith(name + ": ")));
    }
  for (const auto& name : near_counts)
    for (double share : {0.97, 0.985, 1.015, 1.03}) {
      Json found = some_counts();
      found[name] = share * found[name].get<double>();
      EXPECT_THAT(differences(some_counts(), found), SizeIs(std::abs(share - 1) > near_share ? 1 : 0)) << name << ' ' << share;
    }
}

TEST(BaselineComparison, FailsOnAMissingCountOnEitherSide) {
  for (const auto* names : {&exact_counts, &near_counts})
    for (const auto& name : *names) {
      Json less = some_counts();
      less.erase(name);
      EXPECT_THAT(differences(less, some_counts()), ElementsAre(name + ": not in the baseline"));
      EXPECT_THAT(differences(some_counts(), less), ElementsAre(name + ": not in the run"));
      less[name] = nullptr;
      EXPECT_THAT(differences(less, some_counts()), ElementsAre(name + ": not in the baseline"));
    }
}

TEST(BaselineComparison, FailsOnAnEmptyBaseline) {
  for (const Json& empty : {Json::object(), Json::array(), Json()})
    EXPECT_THAT(differences(empty, some_counts()), SizeIs(exact_counts.size() + near_counts.size()));
}

}  // namespace
}  // namespace mortise::test
