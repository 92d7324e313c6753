// Every element: the patch test on a distorted mesh, and the order of convergence on exact solutions.
#include <gtest/gtest.h>

#include <iostream>

#include "assembly/vectors.hpp"
#include "support/unit_block.hpp"

namespace mortise::test {
namespace {

class EveryFormulation : public testing::TestWithParam<ElementCase> {};

std::string two(const std::string& model, const std::string& a, double va, const std::string& b, double vb) {
  return word("model", model) + deck_parameter(a, "double", fmt::format("{}", va)) +
         (b.empty() ? "" : deck_parameter(b, "double", fmt::format("{}", vb)));
}

/// A shear that keeps the volume, so that incompressible elements can follow: det F = 1.
Tensor3<double> volume_keeping() {
  const Tensor3<double> A{{{1, 0.2, 0}, {0, 1, 0}, {0, 0, 1}}}, B{{{1, 0, 0}, {0, 1, -0.15}, {0, 0, 1}}},
      C{{{1, 0, 0}, {0, 1, 0}, {0.1, 0, 1}}};
  return A * B * C;
}

TEST_P(EveryFormulation, PassesThePatchTestOnADistortedMesh) {
  const ElementCase of = GetParam();
  const Tensor3<double> F = volume_keeping();
  const double mu = 0.4, pressure = 0.05;
  Tensor3<double> P;
  std::string material;
  if (of.is_mixed()) {
    material = two("neo-hookean incompressible", "shear modulus", mu, "", 0);
    P = NeoHookeanIncompressible{{mu}}.first_piola(F);
    const auto cof = cofactor(F);
    for (int k = 0; k < 9; ++k) P(k / 3, k % 3) -= pressure * cof(k / 3, k % 3);
  } else {
    material = two("neo-hookean", "youngs modulus", 1, "poissons ratio", 0.25);
    P = NeoHookean::from(Moduli(1, 0.25)).first_piola(F);
  }
  Formulas u, t;
  for (int i = 0; i < 3; ++i) {
    u[i] = fmt::format("{:.17g}*x + {:.17g}*y + {:.17g}*z", F(i, 0) - (i == 0), F(i, 1) - (i == 1), F(i, 2) - (i == 2));
    t[i] = fmt::format("{:.17g}", P(i, 2));
  }
  TestScene s(unit_block(of, 3, material, u, t), world(), [](Scene& scene) {
    scene.solver.further_iterations = 1;
    distort_inside(scene.mesh.mesh, 0.06);
  });
  const auto run = s.march({1});
  ASSERT_TRUE(run.converged) << run.cause;
  const auto x = s.gather(*s.state.x);
  double positions = 0, stress = 0;
  for (std::size_t a = 0; a < s.scene.mesh.mesh.coordinates.size(); ++a) {
    const Point& X = s.scene.mesh.mesh.coordinates[a];
    for (int i = 0; i < 3; ++i)
      positions = std::max(positions, std::abs(x[3 * a + i] - F(i, 0) * X[0] - F(i, 1) * X[1] - F(i, 2) * X[2]));
  }
  const auto overlap = s.problem.to_overlap(*s.state.x);
  s.problem.bodies()[0]->sample(overlap->getData().getRawPtr(), [&](const PointSample& at) {
    for (int k = 0; k < 9; ++k) stress = std::max(stress, std::abs(at.state.P(k / 3, k % 3) - P(k / 3, k % 3)));
  });
  stress = all_reduced(*world(), Teuchos::REDUCE_MAX, stress);
  if (world()->getRank() == 0)
    std::cout << of.name() << ": errors of positions " << positions << ", of stress " << stress << '\n';
  EXPECT_LE(positions, 1e-12);
  EXPECT_LE(stress, 1e-12);
}

/// Root mean square of |u_h - u| over the block.
double error(TestScene& s, const std::function<Vec3<double>(const Point&)>& exact) {
  const auto overlap = s.problem.to_overlap(*s.state.x);
  const auto x = overlap->getData();
  const auto& coordinates = s.scene.mesh.mesh.coordinates;
  double square = 0;
  s.problem.bodies()[0]->sample(x.getRawPtr(), [&](const PointSample& at) {
    Point X{0, 0, 0}, u{0, 0, 0};
    for (int a = 0; a < at.n_nodes; ++a)
      for (int i = 0; i < 3; ++i) {
        X[i] += at.N[a] * coordinates[at.nodes[a]][i];
        u[i] += at.N[a] * (x[s.problem.dofs().local(at.nodes[a]) + i] - coordinates[at.nodes[a]][i]);
      }
    const auto of = exact(X);
    for (int i = 0; i < 3; ++i) square += at.JxW * (u[i] - of[i]) * (u[i] - of[i]);
  });
  return std::sqrt(all_reduced(*world(), Teuchos::REDUCE_SUM, square));
}

void expect_order(const ElementCase& of, const std::string& what, const std::string& material, const Formulas& u,
                  const Formulas& t, const std::function<Vec3<double>(const Point&)>& exact) {
  std::vector<double> errors;
  // A constant pressure per hex8 is not stable: on a regular mesh held at its sides there are pressures, the checkerboards among
  // them, that no free node feels, and the tangent is singular. It takes finer meshes, and nodes that are moved.
  const bool is_unstable = of.is_mixed() && of.order() == 1;
  const std::vector<int> sizes = is_unstable       ? std::vector{3, 6, 12}
                                 : of.order() == 1 ? std::vector{2, 4, 8}
                                                   : std::vector{1, 2, 4};
  for (int n : sizes) {
    TestScene s(unit_block(of, n, material, u, t), world(), [&](Scene& scene) {
      if (is_unstable) distort_inside(scene.mesh.mesh, 0.2 / n);
    });
    const auto run = s.march({1});
    ASSERT_TRUE(run.converged) << run.cause;
    errors.push_back(error(s, exact));
  }
  const double order = std::log2(errors[1] / errors[2]);
  if (world()->getRank() == 0)
    std::cout << of.name() << ", " << what << fmt::format(": errors {:.3e}, order {:.2f}\n", fmt::join(errors, " "), order);
  EXPECT_GT(order, of.order() + 1 - 0.25);
}

// u = grad phi with a harmonic phi has neither divergence nor Laplacian: no body force in linear elasticity (thesis eq. 3.102).
TEST_P(EveryFormulation, ConvergesToAHarmonicFieldOfLinearElasticity) {
  const ElementCase of = GetParam();
  if (of.is_mixed()) GTEST_SKIP() << "linear elasticity is not split into distortion and volume";
  const double A = 1e-4, k = std::sqrt(2.);
  expect_order(of, "linear elastic", two("linear elastic", "youngs modulus", 1, "poissons ratio", 0.3),
               {fmt::format("-{}*sin(x)*cos(y)*cosh({:.17g}*z)", A, k), fmt::format("-{}*cos(x)*sin(y)*cosh({:.17g}*z)", A, k),
                fmt::format("{:.17g}*cos(x)*cos(y)*sinh({:.17g}*z)", A * k, k)},
               {}, [=](const Point& X) {
                 return Vec3<double>{-A * std::sin(X[0]) * std::cos(X[1]) * std::cosh(k * X[2]),
                                     -A * std::cos(X[0]) * std::sin(X[1]) * std::cosh(k * X[2]),
                                     A * k * std::cos(X[0]) * std::cos(X[1]) * std::sinh(k * X[2])};
               });
}

// Antiplane shear u = w(x, y) e_z with a harmonic w at finite strain: F = I + e_z (x) g, F^-T = I - g (x) e_z, g = grad w, and
// P = mu (F - F^-T) has no divergence; the traction on a plane z = const is mu g. A neo-Hookean solid of thesis eq. 3.130 has
// this stress because J = 1, an incompressible one with a pressure of its own.
TEST_P(EveryFormulation, ConvergesToFiniteAntiplaneShear) {
  const ElementCase of = GetParam();
  const double mu = 0.4, A = 0.6;
  const std::string material = of.is_mixed() ? two("neo-hookean incompressible", "shear modulus", mu, "", 0)
                                             : two("neo-hookean", "shear modulus", mu, "lame lambda", 0.4);
  expect_order(of, "antiplane shear", material, {"0", "0", fmt::format("{}*sinh(x)*sin(y)", A)},
               {fmt::format("{:.17g}*cosh(x)*sin(y)", mu * A), fmt::format("{:.17g}*sinh(x)*cos(y)", mu * A), "0"},
               [=](const Point& X) {
                 return Vec3<double>{0, 0, A * std::sinh(X[0]) * std::sin(X[1])};
               });
}

INSTANTIATE_TEST_SUITE_P(Elements, EveryFormulation, testing::ValuesIn(element_cases()), name_of_case);

}  // namespace
}  // namespace mortise::test
