// Every material: stress and moduli against the energy, against Hooke and against each other.
#include <gtest/gtest.h>

#include "assembly/stress_and_moduli.hpp"
#include "support/gradient_check.hpp"
#include "support/materials.hpp"

namespace mortise::test {
namespace {

template <class M>
std::vector<double> moduli_by_ad(const M& material, const Tensor3<double>& F) {
  Tensor3<double> P;
  double A[9][9];
  stress_and_moduli(material, F, P, A);
  return {&A[0][0], &A[0][0] + 81};
}

template <class M>
class EveryMaterial : public ::testing::Test {
 protected:
  const M material = sample<M>();
  /// The greatest of the moduli at rest [Pa].
  const double stiffness = largest(moduli_by_hand(material, identity<double>()));
  /// Linear elasticity is the one that notices rotations.
  static constexpr bool is_invariant = !std::is_same_v<M, LinearElastic>;
};

TYPED_TEST_SUITE(EveryMaterial, Materials);

TYPED_TEST(EveryMaterial, IsFreeOfStressAndEnergyAtRest) {
  Random random(3);
  std::vector<Tensor3<double>> at_rest{identity<double>()};
  if (this->is_invariant) at_rest.insert(at_rest.end(), {random.rotation(), random.rotation()});
  for (const auto& Q : at_rest) {
    EXPECT_NEAR(this->material.strain_energy(Q), 0, 1e-14 * this->stiffness);
    EXPECT_LE(largest(entries(this->material.first_piola(Q))), 1e-14 * this->stiffness);
  }
}

TYPED_TEST(EveryMaterial, HasAnEnergyUnchangedByRotationOfSpace) {
  Random random(4);
  for (const auto& F : some_deformations()) {
    const double W = this->material.strain_energy(F), turned = this->material.strain_energy(random.rotation() * F);
    if (this->is_invariant) {
      EXPECT_NEAR(turned, W, 1e-13 * (W + this->stiffness));
    } else {
      EXPECT_GT(std::abs(turned - W), 1e-3 * this->stiffness);
    }
  }
}

TYPED_TEST(EveryMaterial, IsIsotropic) {
  Random random(5);
  for (const auto& F : some_deformations()) {
    const double W = this->material.strain_energy(F);
    const auto Q = random.rotation();
    const auto turned = this->is_invariant ? F * Q : transpose_times(Q, F * Q);
    EXPECT_NEAR(this->material.strain_energy(turned), W, 1e-13 * (W + this->stiffness));
  }
}

TYPED_TEST(EveryMaterial, HasAStressThatTurnsWithSpace) {
  Random random(6);
  for (const auto& F : some_deformations()) {
    const auto Q = random.rotation();
    const auto turned = entries(Q * this->material.first_piola(F)), stress = entries(this->material.first_piola(Q * F));
    double difference = 0;
    for (int k = 0; k < 9; ++k) difference = std::max(difference, std::abs(stress[k] - turned[k]));
    if (this->is_invariant) {
      EXPECT_LE(difference, 1e-13 * (largest(turned) + this->stiffness));
    } else {
      EXPECT_GT(difference, 1e-3 * this->stiffness);
    }
  }
}

TYPED_TEST(EveryMaterial, HasAStressThatIsTheDerivativeOfItsEnergy) {
  // beside a constant that is as large as the terms whose difference W is, so that their round-off is expected
  const auto energy = [this](const std::vector<double>& F) {
    return std::vector<double>{this->stiffness + this->material.strain_energy(tensor(F))};
  };
  for (const auto& F : some_deformations())
    EXPECT_TRUE(is_derivative(entries(this->material.first_piola(F)), energy, entries(F)));
}

TYPED_TEST(EveryMaterial, HasModuliThatAreTheDerivativeOfItsStress) {
  const auto stress = [this](const std::vector<double>& F) { return entries(this->material.first_piola(tensor(F))); };
  for (const auto& F : some_deformations()) EXPECT_TRUE(is_derivative(moduli_by_hand(this->material, F), stress, entries(F)));
}

TYPED_TEST(EveryMaterial, HasTheSameModuliByHandAndByAutomaticDifferentiation) {
  for (const auto& all : {some_deformations(), nearly_equal_stretches()})
    for (const auto& F : all) {
      const auto by_hand = moduli_by_hand(this->material, F), by_ad = moduli_by_ad(this->material, F);
      for (int k = 0; k < 81; ++k) EXPECT_NEAR(by_hand[k], by_ad[k], 1e-12 * largest(by_ad));
    }
}

TYPED_TEST(EveryMaterial, HasTheSameStressWithTheModuliAndAlone) {
  for (const auto& F : some_deformations()) {
    Tensor3<double> P;
    double A[9][9];
    this->material.moduli(F, P, A);
    const auto alone = entries(this->material.first_piola(F));
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(entries(P)[k], alone[k], 1e-13 * (largest(alone) + this->stiffness));
  }
}

TYPED_TEST(EveryMaterial, HasADerivativeByComplexStep) {
  using Complex = std::complex<double>;
  constexpr double step = 1e-100;
  for (const auto& F : some_deformations()) {
    const auto A = moduli_by_hand(this->material, F), P = entries(this->material.first_piola(F));
    for (int l = 0; l < 9; ++l) {
      Tensor3<Complex> stepped;
      for (int k = 0; k < 9; ++k) stepped(k / 3, k % 3) = Complex(F(k / 3, k % 3), k == l ? step : 0);
      EXPECT_NEAR(this->material.strain_energy(stepped).imag() / step, P[l], 1e-12 * (largest(P) + this->stiffness));
      const auto stress = this->material.first_piola(stepped);
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(stress(k / 3, k % 3).imag() / step, A[9 * k + l], 1e-12 * largest(A));
    }
  }
}

TYPED_TEST(EveryMaterial, HasSymmetricModuli) {
  for (const auto& F : some_deformations()) {
    const auto A = moduli_by_hand(this->material, F);
    for (int k = 0; k < 9; ++k)
      for (int l = 0; l < k; ++l) EXPECT_NEAR(A[9 * k + l], A[9 * l + k], 1e-14 * largest(A));
  }
}

TYPED_TEST(EveryMaterial, IsHookeAtSmallStrain) {
  const auto A = moduli_by_hand(this->material, identity<double>());
  const Moduli rest = this->material.small_strain();
  // without a volumetric energy the bulk modulus is 0: the stress of the energy of shape is a deviator
  const double mu = rest.shear_modulus(), lambda = is_incompressible<TypeParam>() ? -2 * mu / 3 : rest.lame_lambda();
  EXPECT_GT(mu, 300);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          EXPECT_NEAR(A[9 * (3 * i + j) + 3 * k + l],
                      lambda * (i == j) * (k == l) + mu * ((i == k) * (j == l) + (i == l) * (j == k)),
                      1e-14 * 2 * mu + 1e-14 * std::abs(lambda));
}

TYPED_TEST(EveryMaterial, StoresEverMoreEnergyInEverLargerStretch) {
  double last = 0;
  for (double stretch = 2; stretch < 1e12; stretch *= 10) {
    const double W = this->material.strain_energy(Tensor3<double>{{{stretch, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    EXPECT_GT(W, 2 * last);
    last = W;
  }
}

template <class M>
class SplitMaterial : public EveryMaterial<M> {};
using SplitMaterials = ::testing::Types<NeoHookeanIsochoric, MooneyRivlinIsochoric, NeoHookeanIncompressible,
                                        MooneyRivlinIncompressible, OgdenIncompressible>;
TYPED_TEST_SUITE(SplitMaterial, SplitMaterials);
static_assert(!is_split<NeoHookean> && !is_split<MooneyRivlin> && !is_split<Ogden>);

TYPED_TEST(SplitMaterial, IsTheSumOfAnEnergyOfShapeAndOneOfVolume) {
  static_assert(is_split<TypeParam>);
  const double compliance = this->material.volumetric_compliance();
  EXPECT_EQ(compliance == 0, is_incompressible<TypeParam>());
  for (const auto& F : some_deformations()) {
    auto swollen = F;
    for (int k = 0; k < 9; ++k) swollen(k / 3, k % 3) *= 1.3;
    const double shape = this->material.distortional().strain_energy(F), swelling = det(F) - 1;
    EXPECT_NEAR(this->material.distortional().strain_energy(swollen), shape, 1e-13 * (shape + this->stiffness));
    const double volume = compliance == 0 ? 0 : 0.5 * swelling * swelling / compliance;
    EXPECT_NEAR(this->material.strain_energy(F), shape + volume, 1e-13 * (shape + this->stiffness));
  }
}

template <class M>
class GrowingMaterial : public ::testing::Test {
 protected:
  const M material = sample<M>();
};
using GrowingMaterials = ::testing::Types<NeoHookean, NeoHookeanPowerLaw, MooneyRivlin, Ogden>;
TYPED_TEST_SUITE(GrowingMaterial, GrowingMaterials);

TYPED_TEST(GrowingMaterial, CannotBeCompressedToNothing) {
  double last = 0;
  for (double size = 0.1; size > 1e-10; size *= 0.1) {  // each decade costs more than the one before
    const double W = this->material.strain_energy(Tensor3<double>{{{size, 0, 0}, {0, size, 0}, {0, 0, size}}});
    EXPECT_GT(W, last + moduli.shear_modulus());
    last = W;
  }
}

TEST(NeoHookeanSolid, CannotBeFlattened) {
  double last[2] = {0, 0};
  for (double size = 0.1; size > 1e-90; size *= 0.1) {
    const Tensor3<double> F{{{1, 0, 0}, {0, 1, 0}, {0, 0, size}}};
    const double W[2] = {NeoHookean::from(moduli).strain_energy(F), NeoHookeanIsochoric::from(moduli).strain_energy(F)};
    for (int k = 0; k < 2; ++k) {
      EXPECT_GT(W[k], last[k] + moduli.shear_modulus());
      last[k] = W[k];
    }
  }
}

/// c (I1 - 3) + c/beta (J^(-2 beta) - 1), written as it is printed.
double power_law(double nu, const Tensor3<double>& F) {
  const double c = 2250 / (4 * (1 + nu)), beta = nu / (1 - 2 * nu), J = det(F);
  return c * (norm_squared(F) - 3) + (nu == 0 ? -2 * c * std::log(J) : c / beta * (std::pow(J, -2 * beta) - 1));
}

TEST(NeoHookeanPowerLawSolid, IsThePowerLawAndItsLimit) {
  for (const auto& F : some_deformations()) {
    for (double nu : {-0.4, 0.0, 0.1, 0.3, 0.49})
      EXPECT_NEAR(NeoHookeanPowerLaw::from({2250, nu}).strain_energy(F), power_law(nu, F), 1e-12 * (power_law(nu, F) + 2250));
    EXPECT_NEAR(NeoHookeanPowerLaw::from({2250, 1e-13}).strain_energy(F), power_law(0, F), 1e-12 * 2250);
  }
}

TEST(PowerLawAndThesisNeoHookean, AgreeWithoutLateralContraction) {
  const Moduli cork{2250, 0};
  for (const auto& F : some_deformations()) {
    const auto one = entries(NeoHookeanPowerLaw::from(cork).first_piola(F)),
               other = entries(NeoHookean::from(cork).first_piola(F));
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(one[k], other[k], 1e-13 * (largest(other) + 2250));
  }
}

TEST(ElasticModuli, AreTheSameFromEveryUsualPair) {
  const double mu = moduli.shear_modulus(), lambda = moduli.lame_lambda(), kappa = moduli.bulk_modulus();
  EXPECT_NEAR(kappa, 2250 / (3 * 0.4), 1e-12 * kappa);
  for (const auto& same : {moduli, Moduli::from_shear_and_lambda(mu, lambda), Moduli::from_bulk_and_shear(kappa, mu)}) {
    EXPECT_NEAR(same.youngs_modulus(), 2250, 1e-12 * 2250);
    EXPECT_NEAR(same.poissons_ratio(), 0.3, 1e-12);
    EXPECT_NEAR(same.lame_lambda(), lambda, 1e-12 * lambda);
    EXPECT_NEAR(same.shear_modulus(), mu, 1e-12 * mu);
  }
}

TEST(ElasticModuli, KeepTheirDigitsUpToTheIncompressibleSolid) {
  const Moduli nearly = Moduli::from_bulk_and_shear(1e9, 3);
  EXPECT_DOUBLE_EQ(nearly.bulk_modulus(), 1e9);
  EXPECT_DOUBLE_EQ(nearly.shear_modulus(), 3);
  const Moduli rubber = Moduli::incompressible(3);
  EXPECT_EQ(rubber.poissons_ratio(), 0.5);
  EXPECT_EQ(rubber.youngs_modulus(), 9);
}

}  // namespace
}  // namespace mortise::test
