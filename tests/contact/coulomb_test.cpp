// Coulomb's law as one semismooth equation: its solutions, its branches, its derivative.
#include "contact/laws/coulomb.hpp"

#include <gtest/gtest.h>

#include <Sacado.hpp>

#include "support/random.hpp"

namespace mortise::test {
namespace {

constexpr double c = 40;
const Vec3<double> up{0, 0, 1}, nothing{0, 0, 0};

double residual(const FrictionState<double>& at, double mu, FrictionStatus expected) {
  FrictionStatus status = FrictionStatus::none;
  const double missed = norm(exact_stick(at, mu * at.pressure, c, status));
  EXPECT_EQ(status, expected);
  return missed;
}

TEST(ExactStick, IsZeroWhereCoulombsLawHolds) {
  EXPECT_EQ(residual({nothing, {1, 2, 0}, up, 10}, 0.3, FrictionStatus::stick), 0);                // below the bound
  EXPECT_NEAR(residual({{-0.3, 0, 0}, {3, 0, 0}, up, 10}, 0.3, FrictionStatus::slip), 0, 1e-15);   // slips against its traction
  EXPECT_EQ(residual({{0.2, 0, 0}, nothing, up, 0}, 0.3, FrictionStatus::slip), 0);                // no pressure, no friction
  EXPECT_EQ(residual({nothing, nothing, up, 0}, 0.3, FrictionStatus::slip), 0);                    // nothing at all: no 0/0
  EXPECT_EQ(residual({{0.2, 0.1, 0}, nothing, up, 5}, 0, FrictionStatus::slip), 0);                // mu = 0
  EXPECT_NEAR(residual({{0, 0.1, 0}, {0, -15, 0}, up, 10}, 1.5, FrictionStatus::slip), 0, 1e-14);  // mu > 1
}

TEST(ExactStick, IsNotZeroElsewhere) {
  EXPECT_GT(residual({{0.01, 0, 0}, {1, 0, 0}, up, 10}, 0.3, FrictionStatus::stick), 1e-3);  // slips below the bound
  EXPECT_GT(residual({nothing, {4, 0, 0}, up, 10}, 0.3, FrictionStatus::slip), 0.5);         // above the bound
  EXPECT_GT(residual({{0.3, 0, 0}, {3, 0, 0}, up, 10}, 0.3, FrictionStatus::slip), 1);       // pushed the way it slips
  EXPECT_GT(residual({nothing, {1, 0, 0.5}, up, 10}, 0.3, FrictionStatus::stick), 1e-3);     // a part along the normal
  EXPECT_GT(residual({{-0.3, 0, 0}, {3, 0, 0.5}, up, 10}, 0.3, FrictionStatus::slip), 0.4);
  EXPECT_GT(residual({{0.1, 0, 0}, {1, 0, 0}, up, 0}, 0.3, FrictionStatus::slip), 0.5);  // traction without pressure
}

TEST(PenalisedStick, IsASpringThatIsLetOutAtTheBound) {
  const Vec3<double> before{-1, 0, 0};
  const auto missed = [&](const Vec3<double>& slip, const Vec3<double>& traction, FrictionStatus expected) {
    FrictionStatus status = FrictionStatus::none;
    const double r = norm(penalised_stick(FrictionState<double>{slip, traction, up, 10}, 3.0, before, up, 100, status));
    EXPECT_EQ(status, expected);
    return r;
  };
  EXPECT_NEAR(missed({0.01, 0, 0}, {-2, 0, 0}, FrictionStatus::stick), 0, 1e-15);
  EXPECT_NEAR(missed({0.5, 0, 0}, {-3, 0, 0}, FrictionStatus::slip), 0, 1e-15);
  EXPECT_GT(missed({0.01, 0, 0}, {-1, 0, 0}, FrictionStatus::stick), 0.5);
}

TEST(TurnedWithTheNormal, ATractionStaysTangentialAndKeepsItsSize) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto Q = random.rotation();
    const Vec3<double> n0 = rotate(Q, up), t = rotate(Q, Vec3<double>{0.6, -0.8, 0});
    Vec3<double> n = n0 + random.vector(0.5);
    n = (1 / norm(n)) * n;
    const Vec3<double> turned = turned_with(n0, n, t);
    EXPECT_NEAR(dot(turned, n), 0, 1e-15);
    EXPECT_NEAR(norm(turned), 1, 1e-14);
  }
}

/// Both laws away from kinks, against central differences (case C12).
TEST(FrictionLaws, HaveTheDerivativeOfTheirBranch) {
  using Fad = Sacado::Fad::SFad<double, 10>;
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    double at[10];
    for (double& entry : at) entry = random.in(-1, 1);
    at[9] = random.in(0.5, 2);
    const auto law = [&](const auto* x, FrictionStatus& status) {
      using T = std::decay_t<decltype(*x)>;
      const FrictionState<T> state{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, x[9]};
      const T bound = 0.8 * x[9];
      return trial % 2 ? exact_stick(state, bound, 0.7, status) : penalised_stick(state, bound, {0.3, -0.2, 0}, up, 0.7, status);
    };
    Fad x[10];
    for (int k = 0; k < 10; ++k) x[k] = Fad(10, k, at[k]);
    FrictionStatus status = FrictionStatus::none, ahead_status = status, behind_status = status;
    const auto r = law(x, status);
    for (int k = 0; k < 10; ++k) {
      constexpr double h = 1e-6;
      double ahead[10], behind[10];
      std::copy_n(at, 10, ahead);
      std::copy_n(at, 10, behind);
      ahead[k] += h;
      behind[k] -= h;
      const auto plus = law(ahead, ahead_status), minus = law(behind, behind_status);
      if (ahead_status != status || behind_status != status) continue;
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(r[i].dx(k), (plus[i] - minus[i]) / (2 * h), 1e-7) << trial << ", " << k;
    }
  }
}

}  // namespace
}  // namespace mortise::test
