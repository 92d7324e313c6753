// Every formulation on every element: shape functions, rigid motions, and residual and tangent by every route.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "physics/traction.hpp"
#include "support/elements.hpp"
#include "support/gradient_check.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

const Moduli moduli{2250, 0.3};

double largest(const std::vector<double>& x) {
  double size = 0;
  for (double entry : x) size = std::max(size, std::abs(entry));
  return size;
}

template <class F>
class EveryElement : public ::testing::Test {
 protected:
  using Formulation = F;
  using Element = typename F::Element;
  static constexpr bool is_mixed = F::n_pressures > 0;

  /// Materials that the formulation takes.
  static std::vector<Material> materials() {
    std::vector<Material> some{NeoHookeanIsochoric::from(moduli), MooneyRivlinIsochoric{{500, 100}, 2000}};
    if (is_mixed) {
      some.push_back(NeoHookeanIncompressible{{moduli.shear_modulus()}});
    } else {
      some.push_back(NeoHookean::from(moduli));
      some.push_back(Ogden{{{{630, 1.3}, {1.2, 5}, {-10, -2}}}, 900, 9});
    }
    return some;
  }

  static MaterialLaw law(const Material& material, ModuliKind kind = ModuliKind::automatic) {
    return is_mixed ? MaterialLaw::distortional(material, kind) : MaterialLaw::whole(material, kind);
  }

  static OneElement<F> element(const Material& material, double distortion = 0.1) {
    Random random(1);
    return {law(material), distorted<Element>(random, distortion)};
  }
};

TYPED_TEST_SUITE(EveryElement, Formulations);

TYPED_TEST(EveryElement, HasShapeFunctionsThatSumToOneAndBelongToOneNodeEach) {
  using Element = typename TypeParam::Element;
  for (const auto& point : Element::mass_rule) {
    double sum = 0, slope[3] = {};
    for (int a = 0; a < Element::n_nodes; ++a) {
      sum += Element::N(a, point.xi);
      for (int i = 0; i < 3; ++i) slope[i] += Element::dN_dxi(a, point.xi)[i];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    for (double s : slope) EXPECT_NEAR(s, 0, 1e-14);
  }
  for (int a = 0; a < Element::n_nodes; ++a)
    for (int b = 0; b < Element::n_nodes; ++b)
      EXPECT_EQ(Element::N(a, {Element::node[b][0], Element::node[b][1], Element::node[b][2]}), a == b) << a << ' ' << b;
}

TYPED_TEST(EveryElement, HasGradientsThatAreTheDerivativesOfItsShapeFunctions) {
  using Element = typename TypeParam::Element;
  for (const auto& point : Element::stiffness_rule) {
    const std::vector<double> xi(point.xi.begin(), point.xi.end());
    for (int a = 0; a < Element::n_nodes; ++a) {
      const auto dN = Element::dN_dxi(a, point.xi);
      for (int i = 0; i < 3; ++i) {  // central differences are exact to second order, and N is at most cubic along an axis
        constexpr double h = 1e-3;
        auto plus = point.xi, minus = point.xi;
        plus[i] += h, minus[i] -= h;
        EXPECT_NEAR((Element::N(a, plus) - Element::N(a, minus)) / (2 * h), dN[i], 1e-6);
      }
    }
  }
}

TYPED_TEST(EveryElement, HasMassAndVolumeThatAgreeOnStraightEdges) {
  using Element = typename TypeParam::Element;
  Random random(3);
  const auto X = distorted<Element>(random, 0.1);
  const auto M = mass_matrix<Element>(X, Element::mass_rule);
  double sum = 0;
  for (double entry : M) sum += entry;
  const double V = volume(reference_geometry<Element>(X));
  EXPECT_GT(V, 0);
  // The one-point rule of tet4 and all Gauss rules integrate the determinant of straight edges exactly.
  EXPECT_NEAR(sum, V, 1e-14 * V * (std::is_same_v<Element, Wedge6> ? 1 : 10));
  double lumped = 0;
  for (double m : lumped_mass<Element>(M)) {
    EXPECT_GT(m, 0);
    lumped += m;
  }
  EXPECT_NEAR(lumped, V, 1e-13 * V);
}

TYPED_TEST(EveryElement, SeesALinearMotionExactly) {
  Random random(2);
  Tensor3<double> F = identity<double>();
  for (int k = 0; k < 9; ++k) F(k / 3, k % 3) += random.in(-0.3, 0.3);
  for (const auto& material : this->materials()) {
    const auto one = this->element(material);
    auto x = one.at_rest();
    for (std::size_t a = 0; a < one.X.size(); ++a)
      for (int i = 0; i < 3; ++i) x[3 * a + i] = 5 + F(i, 0) * one.X[a][0] + F(i, 1) * one.X[a][1] + F(i, 2) * one.X[a][2];
    int n_points = 0;
    one.block.sample(x.data(), [&](const PointSample& at) {
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(at.state.F(k / 3, k % 3), F(k / 3, k % 3), 1e-12);
      ++n_points;
    });
    EXPECT_EQ(n_points, static_cast<int>(TypeParam::Element::stiffness_rule.size()));
  }
}

TYPED_TEST(EveryElement, HasExactlySixModesWithoutStiffnessAtRest) {
  for (const auto& material : this->materials()) {
    const auto one = this->element(material);
    const auto K = one.tangent(TangentKind::quadrature_point, one.block.law(), one.at_rest());
    using Square = Eigen::Matrix<double, one.n, one.n>;
    // Pressures have another unit: they are scaled so that all entries are of the same size.
    Square scaled = Eigen::Map<const Square>(K.data());
    const double stiffness = scaled.diagonal().head(3 * one.X.size()).cwiseAbs().maxCoeff();
    for (int k = static_cast<int>(3 * one.X.size()); k < one.n; ++k) {
      const double s = stiffness / scaled.row(k).cwiseAbs().maxCoeff();
      scaled.row(k) *= s;
      scaled.col(k) *= s;
    }
    const Eigen::SelfAdjointEigenSolver<Square> solver(scaled);
    std::vector<double> sizes;
    for (double lambda : solver.eigenvalues()) sizes.push_back(std::abs(lambda) / stiffness);
    std::sort(sizes.begin(), sizes.end());
    EXPECT_LT(sizes[5], 1e-13);
    EXPECT_GT(sizes[6], 1e-4);
  }
}

TYPED_TEST(EveryElement, DoesNotNoticeARigidMotion) {
  for (const auto& material : this->materials()) {
    Random random(4);
    const auto one = this->element(material);
    const auto x = one.deformed(random, 100);
    const auto Q = random.rotation();
    auto moved = x;
    for (std::size_t a = 0; a < one.X.size(); ++a) {
      const auto at = rotate(Q, {x[3 * a], x[3 * a + 1], x[3 * a + 2]});
      for (int i = 0; i < 3; ++i) moved[3 * a + i] = at[i] + 3 - i;
    }
    const double W = one.block.strain_energy(x.data());
    EXPECT_NEAR(one.block.strain_energy(moved.data()), W, 1e-12 * W);
    const auto r = one.residual(x), after = one.residual(moved);
    for (std::size_t a = 0; a < one.X.size(); ++a) {
      const auto f = rotate(Q, {r[3 * a], r[3 * a + 1], r[3 * a + 2]});
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(after[3 * a + i], f[i], 1e-12 * moduli.youngs_modulus());
    }
    for (int k = static_cast<int>(3 * one.X.size()); k < one.n; ++k) EXPECT_NEAR(after[k], r[k], 1e-12);
  }
}

TYPED_TEST(EveryElement, HasForcesWithoutResultantAndMoment) {
  for (const auto& material : this->materials()) {
    Random random(5);
    const auto one = this->element(material);
    const auto x = one.deformed(random, 100), r = one.residual(x);
    Vec3<double> force{}, moment{};
    for (std::size_t a = 0; a < one.X.size(); ++a) {
      const Vec3<double> f{r[3 * a], r[3 * a + 1], r[3 * a + 2]}, at{x[3 * a], x[3 * a + 1], x[3 * a + 2]};
      force = force + f;
      moment = moment + cross(at, f);
    }
    EXPECT_LE(norm(force), 1e-13 * largest(r) * static_cast<double>(one.X.size()));
    EXPECT_LE(norm(moment), 1e-13 * largest(r) * static_cast<double>(one.X.size()));
  }
}

TYPED_TEST(EveryElement, HasForcesThatAreTheDerivativeOfItsEnergy) {
  if (TestFixture::is_mixed) GTEST_SKIP() << "the functional of a mixed element is no energy: it has a saddle point";
  for (const auto& material : this->materials()) {
    Random random(6);
    const auto one = this->element(material);
    const auto x = one.deformed(random, 0);
    EXPECT_TRUE(is_derivative(
        one.residual(x), [&](const std::vector<double>& q) { return std::vector<double>{one.block.strain_energy(q.data())}; },
        x));
  }
}

TYPED_TEST(EveryElement, HasTheSameTangentByEveryExactRoute) {
  for (const auto& material : this->materials()) {
    Random random(7);
    const auto one = this->element(material);
    const auto x = one.deformed(random, 100);
    const auto K = one.tangent(TangentKind::quadrature_point, one.block.law(), x);
    ASSERT_FALSE(K.empty());
    for (auto [kind, moduli_kind] : {std::pair{TangentKind::analytic, ModuliKind::analytic},
                                     {TangentKind::whole_element, ModuliKind::automatic},
                                     {TangentKind::complex_step, ModuliKind::automatic}}) {
      const auto other = one.tangent(kind, this->law(material, moduli_kind), x);
      ASSERT_EQ(other.size(), K.size());
      for (std::size_t k = 0; k < K.size(); ++k) ASSERT_NEAR(other[k], K[k], 1e-12 * largest(K)) << k;
    }
  }
}

TYPED_TEST(EveryElement, HasATangentThatIsTheDerivativeOfItsForces) {
  for (const auto& material : this->materials()) {
    Random random(8);
    const auto one = this->element(material);
    const auto x = one.deformed(random, 100);
    EXPECT_TRUE(is_derivative(
        one.tangent(TangentKind::quadrature_point, one.block.law(), x),
        [&](const std::vector<double>& q) { return one.residual(q); }, x));
  }
}

TYPED_TEST(EveryElement, RefusesAnInvertedStateByAllRoutes) {
  for (const auto& material : this->materials()) {
    const auto one = this->element(material);
    auto x = one.at_rest();
    for (std::size_t a = 0; a < one.X.size(); ++a) x[3 * a + 2] = -x[3 * a + 2];
    EXPECT_TRUE(one.residual(x).empty());
    for (auto kind : {TangentKind::quadrature_point, TangentKind::analytic, TangentKind::whole_element, TangentKind::complex_step,
                      TangentKind::central_differences})
      EXPECT_TRUE(one.tangent(kind, one.block.law(), x).empty());
    x[1] = std::nan("");
    EXPECT_TRUE(one.residual(x).empty());
  }
}

// ---- the brick of the references --------------------------------------------------------------------------------------

const ElementNodes<Hex8> brick{{{0.05, -0.02, 0.03},
                                {1.1, 0.04, -0.05},
                                {0.97, 1.08, 0.06},
                                {-0.06, 0.93, 0.02},
                                {0.02, 0.07, 0.95},
                                {0.94, -0.03, 1.09},
                                {1.06, 1.02, 1.04},
                                {0.03, 1.05, 0.9}}};

void expect_reference_values(const Material& material, const std::string& name) {
  if (!have_reference("hex8.json")) GTEST_SKIP() << no_reference("hex8.json");
  const auto values = reference("hex8.json");
  ASSERT_EQ(values["settings"]["X"].get<ElementNodes<Hex8>>(), brick);
  std::vector<double> x, K;
  for (const auto& row : values["settings"]["x"])
    for (double entry : row) x.push_back(entry);
  const auto expected = values["results"][name];
  const std::vector<double> f = expected["fint"];
  for (const auto& row : expected["K"]) K.insert(K.end(), row.begin(), row.end());
  ASSERT_EQ(K.size(), 576U);
  const double W = expected["energy"];
  const OneElement<Standard<Hex8>> one(MaterialLaw::whole(material, ModuliKind::automatic), brick);
  EXPECT_NEAR(one.block.strain_energy(x.data()), W, 1e-12 * W);
  const auto r = one.residual(x);
  for (int k = 0; k < 24; ++k) EXPECT_NEAR(r[k], f[k], 1e-12 * largest(f));
  for (auto kind : {ModuliKind::automatic, ModuliKind::analytic}) {
    const auto tangent = one.tangent(TangentKind::quadrature_point, MaterialLaw::whole(material, kind), x);
    for (int k = 0; k < 576; ++k) EXPECT_NEAR(tangent[k], K[k], 1e-12 * largest(K));
  }
}

TEST(Hex8, HasTheReferenceValuesWithLinearElasticity) { expect_reference_values(LinearElastic::from(moduli), "linear_elastic"); }
TEST(Hex8, HasTheReferenceValuesWithSaintVenantKirchhoff) { expect_reference_values(SaintVenantKirchhoff::from(moduli), "svk"); }
TEST(Hex8, HasTheReferenceValuesWithNeoHooke) { expect_reference_values(NeoHookean::from(moduli), "neo_hooke"); }
TEST(Hex8, HasTheReferenceValuesWithMooneyRivlin) {
  expect_reference_values(MooneyRivlin{176051, 4332.63, 2e6}, "mooney_rivlin");
}
TEST(Hex8, HasTheReferenceValuesWithOgden) {
  expect_reference_values(Ogden{{{{6300, 1.3}, {12, 5}, {-100, -2}}}, 2000, 9}, "ogden_tab61");
}

TEST(Hex8, HasTheReferenceMassByBothRules) {
  if (!have_reference("hex8.json")) GTEST_SKIP() << no_reference("hex8.json");
  const auto values = reference("hex8.json");
  const double density = values["settings"]["rho0"];
  const auto expect = [&](const auto& M, const std::string& name) {
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) EXPECT_NEAR(density * M[8 * a + b], double(values[name][a][b]), 1e-12 * 36) << name;
  };
  expect(mass_matrix<Hex8>(brick, Hex8::stiffness_rule), "mass_2x2x2");
  expect(mass_matrix<Hex8>(brick, Hex8::mass_rule), "mass_3x3x3_exact");
}

// ---- sides ------------------------------------------------------------------------------------------------------------

template <class S>
class EverySide : public ::testing::Test {};
using Sides = ::testing::Types<Tri3, Tri6, Quad4, Quad8, Quad9>;
TYPED_TEST_SUITE(EverySide, Sides);

/// A flat side with straight edges: the shape functions carry area and first moment.
TYPED_TEST(EverySide, HasWeightsThatSumToTheAreaAndBalanceAboutTheCentroid) {
  constexpr int n = TypeParam::n_nodes, corners = n == 3 || n == 6 ? 3 : 4;
  constexpr double corner[4][2] = {{0, 0}, {2, 0.1}, {1.7, 1.2}, {-0.2, 0.9}};
  std::array<std::array<double, 3>, n> X{};
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 2; ++i) {
      if (a < corners) {
        X[a][i] = corner[a][i];
      } else if (a < 2 * corners) {
        X[a][i] = 0.5 * (corner[a - corners][i] + corner[(a + 1) % corners][i]);
      } else {
        X[a][i] = 0.25 * (corner[0][i] + corner[1][i] + corner[2][i] + corner[3][i]);
      }
    }
  double area = 0, exact_moment = 0, sum = 0, moment = 0;  // shoelace formula
  for (int a = 0; a < corners; ++a) {
    const auto &p = corner[a], &q = corner[(a + 1) % corners];
    area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
    exact_moment += (p[0] + q[0]) * (p[0] * q[1] - q[0] * p[1]) / 6;
  }
  const auto W = side_weights<TypeParam>(X);
  for (int a = 0; a < n; ++a) {
    sum += W[a];
    moment += W[a] * X[a][0];
  }
  EXPECT_NEAR(sum, area, 1e-14);
  EXPECT_NEAR(moment, exact_moment, 1e-14);
}

/// Sides in the mesh's numbering belong to the element: their shape functions are those of the element on that side.
TEST(Sides, AreRestrictionsOfTheirElements) {
  for (ElementType type : element_types)
    with_element(type, [&](auto kind) {
      using Element = decltype(kind);
      for (const auto& face : topology(type).faces)
        with_side(static_cast<int>(face.size()), [&](auto side) {
          using Side = decltype(side);
          ASSERT_EQ(static_cast<std::size_t>(Side::n_nodes), face.size());
          for (const auto& point : Side::rule) {
            LocalPoint xi{};  // of the element
            for (std::size_t a = 0; a < face.size(); ++a)
              for (int i = 0; i < 3; ++i) xi[i] += Side::N(static_cast<int>(a), point.xi) * Element::node[face[a]][i];
            for (std::size_t a = 0; a < face.size(); ++a)
              EXPECT_NEAR(Element::N(face[a], xi), Side::N(static_cast<int>(a), point.xi), 1e-14) << topology(type).name;
          }
        });
    });
}

}  // namespace
}  // namespace mortise::test
