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

  /// Takes a matrix for the solves that follow: identity rows are taken out of a copy, which the direct solver factors.
  LinearReport factor(const RCP<const Matrix>& A, const std::vector<char>& identity_rows, long graph_number);

  /// Solves A x = b with the last matrix, and checks the true residual.
  LinearReport solve(const Vector& b, Vector& x);

  const std::string& choice() const { return choice_; }
  const DirectSolver* direct() const { return std::get_if<DirectSolver>(&solver_); }

 private:
  std::variant<DirectSolver, IterativeSolver> solver_;
  std::string choice_;
  GlobalIndex n_positions_;
  double no_length_;
  double accepted_residual_;
  RCP<const Matrix> original_;  // of the last `factor`
  RCP<Matrix> reduced_;         // without the columns of known unknowns
  std::vector<char> identity_rows_;
};

}  // namespace mortise
