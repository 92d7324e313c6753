// The stick zone of inputs/cattaneo must not depend on the number of steps.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "support/frames.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

/// What is compared, at full shear.
struct Sheared {
  std::vector<double> status;
  double shear = 0, dissipated = 0;
  int steps = 0;

  explicit Sheared(const std::string& step) {
    const ScratchFolder folder;
    folder.write("deck.xml", with(input_deck("cattaneo/cattaneo.xml"), "name=\"step\"   type=\"double\"        value=\"0.5\"",
                                  "name=\"step\" type=\"double\" value=\"" + step + "\""));
    const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    if (run.code != 0) return;
    const auto table = read_history(folder / "out" / "history.csv");
    shear = std::abs(table["contact_force_x.upper on lower"].back());
    dissipated = table["friction_dissipation"].back();
    steps = nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["steps"];
    status = read_nodal(folder / "out" / "results.e", "status", steps + 1).values;
  }
  long n(double which) const { return std::count(status.begin(), status.end(), which); }
};

TEST(Cattaneo, SticksTheSameIn10AndIn100Steps) {
  if (std::getenv("MORTISE_LONG") == nullptr) GTEST_SKIP() << "a long test: tools/check --long runs it";
  const Sheared few("0.5"), many("0.05");
  ASSERT_EQ(few.steps, 10);
  ASSERT_EQ(many.steps, 100);
  ASSERT_GT(few.n(2), 0);
  EXPECT_GT(few.n(1), few.n(2));
  EXPECT_EQ(few.status, many.status);
  EXPECT_NEAR(many.shear, few.shear, 0.01 * few.shear);
  EXPECT_NEAR(many.dissipated, few.dissipated, 0.01 * few.dissipated);
  std::cout << few.steps << " and " << many.steps << " steps: " << few.n(2) << " nodes stick, " << few.n(1)
            << " slip, shear differs by " << many.shear / few.shear - 1 << ", dissipation by "
            << many.dissipated / few.dissipated - 1 << '\n';
}

}  // namespace
}  // namespace mortise::test
