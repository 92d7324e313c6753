#include "solve/linear_system.hpp"

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

double true_residual(const Matrix& A, const Vector& x, const Vector& b) {
  Vector r(b, Teuchos::Copy);
  A.apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
  const double size = b.norm2(), rest = r.norm2();
  return size > 0 ? rest / size : rest;
}

}  // namespace mortise
