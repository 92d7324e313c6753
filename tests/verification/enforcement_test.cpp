// Other ways of keeping gaps closed than multipliers settled by an active set.
#include <gtest/gtest.h>

#include <iostream>

#include "assembly/vectors.hpp"
#include "support/marched_scene.hpp"
#include "support/overhang.hpp"

namespace mortise::test {
namespace {

/// The patch test, whose pressure is the same everywhere.
std::string patch(const std::string& options) {
  const std::string primary = "value=\"lower/top\"/>";
  return with(without_list(input_deck("patch_test/contact.xml"), "expected"), primary, primary + "\n" + options);
}

std::string penalty(const std::string& eps) { return word("enforcement", "penalty") + number("normal penalty", eps); }

TEST(Penalty, LetsSurfacesInByThePressureOverIt) {
  for (const double eps : {1e5, 1e7}) {
    TestScene s(patch(penalty(std::to_string(eps))), world(), [](Scene& scene) { scene.solver.further_iterations = 1; });
    const auto run = s.march({0.5, 1});
    ASSERT_TRUE(run.converged) << run.cause;
    const auto gap = s.gather(*run.at.gap), x = s.gather(*s.state.x);
    for (std::size_t k = s.n_positions(); k < x.size(); ++k) {
      EXPECT_NEAR(x[k], x[s.n_positions()], 1e-10 * x[k]);
      EXPECT_NEAR(gap[k], -x[k] / eps, 1e-10 * x[k] / eps + 1e-12);
    }
  }
}

/// A block that is pressed into another one, beyond whose edge it hangs.
std::string overhang(const std::string& options) {
  const std::string primary = "value=\"lower/top\"/>", lower = "<ParameterList name=\"lower bottom\">";
  const std::string pressed =
      list("upper top", word("set", "upper/top") + word("x", "0") + word("y", "0") + word("z", "-0.11*t"));
  return with(with(overhang_deck, lower, pressed + lower), primary, primary + "\n" + options);
}

std::vector<double> forces(const std::string& options) {
  const MarchedScene run{overhang(options)};
  EXPECT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  std::vector<double> all;
  for (const char* column : {"contact_force_x.pair", "contact_force_y.pair", "contact_force_z.pair", "strain_energy"})
    all.push_back(run[column].back());
  return all;
}

void expect_alike(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], tolerance * std::abs(b.back()));
}

TEST(AugmentedLagrangian, ComesToWhatMultipliersGive) {
  expect_alike(forces(word("enforcement", "augmented lagrangian") + number("normal penalty", "300") +
                      number("largest penetration", "1e-8")),
               forces(""), 1e-6);
}

TEST(AugmentedLagrangian, SaysWhenItDoesNotGetThere) {
  const std::string deck = overhang(word("enforcement", "augmented lagrangian") + number("normal penalty", "1e-3") +
                                    number("largest penetration", "1e-12"));
  const std::string step = "name=\"step\" type=\"double\" value=\"1\"/>";
  const MarchedScene run{with(deck, step, step + number("smallest step", "1"))};
  EXPECT_EQ(run.summary.code, ExitCode::no_convergence);
  EXPECT_NE(run.summary.cause.find("augmented Lagrangian: after 50 passes"), std::string::npos) << run.summary.cause;
}

TEST(FischerBurmeister, ComesToWhatTheActiveSetGives) {
  expect_alike(forces(word("complementarity", "fischer burmeister")), forces(""), 1e-9);
}

TEST(InterpolatedNormal, ComesNearTheThesisReading) {
  const auto thesis = forces(""), other = forces(word("contact force", "interpolated normal"));
  expect_alike(other, thesis, 0.05);
  EXPECT_NE(other, thesis);
}

TEST(FrozenIntegrals, ComeNearTheCurrentOnes) {
  expect_alike(forces(word("mortar integrals", "start of step")), forces(""), 0.05);
}

}  // namespace
}  // namespace mortise::test
