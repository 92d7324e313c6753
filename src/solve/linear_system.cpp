#include "solve/linear_system.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>

namespace mortise {

void move_known_columns(const Matrix& A, const std::vector<char>& identity_rows, Vector& b) {
  Vector known(A.getRowMap()), product(A.getRowMap());
  {
    auto k = known.getDataNonConst();
    const auto rhs = b.getData();
    for (std::size_t i = 0; i < identity_rows.size(); ++i)
      if (identity_rows[i]) k[i] = rhs[i];
  }
  A.apply(known, product);
  auto rhs = b.getDataNonConst();
  const auto taken = product.getData();
  for (std::size_t i = 0; i < identity_rows.size(); ++i)
    if (!identity_rows[i]) rhs[i] -= taken[i];
}

void zero_known_columns(Matrix& A, const std::vector<char>& identity_rows) {
  Vector flag(A.getRowMap()), flag_of_column(A.getColMap());
  {
    auto f = flag.getDataNonConst();
    for (std::size_t i = 0; i < identity_rows.size(); ++i) f[i] = identity_rows[i];
  }
  if (const auto importer = A.getCrsGraph()->getImporter(); importer.is_null()) {
    Tpetra::deep_copy(flag_of_column, flag);
  } else {
    flag_of_column.doImport(flag, *importer, Tpetra::INSERT);
  }
  const auto is_known = flag_of_column.getData();
  const auto local = A.getLocalMatrixHost();
  for (std::size_t i = 0; i < identity_rows.size(); ++i) {
    if (identity_rows[i]) continue;
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
      if (is_known[local.graph.entries(e)] != 0) local.values(e) = 0;
  }
}

void eliminate_identity_columns(Matrix& A, const std::vector<char>& identity_rows, Vector& b) {
  move_known_columns(A, identity_rows, b);
  zero_known_columns(A, identity_rows);
}

double backward_error(const Matrix& A, const Vector& x, const Vector& b, GlobalIndex n_first, double no_length) {
  Vector r(b, Teuchos::Copy);
  A.apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
  const auto group_of = [n_first](GlobalIndex k) { return k < n_first ? 0 : 1; };
  const auto xs = x.getData(), rs = r.getData(), bs = b.getData();
  const int n = static_cast<int>(rs.size());
  double my_greatest[2] = {}, greatest[2];
  for (int i = 0; i < n; ++i) {
    double& g = my_greatest[group_of(A.getRowMap()->getGlobalElement(i))];
    g = std::max(g, std::abs(xs[i]));
  }
  Teuchos::reduceAll(*A.getComm(), Teuchos::REDUCE_MAX, 2, my_greatest, greatest);

  const auto local = A.getLocalMatrixHost();
  double mine[6] = {}, all[6];  // squares of |r|, |A| |x|, |b|, for both groups of rows
  for (int i = 0; i < n; ++i) {
    double size = 0;
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
      size += std::abs(local.values(e)) * greatest[group_of(A.getColMap()->getGlobalElement(local.graph.entries(e)))];
    double* sum = mine + 3 * group_of(A.getRowMap()->getGlobalElement(i));
    sum[0] += rs[i] * rs[i];
    sum[1] += size * size;
    sum[2] += bs[i] * bs[i];
  }
  Teuchos::reduceAll(*A.getComm(), Teuchos::REDUCE_SUM, 6, mine, all);
  const auto error = [](const double* sum, double floor) {
    return sum[0] > 0 ? std::sqrt(sum[0]) / (std::sqrt(sum[1]) + std::sqrt(sum[2]) + floor) : 0.0;
  };
  return std::max(error(all, 0.0), error(all + 3, no_length));
}

double true_residual(const Matrix& A, const Vector& x, const Vector& b) {
  Vector r(b, Teuchos::Copy);
  A.apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
  const double size = b.norm2(), rest = r.norm2();
  return size > 0 ? rest / size : rest;
}

}  // namespace mortise
