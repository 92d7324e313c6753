// Elimination of unknowns that belong to one element alone from its equations.
#pragma once

#include <Eigen/Dense>

namespace mortise {

/// Factors of the block K_aa of the last m of n + m unknowns, with partial pivoting; no symmetry is needed.
template <int n, int m>
struct LocalFactors {
  Eigen::PartialPivLU<Eigen::Matrix<double, m, m>> lu;
  bool is_regular;  ///< no pivot vanishes against the greatest entry

  /// @param K (n + m)^2 row-major
  explicit LocalFactors(const double* K) {
    const Eigen::Map<const Eigen::Matrix<double, n + m, n + m, Eigen::RowMajor>> all(K);
    const Eigen::Matrix<double, m, m> K_aa = all.template bottomRightCorner<m, m>();
    lu.compute(K_aa);
    is_regular = lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-14 * K_aa.cwiseAbs().maxCoeff();
  }
};

/// Static condensation. Of the equations  K [du; da] = -[r_u; r_a]  with n + m unknowns, the last m are eliminated:
///   K_uu - K_ua K_aa^-1 K_au,   r_u - K_ua K_aa^-1 r_a.
/// @param K (n + m)^2 row-major, @param r n + m; @param K_out n x n row-major and @param r_out n are overwritten
/// @return false if K_aa is singular
template <int n, int m>
bool condense(const double* K, const double* r, double* K_out, double* r_out) {
  using Square = Eigen::Matrix<double, n + m, n + m, Eigen::RowMajor>;
  const Eigen::Map<const Square> all(K);
  const Eigen::Map<const Eigen::Matrix<double, n + m, 1>> residual(r);
  const LocalFactors<n, m> factors(K);
  if (!factors.is_regular) return false;
  Eigen::Matrix<double, m, n + 1> right;
  right.template leftCols<n>() = all.template bottomLeftCorner<m, n>();
  right.template rightCols<1>() = residual.template tail<m>();
  const Eigen::Matrix<double, m, n + 1> solved = factors.lu.solve(right);
  const auto K_ua = all.template topRightCorner<n, m>();
  Eigen::Map<Eigen::Matrix<double, n, n, Eigen::RowMajor>> condensed(K_out);
  Eigen::Map<Eigen::Matrix<double, n, 1>> rest(r_out);
  condensed = all.template topLeftCorner<n, n>() - K_ua * solved.template leftCols<n>();
  rest = residual.template head<n>() - K_ua * solved.template rightCols<1>();
  return true;
}

/// One Newton step of the eliminated unknowns at held others: da = -K_aa^-1 r_a.  @return false if K_aa is singular
template <int n, int m>
bool local_step(const double* K, const double* r, double* da) {
  const LocalFactors<n, m> factors(K);
  if (!factors.is_regular) return false;
  const Eigen::Map<const Eigen::Matrix<double, n + m, 1>> residual(r);
  Eigen::Map<Eigen::Matrix<double, m, 1>>{da} = -factors.lu.solve(residual.template tail<m>());
  return true;
}

}  // namespace mortise
