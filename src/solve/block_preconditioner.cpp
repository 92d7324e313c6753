#include "solve/block_preconditioner.hpp"

#include <array>
#include <cmath>
#include <map>

namespace mortise {
namespace {

using Block = std::array<std::array<double, 3>, 3>;

// The inverse by cofactors; false if the block is singular to working precision.
bool invert(const Block& D, Block& inverse) {
  double size = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      inverse[i][j] = D[a][c] * D[b][d] - D[a][d] * D[b][c];
      size = std::max(size, std::abs(D[i][j]));
    }
  const double determinant = D[0][0] * inverse[0][0] + D[0][1] * inverse[1][0] + D[0][2] * inverse[2][0];
  if (!(std::abs(determinant) > 1e-12 * size * size * size)) return false;
  for (auto& row : inverse)
    for (double& entry : row) entry /= determinant;
  return true;
}

// Inverse of the 3 x 3 diagonal blocks of K: unknowns 3 n to 3 n + 2 belong to one node.
RCP<Matrix> inverse_of_diagonal_blocks(const Matrix& K) {
  const auto& rows = *K.getRowMap();
  const auto& columns = *K.getColMap();
  const auto local = K.getLocalMatrixHost();
  std::map<GlobalIndex, Block> nodes;
  for (int i = 0; i < static_cast<int>(K.getNodeNumRows()); ++i) {
    const GlobalIndex row = rows.getGlobalElement(i);
    const auto [node, is_new] = nodes.try_emplace(row / 3, Block{});
    if (is_new) node->second = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    node->second[row % 3][row % 3] = 0;
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e)
      if (const GlobalIndex column = columns.getGlobalElement(local.graph.entries(e)); column / 3 == row / 3)
        node->second[row % 3][column % 3] = local.values(e);
  }
  const auto result = Teuchos::rcp(new Matrix(K.getRowMap(), 3));
  for (const auto& [node, D] : nodes) {
    Block inverse;
    if (!invert(D, inverse)) {
      inverse = {};
      for (int i = 0; i < 3; ++i) inverse[i][i] = D[i][i] != 0 ? 1 / D[i][i] : 1.0;
    }
    for (GlobalIndex i = 0; i < 3; ++i)
      for (GlobalIndex j = 0; j < 3; ++j)
        if (rows.isNodeGlobalElement(3 * node + i) && rows.isNodeGlobalElement(3 * node + j)) {
          const GlobalIndex column = 3 * node + j;
          result->insertGlobalValues(3 * node + i, 1, &inverse[i][j], &column);
        }
  }
  result->fillComplete(K.getRowMap(), K.getRowMap());
  return result;
}

}  // namespace

BlockPreconditioner::BlockPreconditioner(const RCP<const Map>& map, GlobalIndex n_positions, int fill_level)
    : map_(map),
      blocks_(map, n_positions),
      riluk_(fill_level, 1),
      schur_(blocks_),
      weights_(Teuchos::rcp(new Vector(map))),
      r_u_(Teuchos::rcp(new Vector(blocks_.map(0)))),
      r_p_(Teuchos::rcp(new Vector(blocks_.map(1)))),
      z_u_(Teuchos::rcp(new Vector(blocks_.map(0)))),
      z_p_(Teuchos::rcp(new Vector(blocks_.map(1)))) {}

void BlockPreconditioner::update(const Matrix& A) {
  const bool graph_is_new = blocks_.take(A);
  riluk_.factor(blocks_.K(), graph_is_new);
  if (blocks_.n_pressures() > 0) schur_.factor(*inverse_of_diagonal_blocks(*blocks_.K()));
  weigh_rows();
}

void BlockPreconditioner::weigh_rows() {
  Vector diagonal(blocks_.map(0)), weight_u(blocks_.map(0)), weight_p(blocks_.map(1));
  blocks_.K()->getLocalDiagCopy(diagonal);
  {
    const auto d = diagonal.getData();
    auto w = weight_u.getDataNonConst();
    for (int i = 0; i < static_cast<int>(d.size()); ++i) w[i] = d[i] != 0 ? 1.0 / std::sqrt(std::abs(d[i])) : 1.0;
  }
  blocks_.extend(0, weight_u, *weights_);
  if (blocks_.n_pressures() == 0) return;
  const Matrix& B2 = *blocks_.B2();
  Vector of_column(B2.getColMap());
  if (const auto importer = B2.getCrsGraph()->getImporter(); importer.is_null())
    of_column.update(1.0, weight_u, 0.0);
  else
    of_column.doImport(weight_u, *importer, Tpetra::INSERT);
  {
    const auto column = of_column.getData();
    const auto local = B2.getLocalMatrixHost();
    auto w = weight_p.getDataNonConst();
    for (int k = 0; k < static_cast<int>(w.size()); ++k) {
      double sum = 0;
      for (auto e = local.graph.row_map(k); e < local.graph.row_map(k + 1); ++e)
        sum += std::pow(local.values(e) * column[local.graph.entries(e)], 2);
      w[k] = sum > 0 ? 1.0 / std::sqrt(sum) : 1.0;  // open: an identity, solved exactly whatever the weight
    }
  }
  blocks_.extend(1, weight_p, *weights_);
}

void BlockPreconditioner::apply(const MultiVector& r, MultiVector& z, Teuchos::ETransp, double, double) const {
  for (std::size_t column = 0; column < r.getNumVectors(); ++column) {
    const auto from = r.getVector(column);
    const auto to = z.getVectorNonConst(column);
    blocks_.restrict_to(0, *from, *r_u_);
    riluk_.solve(*r_u_, *z_u_);
    if (blocks_.n_pressures() > 0) {
      blocks_.restrict_to(1, *from, *r_p_);
      blocks_.B2()->apply(*z_u_, *r_p_, Teuchos::NO_TRANS, -1.0, 1.0);
      schur_.solve(*r_p_, *z_p_);
      blocks_.extend(1, *z_p_, *to);
      schur_.move(*z_p_, *z_u_);
    }
    blocks_.extend(0, *z_u_, *to);
  }
}

}  // namespace mortise
