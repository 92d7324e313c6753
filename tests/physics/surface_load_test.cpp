// Loads on sides and bodies against closed forms, and their derivatives.
#include <gtest/gtest.h>

#include <Sacado.hpp>

#include "physics/body_force.hpp"
#include "physics/elements/tetrahedra.hpp"
#include "physics/elements/wedge6.hpp"
#include "physics/rotation.hpp"
#include "physics/surface_load.hpp"
#include "support/gradient_check.hpp"

namespace mortise::test {
namespace {

template <class Side>
class LoadOnEverySide : public testing::Test {
 protected:
  static constexpr int n = Side::n_nodes;
  static constexpr bool is_triangle = n == 3 || n == 6;

  /// Local coordinates of the nodes: corners, middles of the edges, centre.
  static LocalPoint node(int a) {
    static constexpr double quadrilateral[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static constexpr double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    return is_triangle ? LocalPoint{triangle[a][0], triangle[a][1], 0} : LocalPoint{quadrilateral[a][0], quadrilateral[a][1], 0};
  }

  /// The flat side spanned by two edges from an origin.
  static SidePositions<Side, double> flat(const Vec3<double>& origin, const Vec3<double>& u, const Vec3<double>& v) {
    SidePositions<Side, double> x;
    for (int a = 0; a < n; ++a) {
      const LocalPoint xi = node(a);
      const double r = is_triangle ? xi[0] : 0.5 * (1 + xi[0]), s = is_triangle ? xi[1] : 0.5 * (1 + xi[1]);
      const Vec3<double> at = origin + r * u + s * v;
      x[a] = {at[0], at[1], at[2]};
    }
    return x;
  }

  /// A warped, curved side.
  static SidePositions<Side, double> warped() {
    auto x = flat({1, 2, 3}, {2, 0.3, 0}, {0.2, 1.5, 0.4});
    Random random(3);
    for (auto& point : x)
      for (double& c : point) c += random.in(-0.15, 0.15);
    return x;
  }

  static Vec3<double> sum(const double* f) {
    Vec3<double> total{0, 0, 0};
    for (int k = 0; k < 3 * n; ++k) total[k % 3] += f[k];
    return total;
  }

  static AtSidePoints<Side, Vec3<double>> some_traction() {
    AtSidePoints<Side, Vec3<double>> t;
    for (std::size_t g = 0; g < t.size(); ++g) t[g] = {1.0 + 0.1 * g, -0.5, 0.3 * g};
    return t;
  }
  static AtSidePoints<Side, double> some_pressure() {
    AtSidePoints<Side, double> p;
    for (std::size_t g = 0; g < p.size(); ++g) p[g] = 2.0 - 0.2 * g;
    return p;
  }

  /// A force as a function of the 3 n positions, and its derivative by AD.
  template <class Force>
  static testing::AssertionResult derivative_is_right(const Force& force) {
    const ManyToMany f = [&](const std::vector<double>& y) {
      SidePositions<Side, double> x;
      for (int k = 0; k < 3 * n; ++k) x[k / 3][k % 3] = y[k];
      std::vector<double> values(3 * n, 0.0);
      force(x, values.data());
      return values;
    };
    using Fad = Sacado::Fad::SFad<double, 3 * n>;
    SidePositions<Side, Fad> x;
    std::vector<double> y;
    const auto start = warped();
    for (int k = 0; k < 3 * n; ++k) {
      y.push_back(start[k / 3][k % 3]);
      x[k / 3][k % 3] = Fad(3 * n, k, y.back());
    }
    std::vector<Fad> values(3 * n, Fad(0.0));
    force(x, values.data());
    std::vector<double> jacobian;
    for (const Fad& value : values)
      for (int l = 0; l < 3 * n; ++l) jacobian.push_back(value.dx(l));
    return is_derivative(jacobian, f, y);
  }
};

using Sides = testing::Types<Tri3, Tri6, Quad4, Quad8, Quad9>;
TYPED_TEST_SUITE(LoadOnEverySide, Sides);

// A parallelogram with edges u, v has the area vector u x v; a triangle half of it.
TYPED_TEST(LoadOnEverySide, FlatSideGetsTractionTimesAreaAndPressureAgainstItsNormal) {
  const Vec3<double> u{2, 0.5, 0}, v{0.3, 1.5, 0.7}, area = (this->is_triangle ? 0.5 : 1.0) * cross(u, v);
  const auto x = this->flat({5, -1, 2}, u, v);
  AtSidePoints<TypeParam, Vec3<double>> t;
  AtSidePoints<TypeParam, double> p;
  t.fill({3, -2, 1});
  p.fill(4);
  double traction[3 * TypeParam::n_nodes] = {}, pressure[3 * TypeParam::n_nodes] = {};
  add_traction_force<TypeParam>(x, t, traction);
  add_pressure_force<TypeParam>(x, p, pressure);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(this->sum(traction)[i], t[0][i] * norm(area), 1e-13 * 10);
    EXPECT_NEAR(this->sum(pressure)[i], -4 * area[i], 1e-13 * 10);
  }
}

TYPED_TEST(LoadOnEverySide, DeadLoadIsTheTractionOnTheReferenceSide) {
  const auto X = this->warped();
  AtSidePoints<TypeParam, Vec3<double>> t;
  t.fill({0, 0, 1});
  double force[3 * TypeParam::n_nodes] = {};
  add_traction_force<TypeParam>(X, t, force);
  const auto weights = side_weights<TypeParam>(X);
  for (int a = 0; a < TypeParam::n_nodes; ++a) {
    EXPECT_EQ(force[3 * a], 0);
    EXPECT_NEAR(force[3 * a + 2], weights[a], 1e-14);
  }
}

TYPED_TEST(LoadOnEverySide, TractionTangentIsTheDerivative) {
  const auto t = this->some_traction();
  EXPECT_TRUE(this->derivative_is_right([&](const auto& x, auto* f) { add_traction_force<TypeParam>(x, t, f); }));
}

TYPED_TEST(LoadOnEverySide, PressureTangentIsTheDerivative) {
  const auto p = this->some_pressure();
  EXPECT_TRUE(this->derivative_is_right([&](const auto& x, auto* f) { add_pressure_force<TypeParam>(x, p, f); }));
}

// With unit stiffness and a displacement of all nodes by one: the force is the area.
TYPED_TEST(LoadOnEverySide, BeddingMatrixIsSymmetricAndSumsToTheArea) {
  const auto X = this->warped();
  const auto S = side_mass_matrix<TypeParam>(X);
  const auto weights = side_weights<TypeParam>(X);
  for (int a = 0; a < TypeParam::n_nodes; ++a) {
    double row = 0;
    for (int b = 0; b < TypeParam::n_nodes; ++b) {
      row += S[a * TypeParam::n_nodes + b];
      EXPECT_NEAR(S[a * TypeParam::n_nodes + b], S[b * TypeParam::n_nodes + a], 1e-14);
    }
    EXPECT_NEAR(row, weights[a], 1e-13);
    EXPECT_GT(S[a * (TypeParam::n_nodes + 1)], 0);
  }
}

// A uniform pressure on a closed surface is in equilibrium, however the surface is deformed: its faces share their edges.
TEST(Pressure, OnAClosedSurfaceHasNoForceAndNoMoment) {
  constexpr int faces[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  Random random(7);
  double x[8][3];
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) x[a][i] = hexahedron_node[a][i] + random.in(-0.3, 0.3);
  AtSidePoints<Quad4, double> p;
  p.fill(5);
  Vec3<double> force{0, 0, 0}, moment{0, 0, 0};
  double greatest = 0;
  for (const auto& face : faces) {
    SidePositions<Quad4, double> at;
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i) at[a][i] = x[face[a]][i];
    double f[12] = {};
    add_pressure_force<Quad4>(at, p, f);
    for (int a = 0; a < 4; ++a) {
      const Vec3<double> on_node{f[3 * a], f[3 * a + 1], f[3 * a + 2]}, arm{at[a][0], at[a][1], at[a][2]};
      force = force + on_node;
      moment = moment + cross(arm, on_node);
      greatest = std::max(greatest, norm(on_node));
    }
  }
  EXPECT_GT(greatest, 1);
  EXPECT_LE(norm(force), 1e-14 * greatest);
  EXPECT_LE(norm(moment), 1e-13 * greatest);
}

template <class Element>
class EveryBody : public testing::Test {
 protected:
  static ElementNodes<Element> nodes() {
    ElementNodes<Element> X;
    for (int a = 0; a < Element::n_nodes; ++a) {
      const double* c = Element::node[a];
      X[a] = {2 * c[0] + 0.3 * c[1], 1.5 * c[1], c[2] + 0.2 * c[0] + 4};
    }
    return X;
  }
};
using Bodies = testing::Types<Hex8, Hex20, Hex27, Tet4, Tet10, Wedge6>;
TYPED_TEST_SUITE(EveryBody, Bodies);

// Mass times acceleration, and the moment about the origin of a force that grows linearly, by the rule itself on x^2.
TYPED_TEST(EveryBody, BodyForceIsMassTimesAccelerationAndActsAtTheCentre) {
  const auto X = this->nodes();
  const double density = 3, V = volume(reference_geometry<TypeParam>(X));
  double f[3 * TypeParam::n_nodes] = {};
  add_body_force<TypeParam>(
      X, density,
      [](const std::array<double, 3>&) {
        return std::array<double, 3>{1, -2, 5};
      },
      f);
  Vec3<double> force{0, 0, 0}, centre{0, 0, 0};
  for (int a = 0; a < TypeParam::n_nodes; ++a)
    for (int i = 0; i < 3; ++i) {
      force[i] += f[3 * a + i];
      centre[i] += f[3 * a] * X[a][i] / (density * V);
    }
  EXPECT_NEAR(force[0], density * V, 1e-12 * density * V);
  EXPECT_NEAR(force[1], -2 * density * V, 1e-12 * density * V);
  EXPECT_NEAR(force[2], 5 * density * V, 1e-12 * density * V);
  Vec3<double> exact{0, 0, 0};  // the centroid of an affinely mapped shape: the mean of its corners
  const int corners = TypeParam::n_nodes == 10 ? 4 : TypeParam::n_nodes > 8 ? 8 : TypeParam::n_nodes;
  for (int a = 0; a < corners; ++a)
    for (int i = 0; i < 3; ++i) exact[i] += X[a][i] / corners;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(centre[i], exact[i], 1e-12);
}

TEST(Rotation, QuarterTurnAboutZTakesXToY) {
  const auto v = turned_about<double>({0, 0, 1}, 1, 0, {1, 0, 7});
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(v[1], 1);
  EXPECT_EQ(v[2], 7);
}

TEST(Rotation, KeepsLengthsAndTheAxis) {
  const Vec3<double> axis = (1 / std::sqrt(14.0)) * Vec3<double>{1, 2, 3}, v{0.3, -1, 2};
  const Vec3<double> turned = turned_about<double>(axis, std::sin(0.7), std::cos(0.7), v);
  EXPECT_NEAR(norm(turned), norm(v), 1e-14);
  EXPECT_NEAR(dot(turned, axis), dot(v, axis), 1e-14);
  const Vec3<double> across = v - dot(v, axis) * axis, across_turned = turned - dot(turned, axis) * axis;
  EXPECT_NEAR(dot(across, across_turned) / dot(across, across), std::cos(0.7), 1e-14);
}

}  // namespace
}  // namespace mortise::test
