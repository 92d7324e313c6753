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
  explicit SchurComplement(const BlockSplit& blocks);

  /// Forms and factors S. Collective. @param D_inverse the inverse of D on the positions' rows
  void factor(const Matrix& D_inverse);

  /// y = S^-1 r
  void solve(const Vector& r, Vector& y) const;

 private:
  void factor_dense(const Matrix& product);
  void factor_sparse(const Matrix& product);

  const BlockSplit& blocks_;
  bool dense_ = true;
  std::vector<int> number_;          // of each owned pressure among the closed ones of all ranks; -1: open
  std::vector<double> open_scale_;   // 1 / C of each owned open pressure
  int n_closed_ = 0;                 // on all ranks
  std::vector<double> lu_;           // column by column
  std::vector<int> pivots_;
  Riluk riluk_;
  mutable std::vector<double> mine_, all_;
};

}  // namespace mortise
