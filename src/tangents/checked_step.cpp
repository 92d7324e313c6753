#include "tangents/checked_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "assembly/vectors.hpp"
#include "errors.hpp"

namespace mortise {
namespace {

/// A direction, what the tangent makes of it, and the size of what that is made of.
struct Direction {
  RCP<Vector> d;
  Vector product, size;
  double no_force;  ///< a row of positions below is round-off of the others, as of a slack string across itself
};

/// sum_j |K_ij d_j|
Vector magnitudes(const Matrix& K, const Vector& d) {
  Vector seen(K.getColMap()), sums(K.getRowMap());
  if (const auto importer = K.getGraph()->getImporter(); !importer.is_null()) {
    seen.doImport(d, *importer, Tpetra::INSERT);
  } else {
    seen.assign(d);
  }
  const auto local = K.getLocalMatrixHost();
  const double* from = data(seen);
  double* to = data(sums);
  for (int row = 0; row < local.numRows(); ++row)
    for (auto entry = local.graph.row_map(row); entry < local.graph.row_map(row + 1); ++entry)
      to[row] += std::abs(local.values(entry) * from[local.graph.entries(entry)]);
  return sums;
}

/// Random directions, alike on any number of ranks.
std::vector<Direction> random_directions(const StepProblem& problem, const Vector& x, const Matrix& K) {
  const DofSpace& dofs = problem.dofs();
  const double* unknowns = data(x);
  std::mt19937 engine{20240229};
  std::vector<Direction> directions;
  for (int n = 0; n < n_step_directions; ++n) {
    std::vector<double> all(dofs.n_unknowns());
    for (double& entry : all) entry = 2 * (engine() * 0x1p-32) - 1;
    const auto direction = problem.scatter(all);
    double* d = data(*direction);
    for (int k = 0; k < dofs.n_owned(); ++k) d[k] *= k < dofs.n_owned_positions() ? problem.scene().size : std::abs(unknowns[k]);
    Direction along{direction, Vector(x.getMap()), magnitudes(K, *direction), 0};
    K.apply(*direction, along.product);
    const double* size = data(along.size);
    const double greatest = dofs.n_owned_positions() > 0 ? *std::max_element(size, size + dofs.n_owned_positions()) : 0;
    along.no_force = 1e-12 * all_reduced(*dofs.comm(), Teuchos::REDUCE_MAX, greatest);
    directions.push_back(along);
  }
  return directions;
}

/// Rows of contact that is closed or two-sided, and all that is none of contact.
std::vector<char> compared_rows(const StepProblem& problem, const Evaluation& at) {
  std::vector<char> compared(problem.dofs().n_owned(), 1);
  for (const auto& contact : problem.contacts())
    for (std::size_t k = 0; k < contact->nodes().secondary_nodes.size() && !contact->nodes().is_two_sided; ++k)
      if (const int point = contact->pressure_point(k); problem.dofs().owned(point))
        compared[problem.dofs().local(point)] = at.closed[contact->nodes().first_multiplier + k];
  return compared;
}

}  // namespace

StepTangent tangent_difference(StepProblem& problem, const Vector& x, const Matrix& K) {
  const Comm& comm = *problem.dofs().comm();
  const int n_owned = problem.dofs().n_owned(), n_positions = problem.dofs().n_owned_positions();
  std::vector<char> compared = compared_rows(problem, problem.evaluate(x));
  for (int k = 0; k < n_owned; ++k) compared[k] = compared[k] && !problem.identity_rows()[k];
  const auto directions = random_directions(problem, x, K);
  StepTangent result;
  result.n_rows = all_reduced(comm, Teuchos::REDUCE_SUM, static_cast<int>(std::count(compared.begin(), compared.end(), 1)));
  result.difference = std::numeric_limits<double>::infinity();
  for (double h : {1e-3, 1e-4, 1e-5, 1e-6}) {
    double greatest = 0;
    for (const Direction& along : directions) {
      const auto moved = [&](double step) {
        Vector to(x, Teuchos::Copy);
        to.update(step, *along.d, 1.0);
        return problem.evaluate(to);
      };
      const Evaluation ahead = moved(h), behind = moved(-h);
      if (!ahead.admissible || !behind.admissible) {
        greatest = std::numeric_limits<double>::infinity();
        continue;
      }
      const std::vector<char> closed_ahead = compared_rows(problem, ahead), closed_behind = compared_rows(problem, behind);
      const double *product = data(along.product), *size = data(along.size), *plus = data(*ahead.residual),
                   *minus = data(*behind.residual);
      for (int k = 0; k < n_owned; ++k) {
        const bool is_seen =
            compared[k] && closed_ahead[k] && closed_behind[k] && size[k] > (k < n_positions ? along.no_force : 0);
        if (is_seen) greatest = std::max(greatest, std::abs((plus[k] - minus[k]) / (2 * h) - product[k]) / size[k]);
      }
    }
    result.difference = std::min(result.difference, all_reduced(comm, Teuchos::REDUCE_MAX, greatest));
  }
  return result;
}

std::vector<StepTangent> check_steps(StepProblem& problem, const Vector& deformed) {
  const std::vector<Stage>& stages = problem.scene().stages;
  std::vector<StepTangent> results;
  State state = problem.initial_state();
  for (std::size_t k = 0; k < stages.size(); ++k) {
    state.time = stages[k].begin;
    state = problem.enter_stage(k, state);
    const double dt = stages[k].time.step;
    if (const std::string fault = problem.begin_step(state, state.time + dt); !fault.empty()) throw DeckError(fault);
    RCP<Matrix> K;
    problem.linearise(deformed, K);
    results.push_back(tangent_difference(problem, deformed, Matrix(*K, Teuchos::Copy)));
    results.back().name =
        fmt::format("a step{}: {}, dt = {:g}", stages[k].name.empty() ? "" : " of stage \"" + stages[k].name + "\"",
                    name_of_kind(stages[k].time.scheme), dt);
  }
  return results;
}

}  // namespace mortise
