// Fields of results: exact for a homogeneous deformation on every element, and the same on any number of ranks.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>

#include "assembly/vectors.hpp"
#include "output/element_fields.hpp"
#include "output/nodal.hpp"
#include "support/unit_block.hpp"

namespace mortise::test {
namespace {

using Matrix3 = Eigen::Matrix3d;

const Matrix3 F = (Matrix3() << 1.15, 0.2, 0.05, -0.1, 0.95, 0.12, 0.03, -0.08, 1.1).finished();

Matrix3 matrix(const Tensor3<double>& A) {
  Matrix3 M;
  for (int k = 0; k < 9; ++k) M(k / 3, k % 3) = A(k / 3, k % 3);
  return M;
}

/// What a uniform state with deformation gradient F must give, by the names of tensors and scalars in files.
struct Exact {
  std::map<std::string, Matrix3> tensors;
  std::map<std::string, double> scalars;

  /// @param P first Piola stress, @param W energy density
  Exact(const Matrix3& P, double W) {
    const Matrix3 I = Matrix3::Identity(), sigma = P * F.transpose() / F.determinant(), s = sigma - sigma.trace() / 3 * I;
    tensors["stress"] = sigma;
    tensors["kirchhoff_stress"] = P * F.transpose();
    tensors["first_piola_stress"] = P;
    tensors["second_piola_stress"] = F.inverse() * P;
    tensors["green_lagrange_strain"] = (F.transpose() * F - I) / 2;
    tensors["almansi_strain"] = (I - (F * F.transpose()).inverse()) / 2;
    scalars["von_mises"] = std::sqrt(1.5 * s.squaredNorm());
    scalars["volume_ratio"] = F.determinant();
    scalars["energy_density"] = W;
  }

  /// A variable of a node, or one of a point without its number.
  double of(const std::string& variable) const {
    if (const auto found = scalars.find(variable); found != scalars.end()) return found->second;
    const int i = variable[variable.size() - 2] - 'x', j = variable.back() - 'x';
    return tensors.at(variable.substr(0, variable.size() - 3))(i, j);
  }
};

bool is_principal(const std::string& variable) { return variable.rfind("principal_", 0) == 0; }

/// sigma from its principal values and directions must be sigma; the greatest value comes first.
/// @param value of a variable without the number of a point
void expect_principal_parts(const Matrix3& sigma, const std::function<double(const std::string&)>& value) {
  Matrix3 sum = Matrix3::Zero();
  for (const std::string k : {"1", "2", "3"}) {
    Eigen::Vector3d n;
    for (int i = 0; i < 3; ++i) n[i] = value("principal_direction_" + k + "_" + "xyz"[i]);
    EXPECT_NEAR(n.norm(), 1, 1e-12);
    sum += value("principal_stress_" + k) * n * n.transpose();
  }
  EXPECT_LE((sum - sigma).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT(value("principal_stress_1"), value("principal_stress_2"));
  EXPECT_GT(value("principal_stress_2"), value("principal_stress_3"));
}

std::vector<std::string> point_variables() {
  std::vector<std::string> all;
  for (const std::string& field : point_field_names())
    for (const std::string& variable : variables_of_field(field)) all.push_back(variable);
  return all;
}

std::vector<Field> point_fields() {
  std::vector<Field> fields;
  for (const std::string& name : point_field_names()) fields.push_back(field_named(name));
  return fields;
}

class FieldsOf : public testing::TestWithParam<ElementCase> {
 protected:
  /// A distorted block of two bricks a side, stretched and sheared by F.
  TestScene stretched() const {
    const std::string material = word("model", GetParam().is_mixed() ? "neo-hookean isochoric-volumetric" : "neo-hookean");
    Formulas u;
    for (int i = 0; i < 3; ++i)
      u[i] = fmt::format("{:.17g}*x + {:.17g}*y + {:.17g}*z", F(i, 0) - (i == 0), F(i, 1) - (i == 1), F(i, 2) - (i == 2));
    return TestScene(unit_block(GetParam(), 2, material + number("youngs modulus", "1") + number("poissons ratio", "0.3"), u, {}),
                     world(), [](Scene& scene) {
                       scene.solver.further_iterations = 1;
                       distort_inside(scene.mesh.mesh, 0.06);
                     });
  }

  static Exact exact(const TestScene& s) {
    Tensor3<double> at;
    for (int k = 0; k < 9; ++k) at(k / 3, k % 3) = F(k / 3, k % 3);
    return std::visit([&](const auto& m) { return Exact(matrix(m.first_piola(at)), m.strain_energy(at)); },
                      s.scene.bodies[0].material);
  }
};

TEST_P(FieldsOf, AHomogeneousDeformationAreExactAtNodesAndPoints) {
  TestScene s = stretched();
  const auto run = s.march({1});
  ASSERT_TRUE(run.converged) << run.cause;
  const Exact expected = exact(s);

  const auto names = point_variables();
  const auto nodal = nodal_variables(s.problem, s.state, run.at, names);
  for (std::size_t v = 0; v < names.size(); ++v)
    for (std::size_t a = 0; a < nodal[v].size() && !is_principal(names[v]); ++a)
      ASSERT_NEAR(nodal[v][a], expected.of(names[v]), 1e-11) << names[v] << ", node " << a;
  for (std::size_t a = 0; a < nodal[0].size(); ++a)
    expect_principal_parts(expected.tensors.at("stress"), [&](const std::string& name) {
      return nodal[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())][a];
    });

  const ElementFields elements(s.scene, point_fields());
  const auto& variables = elements.variables();
  const auto values = elements.values(s.problem, s.state);
  const std::size_t n_points = with_element(GetParam().type, [](auto e) { return decltype(e)::stiffness_rule.size(); });
  ASSERT_EQ(variables.names.size(), names.size() * n_points);
  EXPECT_EQ(variables.in_block, std::vector<int>(variables.names.size(), 1));
  if (world()->getRank() != 0) {
    EXPECT_TRUE(values.empty());
    return;
  }
  ASSERT_EQ(values.size(), variables.names.size());
  for (std::size_t g = 0; g < n_points; ++g) {
    const std::string number = "_" + std::to_string(g + 1);
    const auto of = [&](const std::string& name) -> const std::vector<double>& {
      return values.at(static_cast<std::size_t>(std::find(variables.names.begin(), variables.names.end(), name + number) -
                                                variables.names.begin()));
    };
    for (const std::string& name : names)
      for (std::size_t e = 0; e < of(name).size() && !is_principal(name); ++e)
        ASSERT_NEAR(of(name)[e], expected.of(name), 1e-11) << name << ", element " << e << ", point " << g;
    for (std::size_t e = 0; e < values[0].size(); ++e)
      expect_principal_parts(expected.tensors.at("stress"), [&](const std::string& name) { return of(name)[e]; });
  }
}

TEST_P(FieldsOf, ARandomStateHaveEnergyDensitiesThatAddUpToTheEnergy) {
  TestScene s = stretched();
  Random random(6);
  const auto x = s.problem.to_overlap(*s.scatter(s.random_state(random, 0.02, -0.1, 0.1)));
  double sum = 0;
  for (const auto& body : s.problem.bodies())
    body->sample(data(*x), [&](const PointSample& at) { sum += at.JxW * at.state.strain_energy; });
  const double energy = s.problem.strain_energy(data(*x));
  EXPECT_GT(all_reduced(*world(), Teuchos::REDUCE_SUM, energy), 1e-4);
  EXPECT_NEAR(sum, energy, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Elements, FieldsOf, testing::ValuesIn(element_cases()), name_of_case);

/// A contact scene in a random state: nothing in it is alike.
struct RandomState {
  TestScene scene;
  State state;
  Evaluation at;

  explicit RandomState(const RCP<const Comm>& comm) : scene(input_deck("patch_test/shifted.xml"), comm), state(scene.state) {
    Random random(9);
    const double size = 0.03 * scene.scene.bodies[0].size;
    state.x = scene.scatter(scene.random_state(random, size, 0, 1e4));
    at = scene.problem.evaluate(*state.x);
  }
};

void expect_equal_to_round_off(const std::vector<std::string>& names, const std::vector<std::vector<double>>& all,
                               const std::vector<std::vector<double>>& one) {
  ASSERT_EQ(all.size(), one.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    ASSERT_EQ(all[v].size(), one[v].size());
    EXPECT_LE(relative_difference(all[v], one[v], 0, one[v].size()), 1e-11) << names[v];
  }
}

TEST(Fields, AreTheSameOnOneRankAndOnAll) {
  RandomState all(world()), one(alone());
  ASSERT_TRUE(all.at.admissible);
  std::vector<std::string> names;
  for (const FieldEntry& entry : field_table)
    if (entry.need != FieldNeed::inertia)
      for (const std::string& variable : variables_of_field(entry.name)) names.push_back(variable);
  EXPECT_GE(names.size(), 60u);
  expect_equal_to_round_off(names, nodal_variables(all.scene.problem, all.state, all.at, names),
                            nodal_variables(one.scene.problem, one.state, one.at, names));
  const ElementFields elements(all.scene.scene, point_fields());
  const auto on_all = elements.values(all.scene.problem, all.state), on_one = elements.values(one.scene.problem, one.state);
  if (world()->getRank() == 0) expect_equal_to_round_off(elements.variables().names, on_all, on_one);
}

TEST(Fields, ThatTheDeckReaderRefusesAreErrorsOfTheProgram) {
  RandomState s(world());
  for (const std::string name : {"velocity_x", "acceleration_z", "no_such_variable", "displacement"})
    EXPECT_THROW(nodal_variables(s.scene.problem, s.state, s.at, {name}), std::logic_error) << name;
}

}  // namespace
}  // namespace mortise::test
