#include "solve/linear_system.hpp"

namespace mortise {

void eliminate_identity_columns(Matrix& A, const std::vector<char>& identity_rows, Vector& b) {
  const auto n = static_cast<int>(identity_rows.size());
  Vector known(A.getRowMap()), flag(A.getRowMap()), product(A.getRowMap());
  {
    auto k = known.getDataNonConst();
    auto f = flag.getDataNonConst();
    const auto rhs = b.getData();
    for (int i = 0; i < n; ++i)
      if (identity_rows[i]) {
        k[i] = rhs[i];
        f[i] = 1.0;
      }
  }
  Vector flag_col(A.getColMap());
  if (const auto importer = A.getCrsGraph()->getImporter(); importer.is_null()) {
    Tpetra::deep_copy(flag_col, flag);
  } else {
    flag_col.doImport(flag, *importer, Tpetra::INSERT);
  }
  A.apply(known, product);
  auto rhs = b.getDataNonConst();
  const auto taken = product.getData(), column_is_known = flag_col.getData();
  const auto local = A.getLocalMatrixHost();
  for (int i = 0; i < n; ++i) {
    if (identity_rows[i]) continue;
    rhs[i] -= taken[i];
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
      if (column_is_known[local.graph.entries(e)] != 0) local.values(e) = 0;
  }
}

double true_residual(const Matrix& A, const Vector& x, const Vector& b) {
  Vector r(b, Teuchos::Copy);
  A.apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
  const double size = b.norm2(), rest = r.norm2();
  return size > 0 ? rest / size : rest;
}

}  // namespace mortise
