// Closing by `velocity update`: what contact took from a step goes back into the velocities at its end.
#pragma once

#include <string>

#include "assembly/step_problem.hpp"
#include "solve/linear_solver.hpp"

namespace mortise {

/// Lets velocities jump, contact after contact that closes by `velocity update`, along the mass' answer to the force f of its
/// pressures at the end of the step, with Jacobians from there so that momenta stay: v <- v + b M^-1 f with b [s] such that the
/// work of the contact in the step and that of its impulse b f are nothing together,
///   W + b f . v + b^2/2 f . M^-1 f = 0.
/// Of the two roots the one after which the surfaces part; where there is none, the jump takes as much of W as it can. One
/// number for each contact, after Laursen & Love (2002), who have one for each node. Collective.
/// @param from, to states before and after the step; `to.v` changes  @param at its evaluation; the jump is noted there
/// @return an empty text, or why the mass matrix gives no answer
std::string update_velocities(StepProblem& problem, LinearSolver& linear, const State& from, State& to, Evaluation& at);

}  // namespace mortise
