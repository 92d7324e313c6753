// Measures of stress and strain: states known by hand, what rotations do to them, and how they hang together.
#include "physics/stress_and_strain.hpp"

#include <gtest/gtest.h>

#include "support/materials.hpp"

namespace mortise::test {
namespace {

void expect_equal(const Tensor3<double>& A, const Tensor3<double>& B, double size = 1) {
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(A(k / 3, k % 3), B(k / 3, k % 3), 1e-13 * size) << "component " << k;
}

Tensor3<double> turned(const Tensor3<double>& Q, const Tensor3<double>& A) { return times_transpose(Q * A, Q); }

Tensor3<double> diagonal(double a, double b, double c) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}; }

const NeoHookean solid = sample<NeoHookean>();
const double stiffness = moduli.youngs_modulus();

TEST(StrainMeasures, OfAStretchAreThoseOfTheLengths) {
  const auto F = diagonal(1.5, 0.8, 1);
  expect_equal(green_lagrange_strain(F), diagonal((1.5 * 1.5 - 1) / 2, (0.64 - 1) / 2, 0));
  expect_equal(almansi_strain(F), diagonal((1 - 1 / 2.25) / 2, (1 - 1 / 0.64) / 2, 0));
}

TEST(StrainMeasures, OfSimpleShearAreThoseOfTheTextbook) {
  const double g = 0.7;
  const Tensor3<double> F{{{1, g, 0}, {0, 1, 0}, {0, 0, 1}}};
  expect_equal(green_lagrange_strain(F), {{{0, g / 2, 0}, {g / 2, g * g / 2, 0}, {0, 0, 0}}});
  expect_equal(almansi_strain(F), {{{0, g / 2, 0}, {g / 2, -g * g / 2, 0}, {0, 0, 0}}});
}

TEST(StrainMeasures, OfARotationVanish) {
  Random random(1);
  for (int k = 0; k < 10; ++k) {
    const auto Q = random.rotation();
    expect_equal(green_lagrange_strain(Q), {});
    expect_equal(almansi_strain(Q), {});
  }
}

TEST(StrainMeasures, AreConnectedByTheDeformationGradient) {
  for (const auto& F : some_deformations()) expect_equal(green_lagrange_strain(F), transpose_times(F, almansi_strain(F) * F), 10);
}

TEST(StressMeasures, AreConnectedByTheDeformationGradient) {
  for (const auto& F : some_deformations()) {
    const double J = det(F);
    const auto P = solid.first_piola(F), S = second_piola_stress(P, F), sigma = cauchy_stress(P, F);
    expect_equal(F * S, P, 10 * stiffness);
    expect_equal(scaled(J, sigma), times_transpose(P, F), 10 * stiffness);
    expect_equal(scaled(J, sigma), times_transpose(F * S, F), 10 * stiffness);
    expect_equal(kirchhoff_stress(P, F), scaled(J, sigma), 10 * stiffness);
  }
}

// Compressible neo-Hooke (thesis eq. 3.130): S = mu (I - C^-1) + lambda ln J C^-1, tau = mu (b - I) + lambda ln J I.
TEST(StressMeasures, OfNeoHookeAreThoseOfTheClosedForms) {
  const double mu = moduli.shear_modulus(), lambda = solid.lame_lambda, l = 1.3, m = 0.9, log_J = std::log(l * m * m);
  const auto F = diagonal(l, m, m);
  const auto P = solid.first_piola(F);
  const auto S = [&](double stretch) { return mu * (1 - 1 / (stretch * stretch)) + lambda * log_J / (stretch * stretch); };
  const auto tau = [&](double stretch) { return mu * (stretch * stretch - 1) + lambda * log_J; };
  expect_equal(second_piola_stress(P, F), diagonal(S(l), S(m), S(m)), stiffness);
  expect_equal(kirchhoff_stress(P, F), diagonal(tau(l), tau(m), tau(m)), stiffness);
  expect_equal(cauchy_stress(P, F), scaled(1 / (l * m * m), diagonal(tau(l), tau(m), tau(m))), stiffness);
}

TEST(StressAndStrainMeasures, FollowARotationOrDoNotNoticeIt) {
  Random random(3);
  for (const auto& F : some_deformations()) {
    const auto Q = random.rotation(), QF = Q * F;
    const auto P = solid.first_piola(F), QP = solid.first_piola(QF);
    expect_equal(green_lagrange_strain(QF), green_lagrange_strain(F), 10);
    expect_equal(second_piola_stress(QP, QF), second_piola_stress(P, F), 100 * stiffness);
    expect_equal(almansi_strain(QF), turned(Q, almansi_strain(F)), 10);
    expect_equal(cauchy_stress(QP, QF), turned(Q, cauchy_stress(P, F)), 10 * stiffness);
    expect_equal(kirchhoff_stress(QP, QF), turned(Q, kirchhoff_stress(P, F)), 10 * stiffness);
    EXPECT_NEAR(von_mises(cauchy_stress(QP, QF)), von_mises(cauchy_stress(P, F)), 1e-12 * stiffness);
  }
}

TEST(VonMises, IsTheStressOfATensionAndRootThreeTimesThatOfAShear) {
  EXPECT_DOUBLE_EQ(von_mises(diagonal(0, -5, 0)), 5);
  EXPECT_DOUBLE_EQ(von_mises({{{0, 2, 0}, {2, 0, 0}, {0, 0, 0}}}), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(von_mises({{{7, 0, 3}, {0, 7, 0}, {3, 0, 7}}}), 3 * std::sqrt(3.0));  // pressure does not count
}

TEST(PrincipalAxes, OfPureShearLieAtFortyFiveDegrees) {
  const double h = std::sqrt(0.5);
  const auto axes = principal_axes({{{0, 2, 0}, {2, 0, 0}, {0, 0, 0}}});
  const double values[3] = {2, 0, -2};
  const Vec3<double> directions[3] = {{h, h, 0}, {0, 0, 1}, {h, -h, 0}};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(axes.values[k], values[k], 1e-14);
    EXPECT_LT(norm(axes.directions[k] - directions[k]), 1e-14);
  }
}

/// sum_k values_k directions_k (x) directions_k
Tensor3<double> rebuilt(const PrincipalAxes& axes) {
  Tensor3<double> A{};
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 9; ++l) A(l / 3, l % 3) += axes.values[k] * axes.directions[k][l / 3] * axes.directions[k][l % 3];
  return A;
}

TEST(PrincipalAxes, AreOrderedOrthogonalAndRebuildTheTensor) {
  Random random(4);
  std::vector<Tensor3<double>> tensors{diagonal(0, 0, 0), diagonal(3, 3, 3)};
  for (int k = 0; k < 20; ++k) {
    const double a = random.in(-1, 1), b = k % 4 == 0 ? a : random.in(-1, 1);  // also values that coincide
    tensors.push_back(turned(random.rotation(), diagonal(a, b, random.in(-1, 1))));
  }
  for (const auto& A : tensors) {
    const auto axes = principal_axes(A);
    EXPECT_GE(axes.values[0], axes.values[1]);
    EXPECT_GE(axes.values[1], axes.values[2]);
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) EXPECT_NEAR(dot(axes.directions[k], axes.directions[l]), k == l, 1e-14);
    expect_equal(rebuilt(axes), A, 10);
    for (const auto& v : axes.directions) {
      int i = 0;
      while (std::abs(v[i]) <= 1e-6) ++i;
      EXPECT_GT(v[i], 0) << "the sign that the docstring promises";
    }
  }
}

TEST(PrincipalAxes, TurnWithTheTensorAndKeepTheirValues) {
  Random random(5);
  for (int k = 0; k < 10; ++k) {
    const auto A = turned(random.rotation(), diagonal(3, 1, -2)), Q = random.rotation();
    const auto before = principal_axes(A), after = principal_axes(turned(Q, A));
    for (int l = 0; l < 3; ++l) {
      EXPECT_NEAR(after.values[l], before.values[l], 1e-13);
      EXPECT_NEAR(std::abs(dot(after.directions[l], rotate(Q, before.directions[l]))), 1, 1e-13);
    }
  }
}

}  // namespace
}  // namespace mortise::test
