// Laws of friction in a scene: coefficients by formula, Tresca's bound, the law without stick, on any number of ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "assembly/vectors.hpp"
#include "support/drawn_block.hpp"

namespace mortise::test {
namespace {

std::string coefficient(const std::string& formula) { return word("friction coefficient", formula); }

/// f(pressure, traction) of every node of the pair at the end of a run.
template <class Function>
void for_each_node(const MarchedScene& run, Function f) {
  const auto x = run.unknowns();
  for (std::size_t at = run.scene.n_positions(); at < x.size(); at += 4) f(x[at], Vec3<double>{x[at + 1], x[at + 2], x[at + 3]});
}

/// The block's friction is mu times its pressing force but for the tilt of the surface under it: within 6 %.
TEST(FrictionCoefficient, IsRampedInTime) {
  DrawnBlock deck;
  deck.law = coefficient("0.2 + ramp(t)");
  const std::string ramp = list("tables", list("ramp", deck_parameter("arguments", "Array(double)", "{1, 2}") +
                                                           deck_parameter("values", "Array(double)", "{0, 0.2}")));
  const MarchedScene run(with_lists(deck, ramp));
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto t = run["time"], fx = run["contact_force_x.pair"], fz = run["contact_force_z.pair"], slip = run["slip"];
  int n_sliding = 0;
  for (std::size_t k = 1; k < t.size(); ++k)
    if (t[k] > 1 && slip[k] == run["active"][k]) {
      const double mu = 0.2 + 0.2 * (t[k] - 1);
      EXPECT_NEAR(fx[k] / fz[k], -mu, 0.06 * mu) << t[k];
      ++n_sliding;
    }
  EXPECT_GE(n_sliding, 3);
  for_each_node(run, [](double p, const Vec3<double>& traction) { EXPECT_NEAR(norm(traction), 0.4 * std::max(p, 0.0), 1e-8); });
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

TEST(FrictionCoefficient, IsThatOfThePressureAtEachNode) {
  for (const std::string& stick : {std::string(), number("tangential penalty", "1e3")}) {
    DrawnBlock deck;
    deck.law = coefficient("0.5/(1 + p)") + stick;
    const MarchedScene run{deck};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
    double least = 1, greatest = 0;
    for_each_node(run, [&](double p, const Vec3<double>& traction) {
      EXPECT_NEAR(norm(traction), 0.5 / (1 + std::max(p, 0.0)) * std::max(p, 0.0), 1e-8);
      least = std::min(least, 0.5 / (1 + p));
      greatest = std::max(greatest, 0.5 / (1 + p));
    });
    EXPECT_GT(greatest, 1.2 * least);  // the pressures differ
  }
}

/// In statics too the speed is slip over length of the step: that of the drawing, once all slides.
TEST(FrictionCoefficient, IsThatOfTheSlipSpeed) {
  for (const double speed : {0.2, 0.4}) {
    DrawnBlock deck;
    deck.law = coefficient("0.1 + 0.5*v");
    deck.drawn = fmt::format("{}*max(t-1,0)", speed);
    const MarchedScene run{deck};
    ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
    double greatest = 0;
    for_each_node(run, [&](double p, const Vec3<double>& traction) {
      if (p > 0.1) {
        EXPECT_NEAR(norm(traction) / p, 0.1 + 0.5 * speed, 0.05 * (0.1 + 0.5 * speed));
      }
      greatest = std::max(greatest, p);
    });
    EXPECT_GT(greatest, 0.5);
  }
}

TEST(FrictionCoefficient, ThatIsNegativeIsToldWithItsPlace) {
  DrawnBlock deck;
  deck.law = coefficient("0.25 - 0.5*max(t-1,0)");
  const MarchedScene by_time{deck};
  EXPECT_EQ(by_time.summary.code, ExitCode::deck);
  EXPECT_NE(by_time.summary.cause.find("error[D23] contact > pair > \"friction coefficient\" = \"0.25 - 0.5*max(t-1,0)\" - gives "
                                       "-0.125 at t = 1.75, p = 0, v = 0 - must be a finite number that is not negative"),
            std::string::npos)
      << by_time.summary.cause;

  deck.law = coefficient("v > 0.1 ? -1 : 0.3");  // fine at rest: states on the way cannot be, and no shorter step mends it
  const MarchedScene by_speed{deck};
  EXPECT_EQ(by_speed.summary.code, ExitCode::no_convergence);
  EXPECT_NE(by_speed.summary.cause.find(
                "error[D23] contact > pair > \"friction coefficient\" = \"v > 0.1 ? -1 : 0.3\" - gives -1 at t = "),
            std::string::npos)
      << by_speed.summary.cause;

  deck.law = word("friction bound", "0.1/(t-0.5)");
  const MarchedScene bound{deck};
  EXPECT_EQ(bound.summary.code, ExitCode::deck);
  EXPECT_NE(bound.summary.cause.find("\"friction bound\" = \"0.1/(t-0.5)\" - gives -"), std::string::npos) << bound.summary.cause;
}

/// Sum of area times traction, and the area of closed nodes [m^2].
std::pair<Vec3<double>, double> force_and_area(MarchedScene& run) {
  const auto x = run.unknowns(), areas = run.scene.gather(*run.scene.problem.evaluate(*run.scene.state.x).area);
  Vec3<double> force{0, 0, 0};
  double area = 0;
  for (std::size_t at = run.scene.n_positions(); at < x.size(); at += 4) {
    for (int i = 0; i < 3; ++i) force[i] += areas[at] * x[at + 1 + i];
    if (x[at] > 0) area += areas[at];
  }
  return {force, area};
}

TEST(TrescaFriction, IsItsBoundTimesTheArea) {
  DrawnBlock deck;
  deck.law = word("friction bound", "0.05*min(t,1)");
  MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_GT(run["active"].back(), 0);
  EXPECT_EQ(run["slip"].back(), run["active"].back());
  for_each_node(run, [](double p, const Vec3<double>& traction) { EXPECT_NEAR(norm(traction), p > 0 ? 0.05 : 0, 1e-10); });
  const auto [force, area] = force_and_area(run);
  EXPECT_GT(area, 0.1);
  EXPECT_NEAR(force[0], -0.05 * area, 0.01 * 0.05 * area);  // but for the directions of slip
  EXPECT_NEAR(run["contact_force_x.pair"].back(), force[0], 0.02 * run["contact_force_z.pair"].back());  // and the tilt
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

TEST(TrescaFriction, EndsWhereSurfacesPart) {
  DrawnBlock deck;
  deck.law = number("friction bound", "0.05");
  deck.pressed = "-0.1*min(t,1) + 0.3*max(t-2,0)";
  deck.end = "3";
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  EXPECT_EQ(run["active"].back(), 0);
  for_each_node(run, [](double, const Vec3<double>& traction) { EXPECT_EQ(norm(traction), 0); });
  EXPECT_LE(std::abs(run["contact_force_x.pair"].back()), 1e-12);
}

/// Down a slope of 1/2 at the speed at which the law holds the weight.
TEST(RegularisedFriction, LetsABlockCreepDownASlope) {
  constexpr double mu = 0.8, v0 = 0.05, slope = 0.5;
  std::string deck = without_list(input_deck("incline/resting.xml"), "expected");
  deck =
      with(deck, "type=\"double\" value=\"0.51\"/>", "type=\"double\" value=\"0.8\"/>" + number("slip regularisation", "0.05"));
  deck = with(deck, "type=\"double\" value=\"2.5\"", "type=\"double\" value=\"0.25\"");
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  const auto x = run["displacement_x.block"], t = run["time"];
  const std::size_t n = x.size() - 1;
  EXPECT_NEAR((x[n] - x[n - 1]) / (t[n] - t[n - 1]), v0 * slope / std::sqrt(mu * mu - slope * slope), 1e-5 * v0);
  EXPECT_EQ(run["stick"].back(), 0);
}

class EveryLaw : public testing::TestWithParam<std::string> {};

/// Drawn to and fro: every quantity stays finite and friction takes energy.
TEST_P(EveryLaw, TurnsRound) {
  DrawnBlock deck;
  deck.law = GetParam();
  deck.drawn = "0.2*sin(6.283185307179586*max(t-1,0))";
  deck.step = "0.1";
  const MarchedScene run{deck};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  for (double x : run.unknowns()) EXPECT_TRUE(std::isfinite(x));
  const auto lost = run["friction_dissipation"];
  for (std::size_t k = 1; k < lost.size(); ++k) EXPECT_GE(lost[k] - lost[k - 1], -1e-12);
  EXPECT_GT(lost.back(), 1e-3);
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

TEST_P(EveryLaw, IsTheSameOnEveryNumberOfRanks) {
  DrawnBlock deck;
  deck.law = GetParam();
  const MarchedScene shared{deck}, by_itself(deck, alone());
  ASSERT_EQ(shared.summary.code, ExitCode::done) << shared.summary.cause << shared.log;
  EXPECT_LE(relative_difference(shared.unknowns(), by_itself.unknowns(), 0, shared.scene.n_positions()), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(coefficient("0.3/(1+p) + 0.1*v"), coefficient("1.2 + 0.1*t"),
                                         number("friction bound", "0.1"),
                                         number("friction bound", "0.1") + number("tangential penalty", "100"),
                                         coefficient("0.4 - 0.1*p/(1+p)") + number("slip regularisation", "0.05"),
                                         number("friction bound", "0.1") + number("slip regularisation", "0.05")));

}  // namespace
}  // namespace mortise::test
