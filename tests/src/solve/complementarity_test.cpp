// Small complementarity problems that plain changes of the active set never end on.
#include "solve/complementarity_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "support/random.hpp"

namespace mortise::test {
namespace {

using Values = std::vector<double>;

/// The start k of 2^n.
std::vector<char> start(int k, std::size_t n) {
  std::vector<char> basic(n);
  for (std::size_t i = 0; i < n; ++i) basic[i] = static_cast<char>(k >> i & 1);
  return basic;
}

/// w = q + M z.
Values slack(const Values& M, const Values& q, const Values& z) {
  Values w = q;
  for (std::size_t r = 0; r < q.size(); ++r)
    for (std::size_t c = 0; c < q.size(); ++c) w[r] += M[r * q.size() + c] * z[c];
  return w;
}

/// Solves from every start and compares.
void expect_from_every_start(const Values& M, const Values& q, const Values& solution) {
  for (int k = 0; k < 1 << q.size(); ++k) {
    const auto z = solve_complementarity(M, q, 1e-12, start(k, q.size()));
    ASSERT_TRUE(z) << "start " << k;
    for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR((*z)[i], solution[i], 1e-12) << "start " << k << ", " << i;
  }
}

/// The set that all wrong signs being flipped at once leads to (n = 3, Cramer's rule).
std::vector<char> flipped(const Values& M, const Values& q, std::vector<char> basic) {
  double A[3][3];
  Values b(3);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) A[r][c] = basic[c] ? M[3 * r + c] : -(r == c);
    b[r] = -q[r];
  }
  const auto det = [](const double(&a)[3][3]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  };
  for (int c = 0; c < 3; ++c) {
    double of_c[3][3];
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 3; ++k) of_c[r][k] = k == c ? b[r] : A[r][k];
    if (det(of_c) / det(A) < 0) basic[c] = !basic[c];  // z where basic, w elsewhere
  }
  return basic;
}

/// From how many starts that never ends.
int n_cycles(const Values& M, const Values& q) {
  int n = 0;
  for (int k = 0; k < 8; ++k) {
    std::set<std::vector<char>> met;
    std::vector<char> basic = start(k, 3);
    while (met.insert(basic).second) {
      const auto next = flipped(M, q, basic);
      if (next == basic) break;
      basic = next;
    }
    n += flipped(M, q, basic) != basic;
  }
  return n;
}

TEST(ComplementarityProblem, OfBenGharbiaAndGilbertIsSolvedFromEveryStart) {  // case C1
  for (const double a : {1.05, 1.5, 2.0, 3.0, 4.0, 5.0}) {
    const Values M{1, 0, a, a, 1, 0, 0, a, 1}, pulled(3, 1.0), pressed(3, -1.0);
    EXPECT_EQ(n_cycles(M, pressed), 6) << a;
    expect_from_every_start(M, pulled, {0, 0, 0});
    expect_from_every_start(M, pressed, Values(3, 1 / (1 + a)));
  }
}

TEST(ComplementarityProblem, WithASymmetricMatrixThatCyclesIsSolvedFromEveryStart) {  // case C2
  const Values S{10, -6, 6, -6, 11, -5, 6, -5, 4}, q{0, -3, 1};                       // cycles where w = 0 counts as negative
  expect_from_every_start(S, q, {9 / 37.0, 15 / 37.0, 0});
  const Values A{2, -4, -5, -4, 19, 20, -5, 20, 22}, b{2, -1, -4};  // always cycles; determinant 9
  EXPECT_EQ(n_cycles(A, b), 6);
  expect_from_every_start(A, b, {0, 0, 2 / 11.0});
}

TEST(ComplementarityProblem, ThatIsBiactiveEndsFromEveryStart) {  // case C3: z and w of the third are round-off
  const Values S{3, -1, -1, -1, 1, 1, -1, 1, 2}, q{-1, -1, -1};
  expect_from_every_start(S, q, {1, 2, 0});
  const auto w = slack(S, q, *solve_complementarity(S, q, 1e-12));
  for (double one : w) EXPECT_NEAR(one, 0, 1e-12);
}

TEST(ComplementarityProblem, OfRandomPositiveDefiniteMatricesIsSolved) {
  Random random(9);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::size_t n = 1 + trial % 10;
    Values B(n * n), M(n * n, 0.0), q(n);
    for (double& b : B) b = random.in(-1, 1);
    for (double& entry : q) entry = random.in(-1, 1);
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        for (std::size_t k = 0; k < n; ++k) M[r * n + c] += B[r * n + k] * B[c * n + k];
        if (r == c) M[r * n + c] += 0.1;
        if (trial % 2) M[r * n + c] += r < c ? B[r * n + c] : r > c ? -B[c * n + r] : 0;  // not symmetric
      }
    const auto z = solve_complementarity(M, q, 1e-12, start(trial, n));
    ASSERT_TRUE(z) << trial;
    const Values w = slack(M, q, *z);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_GE((*z)[k], 0);
      EXPECT_GE(w[k], -1e-11);
      EXPECT_LE(std::abs((*z)[k] * w[k]), 1e-10) << trial;
    }
  }
}

TEST(ComplementarityProblem, ThatHasNoSolutionOrNoNumbersIsSaidToHaveNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_complementarity({0}, {-1}, 1e-12));   // singular
  EXPECT_FALSE(solve_complementarity({-1}, {-1}, 1e-12));  // w = -1 - z
  EXPECT_FALSE(solve_complementarity({1}, {nan}, 1e-12));
  EXPECT_FALSE(solve_complementarity({nan}, {-1}, 1e-12));
  EXPECT_TRUE(solve_complementarity({}, {}, 1e-12));
}

}  // namespace
}  // namespace mortise::test
