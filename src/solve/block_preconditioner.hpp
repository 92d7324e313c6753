// The preconditioner of GMRES for positions and pressures, and the norm in which GMRES measures.
#pragma once

#include <Tpetra_Operator.hpp>

#include "solve/block_split.hpp"
#include "solve/riluk.hpp"
#include "solve/schur_complement.hpp"

namespace mortise {

/// z = M^-1 r with  M = [ K~ 0 ; B2 S ],  K~ the RILUK factors of K and S = C - B2 D^-1 B1:
///   z_u = K~^-1 r_u,  z_p = S^-1 (r_p - B2 z_u)
/// With exact K~ and S all eigenvalues of A M^-1 are 1 and GMRES needs two iterations.
class BlockPreconditioner : public Tpetra::Operator<double, int, GlobalIndex> {
 public:
  using MultiVector = Tpetra::MultiVector<double, int, GlobalIndex>;

  BlockPreconditioner(const RCP<const Map>& map, GlobalIndex n_positions, int fill_level);

  /// Takes A apart and factors. Collective; throws what Ifpack2 throws.
  void update(const Matrix& A);

  /// Weights w of the rows. Forces and gaps have different units; with w_u = 1 / sqrt(K_ii) and w_p = 1 / |B2 diag(K)^-1/2| the square
  /// of either residual is an energy: that of the motion which would remove the force, or close the gap, by the diagonal of K alone.
  /// (Weights of columns would change nothing: they cancel against those of a right preconditioner.)
  const Vector& row_weights() const { return *weights_; }

  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const MultiVector& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;

 private:
  void weigh_rows();

  RCP<const Map> map_;
  BlockSplit blocks_;
  Riluk riluk_;
  SchurComplement schur_;
  RCP<Vector> weights_;
  mutable RCP<Vector> r_u_, r_p_, z_u_, z_p_;
};

}  // namespace mortise
