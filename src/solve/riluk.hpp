// Incomplete LU factors with level of fill, by Ifpack2.
#pragma once

#include <memory>

#include "assembly/tpetra.hpp"

namespace mortise {

/// M ~ A, factored rank by rank: each rank factors its own rows and, where `overlap` > 0, those next to them, of which it keeps
/// only its own part of the solution (restricted additive Schwarz).
class Riluk {
 public:
  Riluk(int fill_level, int overlap);
  ~Riluk();

  /// Factors A; the symbolic part is kept while the graph stands. Collective; throws what Ifpack2 throws.
  void factor(const RCP<const Matrix>& A, bool graph_is_new);

  /// y = M^-1 r
  void solve(const Vector& r, Vector& y) const;

 private:
  struct Ifpack2;
  std::unique_ptr<Ifpack2> ifpack2_;
};

}  // namespace mortise
