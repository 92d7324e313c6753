// What every linear solver needs: known unknowns taken out, the groups that stay together, and the true residual.
#pragma once

#include <string>
#include <vector>

#include "assembly/tpetra.hpp"

namespace mortise {

/// Outcome of one linear solve. A failure is a value, with its cause in words.
struct LinearReport {
  bool solved = false;
  std::string cause;         ///< why not
  int iterations = 0;        ///< of an iterative solver; 0 for a direct one
  double true_residual = 0;  ///< of b - A x, always computed; see `backward_error`
  int null_pivots = 0;       ///< of a direct solver: rank deficiency it met
};

/// The right-hand side's share of `eliminate_identity_columns`: b changes in all rows but the identities. @param A with its
/// columns
void move_known_columns(const Matrix& A, const std::vector<char>& identity_rows, Vector& b);

/// The matrix' share: the columns of identity rows become zero outside these rows.
void zero_known_columns(Matrix& A, const std::vector<char>& identity_rows);

/// Rows that are identities determine their unknowns at once: their columns go to the right-hand side, the graph stays.
/// @param identity_rows per owned row, 1 where the row is the identity  @param b right-hand side, changed
void eliminate_identity_columns(Matrix& A, const std::vector<char>& identity_rows, Vector& b);

/// Backward error of x, the same in all units: the greater of |b - A x| / (|A| |x| + |b|) over the rows below `n_first` (forces)
/// and over the others (lengths), |x| the greatest position and the greatest pressure.
/// @param no_length added to the size of the lengths: gaps far below it are round-off already
double backward_error(const Matrix& A, const Vector& x, const Vector& b, GlobalIndex n_first, double no_length);

/// |b - A x| / |b|; 0 if b is zero and A x too.
double true_residual(const Matrix& A, const Vector& x, const Vector& b);

}  // namespace mortise
