// The tangent of a whole contact problem against central differences of its residual: bodies, pair, supports, law.
#include <gtest/gtest.h>

#include <iostream>

#include "support/gradient_check.hpp"
#include "support/overhang.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

class ContactJacobian : public testing::Test {
 protected:
  TestScene s{overhang_deck};

  // Values whose derivative the tangent claims to hold: forces, supports, and for every covered node gap + compliance p, open or
  // closed.
  std::vector<double> values(const std::vector<double>& x) {
    const auto at = s.problem.evaluate(*s.scatter(x));
    auto r = s.gather(*at.residual);
    const auto gap = s.gather(*at.gap), compliance = s.gather(*at.compliance), area = s.gather(*at.area);
    for (std::size_t k = s.n_positions(); k < r.size(); ++k)
      if (area[k] > 0) r[k] = gap[k] + compliance[k] * x[k];
    return r;
  }

  struct Kinds {
    int closed = 0, open = 0, partly = 0, uncovered = 0;
  };

  // Rows of nodes with little cover grow like the inverse square of the cover: they are compared times that. Where it is under a
  // hundredth, the differences would reach past the node's last overlap: left out.
  ::testing::AssertionResult tangent_is_exact(const std::vector<double>& x, bool actual_law, const GradientCheck& check,
                                              Kinds* kinds = nullptr) {
    const std::size_t n = s.n_unknowns();
    RCP<Matrix> K;
    const auto at = s.problem.linearise(*s.scatter(x), K);
    if (!at.admissible) return ::testing::AssertionFailure() << "the state is not admissible";
    const auto J = s.dense(*K);
    const auto area = s.gather(*at.area), compliance = s.gather(*at.compliance);
    std::vector<std::size_t> rows;
    std::vector<double> compared, scale;
    for (std::size_t r = 0; r < n; ++r) {
      const bool pressure = r >= s.n_positions(), covered = pressure && area[r] > 0,
                 open = covered && !at.closed[r - s.n_positions()];
      if (kinds && pressure)
        ++(!covered ? kinds->uncovered : compliance[r] > 0 ? kinds->partly : open ? kinds->open : kinds->closed);
      const double cover = covered ? area[r] / s.scene.pairs[0].tributary_area[r - s.n_positions()] : 1;
      if (cover < 0.01) continue;
      rows.push_back(r);
      scale.push_back(std::min(1.0, cover * cover));
      for (std::size_t c = 0; c < n; ++c)
        compared.push_back(scale.back() * (open && actual_law ? (r == c ? 1.0 : 0.0) : J[r * n + c]));
    }
    const auto f = [&](const std::vector<double>& y) {
      const auto all = actual_law ? s.gather(*s.problem.evaluate(*s.scatter(y)).residual) : values(y);
      std::vector<double> chosen;
      for (std::size_t k = 0; k < rows.size(); ++k) chosen.push_back(scale[k] * all[rows[k]]);
      return chosen;
    };
    return is_derivative(compared, f, x, check);
  }
};

// States at which no overlap gains or loses a corner within the steps: the second derivative jumps there, and the order of the
// differences with it (the first does not).
TEST_F(ContactJacobian, IsExactWithOpenAndClosedAndPartlyCoveredNodes) {
  Random random(13);
  GradientCheck check;
  check.first_step = 1e-4;
  Kinds kinds;
  for (const double distortion : {0.02, 0.03, 0.08})
    EXPECT_TRUE(tangent_is_exact(s.random_state(random, distortion, -0.3, 1), false, check, &kinds))
        << "distortion " << distortion;
  EXPECT_GT(kinds.closed, 5);
  EXPECT_GT(kinds.open, 5);
  EXPECT_GT(kinds.partly, 2);
  EXPECT_GT(kinds.uncovered, 0);
  if (world()->getRank() == 0)
    std::cout << kinds.closed << " closed, " << kinds.open << " open, " << kinds.partly << " partly covered, " << kinds.uncovered
              << " uncovered\n";
}

TEST_F(ContactJacobian, IsExactOnBothSidesOfTheKinkOfTheLaw) {
  Random random(12);
  auto x = s.random_state(random, 0.08, 0.2, 1);
  const auto at = s.problem.evaluate(*s.scatter(x));
  const auto area = s.gather(*at.area), compliance = s.gather(*at.compliance);
  const auto closed_at = [&](std::size_t row, double p) {
    auto y = x;
    y[row] = p;
    return s.problem.evaluate(*s.scatter(y)).closed[row - s.n_positions()] != 0;
  };
  GradientCheck check;
  check.first_step = 2e-4;
  int n_kinks = 0;
  for (std::size_t row = s.n_positions(); row < x.size() && n_kinks < 3; ++row) {
    if (!(area[row] > 0) || compliance[row] > 0 || closed_at(row, -1) || !closed_at(row, 1)) continue;
    ++n_kinks;
    double open = -1, closed = 1;  // the pressure at which the node switches lies between
    for (int k = 0; k < 50; ++k) (closed_at(row, 0.5 * (open + closed)) ? closed : open) = 0.5 * (open + closed);
    const double kept = x[row];
    for (const double side : {-1, 1}) {
      x[row] = open + side * 2e-3;  // nearer would let the differences reach across
      EXPECT_EQ(closed_at(row, x[row]), side > 0);
      EXPECT_TRUE(tangent_is_exact(x, true, check)) << "pressure " << row - s.n_positions() << (side > 0 ? ", closed" : ", open");
    }
    x[row] = kept;
  }
  EXPECT_EQ(n_kinks, 3);
}

TEST_F(ContactJacobian, HasIdentityRowsForSupportsAndUncoveredPressures) {
  Random random(13);
  RCP<Matrix> K;
  const auto x = s.scatter(s.random_state(random, 0.08, 0.2, 1));
  const auto at = s.problem.linearise(*x, K);
  const auto J = s.dense(*K);
  const auto area = s.gather(*at.area);
  const std::size_t n = s.n_unknowns();
  std::vector<std::size_t> rows;
  for (const auto& p : s.scene.prescribed) rows.push_back(3 * static_cast<std::size_t>(p.node) + p.axis);
  for (std::size_t k = s.n_positions(); k < n; ++k)
    if (area[k] == 0) rows.push_back(k);
  for (std::size_t r : rows)
    for (std::size_t c = 0; c < n; ++c) EXPECT_EQ(J[r * n + c], r == c ? 1.0 : 0.0);
}

// The check itself: an entry of the tangent that is off by a thousandth must be noticed.
TEST_F(ContactJacobian, CheckNoticesAWrongEntry) {
  Random random(11);
  const auto x = s.random_state(random, 0.08, 0.2, 1);
  RCP<Matrix> K;
  s.problem.linearise(*s.scatter(x), K);
  auto J = s.dense(*K);
  const std::size_t n = s.n_unknowns(), row = 3 * static_cast<std::size_t>(s.scene.pairs[0].secondary_nodes[12]);
  J[row * n + row] *= 1.001;
  std::vector<double> one_row(J.begin() + row * n, J.begin() + (row + 1) * n);
  GradientCheck check;
  check.first_step = 2e-4;
  EXPECT_FALSE(is_derivative(
      one_row, [&](const std::vector<double>& y) { return std::vector<double>{values(y)[row]}; }, x, check));
}

}  // namespace
}  // namespace mortise::test
