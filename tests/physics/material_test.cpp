// Every material: stress and moduli against the energy, against Hooke and against independent values.
#include <gtest/gtest.h>

#include "assembly/element_tangent.hpp"
#include "benchmarks/analytic_tangent.hpp"
#include "physics/materials/materials.hpp"
#include "support/gradient_check.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

const Moduli moduli{2250, 0.3};  // those of the references

Tensor3<double> tensor(const std::vector<double>& entries) {
  Tensor3<double> F;
  for (int k = 0; k < 9; ++k) F(k / 3, k % 3) = entries[k];
  return F;
}

std::vector<double> entries(const Tensor3<double>& F) { return {&F.a[0][0], &F.a[0][0] + 9}; }

double largest(const std::vector<double>& x) {
  double size = 0;
  for (double entry : x) size = std::max(size, std::abs(entry));
  return size;
}

/// Deformation gradients with 0.3 < J < 3: a random stretch, turned.
std::vector<Tensor3<double>> some_deformations() {
  Random random(2);
  std::vector<Tensor3<double>> all;
  while (all.size() < 20) {
    Tensor3<double> F = identity<double>();
    for (int k = 0; k < 9; ++k) F(k / 3, k % 3) += random.in(-0.4, 0.4);
    if (det(F) > 0.3 && det(F) < 3) all.push_back(random.rotation() * F);
  }
  return all;
}

template <class M>
std::vector<double> moduli_of(const M& material, const Tensor3<double>& F) {
  Tensor3<double> P;
  double A[9][9];
  stress_and_moduli(material, F, P, A);
  return {&A[0][0], &A[0][0] + 81};
}

template <class M>
class EveryMaterial : public ::testing::Test {
 protected:
  const M material = M::from(moduli);
};

using Materials = ::testing::Types<NeoHookean, NeoHookeanIsochoric, SaintVenantKirchhoff>;
TYPED_TEST_SUITE(EveryMaterial, Materials);

TYPED_TEST(EveryMaterial, IsFreeOfStressAndEnergyAtRest) {
  Random random(3);
  for (const auto& Q : {identity<double>(), random.rotation(), random.rotation()}) {
    EXPECT_NEAR(this->material.strain_energy(Q), 0, 1e-14 * moduli.youngs_modulus());
    EXPECT_LE(largest(entries(this->material.first_piola(Q))), 1e-14 * moduli.youngs_modulus());
  }
}

TYPED_TEST(EveryMaterial, HasAnEnergyUnchangedByRotationOfSpace) {
  Random random(4);
  for (const auto& F : some_deformations()) {
    const double W = this->material.strain_energy(F);
    EXPECT_NEAR(this->material.strain_energy(random.rotation() * F), W, 1e-13 * (W + moduli.youngs_modulus()));
  }
}

TYPED_TEST(EveryMaterial, IsIsotropic) {
  Random random(5);
  for (const auto& F : some_deformations()) {
    const double W = this->material.strain_energy(F);
    EXPECT_NEAR(this->material.strain_energy(F * random.rotation()), W, 1e-13 * (W + moduli.youngs_modulus()));
  }
}

TYPED_TEST(EveryMaterial, HasAStressThatTurnsWithSpace) {
  Random random(6);
  for (const auto& F : some_deformations()) {
    const auto Q = random.rotation();
    const auto turned = entries(Q * this->material.first_piola(F)), stress = entries(this->material.first_piola(Q * F));
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(stress[k], turned[k], 1e-13 * (largest(turned) + moduli.youngs_modulus()));
  }
}

TYPED_TEST(EveryMaterial, HasAStressThatIsTheDerivativeOfItsEnergy) {
  const auto energy = [this](const std::vector<double>& F) {
    return std::vector<double>{this->material.strain_energy(tensor(F))};
  };
  for (const auto& F : some_deformations())
    EXPECT_TRUE(is_derivative(entries(this->material.first_piola(F)), energy, entries(F)));
}

TYPED_TEST(EveryMaterial, HasModuliThatAreTheDerivativeOfItsStress) {
  const auto stress = [this](const std::vector<double>& F) { return entries(this->material.first_piola(tensor(F))); };
  for (const auto& F : some_deformations()) EXPECT_TRUE(is_derivative(moduli_of(this->material, F), stress, entries(F)));
}

TYPED_TEST(EveryMaterial, HasSymmetricModuli) {
  for (const auto& F : some_deformations()) {
    const auto A = moduli_of(this->material, F);
    for (int k = 0; k < 9; ++k)
      for (int l = 0; l < k; ++l) EXPECT_NEAR(A[9 * k + l], A[9 * l + k], 1e-14 * largest(A));
  }
}

TYPED_TEST(EveryMaterial, IsHookeAtSmallStrain) {
  const auto A = moduli_of(this->material, identity<double>());
  const double mu = moduli.shear_modulus(), lambda = moduli.lame_lambda();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          EXPECT_NEAR(A[9 * (3 * i + j) + 3 * k + l],
                      lambda * (i == j) * (k == l) + mu * ((i == k) * (j == l) + (i == l) * (j == k)),
                      1e-14 * 2 * mu + 1e-14 * lambda);
}

TYPED_TEST(EveryMaterial, StoresEverMoreEnergyInEverLargerStretch) {
  double last = 0;
  for (double stretch = 2; stretch < 1e12; stretch *= 10) {
    const double W = this->material.strain_energy(Tensor3<double>{{{stretch, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    EXPECT_GT(W, 2 * last);
    last = W;
  }
}

TEST(NeoHookeanSolid, CannotBeCompressedToNothing) {
  const auto material = NeoHookean::from(moduli);
  double last = 0;
  for (double size = 0.1; size > 1e-90; size *= 0.1) {  // each decade costs more than the one before
    const double W = material.strain_energy(Tensor3<double>{{{size, 0, 0}, {0, size, 0}, {0, 0, size}}});
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

/// Energy, stress and moduli at the 16 deformation gradients of the references, from 80-digit differences of the energy alone.
template <class M>
void expect_reference_values(const M& material, const std::string& name) {
  if (!have_reference("materials.json")) GTEST_SKIP() << no_reference("materials.json");
  const auto values = reference("materials.json");
  ASSERT_DOUBLE_EQ(values["parameters"]["E"].get<double>(), moduli.youngs_modulus());
  ASSERT_DOUBLE_EQ(values["parameters"]["nu"].get<double>(), moduli.poissons_ratio());
  int n_compared = 0;
  for (const auto& [label, rows] : values["F"].items()) {
    const auto& expected = values["results"][name + "|" + label];
    std::vector<double> F, A;
    for (const auto& row : rows)
      for (const auto& entry : row) F.push_back(entry);
    for (const auto& row : expected["A"])
      for (const auto& entry : row) A.push_back(entry);
    const std::vector<double> P = expected["P"];
    ASSERT_EQ(A.size(), 81U);
    const double tolerance = 1e-12 * largest(A) * largest(F);
    EXPECT_NEAR(material.strain_energy(tensor(F)), double(expected["W"]), tolerance) << label;
    const auto stress = entries(material.first_piola(tensor(F))), tangent = moduli_of(material, tensor(F));
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(stress[k], P[k], tolerance) << label;
    for (int k = 0; k < 81; ++k) EXPECT_NEAR(tangent[k], A[k], 1e-12 * largest(A)) << label;
    ++n_compared;
  }
  EXPECT_EQ(n_compared, 16);
}

TEST(SaintVenantKirchhoffSolid, HasTheReferenceValues) { expect_reference_values(SaintVenantKirchhoff::from(moduli), "svk"); }

TEST(NeoHookeanSolid, HasTheReferenceValues) { expect_reference_values(NeoHookean::from(moduli), "neo_hooke"); }

}  // namespace
}  // namespace mortise::test
