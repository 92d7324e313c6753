#include "solve/schur_complement.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_LAPACK.hpp>
#include <TpetraExt_MatrixMatrix.hpp>
#include <algorithm>
#include <cmath>

namespace mortise {
namespace {

bool is_zero_row(const Matrix& A, int i) {
  const auto local = A.getLocalMatrixHost();
  for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
    if (local.values(e) != 0) return false;
  return true;
}

template <class Visit>  // visit(row, global column, value)
void for_each_entry(const Matrix& A, Visit visit) {
  const auto local = A.getLocalMatrixHost();
  const auto& columns = *A.getColMap();
  for (int i = 0; i < static_cast<int>(A.getNodeNumRows()); ++i)
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
      visit(i, columns.getGlobalElement(local.graph.entries(e)), local.values(e));
}

}  // namespace

SchurComplement::SchurComplement(const BlockSplit& blocks, int largest_dense)
    : blocks_(blocks), largest_dense_(largest_dense), riluk_(2, 1) {}

void SchurComplement::factor(const Matrix& D_inverse) {
  const auto n = static_cast<int>(blocks_.map(1)->getNodeNumElements());
  Vector diagonal(blocks_.map(1));
  blocks_.C()->getLocalDiagCopy(diagonal);
  const auto c = diagonal.getData();
  number_.assign(n, -1);
  open_scale_.assign(n, 1.0);
  int n_mine = 0, n_up_to_me = 0;
  for (int k = 0; k < n; ++k) {
    if (!is_zero_row(*blocks_.B2(), k))
      number_[k] = n_mine++;
    else if (c[k] != 0)
      open_scale_[k] = 1.0 / c[k];
  }
  const auto& comm = *blocks_.map(1)->getComm();
  Teuchos::scan(comm, Teuchos::REDUCE_SUM, n_mine, Teuchos::outArg(n_up_to_me));
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, n_mine, Teuchos::outArg(n_closed_));
  for (int& number : number_)
    if (number >= 0) number += n_up_to_me - n_mine;
  motion_ = Teuchos::null;
  if (n_closed_ == 0) return;

  motion_ = Teuchos::rcp(new Matrix(blocks_.map(0), 0));
  Matrix product(blocks_.map(1), 0);
  Tpetra::MatrixMatrix::Multiply(D_inverse, false, *blocks_.B1(), false, *motion_);
  Tpetra::MatrixMatrix::Multiply(*blocks_.B2(), false, *motion_, false, product);
  dense_ = n_closed_ <= largest_dense_;
  if (dense_)
    factor_dense(product);
  else
    factor_sparse(product);
}

void SchurComplement::factor_dense(const Matrix& product) {
  Vector owned(blocks_.map(1)), needed(product.getColMap());
  {
    auto number = owned.getDataNonConst();
    for (std::size_t k = 0; k < number_.size(); ++k) number[k] = number_[k];
  }
  const std::size_t n = n_closed_;
  mine_.assign(n * n, 0.0);
  lu_.resize(n * n);
  const auto gather = [&](const Matrix& A, double factor) {
    Vector of_column(A.getColMap());
    if (const auto importer = A.getCrsGraph()->getImporter(); importer.is_null())
      of_column.update(1.0, owned, 0.0);
    else
      of_column.doImport(owned, *importer, Tpetra::INSERT);
    const auto column = of_column.getData();
    const auto local = A.getLocalMatrixHost();
    for (std::size_t i = 0; i < number_.size(); ++i)
      for (auto e = local.graph.row_map(i); number_[i] >= 0 && e < local.graph.row_map(i + 1); ++e) {
        const int j = static_cast<int>(column[local.graph.entries(e)]);
        if (j >= 0) mine_[j * n + number_[i]] += factor * local.values(e);
      }
  };
  gather(*blocks_.C(), 1.0);
  gather(product, -1.0);
  Teuchos::reduceAll(*blocks_.map(1)->getComm(), Teuchos::REDUCE_SUM, static_cast<int>(n * n), mine_.data(), lu_.data());

  Teuchos::LAPACK<int, double> lapack;
  pivots_.resize(n);
  int status = 0;
  lapack.GETRF(n_closed_, n_closed_, lu_.data(), n_closed_, pivots_.data(), &status);
  // A zero pivot is a redundant constraint: any scale serves, GMRES finds out whether the system has a solution.
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(lu_[k * n + k]));
  for (std::size_t k = 0; k < n; ++k)
    if (double& pivot = lu_[k * n + k]; std::abs(pivot) <= 1e-14 * largest) pivot = largest > 0 ? -largest : -1.0;
}

void SchurComplement::factor_sparse(const Matrix& product) {
  const std::size_t width = product.getNodeMaxNumRowEntries() + blocks_.C()->getNodeMaxNumRowEntries();
  const auto S = Teuchos::rcp(new Matrix(blocks_.map(1), width));
  const auto insert = [&](const Matrix& A, double factor) {
    for_each_entry(A, [&](int i, GlobalIndex j, double value) {
      const double v = factor * value;
      S->insertGlobalValues(blocks_.map(1)->getGlobalElement(i), 1, &v, &j);
    });
  };
  insert(*blocks_.C(), 1.0);
  insert(product, -1.0);
  S->fillComplete(blocks_.map(1), blocks_.map(1));
  riluk_.factor(S, true);
}

void SchurComplement::solve(const Vector& r, Vector& y) const {
  if (n_closed_ > 0 && !dense_) return riluk_.solve(r, y);
  const auto from = r.getData();
  auto to = y.getDataNonConst();
  for (std::size_t k = 0; k < number_.size(); ++k) to[k] = open_scale_[k] * from[k];
  if (n_closed_ == 0) return;
  mine_.assign(n_closed_, 0.0);
  all_.resize(n_closed_);
  for (std::size_t k = 0; k < number_.size(); ++k)
    if (number_[k] >= 0) mine_[number_[k]] = from[k];
  Teuchos::reduceAll(*blocks_.map(1)->getComm(), Teuchos::REDUCE_SUM, n_closed_, mine_.data(), all_.data());
  Teuchos::LAPACK<int, double> lapack;
  int status = 0;
  lapack.GETRS('N', n_closed_, 1, lu_.data(), n_closed_, pivots_.data(), all_.data(), n_closed_, &status);
  for (std::size_t k = 0; k < number_.size(); ++k)
    if (number_[k] >= 0) to[k] = all_[number_[k]];
}

void SchurComplement::move(const Vector& p, Vector& u) const {
  if (!motion_.is_null()) motion_->apply(p, u, Teuchos::NO_TRANS, -1.0, 1.0);
}

}  // namespace mortise
