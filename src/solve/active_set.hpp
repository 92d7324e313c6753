// The Newton direction of a contact problem: the active set is settled on the linearised equations before the state moves.
#pragma once

#include "assembly/step_problem.hpp"
#include "solve/linear_solver.hpp"

namespace mortise {

/// What it took to find a direction.
struct DirectionReport : LinearReport {
  int solves = 0;  ///< linear systems, one per active set tried
};

/// Solves the linearised step: K dx = -R with, for every covered secondary node, either  p + dp = 0  (open) or  gap + d gap = 0  (closed),
/// such that p + dp >= 0 where closed and gap + d gap >= 0 where open. A primal-dual active set (Hueber & Wohlmuth 2005) with the tangent
/// held, starting from the branches of the law at `x`: with the state moved after every guess of the set, pressures of a wrong set would
/// enter the geometry. If the sets repeat, the last direction is returned; Newton's own cycle detection sees to the rest.
/// @param tangent with gap rows for all covered nodes; not changed  @param direction result, on the owned map
DirectionReport find_direction(const StepProblem& problem, const Vector& x, const Evaluation& at, const Matrix& tangent, LinearSolver& linear,
                               Vector& direction);

}  // namespace mortise
