// GMRES by Belos with a block preconditioner by Ifpack2 for positions and pressures.
#pragma once

#include <memory>

#include "deck/options.hpp"
#include "solve/linear_system.hpp"

namespace mortise {

/// GMRES, preconditioned by a block lower-triangular matrix: positions by RILUK, pressures by RILUK of the Schur complement
/// - B1 diag(K)^-1 B2 (rows of open pressures are the identity).
class IterativeSolver {
 public:
  /// @param n_positions global number of position unknowns; what follows are pressures
  IterativeSolver(const RCP<const Map>& map, long long n_positions, const SolverOptions& options);
  ~IterativeSolver();
  IterativeSolver(IterativeSolver&&) noexcept;

  LinearReport solve(const Matrix& A, const Vector& b, Vector& x);

 private:
  struct Blocks;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace mortise
