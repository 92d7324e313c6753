// Steps in dynamics: where Newton starts, lengths by error and by touch, and output that changes nothing.
#include <gtest/gtest.h>

#include "support/moving_bars.hpp"

namespace mortise::test {
namespace {

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return sum;
}

TEST(FirstGuess, ChangesTheIterationsAndNotTheSolution) {
  std::vector<double> iterations, reference;
  for (const char* guess : {"old state", "motion", "linear"}) {
    FreeBar bar;
    bar.scheme = "energy momentum";
    bar.step = "0.005";
    bar.parameters = word("first guess", guess);
    const MarchedScene run{bar};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    iterations.push_back(sum_of(run["newton_iterations"]));
    if (reference.empty()) reference = run.unknowns();
    EXPECT_LE(relative_difference(run.unknowns(), reference, 0, reference.size()), 1e-10);
  }
  EXPECT_LT(iterations[2], iterations[0]);
  EXPECT_LE(iterations[1], iterations[0]);
  if (world()->getRank() == 0 && world()->getSize() == 1)
    std::cout << "Newton iterations in 80 steps: old state " << iterations[0] << ", motion " << iterations[1] << ", linear "
              << iterations[2] << "\n";
}

// Ten times the tolerance gives about 10^(1/3) times the step, and ten times... the error: of global order 2/3 in the tolerance.
TEST(ErrorControl, KeepsTheErrorNearTheToleranceAndTakesFewerSteps) {
  const auto run_with = [](const std::string& parameters, const std::string& step) {
    FreeBar bar;
    bar.parameters = parameters;
    bar.step = step;
    bar.end = "0.2";
    return MarchedScene{bar};
  };
  const auto exact = run_with("", "2e-4").unknowns();
  double errors[2];
  std::size_t steps[2];
  int k = 0;
  for (const char* tolerance : {"1e-4", "1e-6"}) {
    const auto run = run_with(number("error tolerance", tolerance) + number("largest step", "0.1"), "1e-3");
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
    errors[k] = relative_difference(run.unknowns(), exact, 0, exact.size());
    steps[k++] = run["time"].size();
  }
  EXPECT_LT(errors[1], errors[0] / 5);
  EXPECT_GT(steps[1], 2 * steps[0]);
  EXPECT_LT(errors[1], 1e-3);
}

// Velocities, accelerations, the ledger and what sizes the next step are all in the checkpoint.
TEST(DynamicRestart, GoesOnBitForBit) {
  if (world()->getSize() > 1) GTEST_SKIP() << "bit for bit on one rank only";
  std::vector<std::string> decks;
  FreeBar bar;
  bar.scheme = "generalised alpha";
  bar.parameters = number("error tolerance", "1e-4") + number("largest step", "0.1");
  decks.push_back(bar);
  FlyingBar flying;
  flying.end = "0.8";
  for (const char* closing : {"modified", "persistent"}) {
    flying.closing = closing;
    decks.push_back(flying);
  }
  for (const std::string& deck : decks) {
    const MarchedScene whole(deck);
    ASSERT_EQ(whole.summary.code, ExitCode::done) << whole.log;
    const int n = static_cast<int>(whole["time"].size());
    ASSERT_GT(n, 8);
    const MarchedScene begun(deck, world(), 3 * n / 4), resumed(deck, world(), to_the_end, &begun);
    EXPECT_EQ(resumed.summary.code, ExitCode::done) << resumed.log;
    EXPECT_EQ(resumed.unknowns(), whole.unknowns());
    for (const char* column : {"dt", "total_energy", "algorithmic_dissipation", "contact_work", "angular_momentum_mismatch"})
      EXPECT_EQ(resumed[column], whole[column]) << column;
  }
}

TEST(TouchStep, ShortensTheStepInWhichABarTouches) {
  FlyingBar bar;
  bar.closing = "position";
  bar.end = "0.6";
  bar.step = "0.02\"/><Parameter name=\"touch step\" type=\"double\" value=\"0.001";
  const MarchedScene run(bar);
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  const auto active = run["active"], dt = run["dt"];
  const std::size_t first = std::find_if(active.begin(), active.end(), [](double n) { return n > 0; }) - active.begin();
  ASSERT_LT(first, active.size());
  EXPECT_NEAR(dt[first], 0.001, 1e-9);
  EXPECT_NE(run.log.find("nodes touch where none did"), std::string::npos);
  EXPECT_EQ(run["cuts"][first], 1);
}

}  // namespace
}  // namespace mortise::test
