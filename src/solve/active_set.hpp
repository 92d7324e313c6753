// The Newton direction of a contact problem: the active set is settled on the linearised equations before the state moves.
#pragma once

#include "assembly/step_problem.hpp"
#include "solve/linear_solver.hpp"

namespace mortise {

/// What it took to find a direction.
struct DirectionReport : LinearReport {
  int factorisations = 0;
  int solves = 0;
};

/// Solves the linearised step: K dx = -R with, for every covered secondary node, either  p + dp = 0  (open) or  gap + d gap = 0
/// (closed), such that p + dp >= 0 where closed and gap + d gap >= 0 where open; with the state moved after every guess of the
/// set, pressures of a wrong set would enter the geometry. Starts from the branches of the law at `x`. Many wrong nodes: the set
/// is changed and the matrix factored anew (primal-dual active set, Hueber & Wohlmuth 2005). A few: the matrix stays, each of
/// them costs one solve for its influence, and the small complementarity problem among them is solved by pivoting, which cannot
/// cycle for the matrices of elastic bodies.
/// @param tangent with gap rows for all covered nodes; not changed  @param direction result, on the owned map
DirectionReport find_direction(const StepProblem& problem, const Vector& x, const Evaluation& at, const Matrix& tangent,
                               LinearSolver& linear, Vector& direction);

}  // namespace mortise
