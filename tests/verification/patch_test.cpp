// The contact patch test: a uniform state passes through the contact surface undisturbed, whatever the meshes.
#include <gtest/gtest.h>

#include <iostream>

#include "assembly/vectors.hpp"
#include "deck/field_table.hpp"
#include "output/nodal.hpp"
#include "physics/stress_and_strain.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

/// Uniaxial stress along `axis`: stretches and stress.
struct Exact {
  Vec3<double> axis;
  double axial = 1, lateral = 1, stress = 0;  // Cauchy
};

// Thesis 3.130 in principal stretches: P_i = mu (l_i - 1/l_i) + lambda ln J / l_i. From P_lateral = 0 follows ln J, hence the
// axial stretch, as a function of the lateral one; what is left is one equation for that: P_axial = `pressing`.
Exact uniaxial(double youngs_modulus, double poissons_ratio, double pressing) {
  const double mu = youngs_modulus / (2 * (1 + poissons_ratio)),
               lambda = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
  const auto axial = [&](double l) { return std::exp(-mu * (l * l - 1) / lambda) / (l * l); };
  const auto miss = [&](double l) {
    const double a = axial(l);
    return mu * (a - l * l / a) - pressing;  // lambda ln J = -mu (l^2 - 1)
  };
  double l = 1 - poissons_ratio * pressing / youngs_modulus;
  for (int k = 0; k < 20; ++k) {
    const double a = axial(l), da = -a * (2 * mu * l / lambda + 2 / l), slope = mu * (da - 2 * l / a + l * l / (a * a) * da);
    l -= miss(l) / slope;
  }
  return {{}, axial(l), l, pressing / (l * l)};
}

/// Where f rises through 0, to the last bit.
template <class Function>
double root(double low, double high, Function f) {
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
    (f(middle) < 0 ? low : high) = middle;
  return low;
}

// Thesis 3.125 in principal stretches, d = 2 (c1 + 2 c2): P_i = 2 c1 l_i + 2 c2 l_i (I1 - l_i^2) + (2 c (J - 1) J - d) / l_i.
// Both P_lateral = 0 and what is pressed rise with their stretch.
Exact mooney_rivlin(double pressing, bool on_current_area) {
  constexpr double c1 = 176051, c2 = 4332.63, c = 2e6, d = 2 * (c1 + 2 * c2);
  const auto P = [&](double stretch, double others, double J) {  // others: sum of the squares of the other two
    return 2 * c1 * stretch + 2 * c2 * stretch * others + (2 * c * (J - 1) * J - d) / stretch;
  };
  const auto lateral = [&](double a) { return root(0.5, 2, [&](double l) { return P(l, a * a + l * l, a * l * l); }); };
  const auto axial_stress = [&](double a, double l) { return P(a, 2 * l * l, a * l * l) / (on_current_area ? l * l : 1); };
  const double a = root(0.5, 2, [&](double at) { return axial_stress(at, lateral(at)) - pressing; }), l = lateral(a);
  return {{}, a, l, on_current_area ? pressing : pressing / (l * l)};
}

struct Case {
  std::string deck;
  Exact exact;
};

Exact along(Exact exact, const Vec3<double>& axis) {
  exact.axis = axis;
  return exact;
}

/// The inclined decks press the ends together by 10 %, with Poisson's ratio 0: P = mu (0.9 - 1/0.9).
Exact inclined() { return {{0.5, 0, std::sqrt(0.75)}, 0.9, 1, 0.5e6 * (0.9 - 1 / 0.9)}; }

class PatchTest : public testing::TestWithParam<Case> {
 protected:
  double position_error(const TestScene& s, const std::vector<double>& x) const {
    const Exact& e = GetParam().exact;
    double error = 0;
    for (std::size_t n = 0; n < s.scene.mesh.mesh.coordinates.size(); ++n) {
      const auto& c = s.scene.mesh.mesh.coordinates[n];
      const Vec3<double> X{c[0], c[1], c[2]};
      const Vec3<double> exact = e.lateral * X + ((e.axial - e.lateral) * dot(e.axis, X)) * e.axis;
      for (int i = 0; i < 3; ++i) error = std::max(error, std::abs(x[3 * n + i] - exact[i]));
    }
    return error / 120;
  }

  double stress_at(int i, int j) const { return GetParam().exact.stress * GetParam().exact.axis[i] * GetParam().exact.axis[j]; }

  double gauss_stress_error(const TestScene& s, const std::vector<double>& x) const {
    double error = 0;
    const auto overlap = s.problem.to_overlap(*s.scatter(x));
    for (const auto& body : s.problem.bodies())
      body->sample(overlap->getData().getRawPtr(), [&](const PointSample& at) {
        const auto sigma = cauchy_stress(at.state.P, at.state.F);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) error = std::max(error, std::abs(sigma(i, j) - stress_at(i, j)));
      });
    error = all_reduced(*s.problem.dofs().comm(), Teuchos::REDUCE_MAX, error);
    return error / std::abs(GetParam().exact.stress);
  }

  double nodal_stress_error(const TestScene& s, const Evaluation& at) const {
    constexpr int index[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
    double error = 0;
    const auto stress = nodal_variables(s.problem, s.state, at, variables_of_field("cauchy stress"));
    for (int c = 0; c < 6; ++c)
      for (double value : stress[c]) error = std::max(error, std::abs(value - stress_at(index[c][0], index[c][1])));
    return error / std::abs(GetParam().exact.stress);
  }
};

TEST_P(PatchTest, StressAndPressureAreUniform) {
  TestScene s(input_deck("patch_test/" + GetParam().deck + ".xml"), world(),
              [](Scene& scene) { scene.solver.further_iterations = 1; });
  const auto run = s.march({0.5, 1});
  ASSERT_TRUE(run.converged) << run.cause;
  const auto x = s.gather(*s.state.x);
  double pressure_error = 0;
  for (std::size_t k = s.n_positions(); k < x.size(); ++k)
    pressure_error = std::max(pressure_error, std::abs(x[k] / -GetParam().exact.stress - 1));
  const double position = position_error(s, x), gauss = gauss_stress_error(s, x), nodal = nodal_stress_error(s, run.at);
  EXPECT_EQ(run.at.n_closed, s.scene.n_multipliers);
  EXPECT_LE(position, 1e-12);
  EXPECT_LE(gauss, 1e-10);
  EXPECT_LE(nodal, 1e-10);
  EXPECT_LE(pressure_error, 1e-10);
  if (world()->getRank() == 0)
    std::cout << GetParam().deck << ": errors of positions " << position << ", stress at Gauss points " << gauss << ", at nodes "
              << nodal << ", pressure " << pressure_error << "; " << run.iterations << " iterations\n";
}

TEST_P(PatchTest, IsPassedInEveryReading) {
  const std::string primary = "value=\"lower/top\"/>";
  for (const std::string& option :
       {word("contact force", "interpolated normal"), word("mortar integrals", "start of step"),
        word("complementarity", "fischer burmeister"), deck_parameter("quadrature degree", "int", "3")}) {
    TestScene s(with(input_deck("patch_test/" + GetParam().deck + ".xml"), primary, primary + "\n" + option), world(),
                [](Scene& scene) { scene.solver.further_iterations = 1; });
    const auto run = s.march({0.5, 1});
    ASSERT_TRUE(run.converged) << run.cause << option;
    const auto x = s.gather(*s.state.x);
    EXPECT_LE(position_error(s, x), 1e-12) << option;
    EXPECT_LE(gauss_stress_error(s, x), 1e-10) << option;
  }
}

TEST_P(PatchTest, IsPassedByTiedSurfaces) {
  for (const char* form : {"frame invariant", "plain"}) {
    std::string deck = input_deck("patch_test/" + GetParam().deck + ".xml");
    for (const char* of_contact : {"contact", "output", "expected"}) deck = without_list(deck, of_contact);
    deck = with_lists(deck, list("ties", list("upper on lower", word("secondary", "upper/bottom") + word("primary", "lower/top") +
                                                                    word("form", form))));
    TestScene s(deck, world(), [](Scene& scene) { scene.solver.further_iterations = 1; });
    const int n_pairs = s.scene.ties[0].n_pairs;
    const auto run = s.march({0.5, 1});
    ASSERT_TRUE(run.converged) << run.cause;
    EXPECT_EQ(s.scene.ties[0].n_pairs, n_pairs);  // the reference configuration alone is integrated over
    const auto x = s.gather(*s.state.x);
    EXPECT_LE(position_error(s, x), 1e-12);
    EXPECT_LE(gauss_stress_error(s, x), 1e-10);
    // T = P N, per reference area
    const Exact& e = GetParam().exact;
    const auto traction = nodal_variables(s.problem, s.state, run.at, variables_of_field("tie traction"));
    const Vec3<double> N = s.problem.contacts()[0]->normals(data(*s.problem.to_overlap(*s.problem.reference_state())))[0];
    const double T = e.stress * e.lateral * e.lateral * dot(N, e.axis);
    double error = 0;
    for (int node : s.scene.ties[0].secondary_nodes)
      for (int i = 0; i < 3; ++i) error = std::max(error, std::abs(traction[i][node] - T * e.axis[i]) / std::abs(T));
    EXPECT_LE(error, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Decks, PatchTest,
                         testing::Values(Case{"contact", along(uniaxial(1e6, 0.3, -1e4), {0, 0, 1})},
                                         Case{"conforming", along(uniaxial(1e6, 0.3, -1e4), {0, 0, 1})},
                                         Case{"shifted", along(uniaxial(1e6, 0.3, -1e4), {0, 0, 1})},
                                         Case{"rotated", along(uniaxial(1e6, 0.3, -1e4), {0, 1, 0})},
                                         Case{"inclined", inclined()},
                                         Case{"mooney_rivlin_dead", along(mooney_rivlin(-1e5, false), {0, 0, 1})},
                                         Case{"mooney_rivlin_follower", along(mooney_rivlin(-1e5, true), {0, 0, 1})}),
                         [](const auto& info) { return info.param.deck; });

}  // namespace
}  // namespace mortise::test
