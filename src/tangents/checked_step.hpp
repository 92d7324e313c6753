// The tangent of a whole step: what Newton solves with, in the schemes of a deck, against differences of the step's residual.
#pragma once

#include <string>
#include <vector>

#include "assembly/step_problem.hpp"

namespace mortise {

/// One stage's step at a deformed state.
struct StepTangent {
  std::string name;       ///< e.g. `a step of stage "flight": energy momentum, dt = 0.01`
  double difference = 0;  ///< see `tangent_difference`
  int n_rows = 0;         ///< compared, of all ranks
};

/// Greatest difference of the tangents of a step, relative. Differences are no better than 1e-9 of a row's greatest parts.
inline constexpr double step_tangent_limit = 1e-7;
inline constexpr int n_step_directions = 3;

/// K d against central differences of the residual along random directions d, per row over sum |K_ij d_j|: the greatest over rows
/// and directions, for the step size of differences at which it is least. Positions are moved by parts of the size of elements,
/// all else by parts of itself. Rows that are identities and those of open contact are left out: they are not those of the
/// residual. A step must have begun. Collective.
/// @param K tangent at `x` (owned)
StepTangent tangent_difference(StepProblem& problem, const Vector& x, const Matrix& K);

/// The first step of every stage of a scene, from its initial state to a deformed one. Collective.
/// @throws DeckError for a formula without value, MeshError for surfaces inside each other
std::vector<StepTangent> check_steps(StepProblem& problem, const Vector& deformed);

}  // namespace mortise
