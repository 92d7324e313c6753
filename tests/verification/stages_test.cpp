// Stages: statics before dynamics and after it, terms that some stages are without, and what passes on between them.
#include <gtest/gtest.h>

#include "support/moving_bars.hpp"

namespace mortise::test {
namespace {

std::string stage(const std::string& name, const std::string& scheme, double step, double end, const std::string& more = "") {
  return list(name,
              word("scheme", scheme) + number("step", fmt::format("{}", step)) + number("end", fmt::format("{}", end)) + more);
}
std::string without(const std::string& entries) { return deck_parameter("without", "Array(string)", "{" + entries + "}"); }

/// A bar of 20 elements along x, held at its left end, pulled at its right one; waves run at 30 along it in 1/3.
struct PulledBar {
  std::string model = "linear elastic", kind = "traction", force = "9";
  std::string lists, stages;

  operator std::string() const {
    const std::string mesh = word("recipe", "block") + deck_parameter("size", "Array(double)", "{10, 0.5, 0.5}") +
                             deck_parameter("elements", "Array(int)", "{20, 1, 1}");
    const std::string wall = list("wall", word("set", "bar/left") + word("x", "0") + word("y", "0") + word("z", "0"));
    return list("bar",
                list("meshes", list("bar", mesh)) +
                    list("materials", list("elastic", word("model", model) + number("youngs modulus", "900") +
                                                          number("poissons ratio", "0") + number("density", "1"))) +
                    list("bodies", list("bar", word("mesh", "bar") + word("material", "elastic"))) +
                    list("supports", wall + straight_sides()) +
                    list("loads", list("pull", word("type", kind) + (kind == "body force" ? "" : word("set", "bar/right")) +
                                                   word("x", force))) +
                    list("probes", list("tip", word("quantity", "displacement_x") + word("mesh", "bar") +
                                                   deck_parameter("nearest", "Array(double)", "{10, 0, 0}"))) +
                    lists + stages);
  }
};

PulledBar released(const std::string& scheme) {
  PulledBar bar;
  bar.stages = list("stages", stage("pull", "static", 1, 1) + stage("swing", scheme, 0.01, 1 + 4.0 / 3, without("loads/pull")));
  return bar;
}

class ReleasedBar : public testing::TestWithParam<const char*> {};

// Released from u = 9 X / 900 it swings with period 4 L / c = 4/3: at half of it the tip is at -0.1, then at 0.1 again.
TEST_P(ReleasedBar, SwingsAsTheWaveEquationSays) {
  const MarchedScene run{released(GetParam())};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_NEAR(run.at(1, "displacement_x.tip"), 0.1, 1e-12);
  EXPECT_NEAR(run.at(1, "kinetic_energy"), 0, 0);
  const double stored = run.at(1, "strain_energy");
  EXPECT_NEAR(stored, 0.5 * 900 * 0.01 * 0.01 * 2.5, 1e-12);
  EXPECT_NEAR(run.at(1, "external_work"), 2 * stored, 1e-10);  // pulled at once: half of it is dissipated
  const auto time = run["time"], tip = run["displacement_x.tip"];
  double lowest = 0;
  for (double u : tip) lowest = std::min(lowest, u);
  EXPECT_NEAR(lowest, -0.1, 0.004);
  EXPECT_NEAR(tip.back(), 0.1, 0.006);
  EXPECT_EQ(run["external_work"].back(), run.at(1, "external_work"));  // nothing pulls any more
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  if (std::string(GetParam()) != "generalised alpha") {  // dissipates
    EXPECT_NEAR(run["total_energy"].back(), stored, 1e-11 * stored);
  }
  EXPECT_GT(greatest_of(run["kinetic_energy"]), 0.9 * stored);
}

INSTANTIATE_TEST_SUITE_P(Stages, ReleasedBar, testing::Values("energy momentum", "midpoint", "trapezoidal", "generalised alpha"));

// What is in equilibrium stays there, whatever the scheme: its forces at the start are those of the static state.
TEST(Stages, KeepAnEquilibrium) {
  const std::string mean = word("forces", "mean");
  for (const auto& [scheme, more] : std::vector<std::pair<std::string, std::string>>{{"backward euler", ""},
                                                                                     {"midpoint", ""},
                                                                                     {"trapezoidal", ""},
                                                                                     {"newmark", ""},
                                                                                     {"generalised alpha", ""},
                                                                                     {"generalised alpha", mean},
                                                                                     {"energy momentum", ""}})
    for (const char* kind : {"traction", "cauchy traction", "body force"}) {
      PulledBar bar;
      bar.model = "neo-hookean";
      bar.kind = kind;
      bar.force = "90";
      bar.stages = list("stages", stage("pull", "static", 0.5, 1) + stage("wait", scheme, 0.05, 2, more));
      const MarchedScene run{bar};
      ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
      const std::string which = scheme + more + kind;
      EXPECT_GT(run.at(1, "displacement_x.tip"), 0.5) << which;
      EXPECT_LE(greatest_of(run["kinetic_energy"]), 1e-17) << which;
      EXPECT_NEAR(run["displacement_x.tip"].back(), run.at(1, "displacement_x.tip"), 1e-9) << which;
      EXPECT_LE(run.relative_mismatch(), 1e-13) << which;
    }
}

// A block that has been pressed onto a slab stays when time begins: contact passes on, the average acceleration excepted, which
// multipliers make unstable.
TEST(Stages, KeepContact) {
  auto deck = without_list(without_list(input_deck("ironing/frictionless.xml"), "expected"), "time");
  deck = with(with(deck, "{20, 5, 3}", "{6, 3, 2}"), "{4, 4, 4}", "{2, 2, 2}");
  deck = with(with(deck, "-0.7*min(t,1)", "-0.2*min(t,1)"), "0.15*max(t-1,0)", "0");
  const std::string model = "value=\"neo-hookean\"/>", heavy = "value=\"neo-hookean\" />" + number("density", "1");
  deck = with(with(deck, model, heavy), model, heavy);
  for (const char* scheme : {"midpoint", "energy momentum midpoint contact", "trapezoidal", "generalised alpha"}) {
    const MarchedScene run{with_lists(deck, list("stages", stage("press", "static", 0.5, 1) + stage("wait", scheme, 0.1, 1.5)))};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
    const auto force = run["contact_force_z.indenter on slab"], active = run["active"];
    EXPECT_GT(active.back(), 3);
    EXPECT_NEAR(force.back(), run.at(1, "contact_force_z.indenter on slab"), 1e-8 * std::abs(force.back())) << scheme;
    EXPECT_LE(greatest_of(run["kinetic_energy"]), 1e-16) << scheme;
    EXPECT_LE(run.relative_mismatch(), 1e-12) << scheme;
  }
}

// Motion begins with the first stage that has inertia and ends with the next that has none: work and impulse from outside.
TEST(Stages, BeginAndEndMotion) {
  PulledBar bar;
  bar.lists = list("initial conditions", list("bar", deck_parameter("velocity", "Array(double)", "{0.3, 0, 0}")));
  bar.stages = list("stages", stage("pull", "static", 1, 1) + stage("swing", "energy momentum", 0.01, 1.1) +
                                  stage("go on", "midpoint", 0.01, 1.2) + stage("settle", "static", 0.4, 2) +
                                  stage("free", "energy momentum", 0.01, 2.1, without("supports/wall, loads/pull")));
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const double given = 0.5 * 2.5 * 0.3 * 0.3;
  const double pulled = 9 * 0.25 * (run.at(1.01, "displacement_x.tip") - 0.1);
  EXPECT_NEAR(run.at(1.01, "external_work") - run.at(1, "external_work"), given + pulled, 1e-10);
  EXPECT_GT(run.at(1.2, "kinetic_energy"), 0.01 * given);
  EXPECT_EQ(run.at(1.6, "kinetic_energy"), 0);
  EXPECT_NEAR(run.at(2, "displacement_x.tip"), 0.1, 1e-12);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
  EXPECT_LE(relative_to(run, "linear_momentum_mismatch", "linear_momentum"), 1e-11);
  const auto work = run["external_work"], energy = run["total_energy"], algorithmic = run["algorithmic_dissipation"],
             residual = run["residual_work"];
  for (std::size_t k = 0; k < work.size(); ++k) EXPECT_NEAR(energy[k] + algorithmic[k], work[k] + residual[k], 1e-11) << k;
  // Free, it flies on with the velocity that the deck gives what begins to move.
  const double flying = run["linear_momentum_x"].back();
  EXPECT_NEAR(flying, 2.5 * 0.3, 1e-11);
}

// Acceleration where a stage begins is that of what acts in it.
TEST(Stages, BeginWithTheAccelerationOfTheirOwnForces) {
  PulledBar bar;
  bar.stages = list("stages", stage("pull", "static", 1, 1) + stage("swing", "newmark", 1e-4, 1 + 1e-4, without("loads/pull")));
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  // The tip of a consistent mass matrix: (q_1 - q_0) = a_0 dt^2/2 with M a_0 = -9 A at the last node alone.
  const double u = run["displacement_x.tip"].back() - 0.1, dt = 1e-4, h = 0.5;
  const double a = -9 / h * 2 * std::sqrt(3.0);  // of a half-infinite row of linear elements: lambda = sqrt(3) - 2
  EXPECT_NEAR(u, 0.5 * a * dt * dt, 0.02 * std::abs(u));
}

// One stage is what `time` is.
TEST(Stages, OfOneAreNoOtherThanTime) {
  const std::string free_bar = FreeBar{};
  const std::string time = free_bar.substr(free_bar.find("<ParameterList name=\"time\">"));
  const std::string only = time.substr(0, time.find("</ParameterList>\n") + 17);
  const MarchedScene run{free_bar}, staged{with(free_bar, only, list("stages", with(only, "\"time\"", "\"flight\"")))};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.log;
  if (world()->getSize() == 1) {
    EXPECT_EQ(run.unknowns(), staged.unknowns());
  } else {
    EXPECT_LE(relative_difference(run.unknowns(), staged.unknowns(), 0, run.unknowns().size()), 1e-12);
  }
  EXPECT_EQ(run["time"], staged["time"]);
}

// Stopped after any attempt, on both sides of where a stage begins, a run goes on to the same end.
TEST(Stages, GoOnFromACheckpoint) {
  PulledBar bar;
  bar.lists = list("initial conditions", list("bar", deck_parameter("velocity", "Array(double)", "{0.3, 0, 0}")));
  bar.stages = list("stages", stage("pull", "static", 0.5, 1) + stage("swing", "energy momentum", 0.02, 1.04) +
                                  stage("settle", "static", 0.5, 2));
  const MarchedScene whole{bar};
  ASSERT_EQ(whole.summary.code, ExitCode::done) << whole.summary.cause;
  for (int attempts : {1, 2, 3, 4, 5}) {
    const MarchedScene part(bar, world(), attempts);
    ASSERT_EQ(part.summary.code, ExitCode::terminated);
    const MarchedScene rest(bar, world(), to_the_end, &part);
    ASSERT_EQ(rest.summary.code, ExitCode::done) << rest.summary.cause;
    for (const char* column : {"time", "external_work", "total_energy", "linear_momentum_x", "ledger_mismatch"}) {
      if (world()->getSize() == 1) {
        EXPECT_EQ(rest[column], whole[column]) << column << " after " << attempts;
      } else {
        EXPECT_NEAR(rest[column].back(), whole[column].back(), 1e-11) << column << " after " << attempts;
      }
    }
    if (world()->getSize() == 1) {
      EXPECT_EQ(rest.unknowns(), whole.unknowns()) << attempts;
    }
  }
}

// A spring that goes takes what it holds along: not the scheme's doing.
TEST(TemporarySprings, GiveAndTakeWorkFromOutside) {
  PulledBar bar;
  bar.lists = list("springs", list("posts", word("type", "nodes") + word("set", "bar/right") + number("x", "30")));
  bar.stages =
      list("stages", stage("pull", "static", 1, 1) + stage("swing", "energy momentum", 0.01, 1.5, without("springs/posts")));
  const MarchedScene run{bar};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause;
  const double tip = run.at(1, "displacement_x.tip"), in_springs = 0.5 * 4 * 30 * tip * tip;
  EXPECT_GT(tip, 0.01);
  EXPECT_NEAR(run["algorithmic_dissipation"].back(), run.at(1, "algorithmic_dissipation"), 1e-12);
  EXPECT_NEAR(run.at(1.01, "total_energy") - run.at(1, "total_energy"),
              run.at(1.01, "external_work") - run.at(1, "external_work"), 1e-11);
  EXPECT_NEAR(run.at(1, "strain_energy") - 0.5 * 900 * tip * tip / 100 * 2.5, in_springs, 1e-12);
  EXPECT_LE(run.relative_mismatch(), 1e-13);
}

}  // namespace
}  // namespace mortise::test
