// Every law of friction: its bound, its derivative in every branch (case C12), what it does at rest and without pressure.
#include <gtest/gtest.h>

#include <Sacado.hpp>
#include <limits>

#include "contact/laws/friction_bound.hpp"
#include "contact/laws/regularised.hpp"
#include "support/random.hpp"

namespace mortise::test {
namespace {

using Fad = Sacado::Fad::SFad<double, 10>;
using Complex = std::complex<double>;
constexpr double dt = 0.2, c = 0.7;
const Vec3<double> up{0, 0, 1}, nothing{0, 0, 0};

template <class T>
FrictionState<T> state_of(const std::array<T, 10>& x) {
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, x[9]};
}

/// A coefficient of pressure and speed; smooth.
template <class T>
T coefficient(const T& p, const T& v) {
  using std::exp;
  return 0.3 + 0.2 * exp(T(-p)) + 0.1 * v / (1.0 + v);
}
FrictionCoefficient coefficient_at(double p, double v) {
  return {coefficient(p, v), coefficient(p, 0.0), -0.2 * std::exp(-p), 0.1 / ((1 + v) * (1 + v))};
}

struct Coulomb {
  static constexpr double mu = 0.8;
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    return exact_stick(at, T(mu * at.pressure), c, status);
  }
};
struct WithoutFriction {
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    return exact_stick(at, T(0.0 * at.pressure), c, status);
  }
};
struct Penalised {
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    return penalised_stick(at, T(0.8 * at.pressure), {0.3, -0.2, 0}, up, 0.7, status);
  }
};
/// A formula is known by value and derivatives; a complex step sees the function itself.
struct Formula {
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    if constexpr (std::is_same_v<T, Fad>) {
      return exact_stick(at, coulomb_bound(at, coefficient_at(value(at.pressure), value(slip_speed(at, dt))), dt), c, status);
    } else {
      return exact_stick(at, T(coefficient(at.pressure, slip_speed(at, dt)) * at.pressure), c, status);
    }
  }
};
struct Tresca {
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    return exact_stick(at, T(tresca_bound(0.9, value(at.pressure) > 0)), c, status);
  }
};
struct Regularised {
  template <class T>
  Vec3<T> operator()(const FrictionState<T>& at, FrictionStatus& status) const {
    return regularised_slip(at, T(0.8 * at.pressure), 0.1 * dt, status);
  }
};

template <class Law>
struct EveryFrictionLaw : testing::Test {};
using FrictionLaws = testing::Types<Coulomb, WithoutFriction, Penalised, Formula, Tresca, Regularised>;
TYPED_TEST_SUITE(EveryFrictionLaw, FrictionLaws);

/// Derivatives by AD against complex steps. @return the greatest difference
template <class Law>
double greatest_difference(const std::array<double, 10>& at) {
  std::array<Fad, 10> x;
  for (int k = 0; k < 10; ++k) x[k] = Fad(10, k, at[k]);
  FrictionStatus status = FrictionStatus::none, unused = status;
  const Vec3<Fad> r = Law()(state_of(x), status);
  double greatest = 0;
  for (int k = 0; k < 10; ++k) {
    constexpr double h = 1e-30;
    std::array<Complex, 10> z;
    for (int l = 0; l < 10; ++l) z[l] = {at[l], l == k ? h : 0.0};
    const Vec3<Complex> stepped = Law()(state_of(z), unused);
    for (int i = 0; i < 3; ++i) {
      const double difference = std::abs(r[i].dx(k) - stepped[i].imag() / h);
      greatest = difference <= greatest ? greatest : difference;  // NaN stays
    }
  }
  return greatest;
}

TYPED_TEST(EveryFrictionLaw, HasTheDerivativeThatAComplexStepFinds) {
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    std::array<double, 10> at;
    for (double& entry : at) entry = random.in(-1, 1);
    at[9] = random.in(0.5, 2);
    EXPECT_LE(greatest_difference<TypeParam>(at), 1e-10) << trial;
  }
  const std::array<double, 10> stick{0.1, 0, 0, 0.2, 0.1, 0, 0, 0, 1, 2}, slip{0.5, 0.2, 0, -2, 0.4, 0, 0, 0, 1, 0.6};
  auto open = slip, hardly = slip, at_the_bound = slip, beyond = slip;
  open[9] = 0;
  hardly[0] = hardly[1] = 1e-13;  // |s| -> 0
  for (auto* kink : {&at_the_bound, &beyond}) (*kink)[0] = (*kink)[1] = (*kink)[4] = 0;
  at_the_bound[3] = -0.8 * 0.6 * (1 - 1e-6);  // both sides of the kink, of those laws whose bound this is
  beyond[3] = -0.8 * 0.6 * (1 + 1e-6);
  for (const auto& at : {stick, slip, open, hardly, at_the_bound, beyond}) EXPECT_LE(greatest_difference<TypeParam>(at), 1e-10);
}

TYPED_TEST(EveryFrictionLaw, IsFiniteAtRestAndWithoutPressure) {
  for (const double p : {0.0, 1e-300, 1e-16, 3.0, -1e-16})
    for (const double s : {0.0, 1e-300, 1e-160, 1e-16, 0.3})
      for (const double t : {0.0, 1e-300, 0.5}) {
        std::array<double, 10> at{s, 0, 0, t, 0, 0, 0, 0, 1, p};
        std::array<Fad, 10> x;
        for (int k = 0; k < 10; ++k) x[k] = Fad(10, k, at[k]);
        FrictionStatus status = FrictionStatus::none;
        const Vec3<Fad> r = TypeParam()(state_of(x), status);
        for (int i = 0; i < 3; ++i) {
          EXPECT_TRUE(std::isfinite(r[i].val()));
          for (int k = 0; k < 10; ++k) EXPECT_TRUE(std::isfinite(r[i].dx(k))) << p << ", " << s << ", " << t << ": " << i << k;
        }
      }
}

/// Traction that a law asks for where the secondary surface slips by `slip`: found by Newton's method from none.
template <class Law>
Vec3<double> traction_of(const Vec3<double>& slip, double p) {
  Vec3<double> t = nothing;
  for (int iteration = 0; iteration < 60; ++iteration) {
    FrictionStatus status = FrictionStatus::none;
    t = t - Law()(FrictionState<double>{slip, t, up, p}, status);
  }
  return t;
}

TEST(CoulombBound, IsTheCoefficientTimesThePressureWithBothItsDerivatives) {
  std::array<double, 10> at{0.03, -0.04, 0, 0, 0, 0, 0, 0, 1, 2};  // speed 0.25
  std::array<Fad, 10> x;
  for (int k = 0; k < 10; ++k) x[k] = Fad(10, k, at[k]);
  const Fad bound = coulomb_bound(state_of(x), {0.3, 0.4, 0.01, -0.2}, dt);
  EXPECT_DOUBLE_EQ(bound.val(), 0.6);
  EXPECT_DOUBLE_EQ(bound.dx(9), 0.3 + 0.01 * 2);
  EXPECT_DOUBLE_EQ(bound.dx(0), 2 * -0.2 * 0.6 / dt);
  EXPECT_DOUBLE_EQ(bound.dx(1), 2 * -0.2 * -0.8 / dt);
}

/// At rest the speed rises the way slip will go: against the traction.
TEST(SlipSpeed, HasADerivativeAtRest) {
  std::array<double, 10> at{0, 0, 0, 3, -4, 0, 0, 0, 1, 2};
  std::array<Fad, 10> x;
  for (int k = 0; k < 10; ++k) x[k] = Fad(10, k, at[k]);
  const Fad speed = slip_speed(state_of(x), dt);
  EXPECT_EQ(speed.val(), 0);
  EXPECT_DOUBLE_EQ(speed.dx(0), -0.6 / dt);
  EXPECT_DOUBLE_EQ(speed.dx(1), 0.8 / dt);
  EXPECT_EQ(speed.dx(3), 0);
}

/// A bound that rises with the speed, by more than c s in the step, does not hold what slips.
TEST(ExactStick, IsDecidedByTheBoundAtRest) {
  const FrictionState<double> sliding{{0.1, 0, 0}, {-1, 0, 0}, up, 2};
  FrictionStatus status = FrictionStatus::none;
  exact_stick(sliding, 50.0, c, status);
  EXPECT_EQ(status, FrictionStatus::stick);
  exact_stick(sliding, 50.0, c, status, 1.0);
  EXPECT_EQ(status, FrictionStatus::slip);
  exact_stick(sliding, 0.5, c, status, 5.0);  // and one that falls with it neither
  EXPECT_EQ(status, FrictionStatus::slip);
}

TEST(TrescaBound, IsThatOfTheDeckWhileClosedAndNoneElse) {
  EXPECT_EQ(tresca_bound(0.9, true), 0.9);
  EXPECT_EQ(tresca_bound(0.9, false), 0);
  const auto pressed = traction_of<Tresca>({0.1, 0, 0}, 1), hardly = traction_of<Tresca>({0.1, 0, 0}, 1e-9),
             open = traction_of<Tresca>({0.1, 0, 0}, 0);
  EXPECT_NEAR(pressed[0], -0.9, 1e-14);
  EXPECT_NEAR(hardly[0], -0.9, 1e-14);
  EXPECT_EQ(open[0], 0);
}

TEST(RegularisedSlip, OpposesTheSlipBelowTheBoundAndReachesItAtSpeed) {
  const double scale = 0.1 * dt, bound = 0.8 * 2;
  EXPECT_NEAR(traction_of<Regularised>({scale, 0, 0}, 2)[0], -bound / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(traction_of<Regularised>({0, -1e4 * scale, 0}, 2)[1], bound, 1e-7);
  EXPECT_NEAR(traction_of<Regularised>({1e-6 * scale, 0, 0}, 2)[0], -1e-6 * bound, 1e-15);
  EXPECT_EQ(norm(traction_of<Regularised>(nothing, 2)), 0);
  EXPECT_EQ(norm(traction_of<Regularised>({1, 1, 0}, 0)), 0);
}

}  // namespace
}  // namespace mortise::test
