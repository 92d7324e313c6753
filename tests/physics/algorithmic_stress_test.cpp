// The algorithmic stress of every objective material, for steps of all sizes: work, symmetry, limits, switches, derivatives.
#include "physics/algorithmic_stress.hpp"

#include <gtest/gtest.h>

#include "assembly/stress_and_moduli.hpp"
#include "support/gradient_check.hpp"
#include "support/materials.hpp"

namespace mortise::test {
namespace {

struct Step {
  Tensor3<double> F_n, F_1;
  Tensor3<double> dF() const { return increment(F_1, F_n); }
  StrainStep<double> strain() const { return {F_n, F_1}; }
  double size() const { return std::sqrt(norm_squared(strain().dC)); }
};

/// Steps from many deformations with |dC| of about a size [-].
std::vector<Step> steps_of_size(double size) {
  Random random(3);
  std::vector<Step> steps;
  for (const auto& F_n : some_deformations()) {
    Tensor3<double> direction;
    for (int k = 0; k < 9; ++k) direction(k / 3, k % 3) = random.in(-1, 1);
    const Tensor3<double> F_dF = transpose_times(F_n, direction);
    Tensor3<double> dC;
    for (int k = 0; k < 9; ++k) dC(k / 3, k % 3) = F_dF(k / 3, k % 3) + F_dF(k % 3, k / 3);
    steps.push_back({F_n, sum(F_n, scaled(size / std::sqrt(norm_squared(dC)), direction))});
  }
  return steps;
}

const std::vector<double> sizes{1e-1, 3e-2, 1e-2, 3e-3,  1e-3,  1e-4,  1e-5,  1e-6,
                                1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};

/// Steps with rho = sqrt(tr (C_m^-1 dC)^2) near a value small against 1 [-].
std::vector<Step> steps_of_strain(double rho) {
  std::vector<Step> steps = steps_of_size(1e-3);
  for (Step& step : steps) {
    const StrainStep<double> strain = step.strain();
    const Tensor3<double> M = scaled(1 / det(strain.C_m), cofactor(strain.C_m) * strain.dC);
    step.F_1 = sum(step.F_n, scaled(rho / std::sqrt((M * M)(0, 0) + (M * M)(1, 1) + (M * M)(2, 2)), step.dF()));
  }
  return steps;
}

double distance(const Tensor3<double>& A, const Tensor3<double>& B) { return std::sqrt(norm_squared(increment(A, B))); }

/// W_1 - W_n [J/m^3] as the work of the stress along the straight line from F_n to F_1: it keeps its digits in steps of any size.
template <class M>
double energy_difference_along_line(const M& material, const Step& step) {
  // Gauss-Legendre, ten points: positive abscissae and weights on [-1, 1]
  constexpr double x[5] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845, 0.9739065285171717};
  constexpr double w[5] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159821, 0.1494513491505806, 0.0666713443086881};
  const Tensor3<double> dF = step.dF(), F_m = step.strain().F_m;
  double work = 0;
  for (int k = 0; k < 5; ++k)
    for (double t : {-0.5 * x[k], 0.5 * x[k]}) work += 0.5 * w[k] * double_dot(material.first_piola(sum(F_m, scaled(t, dF))), dF);
  return work;
}

template <class M>
class AlgorithmicStress : public ::testing::Test {
 protected:
  const M material = sample<M>();
  const double stiffness = 2 * material.small_strain().shear_modulus();
  /// Ogden's energy is found in doubles alone.
  static constexpr bool has_long_double = !std::is_same_v<M, Ogden> && !std::is_same_v<M, OgdenIncompressible>;

  Tensor3<double> P(const Step& step) const { return algorithmic_first_piola(material, step.F_n, step.F_1); }
  Tensor3<double> P(const Step& step, EnergyDifference kind) const {
    return algorithmic_first_piola(material, step.F_n, step.F_1, step.strain(), kind);
  }
  /// Of S(C_m) alone.
  Tensor3<double> P_m(const Step& step) const { return P(step, EnergyDifference::negligible); }

  /// Size of stresses [Pa]: that of the stress, and of moduli where there is none.
  double scale(const Step& step) const { return std::sqrt(norm_squared(P_m(step))) + stiffness; }

  std::vector<double> moduli(const Step& step) const {
    Tensor3<double> stress;
    double A[9][9];
    algorithmic_moduli(material, step.F_n, step.F_1, stress, A);
    EXPECT_LE(distance(stress, P(step)), 1e-12 * scale(step));
    return {&A[0][0], &A[0][0] + 81};
  }
};

using ObjectiveMaterials =
    ::testing::Types<SaintVenantKirchhoff, NeoHookean, NeoHookeanPowerLaw, MooneyRivlin, Ogden, NeoHookeanIsochoric,
                     MooneyRivlinIsochoric, NeoHookeanIncompressible, MooneyRivlinIncompressible, OgdenIncompressible>;
static_assert(std::variant_size_v<Material> == 1 + 10, "a new objective material joins the list; linear elasticity is not one");
TYPED_TEST_SUITE(AlgorithmicStress, ObjectiveMaterials);

TYPED_TEST(AlgorithmicStress, DoesTheWorkThatTheEnergyTakesUp) {
  for (double size : sizes)
    for (const auto& step : steps_of_size(size)) {
      const auto stress = this->P(step);
      const double scale = std::sqrt(norm_squared(stress)) * step.size();
      const double error = std::abs(double_dot(stress, step.dF()) - energy_difference_along_line(this->material, step));
      EXPECT_LE(error, 1e-12 * scale) << size;
    }
}

/// The reference above, against energies in long double, where they have enough digits, and in double.
TYPED_TEST(AlgorithmicStress, IsComparedWithEnergiesThatAreRight) {
  for (double size : sizes)
    for (const auto& step : steps_of_size(size)) {
      const double along = energy_difference_along_line(this->material, step);
      const double direct = this->material.strain_energy(step.F_1) - this->material.strain_energy(step.F_n);
      EXPECT_NEAR(along, direct, 1e-14 * (std::abs(direct) + this->scale(step)));
      if constexpr (TestFixture::has_long_double) {
        Tensor3<long double> F_n, F_1;
        for (int k = 0; k < 9; ++k) {
          F_n(k / 3, k % 3) = step.F_n(k / 3, k % 3);
          F_1(k / 3, k % 3) = step.F_1(k / 3, k % 3);
        }
        const long double exact = this->material.strain_energy(F_1) - this->material.strain_energy(F_n);
        const double tolerance = std::max(1e-12 * size, 1e-17) * this->stiffness;  // long doubles have three digits more
        EXPECT_NEAR(along, static_cast<double>(exact), tolerance) << size;
      }
    }
}

TYPED_TEST(AlgorithmicStress, IsTheStressItselfInAStepWithoutStrain) {
  Random random(4);
  for (const auto& F : some_deformations()) {
    const auto stress = this->material.first_piola(F);
    EXPECT_LE(distance(this->P({F, F}), stress), 1e-14 * this->scale({F, F}));
    const Step turn{F, random.rotation() * F};  // S* = S, and P* = F_m S
    const auto S = scaled(1 / det(F), transpose_times(cofactor(F), stress));
    EXPECT_LE(distance(this->P(turn), turn.strain().F_m * S), 1e-13 * this->scale({F, F}));
  }
}

TYPED_TEST(AlgorithmicStress, DiffersFromTheStressOfTheMeanStrainBySecondOrder) {
  const auto correction = [&](const Step& step) { return distance(this->P(step), this->P_m(step)) / this->scale(step); };
  const auto steps = steps_of_size(4e-4), halves = steps_of_size(2e-4);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (std::is_same_v<TypeParam, SaintVenantKirchhoff>) {  // its energy is quadratic in C: the mean is right
      EXPECT_LE(correction(steps[k]), 1e-14);
    } else {
      ASSERT_GT(correction(steps[k]), 1e-11);
      EXPECT_NEAR(correction(steps[k]) / correction(halves[k]), 4, 0.1);
    }
  }
  for (double size : sizes)
    for (const auto& step : steps_of_size(size)) EXPECT_LE(correction(step), 12 * size * size + 1e-15) << size;
}

TYPED_TEST(AlgorithmicStress, IsSymmetric) {
  for (double size : sizes)
    for (const auto& step : steps_of_size(size)) {
      const auto tau = times_transpose(this->P(step), step.strain().F_m);
      for (auto [i, j] : {std::pair{0, 1}, {1, 2}, {2, 0}})
        EXPECT_LE(std::abs(tau(i, j) - tau(j, i)), 4e-15 * std::sqrt(norm_squared(tau))) << size;
    }
}

TYPED_TEST(AlgorithmicStress, TurnsWithSpace) {
  Random random(5);
  for (double size : {1e-1, 1e-3, 1e-12})
    for (const auto& step : steps_of_size(size)) {
      const auto Q = random.rotation(), stress = this->P(step);
      EXPECT_LE(distance(this->P({Q * step.F_n, Q * step.F_1}), Q * stress), 1e-12 * this->scale(step));
    }
}

TYPED_TEST(AlgorithmicStress, HasNoJumpWhereTheEnergyIsFoundAnotherWay) {
  double upper = 0, lower = 0;
  for (double rho : {4e-3, 5e-3, 6e-3})
    for (const auto& step : steps_of_strain(rho)) {
      const auto one = this->P(step, EnergyDifference::quadrature), other = this->P(step, EnergyDifference::direct);
      upper = std::max(upper, distance(one, other) / this->scale(step));
    }
  for (double rho : {0.8e-8, 1e-8, 1.2e-8})
    for (const auto& step : steps_of_strain(rho))
      lower = std::max(lower, distance(this->P(step, EnergyDifference::quadrature), this->P_m(step)) / this->scale(step));
  EXPECT_LE(upper, 1e-12);
  EXPECT_LE(lower, 4e-15);
}

TYPED_TEST(AlgorithmicStress, HasModuliThatAreItsDerivative) {
  for (const auto& step : steps_of_size(0.1)) {
    // It has the round-off of energies over |dC|: beside a constant of that size it is expected.
    const auto stress = [&](const std::vector<double>& F) {
      auto P = entries(this->P({step.F_n, tensor(F)}));
      for (double& entry : P) entry += this->scale(step) / 0.1;
      return P;
    };
    EXPECT_TRUE(is_derivative(this->moduli(step), stress, entries(step.F_1), {1e-3}));
  }
}

/// By AD and by complex step. Both, like the closed form, divide differences of stresses by |dC|: round-off is eps |S| / |dC|,
/// until the correction is left out, and its derivative of about |dC| with it. For Newton's method that is as good as exact.
TYPED_TEST(AlgorithmicStress, HasTheSameModuliByEveryRoute) {
  using Fad = Sacado::CacheFad::SFad<double, 10>;
  using Complex = std::complex<double>;
  constexpr double h = 1e-100;
  for (double size : sizes)
    for (const auto& step : steps_of_size(size)) {
      const auto A = this->moduli(step);
      const StrainStep<double> strain = step.strain();
      const bool has_correction = energy_difference(strain.C_m, strain.dC) != EnergyDifference::negligible;
      const double tolerance = (has_correction ? 2e-11 + 5e-15 / size : 1e-13) * largest(A);
      Tensor3<Fad> F_ad;
      for (int k = 0; k < 9; ++k) {
        F_ad(k / 3, k % 3).val() = step.F_1(k / 3, k % 3);
        F_ad(k / 3, k % 3).fastAccessDx(k) = 1;
      }
      const auto P_ad = algorithmic_first_piola(this->material, step.F_n, F_ad);
      for (int l = 0; l < 9; ++l) {
        Tensor3<Complex> F_c;
        for (int k = 0; k < 9; ++k) F_c(k / 3, k % 3) = Complex(step.F_1(k / 3, k % 3), k == l ? h : 0);
        const auto P_c = algorithmic_first_piola(this->material, step.F_n, F_c);
        for (int k = 0; k < 9; ++k) {
          EXPECT_NEAR(A[9 * k + l], P_ad(k / 3, k % 3).fastAccessDx(l), tolerance) << size;
          EXPECT_NEAR(A[9 * k + l], P_c(k / 3, k % 3).imag() / h, tolerance) << size;
        }
      }
    }
}

TEST(EnergyDifferenceOfAStep, IsFoundInTheWayThatSuitsItsSize) {
  const auto way = [](double strain) {
    const Tensor3<double> C{{{2, 0, 0}, {0, 3, 0}, {0, 0, 0.1}}};
    return energy_difference(C, scaled(strain / std::sqrt(3.0), C));
  };
  EXPECT_EQ(way(0), EnergyDifference::negligible);
  EXPECT_EQ(way(0.9e-8), EnergyDifference::negligible);
  EXPECT_EQ(way(-1.1e-8), EnergyDifference::quadrature);
  EXPECT_EQ(way(4.9e-3), EnergyDifference::quadrature);
  EXPECT_EQ(way(-5.1e-3), EnergyDifference::direct);
}

}  // namespace
}  // namespace mortise::test
