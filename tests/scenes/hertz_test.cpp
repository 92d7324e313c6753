// The pressure of the cylinder of inputs/hertz under growing load: its error over a refinement, its sign, its resultant.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "support/frames.hpp"
#include "support/program.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double E_star = 2250 / (2 * (1 - 0.3 * 0.3)), R = 1;  // of both bodies together
constexpr double thickness = 0.01;

/// Hertz for a cylinder under the force F per length: half width a, pressure p0 sqrt(1 - (x/a)^2).
struct Hertz {
  double a, p0;
  explicit Hertz(double F) : a(std::sqrt(4 * F * R / (pi * E_star))), p0(std::sqrt(F * E_star / (pi * R))) {}
  double operator()(double x) const { return x < a ? p0 * std::sqrt(1 - x * x / (a * a)) : 0; }
};

/// The deck with another number of elements along x and loads of 0.6, 0.7 ... 1.
std::string deck(int n) {
  const auto elements = [](int x, int z) { return "{" + std::to_string(x) + ", 1, " + std::to_string(z) + "}"; };
  auto text = without_list(input_deck("hertz/cylinder.xml"), "expected");
  text = with(with(text, "{60, 1, 36}", elements(n, n * 3 / 5)), "{48, 1, 29}", elements(n * 4 / 5, n / 2));
  return with(text, "name=\"step\"   type=\"double\" value=\"0.5\"", "name=\"step\" type=\"double\" value=\"0.1\"");
}

/// Pressures on the cylinder by x, in one frame. Nodes of other surfaces have none.
std::map<double, double> pressures(const std::filesystem::path& file, int frame) {
  const NodalFrame nodal = read_nodal(file, "contact_pressure", frame);
  std::map<double, double> p;
  for (std::size_t a = 0; a < nodal.X.size(); ++a) {
    const auto [x, y, z] = nodal.X[a];
    if (y == 0 && std::abs(z - (R - std::sqrt(R * R - x * x))) < 1e-12)
      p.emplace(x, nodal.values[a]);  // the first is the cylinder's
  }
  return p;
}

/// Relative error in L2(0, 1.3 a) of the pressures joined by straight lines.
double error(const std::map<double, double>& p, const Hertz& hertz) {
  constexpr int n = 4000;
  double off = 0, size = 0;
  for (int k = 0; k < n; ++k) {
    const double x = 1.3 * hertz.a * (k + 0.5) / n;
    const auto right = p.upper_bound(x), left = std::prev(right);
    const double share = (x - left->first) / (right->first - left->first);
    const double found = (1 - share) * left->second + share * right->second;
    off += std::pow(found - hertz(x), 2);
    size += std::pow(hertz(x), 2);
  }
  return std::sqrt(off / size);
}

// The edge of contact lies anywhere in an element, and the error with it: several loads average that.
TEST(HertzCylinder, HasAPressureThatConvergesWithOrder1AndIsNeverTension) {
  std::vector<double> errors;
  for (int n : {15, 30, 60}) {
    const ScratchFolder folder;
    folder.write("deck.xml", deck(n));
    const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
    ASSERT_EQ(run.code, 0) << run.out << run.err;
    const auto table = read_history(folder / "out" / "history.csv");
    const auto time = table["time"], force = table["contact_force_z.cylinder on block"];
    double squares = 0, peak = 0;
    int n_loads = 0;
    for (std::size_t k = 1; k < time.size(); ++k) {
      const auto p = pressures(folder / "out" / "results.e", static_cast<int>(k) + 1);
      ASSERT_EQ(p.size(), static_cast<std::size_t>(n) + 1);
      for (const auto& [x, pressure] : p) EXPECT_GE(pressure, 0) << x;
      if (time[k] < 0.55) continue;  // not yet the load
      const double F = time[k];
      EXPECT_NEAR(std::abs(force[k]), F / 2 * thickness, 1e-8 * F * thickness);
      squares += std::pow(error(p, Hertz(F)), 2);
      peak = p.begin()->second / Hertz(F).p0 - 1;
      ++n_loads;
    }
    ASSERT_EQ(n_loads, 5);
    errors.push_back(std::sqrt(squares / n_loads));
    std::cout << n << " elements: L2 error of the pressure " << errors.back() << ", of the peak at full load " << peak << '\n';
    if (n == 60) {
      EXPECT_LE(std::abs(peak), 0.02);
    }
  }
  const double order = std::log2(errors[0] / errors[2]) / 2;
  std::cout << "order " << order << '\n';
  EXPECT_GE(order, 1);
}

TEST(HertzDecks, ExpectTheIndependentValues) {
  if (!have_reference("patch_and_hertz.json")) GTEST_SKIP() << no_reference("patch_and_hertz.json");
  const auto cylinder =
      reference("patch_and_hertz.json")["hertz"]["cylinder(unit length) R=1 on same half space E=2250 nu=0.3 F=1"];
  const double p0 = std::stod(cylinder["p0"].get<std::string>());
  EXPECT_NEAR(Hertz(1).p0, p0, 1e-12 * p0);
  EXPECT_NEAR(Hertz(1).a, std::stod(cylinder["half_width"].get<std::string>()), 1e-14);
  EXPECT_EQ(count_of(input_deck("hertz/cylinder.xml"), "value=\"19.8372\""), 1);
}

}  // namespace
}  // namespace mortise::test
