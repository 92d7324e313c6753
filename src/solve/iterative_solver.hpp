// GMRES by Belos with a block preconditioner by Ifpack2 for positions and pressures.
#pragma once

#include <memory>

#include "deck/options.hpp"
#include "solve/linear_system.hpp"

namespace mortise {

/// GMRES, preconditioned by elimination of the positions: RILUK for their forces, the diagonal blocks of K for the Schur
/// complement of the pressures (block_preconditioner.hpp). Converged when the residual, computed afresh, is below the tolerance
/// both relative to |b| as it stands and with its rows weighted to energies.
class IterativeSolver {
 public:
  /// @param n_positions global number of position unknowns; what follows are pressures
  IterativeSolver(const RCP<const Map>& map, long long n_positions, const SolverOptions& options);
  ~IterativeSolver();
  IterativeSolver(IterativeSolver&&) noexcept;

  /// Solves A x = b from x = 0; rows that hold nothing but their diagonal are solved at once.
  /// Builds the preconditioner for `solve(b, x)`. A must live as long as these solves.
  LinearReport prepare(const Matrix& A);

  /// Solves with the last matrix.
  LinearReport solve(const Vector& b, Vector& x);

  /// Solves A x = b: prepares, then solves.
  LinearReport solve(const Matrix& A, const Vector& b, Vector& x);

 private:
  struct Blocks;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace mortise
