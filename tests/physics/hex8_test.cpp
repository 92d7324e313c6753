// The trilinear brick: geometry, rigid motions, and residual and tangent by every route.
#include <gtest/gtest.h>

#include <Teuchos_LAPACK.hpp>
#include <numeric>

#include "assembly/element_tangent.hpp"
#include "benchmarks/analytic_tangent.hpp"
#include "physics/materials/materials.hpp"
#include "physics/traction.hpp"
#include "support/gradient_check.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

using Points = std::array<std::array<double, 3>, 8>;

/// The distorted brick of the references and a deformed state of it: strains of some 20 %.
const Points distorted{{{0.05, -0.02, 0.03},
                        {1.1, 0.04, -0.05},
                        {0.97, 1.08, 0.06},
                        {-0.06, 0.93, 0.02},
                        {0.02, 0.07, 0.95},
                        {0.94, -0.03, 1.09},
                        {1.06, 1.02, 1.04},
                        {0.03, 1.05, 0.9}}};
const Points deformed{{{0.07, -0.05, 0.08},
                       {1.21, 0.1, -0.09},
                       {0.9, 1.2, 0.15},
                       {-0.02, 0.85, 0.15},
                       {-0.1, 0.12, 1.05},
                       {1.02, -0.14, 1.16},
                       {1.2, 1.05, 0.98},
                       {-0.02, 1.14, 1.05}}};

struct Response {
  bool admissible = true;
  double f[8][3] = {};
  std::vector<double> K = std::vector<double>(576, 0.0);
};

template <class M>
Response response(const M& material, const Points& X, const Points& x) {
  Response r;
  double q[8][3];
  for (int k = 0; k < 24; ++k) q[k / 3][k % 3] = x[k / 3][k % 3];
  r.admissible = quadrature_point_tangent(material, hex8_geometry(X), q, r.f, r.K.data());
  return r;
}

double largest(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0, [](double size, double entry) { return std::max(size, std::abs(entry)); });
}

template <class M>
double energy(const M& material, const Points& X, const Points& x) {
  double q[8][3];
  for (int k = 0; k < 24; ++k) q[k / 3][k % 3] = x[k / 3][k % 3];
  return strain_energy(material, hex8_geometry(X), q);
}

TEST(Hex8, HasShapeFunctionsThatSumToOne) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const std::array<double, 3> xi{random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
    double sum = 0, slope[3] = {};
    for (int a = 0; a < 8; ++a) {
      sum += Hex8::N(a, xi);
      for (int i = 0; i < 3; ++i) slope[i] += Hex8::dN_dxi(a, xi)[i];
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    for (double s : slope) EXPECT_NEAR(s, 0, 1e-15);
  }
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b) EXPECT_EQ(Hex8::N(a, {Hex8::corner[b][0], Hex8::corner[b][1], Hex8::corner[b][2]}), a == b);
}

TEST(Hex8, GivesTheGradientOfALinearFieldExactly) {
  const auto geometry = hex8_geometry(distorted);
  const double G[3][3] = {{0.3, -1.2, 0.7}, {2.1, 0.4, -0.5}, {-0.6, 0.8, 1.9}};
  double u[8][3];
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) u[a][i] = 5 + G[i][0] * distorted[a][0] + G[i][1] * distorted[a][1] + G[i][2] * distorted[a][2];
  for (int g = 0; g < 8; ++g) {
    const auto gradient = deformation_gradient(geometry.grad_N[g], u);
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(gradient(k / 3, k % 3), G[k / 3][k % 3], 1e-13);
  }
}

TEST(Hex8, HasTheVolumeOfTheBrick) {
  const auto geometry = hex8_geometry(distorted);
  EXPECT_NEAR(std::accumulate(geometry.JxW, geometry.JxW + 8, 0.0), 0.9960140833333333, 1e-15);  // exact, from the references
}

/// 2 x 2 x 2 bricks whose middle node is out of place: a linear motion of the surface is carried inside without any force there.
TEST(Hex8, PassesThePatchTestOnADistortedMesh) {
  const auto place = [](int i, int j, int k) {
    std::array<double, 3> X{i * 0.5, j * 0.5, k * 0.5};
    if (i == 1 && j == 1 && k == 1) X = {0.61, 0.43, 0.55};
    return X;
  };
  const double F[3][3] = {{1.2, 0.1, -0.2}, {0.05, 0.9, 0.1}, {0.3, -0.1, 1.1}};
  double middle[3] = {}, typical = 0;
  for (int e = 0; e < 8; ++e) {
    Points X, x;
    int at_middle = -1;
    for (int a = 0; a < 8; ++a) {
      const int i = e % 2 + (Hex8::corner[a][0] > 0), j = e / 2 % 2 + (Hex8::corner[a][1] > 0),
                k = e / 4 + (Hex8::corner[a][2] > 0);
      X[a] = place(i, j, k);
      if (i == 1 && j == 1 && k == 1) at_middle = a;
      for (int c = 0; c < 3; ++c) x[a][c] = F[c][0] * X[a][0] + F[c][1] * X[a][1] + F[c][2] * X[a][2];
    }
    const auto r = response(NeoHookean::from({1, 0.3}), X, x);
    for (int c = 0; c < 3; ++c) {
      middle[c] += r.f[at_middle][c];
      typical = std::max(typical, std::abs(r.f[at_middle][c]));
    }
  }
  EXPECT_GT(typical, 1e-3);
  for (double f : middle) EXPECT_NEAR(f, 0, 1e-14 * typical);
}

template <class M>
class Hex8WithEveryMaterial : public ::testing::Test {
 protected:
  const M material = M::from({2250, 0.3});
};

using Materials = ::testing::Types<NeoHookean, NeoHookeanIsochoric, SaintVenantKirchhoff>;
TYPED_TEST_SUITE(Hex8WithEveryMaterial, Materials);

TYPED_TEST(Hex8WithEveryMaterial, HasExactlySixRigidModesAtRest) {
  auto K = response(this->material, distorted, distorted).K;
  const double stiffness = largest(K);
  for (int mode = 0; mode < 6; ++mode) {
    double forces = 0;
    for (int r = 0; r < 24; ++r) {
      double f = 0;
      for (int a = 0; a < 8; ++a) {
        Vec3<double> axis{}, x{distorted[a][0], distorted[a][1], distorted[a][2]};
        axis[mode % 3] = 1;
        const auto motion = mode < 3 ? axis : cross(axis, x);
        for (int i = 0; i < 3; ++i) f += K[24 * r + 3 * a + i] * motion[i];
      }
      forces = std::max(forces, std::abs(f));
    }
    EXPECT_LE(forces, 1e-14 * stiffness) << "mode " << mode;
  }
  std::vector<double> eigenvalue(24), work(240);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', 24, K.data(), 24, eigenvalue.data(), work.data(), 240, &info);
  ASSERT_EQ(info, 0);
  EXPECT_NEAR(eigenvalue[0], 0, 1e-14 * stiffness);
  EXPECT_NEAR(eigenvalue[5], 0, 1e-14 * stiffness);
  EXPECT_GT(eigenvalue[6], 1e-2 * stiffness);
}

TYPED_TEST(Hex8WithEveryMaterial, DoesNotNoticeARigidMotion) {
  Random random(2);
  const double W = energy(this->material, distorted, deformed);
  const auto before = response(this->material, distorted, deformed);
  const auto Q = random.rotation();
  Points moved;
  for (int a = 0; a < 8; ++a) {
    const auto x = rotate(Q, {deformed[a][0], deformed[a][1], deformed[a][2]});
    for (int i = 0; i < 3; ++i) moved[a][i] = x[i] + 3 - i;
  }
  EXPECT_NEAR(energy(this->material, distorted, moved), W, 1e-13 * W);
  const auto after = response(this->material, distorted, moved);
  for (int a = 0; a < 8; ++a) {
    const auto f = rotate(Q, {before.f[a][0], before.f[a][1], before.f[a][2]});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(after.f[a][i], f[i], 1e-13 * largest(before.K));
  }
}

TYPED_TEST(Hex8WithEveryMaterial, HasForcesWithoutResultantAndMoment) {
  const auto r = response(this->material, distorted, deformed);
  Vec3<double> force{}, moment{};
  double typical = 0;
  for (int a = 0; a < 8; ++a) {
    const Vec3<double> f{r.f[a][0], r.f[a][1], r.f[a][2]}, x{deformed[a][0], deformed[a][1], deformed[a][2]};
    force = force + f;
    moment = moment + cross(x, f);
    typical = std::max(typical, norm(f));
  }
  EXPECT_LE(norm(force), 1e-14 * typical);
  EXPECT_LE(norm(moment), 1e-14 * typical);
}

TYPED_TEST(Hex8WithEveryMaterial, HasForcesThatAreTheDerivativeOfItsEnergyAndATangentThatIsTheirs) {
  const auto points = [](const std::vector<double>& q) {
    Points x;
    for (int k = 0; k < 24; ++k) x[k / 3][k % 3] = q[k];
    return x;
  };
  const std::vector<double> q(&deformed[0][0], &deformed[0][0] + 24);
  const auto r = response(this->material, distorted, deformed);
  const std::vector<double> f(&r.f[0][0], &r.f[0][0] + 24);
  EXPECT_TRUE(is_derivative(
      f, [&](const std::vector<double>& x) { return std::vector<double>{energy(this->material, distorted, points(x))}; }, q));
  EXPECT_TRUE(is_derivative(
      r.K,
      [&](const std::vector<double>& x) {
        const auto at = response(this->material, distorted, points(x));
        return std::vector<double>(&at.f[0][0], &at.f[0][0] + 24);
      },
      q));
}

TYPED_TEST(Hex8WithEveryMaterial, HasTheSameTangentByPointsAndByTheWholeElement) {
  const auto by_points = response(this->material, distorted, deformed);
  double q[8][3], f[8][3] = {};
  for (int k = 0; k < 24; ++k) q[k / 3][k % 3] = deformed[k / 3][k % 3];
  std::vector<double> K(576, 0.0);
  ASSERT_TRUE(whole_element_tangent(this->material, hex8_geometry(distorted), q, f, K.data()));
  for (int k = 0; k < 576; ++k) EXPECT_NEAR(K[k], by_points.K[k], 1e-13 * largest(K));
  for (int k = 0; k < 24; ++k) EXPECT_NEAR(f[k / 3][k % 3], by_points.f[k / 3][k % 3], 1e-13 * largest(K));
}

TYPED_TEST(Hex8WithEveryMaterial, RefusesAnInvertedStateByAllRoutes) {
  Points inverted = deformed;
  for (int a = 4; a < 8; ++a) inverted[a][2] -= 1.5;
  const auto geometry = hex8_geometry(distorted);
  double q[8][3], f[8][3] = {};
  for (int k = 0; k < 24; ++k) q[k / 3][k % 3] = inverted[k / 3][k % 3];
  std::vector<double> K(576, 0.0);
  EXPECT_FALSE(add_internal_force(this->material, geometry, q, f));
  EXPECT_FALSE(quadrature_point_tangent(this->material, geometry, q, f, K.data()));
  EXPECT_FALSE(whole_element_tangent(this->material, geometry, q, f, K.data()));
  q[6][1] = std::nan("");
  EXPECT_FALSE(add_internal_force(this->material, geometry, q, f));
}

template <class M>
void expect_reference_values(const M& material, const std::string& name) {
  if (!have_reference("hex8.json")) GTEST_SKIP() << no_reference("hex8.json");
  const auto values = reference("hex8.json");
  ASSERT_EQ(values["settings"]["X"].get<Points>(), distorted);
  ASSERT_EQ(values["settings"]["x"].get<Points>(), deformed);
  const auto expected = values["results"][name];
  const std::vector<double> f = expected["fint"];
  std::vector<double> K;
  for (const auto& row : expected["K"]) K.insert(K.end(), row.begin(), row.end());
  ASSERT_EQ(K.size(), 576U);
  const double W = expected["energy"];
  EXPECT_NEAR(energy(material, distorted, deformed), W, 1e-12 * W);
  const auto r = response(material, distorted, deformed);
  for (int k = 0; k < 24; ++k) EXPECT_NEAR(r.f[k / 3][k % 3], f[k], 1e-12 * largest(f));
  for (int k = 0; k < 576; ++k) EXPECT_NEAR(r.K[k], K[k], 1e-12 * largest(K));
}

TEST(Hex8, HasTheReferenceValuesWithSaintVenantKirchhoff) {
  expect_reference_values(SaintVenantKirchhoff::from({2250, 0.3}), "svk");
}

TEST(Hex8, HasTheReferenceValuesWithNeoHooke) { expect_reference_values(NeoHookean::from({2250, 0.3}), "neo_hooke"); }

TEST(Hex8, HasTheTangentDerivedByHand) {
  const auto material = NeoHookean::from({2250, 0.3});
  const auto by_ad = response(material, distorted, deformed);
  double q[8][3], f[8][3] = {};
  for (int k = 0; k < 24; ++k) q[k / 3][k % 3] = deformed[k / 3][k % 3];
  std::vector<double> K(576, 0.0);
  ASSERT_TRUE(analytic_tangent(material, hex8_geometry(distorted), q, f, K.data()));
  for (int k = 0; k < 576; ++k) EXPECT_NEAR(K[k], by_ad.K[k], 1e-13 * largest(K));
}

TEST(SideWeights, SumToTheAreaAndBalanceAboutTheCentroid) {
  const std::array<std::array<double, 3>, 4> flat{{{0, 0, 1}, {2, 0.1, 1}, {1.7, 1.2, 1}, {-0.2, 0.9, 1}}};
  const double area = 0.5 * ((1.7 - 0) * (0.9 - 0.1) - (1.2 - 0) * (-0.2 - 2));
  const auto W = side_weights(flat);
  EXPECT_NEAR(W[0] + W[1] + W[2] + W[3], area, 1e-15);
  double first_moment = 0, exact = 0;  // int x dA: shoelace formula
  for (int a = 0; a < 4; ++a) {
    first_moment += W[a] * flat[a][0];
    const auto &p = flat[a], &q = flat[(a + 1) % 4];
    exact += (p[0] + q[0]) * (p[0] * q[1] - q[0] * p[1]) / 6;
  }
  EXPECT_NEAR(first_moment, exact, 1e-14);
}

}  // namespace
}  // namespace mortise::test
