#include "tangents/perturbation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

/// Uniform in [low, high), alike on every machine.
class Random {
 public:
  double in(double low, double high) { return low + (high - low) * (engine_() * 0x1p-32); }

 private:
  std::mt19937 engine_{20240229};
};

bool is_admissible(const StepProblem& problem, const Vector& x) {
  const auto overlap_x = problem.to_overlap(x);
  Vector force(problem.dofs().overlap_map());
  int good = 1;
  for (const auto& body : problem.bodies())
    if (!body->add_force(data(*overlap_x), data(force))) good = 0;
  return all_reduced(*problem.dofs().comm(), Teuchos::REDUCE_MIN, good) == 1;
}

std::vector<double> state(const StepProblem& problem, double factor) {
  constexpr double pi = 3.14159265358979323846;
  const Scene& scene = problem.scene();
  const auto& X = scene.mesh.mesh.coordinates;
  const std::size_t n_positions = 3 * X.size();
  std::vector<double> x(problem.dofs().n_unknowns(), 0.0), edge(X.size(), std::numeric_limits<double>::max());
  for (const auto& body : scene.bodies)
    for (int node : body.nodes) edge[node] = std::min(edge[node], body.size);
  Random random;
  for (std::size_t k = 0; k < n_positions; ++k) {
    const Point& at = X[k / 3];
    const double h = edge[k / 3], phase = 2 * pi * ((at[0] + at[1] + at[2]) / (8 * h) + static_cast<double>(k % 3) / 3);
    const double noise = random.in(-0.02, 0.02);
    x[k] = at[k % 3];
    if (h < std::numeric_limits<double>::max()) x[k] += factor * h * (0.08 * std::sin(phase) + noise);  // a node of some body
  }
  for (const ContactNodes* contact : scene.contacts())
    for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k) {
      const int point = problem.dofs().n_nodes() + contact->first_multiplier + static_cast<int>(k);
      double* at = &x[problem.dofs().global(point)];
      *at = contact->youngs_modulus * random.in(0.05, 0.15);
      for (int i = 1; i < contact->n_unknowns; ++i) at[i] = contact->youngs_modulus * random.in(-0.05, 0.05);
    }
  if (!scene.first_pressure.empty())
    for (const auto& body : scene.bodies)
      for (int e : body.elements)
        for (int m = 0; m < scene.first_pressure[e + 1] - scene.first_pressure[e]; ++m)
          x[problem.dofs().global(scene.pressure_point(e, m))] = body.youngs_modulus * random.in(-0.05, 0.05);
  return x;
}

}  // namespace

Perturbation perturbed(const StepProblem& problem) {
  for (double factor = 1; factor > 1e-3; factor /= 2) {
    const auto x = problem.scatter(state(problem, factor));
    problem.settle_springs(*x);
    if (is_admissible(problem, *x)) return {x, factor};
  }
  throw std::runtime_error("no admissible deformed state was found");
}

}  // namespace mortise
