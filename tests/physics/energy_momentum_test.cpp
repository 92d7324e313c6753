// The element of energy-momentum schemes: work, momenta and tangents over large
// steps.
#include "physics/formulations/energy_momentum.hpp"

#include <gtest/gtest.h>

#include "support/elements.hpp"
#include "support/materials.hpp"

namespace mortise::test {
namespace {

/// A step of one distorted element, which is strained by some 20 % and turned
/// by up to a third of a turn. The strain in between is another such, or a
/// share of it.
template <class E>
struct ElementStep {
  using Formulation = EnergyMomentum<E>;
  static constexpr int n = 3 * E::n_nodes;
  typename Formulation::Geometry geometry;
  std::vector<double> y_n, y;

  explicit ElementStep(unsigned seed, double share = 1) {
    Random random(seed);
    const Material any = sample<NeoHookean>();
    const OneElement<Standard<E>> one(MaterialLaw::whole(any, ModuliKind::automatic), distorted<E>(random, 0.1));
    geometry = Formulation::geometry(one.X);
    y_n = one.deformed(random, 0);
    y = one.deformed(random, 0);
    for (int k = 0; k < n; ++k) y[k] = y_n[k] + share * (y[k] - y_n[k]);
    const double angle = random.in(-2, 2);
    const Tensor3<double> Q{{{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
    for (int a = 0; a < E::n_nodes; ++a) {
      const auto at = rotate(Q, {y[3 * a], y[3 * a + 1], y[3 * a + 2]});
      for (int i = 0; i < 3; ++i) y[3 * a + i] = at[i] + 0.3 * i;
    }
  }

  std::vector<double> force(const MaterialLaw& law) const {
    std::vector<double> r(n, 0.0);
    const typename Formulation::template Since<MaterialLaw> since{law, y_n.data()};
    return Formulation::add_residual(since, geometry, y.data(), r.data()) ? r : std::vector<double>{};
  }

  /// Row-major; empty if the state is inadmissible.
  std::vector<double> tangent(TangentKind kind, const MaterialLaw& law) const {
    std::vector<double> r(n, 0.0), K(n * n, 0.0);
    const std::vector<double> scale(n, 1.0);
    const typename Formulation::template Since<MaterialLaw> since{law, y_n.data()};
    const bool is_admissible =
        element_tangent<Formulation>(kind, best_step(kind), since, geometry, y.data(), scale.data(), r.data(), K.data());
    const auto f = force(law);
    EXPECT_EQ(is_admissible, !f.empty());
    if (!is_admissible) return {};
    for (int k = 0; k < n; ++k) EXPECT_NEAR(r[k], f[k], 1e-12 * largest(f));
    return K;
  }
};

std::vector<Material> some_materials() {
  return {sample<NeoHookean>(), sample<MooneyRivlin>(), sample<MooneyRivlinIsochoric>(), sample<Ogden>()};
}

MaterialLaw law_of(const Material& material, ModuliKind kind = ModuliKind::analytic) {
  return MaterialLaw::whole(material, kind);
}

template <class E>
class EnergyMomentumElement : public ::testing::Test {};
using Elements = ::testing::Types<Hex8, Hex20, Tet10, Wedge6>;
TYPED_TEST_SUITE(EnergyMomentumElement, Elements);

TYPED_TEST(EnergyMomentumElement, DoesTheWorkThatItsEnergyTakesUp) {
  for (const auto& material : some_materials())
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const double share = seed <= 10 ? 1 : seed <= 20 ? 1e-3 : 1e-7;
      const ElementStep<TypeParam> step(seed, share);
      const auto law = law_of(material);
      const auto f = step.force(law);
      ASSERT_FALSE(f.empty());
      double work = 0, terms = 0;
      for (std::size_t k = 0; k < f.size(); ++k) {
        work += f[k] * (step.y[k] - step.y_n[k]);
        terms += std::abs(f[k] * (step.y[k] - step.y_n[k]));
      }
      const double V_n = Standard<TypeParam>::strain_energy(law, step.geometry, step.y_n.data());
      const double V = Standard<TypeParam>::strain_energy(law, step.geometry, step.y.data());
      EXPECT_GT(std::abs(V - V_n), 1e-4 * share * V);
      EXPECT_NEAR(work, V - V_n, 2e-15 * (terms + V + V_n));
    }
}

TYPED_TEST(EnergyMomentumElement, HasForcesWithoutResultantAndMomentAboutMeanPositions) {
  for (const auto& material : some_materials())
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const double share = seed <= 10 ? 1 : seed <= 20 ? 1e-3 : 1e-7;
      const ElementStep<TypeParam> step(seed, share);
      const auto r = step.force(law_of(material));
      ASSERT_FALSE(r.empty());
      Vec3<double> force{}, moment{};
      double terms = 0;
      for (std::size_t a = 0; a < r.size(); a += 3) {
        const Vec3<double> f{r[a], r[a + 1], r[a + 2]};
        const Vec3<double> x_n{step.y_n[a], step.y_n[a + 1], step.y_n[a + 2]}, x{step.y[a], step.y[a + 1], step.y[a + 2]};
        const Vec3<double> x_m = 0.5 * (x_n + x);
        force = force + f;
        moment = moment + cross(x_m, f);
        terms += norm(f) * (1 + norm(x_m));
      }
      EXPECT_LE(norm(force), 1e-15 * terms);
      EXPECT_LE(norm(moment), 1e-15 * terms);
    }
}

TYPED_TEST(EnergyMomentumElement, HasTheSameTangentByEveryRoute) {
  const std::pair<TangentKind, double> kinds[]{
      {TangentKind::quadrature_point, 0},       {TangentKind::whole_element, 0},
      {TangentKind::complex_step, 0},           {TangentKind::central_differences, 5e-6},
      {TangentKind::forward_differences, 1e-5}, {TangentKind::backward_differences, 1e-5}};
  for (const auto& material : some_materials()) {
    for (double share : {1.0, 1e-3}) {
      const ElementStep<TypeParam> step(7, share);
      const double round_off = 1e-12 + 1e-14 / share * (share < 1);  // over the strain of the step
      const auto K = step.tangent(TangentKind::analytic, law_of(material));
      ASSERT_FALSE(K.empty());
      double skew = 0;
      const int n = step.n;
      for (int k = 0; k < n; ++k)
        for (int l = 0; l < k; ++l) skew = std::max(skew, std::abs(K[k * n + l] - K[l * n + k]));
      EXPECT_GT(skew, 1e-3 * share * largest(K));
      for (auto [kind, tolerance] : kinds) {
        const auto other = step.tangent(kind, law_of(material, ModuliKind::automatic));
        ASSERT_EQ(other.size(), K.size());
        for (std::size_t k = 0; k < K.size(); ++k) {
          ASSERT_NEAR(other[k], K[k], (tolerance + round_off) * largest(K)) << static_cast<int>(kind);
        }
      }
    }
  }
}

/// The step that Newton's method starts from.
TYPED_TEST(EnergyMomentumElement, IsTheDisplacementElementInAStepWithoutMotionWithHalfItsStiffness) {
  constexpr int n = 3 * TypeParam::n_nodes;
  for (const auto& material : some_materials()) {
    ElementStep<TypeParam> step(3);
    step.y = step.y_n;
    const auto law = law_of(material);
    std::vector<double> f(n, 0.0), K(n * n, 0.0);
    ASSERT_TRUE(Standard<TypeParam>::add_tangent(law, step.geometry, step.y.data(), f.data(), K.data()));
    const auto force = step.force(law), tangent = step.tangent(TangentKind::analytic, law);
    for (int k = 0; k < n; ++k) EXPECT_NEAR(force[k], f[k], 1e-13 * largest(f));
    for (int k = 0; k < n * n; ++k) EXPECT_NEAR(tangent[k], 0.5 * K[k], 1e-13 * largest(K));
  }
}

/// Maps the positions at the start of the step by a diagonal tensor.
template <class E>
ElementStep<E> mapped(double x, double y, double z) {
  ElementStep<E> step(2);
  const double factor[3] = {x, y, z};
  for (std::size_t k = 0; k < step.y.size(); ++k) step.y[k] = factor[k % 3] * step.y_n[k];
  return step;
}

TYPED_TEST(EnergyMomentumElement, RefusesStatesThatAreInvertedAtTheEndOrHalfWay) {
  const Material material = sample<NeoHookean>();
  const auto law = law_of(material);
  EXPECT_FALSE(mapped<TypeParam>(1.5, 0.5, 1).force(law).empty());
  for (const auto& step : {mapped<TypeParam>(1, 1, -0.5), mapped<TypeParam>(-3, -0.5, 1)}) {
    EXPECT_TRUE(step.force(law).empty());
    for (auto kind : {TangentKind::quadrature_point, TangentKind::analytic, TangentKind::whole_element, TangentKind::complex_step,
                      TangentKind::central_differences})
      EXPECT_TRUE(step.tangent(kind, law).empty());
  }
  auto step = mapped<TypeParam>(1, 1, 1);
  step.y[1] = std::nan("");
  EXPECT_TRUE(step.force(law).empty());
}

}  // namespace
}  // namespace mortise::test
