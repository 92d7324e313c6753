// A march that is kept as a checkpoint after any attempt and goes on in a new process ends where it would have ended.
#include <gtest/gtest.h>

#include <iostream>

#include "output/checkpoint.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

/// The ironing on a coarse mesh, pressed 0.3 deep, then drawn along.
std::string deck() {
  auto text = without_list(input_deck("ironing/frictionless.xml"), "expected");
  text = with(with(text, "{20, 5, 3}", "{9, 3, 2}"), "{4, 4, 4}", "{2, 2, 2}");
  return with(with(text, "-0.7*min(t,1)", "-0.3*min(t,1)"), "name=\"end\"          type=\"double\" value=\"20\"",
              "name=\"end\" type=\"double\" value=\"2\"");
}
constexpr std::size_t n_pressures = 9;  // of the indenter's face

struct Marched {
  Checkpoint end;
  MarchSummary summary;
};

/// Marches in a scene of its own until `most_attempts` have been made (accepted or not), and keeps what is then there.
/// @param from the bytes of a checkpoint, empty: from the start
Marched march_on(const std::string& from, int most_attempts, const RCP<const Comm>& comm,
                 const std::function<void(Scene&)>& change) {
  TestScene s(deck(), comm, change);
  Newton newton(s.problem, s.scene.solver);
  MarchState at = from.empty() ? starting(s.problem.initial_state()) : resume(from_bytes(from), s.problem);
  int asked = 0;
  MarchParty party;
  party.keep = [](const MarchState&) {};
  party.stop = [&] { return asked++ < most_attempts ? ExitCode::done : ExitCode::terminated; };
  party.log = party.progress = [](const std::string&) {};
  const auto summary = march(s.problem, newton, at, party);
  return {make_checkpoint({}, s.problem, at, {}, 0), summary};
}

constexpr int to_the_end = 1000000;

// Few Newton iterations are allowed and steps grow quickly: some attempts are rejected.
void with_cuts(Scene& scene) {
  scene.solver.largest_iterations = 3;
  scene.stages.front().time.growth = 3;
}

void expect_same_end(const Checkpoint& a, const Checkpoint& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.search_x, b.search_x);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.dt, b.dt);
  EXPECT_EQ(a.done.steps, b.done.steps);
  EXPECT_EQ(a.done.cuts, b.done.cuts);
  EXPECT_EQ(a.done.newton_iterations, b.done.newton_iterations);
  EXPECT_EQ(a.done.wasted_iterations, b.done.wasted_iterations);
}

// Every kind of place: before the first step, in mid-contact, right after a rejected attempt, at the end.
TEST(Restart, AfterAnyAttemptEndsAtTheSameNumbersToTheLastBit) {
  const auto whole = march_on("", to_the_end, world(), with_cuts);
  ASSERT_EQ(whole.summary.code, ExitCode::done) << whole.summary.cause;
  ASSERT_GE(whole.end.done.cuts, 1) << "no step was cut: the case is not tested";
  const int n_attempts = whole.end.done.steps + whole.end.done.cuts;
  int n_after_a_cut = 0, n_in_contact = 0;
  for (int k = 0; k <= n_attempts; k += world()->getSize() == 1 ? 1 : 3) {
    const auto part = march_on("", k, world(), with_cuts);
    n_after_a_cut += part.end.pending_cuts > 0;
    n_in_contact += part.end.x.back() > 0;
    expect_same_end(march_on(to_bytes(part.end), to_the_end, world(), with_cuts).end, whole.end);
  }
  EXPECT_GE(n_in_contact, 2);
  if (world()->getRank() == 0) std::cout << whole.end.done.steps << " steps, " << whole.end.done.cuts << " cuts\n";
  EXPECT_GE(n_after_a_cut, world()->getSize() == 1 ? 1 : 0);
}

TEST(Restart, OfARestartAfterEveryAttemptChangesNoBit) {
  for (const auto kind : {LinearSolverKind::direct, LinearSolverKind::iterative}) {
    const auto change = [&](Scene& scene) {
      with_cuts(scene);
      scene.solver.linear = kind;
    };
    const auto whole = march_on("", to_the_end, world(), change);
    Marched at = march_on("", 0, world(), change);
    for (int k = 0; at.summary.code != ExitCode::done; ++k) {
      ASSERT_LT(k, 100);
      at = march_on(to_bytes(at.end), 1, world(), change);
    }
    expect_same_end(at.end, whole.end);
  }
}

// Kept on all ranks, resumed on one; conventions, section 8: 1e-10 with one further Newton iteration.
TEST(Restart, OnAnotherNumberOfRanksAgrees) {
  const auto further = [](Scene& scene) { scene.solver.further_iterations = 1; };
  const auto whole = march_on("", to_the_end, world(), further);
  const std::string kept = to_bytes(march_on("", 4, world(), further).end);
  const auto alone_on = march_on(kept, to_the_end, alone(), further);
  const std::size_t n = whole.end.x.size(), n_positions = n - n_pressures;
  const double positions = relative_difference(alone_on.end.x, whole.end.x, 0, n_positions),
               pressures = relative_difference(alone_on.end.x, whole.end.x, n_positions, n);
  EXPECT_LE(positions, 1e-10);
  EXPECT_LE(pressures, 1e-10);
  EXPECT_EQ(alone_on.end.done.steps, whole.end.done.steps);
  if (world()->getRank() == 0)
    std::cout << world()->getSize() << " ranks, resumed on one: positions " << positions << ", pressures " << pressures << '\n';
}

}  // namespace
}  // namespace mortise::test
