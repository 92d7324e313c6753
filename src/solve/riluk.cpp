#include "solve/riluk.hpp"

#include <Ifpack2_AdditiveSchwarz.hpp>
#include <Ifpack2_RILUK.hpp>
#include <Teuchos_ParameterList.hpp>

namespace mortise {

struct Riluk::Ifpack2 {
  using Row = Tpetra::RowMatrix<double, int, GlobalIndex>;
  int fill_level, overlap;
  RCP<::Ifpack2::Preconditioner<double, int, GlobalIndex>> factors;
};

Riluk::Riluk(int fill_level, int overlap) : ifpack2_(std::make_unique<Ifpack2>(Ifpack2{fill_level, overlap, {}})) {}
Riluk::~Riluk() = default;

void Riluk::factor(const RCP<const Matrix>& A, bool graph_is_new) {
  auto& factors = ifpack2_->factors;
  const bool schwarz = A->getComm()->getSize() > 1;
  // The overlap's rows are fetched by initialize(), not by compute(): stale values unless it is made anew.
  if (graph_is_new || factors.is_null() || (schwarz && ifpack2_->overlap > 0)) {
    Teuchos::ParameterList riluk;
    riluk.set("fact: iluk level-of-fill", ifpack2_->fill_level);
    if (schwarz) {
      Teuchos::ParameterList list;
      list.set("schwarz: overlap level", ifpack2_->overlap);
      list.set("schwarz: combine mode", "ZERO");
      list.set("schwarz: inner preconditioner name", "RILUK");
      list.set("schwarz: inner preconditioner parameters", riluk);
      factors = Teuchos::rcp(new ::Ifpack2::AdditiveSchwarz<Ifpack2::Row>(A));
      factors->setParameters(list);
    } else {
      factors = Teuchos::rcp(new ::Ifpack2::RILUK<Ifpack2::Row>(A));
      factors->setParameters(riluk);
    }
    factors->initialize();
  }
  factors->compute();
}

void Riluk::solve(const Vector& r, Vector& y) const { ifpack2_->factors->apply(r, y); }

}  // namespace mortise
