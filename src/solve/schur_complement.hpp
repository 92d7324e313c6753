// The Schur complement of the pressures, formed with the diagonal of the positions' block, and its inverse.
#pragma once

#include <vector>

#include "solve/block_split.hpp"
#include "solve/riluk.hpp"

namespace mortise {

/// S = C - B2 D^-1 B1 with D the 3 x 3 diagonal blocks of K. Rows of open pressures are those of C.
/// With few closed pressures S is factored exactly, as a dense matrix on every rank; beyond that by RILUK.
class SchurComplement {
 public:
  /// @param largest_dense closed pressures up to which S is dense: 2000 take 32 MB and about a second per rank
  explicit SchurComplement(const BlockSplit& blocks, int largest_dense = 2000);

  /// Forms and factors S. Collective. @param D_inverse the inverse of D on the positions' rows
  void factor(const Matrix& D_inverse);

  /// y = S^-1 r
  void solve(const Vector& r, Vector& y) const;

  /// u -= D^-1 B1 p: what the pressures do to the positions.
  void move(const Vector& p, Vector& u) const;

 private:
  void factor_dense(const Matrix& product);
  void factor_sparse(const Matrix& product);

  const BlockSplit& blocks_;
  int largest_dense_;
  bool dense_ = true;
  RCP<Matrix> motion_;              // D^-1 B1; none if all pressures are open
  std::vector<int> number_;         // of each owned pressure among the closed ones of all ranks; -1: open
  std::vector<double> open_scale_;  // 1 / C of each owned open pressure
  int n_closed_ = 0;                // on all ranks
  std::vector<double> lu_;          // column by column
  std::vector<int> pivots_;
  Riluk riluk_;
  mutable std::vector<double> mine_, all_;
};

}  // namespace mortise
