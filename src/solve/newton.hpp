// One step solved: Newton's method with a semismooth active set, run by NOX.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assembly/step_problem.hpp"
#include "solve/linear_solver.hpp"

namespace mortise {

/// One line of the active-set log: the state at the start of an iteration or at its end.
struct NewtonLine {
  double force_residual = 0, force_scale = 0;  ///< [N]
  double gap_residual = 0;                     ///< [m]
  int closed = 0, opened_now = 0, closed_now = 0;
  int linear_iterations = 0;
  int factorisations = 0, linear_solves = 0;
  double step_length = 1;
};

/// Outcome of a step: the new state, or the cause why there is none. Never an exception.
struct StepResult {
  bool converged = false;
  State state;
  Evaluation evaluation;  ///< at the new state
  int iterations = 0;
  std::vector<NewtonLine> log;
  std::string cause;           ///< why not, in words
  bool is_deck_fault = false;  ///< a formula gives no value, or two supports differ: `cause` is the message, with its place
  bool is_free = false;        ///< a body can move as a rigid one: no smaller step will help
  std::vector<int> unsettled;  ///< multipliers whose branch changed in the last iteration
};

/// Solves step after step; keeps the linear solver with its analysis.
class Newton {
 public:
  Newton(StepProblem& problem, const SolverOptions& options);

  /// Solves for the state at time `t`, starting from the state before (old positions, old pressures).
  StepResult solve(const State& from, double t);

  /// Finds the accelerations of a state at rest in time:  M a = f_ext - f_int - f_damping - f_contact; supported components have
  /// none. @return an empty text, or why there are none
  std::string find_acceleration(State& state);

  const LinearSolver& linear_solver() const { return linear_; }
  LinearSolver& linear_solver() { return linear_; }
  double seconds_linear() const { return seconds_linear_; }

 private:
  RCP<Vector> first_guess(const State& from, double t);
  void iterate(const State& from, const RCP<Vector>& x, StepResult& result);

  StepProblem& problem_;
  SolverOptions options_;
  LinearSolver linear_;
  double seconds_linear_ = 0;
};

}  // namespace mortise
