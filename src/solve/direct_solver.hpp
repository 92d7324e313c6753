// Sparse LU by MUMPS through its C interface.
#pragma once

#include <memory>

#include "solve/linear_system.hpp"

namespace mortise {

/// Unsymmetric MUMPS with a nested-dissection ordering (METIS) of groups of unknowns: a node with its pressure stays together.
/// Below 50,000 unknowns it factors on one rank, which keeps reruns on the same ranks bitwise equal; above on all ranks.
/// The analysis is kept as long as the graph stands; too little workspace (-9) is met with more and a second try.
class DirectSolver {
 public:
  /// @param group per global unknown: unknowns of one group are eliminated next to each other
  /// @param largest_on_one_rank systems below are gathered and factored on rank 0, others on all ranks
  DirectSolver(const RCP<const Map>& map, std::vector<int> group, int largest_on_one_rank = 50000);
  ~DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;

  /// Factors A for `solve(b, x)`. @param graph_number changes when the graph of A has changed since the last call
  LinearReport factor(const Matrix& A, long graph_number);

  /// Solves with the last factors.
  LinearReport solve(const Vector& b, Vector& x);

  /// Solves A x = b: factors, then solves. @param graph_number changes when the graph of A has changed since the last call
  LinearReport solve(const Matrix& A, const Vector& b, Vector& x, long graph_number);

  long analyses() const;
  double factor_entries() const;  ///< entries of the last factors
  double seconds_analysis() const;
  double seconds_factor() const;
  double seconds_solve() const;

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
};

}  // namespace mortise
