// The ledger of a run: what became of the energy and the momenta, step by step (conventions, section 7).
#pragma once

#include <array>
#include <vector>

#include "assembly/step_problem.hpp"

namespace mortise {

/// Sums of works and impulses since the start, and what the next step's are counted from.
struct Ledger {
  double external = 0, contact = 0, closing = 0, resegmentation = 0, algorithmic = 0, residual = 0;  ///< [J]
  double damping = 0, friction = 0;                                                                  ///< dissipated [J]
  double mismatch = 0;                                                                               ///< of the last step [J]
  double strain_energy = 0, kinetic_energy = 0, stick_energy = 0;                                    ///< [J]
  std::vector<char> closed;                               ///< per multiplier of the scene
  std::vector<double> weighted_gap;                       ///< likewise [m^3]
  std::vector<double> linear_momentum, angular_momentum;  ///< of the state [kg m/s], [kg m^2/s]; about the origin
  /// Of loads, reactions, damping, the ground and the residual, since the start, with what the state had then: without a mismatch
  /// the momenta.
  std::vector<double> linear_balance, angular_balance;

  /// |momentum - balance| [kg m/s], [kg m^2/s]
  double linear_mismatch() const;
  double angular_mismatch() const;
};

/// Begins with the initial state. Collective, as all that follows.
void open_ledger(Ledger& ledger, StepProblem& problem, const State& state, const Evaluation& at);

/// Enters a stage at its start: what it gives to or takes from the motion is external work, and an impulse in the balance.
void enter_stage(Ledger& ledger, StepProblem& problem, const State& start);

/// Adds an accepted step. @param at the evaluation that the step ended with
void add_step(Ledger& ledger, StepProblem& problem, const State& before, const State& now, const Evaluation& at);

}  // namespace mortise
