// One node on two coupled springs before a wall with friction (Klarbring 1990): by Newton's method with the laws of contact.
#include <gtest/gtest.h>

#include <Sacado.hpp>
#include <Teuchos_LAPACK.hpp>
#include <optional>

#include "contact/laws/coulomb.hpp"
#include "contact/laws/signorini.hpp"
#include "support/random.hpp"

namespace mortise::test {
namespace {

constexpr int n = 4;
using Unknowns = std::array<double, n>;  // normal and tangential displacement, pressure, traction

/// Springs k_n = k_t = 1, coupled by 1/2; the wall holds what moves in the normal direction.
struct Node {
  double force_n, force_t, mu, c = 1;

  template <class T>
  std::array<T, n> residual(const std::array<T, n>& x) const {
    const T &u_n = x[0], &u_t = x[1], &p = x[2], &t = x[3];
    FrictionStatus status = FrictionStatus::none;
    const FrictionState<T> state{{u_t, T(0.0), T(0.0)}, {t, T(0.0), T(0.0)}, {T(0.0), T(0.0), T(1.0)}, p};
    return {T(u_n + 0.5 * u_t + p - force_n), T(0.5 * u_n + u_t - t - force_t), complementarity(p, T(-u_n), c),
            exact_stick(state, T(mu * p), c, status)[0]};
  }

  /// Newton's method with full steps. @return nothing if it does not end within 50 iterations or the tangent is singular
  std::optional<Unknowns> solve(Unknowns x) const {
    using Fad = Sacado::Fad::SFad<double, n>;
    for (int iteration = 0; iteration < 50; ++iteration) {
      std::array<Fad, n> at;
      for (int k = 0; k < n; ++k) at[k] = Fad(n, k, x[k]);
      const auto r = residual(at);
      double K[n * n], dx[n], greatest = 0;
      for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) K[k * n + i] = r[i].dx(k);
        dx[i] = -r[i].val();
        greatest = std::max(greatest, std::abs(dx[i]));
        EXPECT_TRUE(std::isfinite(dx[i]));
      }
      if (greatest <= 1e-15) return x;
      int pivots[n], info = 0;
      Teuchos::LAPACK<int, double>().GESV(n, 1, K, n, pivots, dx, n, &info);
      if (info != 0) return std::nullopt;
      for (int k = 0; k < n; ++k) x[k] += dx[k];
    }
    return std::nullopt;
  }
};

const Unknowns open{-1 / 3.0, 8 / 3.0, 0, 0}, stick{0, 0, 1, -2.5}, slip{0, 1, 0.5, -1.5};

double distance(const Unknowns& a, const Unknowns& b) {
  double greatest = 0;
  for (int k = 0; k < n; ++k) greatest = std::max(greatest, std::abs(a[k] - b[k]));
  return greatest;
}

/// Case C4: three solutions where mu > k_t / (1/2).
TEST(KlarbringsNode, FindsOneOfItsThreeSolutionsOrNone) {
  const Node at{1, 2.5, 3};
  for (const Unknowns& solution : {open, stick, slip}) {
    const auto found = at.solve(solution);
    ASSERT_TRUE(found);
    EXPECT_LE(distance(*found, solution), 1e-12);
  }
  Random random(10);
  int n_found[4] = {};  // open, stick, slip, none
  for (int trial = 0; trial < 1000; ++trial) {
    Node node = at;
    node.c = std::pow(10, random.in(-1, 1));
    const auto found = node.solve({random.in(-1, 1), random.in(-3, 3), random.in(-1, 3), random.in(-3, 3)});
    const int which = !found ? 3 : distance(*found, open) <= 1e-12 ? 0 : distance(*found, stick) <= 1e-12 ? 1 : 2;
    if (which == 2) {
      EXPECT_LE(distance(*found, slip), 1e-12) << trial;
    }
    ++n_found[which];
  }
  EXPECT_GT(n_found[0], 0);
  EXPECT_GT(n_found[1], 0);
  RecordProperty("none", n_found[3]);
}

TEST(KlarbringsNode, HasOneSolutionWithLittleFriction) {
  Random random(11);
  int n_none = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Node node{1, 2.5, random.in(0, 1.9)};
    node.c = std::pow(10, random.in(-1, 1));
    const auto found = node.solve({random.in(-1, 1), random.in(-3, 3), random.in(-1, 3), random.in(-3, 3)});
    n_none += !found;
    if (found) {
      EXPECT_LE(distance(*found, open), 1e-12) << trial;
    }
  }
  EXPECT_LT(n_none, 1000);
  RecordProperty("none", n_none);
}

/// Case C5: no normal load, nothing to divide by.
TEST(KlarbringsNode, HasNoTractionWithoutPressure) {
  for (const double force_t : {0.0, 1e-16, -1e-16, 1e-300})
    for (const double mu : {0.0, 0.3, 3.0}) {
      const auto found = Node{0, force_t, mu}.solve({0, 0, 0, 0});
      ASSERT_TRUE(found) << force_t << ", " << mu;
      for (double x : *found) EXPECT_LE(std::abs(x), 2e-16);
      EXPECT_EQ((*found)[3], 0);
    }
}

}  // namespace
}  // namespace mortise::test
