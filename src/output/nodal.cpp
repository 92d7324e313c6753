// Nodal quantities for results and probes.
#include <array>
#include <stdexcept>

#include <Teuchos_CommHelpers.hpp>

#include "output/history.hpp"

namespace mortise {
namespace {

// Volume-weighted means of the Gauss points' values at the nodes.
std::vector<double> nodal_stress(const StepProblem& problem, const State& state, int component) {
  const int n = problem.dofs().n_nodes();
  std::vector<double> stress(7 * static_cast<std::size_t>(n), 0.0), volume(n, 0.0);
  const auto x = problem.to_overlap(*state.x);
  for (const auto& body : problem.bodies())
    body->sample(x->getData().getRawPtr(), [&](const PointSample& at) {
      const Tensor3<double> s = cauchy_stress(at.state.P, at.state.F);
      const double components[7] = {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0), von_mises(s)};
      for (int a = 0; a < at.n_nodes; ++a) {
        const double weight = at.N[a] * at.JxW;
        for (int k = 0; k < 7; ++k) stress[7 * static_cast<std::size_t>(at.nodes[a]) + k] += weight * components[k];
        volume[at.nodes[a]] += weight;
      }
    });
  std::vector<double> shares(2 * static_cast<std::size_t>(n)), all(shares.size());
  for (int a = 0; a < n; ++a) {
    shares[2 * a] = stress[7 * static_cast<std::size_t>(a) + component];
    shares[2 * a + 1] = volume[a];
  }
  Teuchos::reduceAll(*problem.dofs().comm(), Teuchos::REDUCE_SUM, static_cast<int>(shares.size()), shares.data(), all.data());
  std::vector<double> values(n);
  for (int a = 0; a < n; ++a) values[a] = all[2 * a + 1] > 0 ? all[2 * a] / all[2 * a + 1] : 0.0;
  return values;
}

std::vector<double> at_secondary_nodes(const StepProblem& problem, const std::vector<double>& unknowns) {
  const int n = problem.dofs().n_nodes();
  std::vector<double> values(n, 0.0);
  for (const auto& pair : problem.scene().pairs)
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k)
      values[pair.secondary_nodes[k]] = unknowns[3 * static_cast<std::size_t>(n) + pair.first_multiplier + k];
  return values;
}

std::vector<double> component_of(const std::vector<double>& unknowns, int n, int axis) {
  std::vector<double> values(n);
  for (int a = 0; a < n; ++a) values[a] = unknowns[3 * static_cast<std::size_t>(a) + axis];
  return values;
}

}  // namespace

std::vector<double> nodal_quantity(const StepProblem& problem, const State& state, const Evaluation& at,
                                   const std::string& name) {
  const int n = problem.dofs().n_nodes();
  const Scene& scene = problem.scene();
  constexpr std::array<const char*, 7> stresses{"stress_xx", "stress_yy", "stress_zz", "stress_xy",
                                                "stress_yz", "stress_zx", "von_mises"};
  for (int c = 0; c < 7; ++c)
    if (name == stresses[c]) return nodal_stress(problem, state, c);
  const int axis = name.back() - 'x';
  const bool has_axis = name.size() > 2 && name[name.size() - 2] == '_' && axis >= 0 && axis < 3;
  if (has_axis && (name.rfind("displacement_", 0) == 0 || name.rfind("position_", 0) == 0)) {
    auto values = component_of(problem.gather(*state.x), n, axis);
    if (name[0] == 'd')
      for (int a = 0; a < n; ++a) values[a] -= scene.mesh.mesh.coordinates[a][axis];
    return values;
  }
  if (has_axis && name.rfind("reaction_", 0) == 0) {
    const auto unbalanced = problem.gather(*at.unbalanced);
    std::vector<double> values(n, 0.0);
    for (const auto& p : *at.prescribed)
      if (p.axis == axis) values[p.node] = unbalanced[3 * static_cast<std::size_t>(p.node) + axis];
    return values;
  }
  if (name == "contact_pressure") return at_secondary_nodes(problem, problem.gather(*state.x));
  if (name == "gap")
    return scene.pairs.empty() ? std::vector<double>(n, 0.0) : at_secondary_nodes(problem, problem.gather(*at.gap));
  if (name == "status") {
    std::vector<double> values(n, 0.0);
    for (const auto& pair : scene.pairs)
      for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k)
        values[pair.secondary_nodes[k]] = at.closed[pair.first_multiplier + k];
    return values;
  }
  throw std::logic_error("no nodal quantity \"" + name + "\"");
}

std::vector<std::string> variables_of_field(const std::string& field) {
  if (field == "displacement" || field == "reaction") return {field + "_x", field + "_y", field + "_z"};
  if (field == "von mises") return {"von_mises"};
  if (field == "cauchy stress") return {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"};
  if (field == "contact pressure") return {"contact_pressure"};
  return {field};
}

}  // namespace mortise
