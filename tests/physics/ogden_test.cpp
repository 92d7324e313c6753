// Ogden's solids against those they contain, nearly equal principal stretches included; the stretches themselves.
#include <gtest/gtest.h>

#include <Sacado.hpp>

#include "support/materials.hpp"

namespace mortise::test {
namespace {

/// Energy, stress and moduli of two materials agree. @param tolerance relative to the greatest of the moduli
template <class One, class Other>
void expect_same(const One& one, const Other& other, const Tensor3<double>& F, double tolerance) {
  const auto A = moduli_by_hand(other, F), A_one = moduli_by_hand(one, F);
  const auto P = entries(other.first_piola(F)), P_one = entries(one.first_piola(F));
  EXPECT_NEAR(one.strain_energy(F), other.strain_energy(F), tolerance * largest(A));
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(P_one[k], P[k], tolerance * largest(A));
  for (int k = 0; k < 81; ++k) EXPECT_NEAR(A_one[k], A[k], tolerance * largest(A));
}

TEST(OgdenSolid, WithTheExponentTwoIsNeoHookean) {
  for (const auto& all : {some_deformations(), nearly_equal_stretches()})
    for (const auto& F : all) expect_same(OgdenIncompressible{{{{800, 2}}}}, NeoHookeanIncompressible{{800}}, F, 1e-12);
}

TEST(OgdenSolid, WithTheExponentsTwoAndMinusTwoIsMooneyRivlin) {
  for (const auto& all : {some_deformations(), nearly_equal_stretches()})
    for (const auto& F : all)
      expect_same(OgdenIncompressible{{{{600, 2}, {-240, -2}}}}, MooneyRivlinIncompressible{{300, 120}}, F, 1e-12);
}

TEST(OgdenSolid, IsTheSameHoweverItsTermsAreShared) {
  const OgdenDistortional one{{{630, 1.3}, {12, 5}}}, other{{{12, 5}, {600, 1.3}, {30, 1.3}}};
  for (const auto& F : some_deformations()) expect_same(other, one, F, 1e-13);
}

TEST(OgdenSolid, HasTwiceItsShearModulusAsTheSumOfModuliTimesExponents) {
  EXPECT_DOUBLE_EQ(sample<Ogden>().small_strain().shear_modulus(), 0.5 * (630 * 1.3 + 12 * 5 + 100 * 2));
}

TEST(OgdenSolid, HasAVolumetricEnergyOfAnyExponent) {
  const auto volumetric = [](double exponent, double J) {
    const double size = std::cbrt(J);
    return Ogden{ogden_terms, 1, exponent}.strain_energy(Tensor3<double>{{{size, 0, 0}, {0, size, 0}, {0, 0, size}}});
  };
  for (double J : {0.3, 0.9, 1 + 1e-7, 1.2, 3.0}) {
    const double log_J = std::log(J);
    EXPECT_NEAR(volumetric(0, J), 0.5 * log_J * log_J, 1e-12);
    EXPECT_NEAR(volumetric(1e-12, J), 0.5 * log_J * log_J, 1e-11 * std::abs(log_J * log_J * log_J) + 1e-12);
    EXPECT_NEAR(volumetric(-2, J), 0.25 * (J * J - 1) - 0.5 * log_J, 1e-12);
    EXPECT_NEAR(volumetric(9, J), log_J / 9 + (std::pow(J, -9) - 1) / 81, 1e-12 * std::pow(J, -9) + 1e-12);
  }
}

TEST(OgdenSolid, HasDerivativesInAsManyDirectionsAsAnElementNeeds) {
  using Fad = Sacado::Fad::SFad<double, 24>;
  const auto material = sample<Ogden>();
  for (const auto& F : some_deformations()) {
    Tensor3<Fad> F_ad;
    for (int k = 0; k < 9; ++k) F_ad(k / 3, k % 3) = Fad(24, 2 * k + 3, F(k / 3, k % 3));
    const auto P_ad = material.first_piola(F_ad);
    const Fad W_ad = material.strain_energy(F_ad);
    const auto A = moduli_by_hand(material, F), P = entries(material.first_piola(F));
    for (int k = 0; k < 9; ++k) {
      EXPECT_NEAR(W_ad.dx(2 * k + 3), P[k], 1e-12 * largest(A));
      for (int l = 0; l < 9; ++l) EXPECT_NEAR(P_ad(k / 3, k % 3).dx(2 * l + 3), A[9 * k + l], 1e-12 * largest(A));
      EXPECT_EQ(P_ad(k / 3, k % 3).dx(0), 0);
    }
  }
}

double distance(const Tensor3<double>& A, const Tensor3<double>& B) {
  double size = 0;
  for (int k = 0; k < 9; ++k) size = std::max(size, std::abs(A(k / 3, k % 3) - B(k / 3, k % 3)));
  return size;
}

TEST(PrincipalStretches, MakeUpTheDeformationAndAreOrthogonal) {
  for (const auto& all : {some_deformations(), nearly_equal_stretches(), {identity<double>()}})
    for (const auto& F : all) {
      const auto s = principal_stretches(F);
      EXPECT_LE(distance(stress_along(s, s.stretch), F), 1e-14 * largest(entries(F)));
      EXPECT_LE(distance(transpose_times(s.n, s.n), identity<double>()), 1e-14);
      EXPECT_LE(distance(transpose_times(s.N, s.N), identity<double>()), 1e-14);
      for (double stretch : s.stretch) EXPECT_GT(stretch, 0);
    }
}

TEST(PrincipalStretches, AreExactToRoundOffWhereTheyAreFarApart) {
  Random random(8);
  for (int n = 0; n < 20; ++n) {
    // columns of very different length: the smallest stretch is lost if C = F^T F is formed
    const auto F = random.rotation() * Tensor3<double>{{{1e6, 0, 0}, {0, 1, 0}, {0, 0, 1e-6}}};
    auto s = principal_stretches(F);
    std::sort(s.stretch, s.stretch + 3);
    EXPECT_NEAR(s.stretch[0], 1e-6, 1e-20);
    EXPECT_NEAR(s.stretch[1], 1, 1e-14);
    EXPECT_NEAR(s.stretch[2], 1e6, 1e-8);
  }
}

}  // namespace
}  // namespace mortise::test
