// The linear solver of a run: the direct or the iterative one, chosen by the deck or by size.
#pragma once

#include <string>
#include <variant>

#include "assembly/dof_space.hpp"
#include "solve/direct_solver.hpp"
#include "solve/iterative_solver.hpp"

namespace mortise {

/// One of two; which one and why can be asked for.
class LinearSolver {
 public:
  LinearSolver(const Scene& scene, const DofSpace& dofs, const SolverOptions& options);

  /// Solves A x = b and checks the true residual; identity rows are taken out first (A and b are changed).
  LinearReport solve(Matrix& A, Vector& b, Vector& x, const std::vector<char>& identity_rows, long graph_number);

  const std::string& choice() const { return choice_; }
  const DirectSolver* direct() const { return std::get_if<DirectSolver>(&solver_); }

 private:
  std::variant<DirectSolver, IterativeSolver> solver_;
  std::string choice_;
  double accepted_residual_;
};

}  // namespace mortise
