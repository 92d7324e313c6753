#include "solve/iterative_solver.hpp"

#include <fmt/format.h>

#include <BelosPseudoBlockGmresSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <exception>

#include "solve/block_preconditioner.hpp"

namespace mortise {
namespace {

using MultiVector = Tpetra::MultiVector<double, int, GlobalIndex>;
using Operator = Tpetra::Operator<double, int, GlobalIndex>;

constexpr int restart = 150;  // basis vectors kept: one costs as much memory as a solution

// y = W A x
class WeightedRows : public Operator {
 public:
  WeightedRows(const Matrix& A, const Vector& weights) : A_(A), weights_(weights) {}
  RCP<const Map> getDomainMap() const override { return A_.getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return A_.getRangeMap(); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double, double) const override {
    A_.apply(x, y);
    y.elementWiseMultiply(1.0, weights_, y, 0.0);
  }

 private:
  const Matrix& A_;
  const Vector& weights_;
};

// z = M^-1 W^-1 r
class UnweightedFirst : public Operator {
 public:
  UnweightedFirst(const Operator& M, const Vector& weights) : M_(M), inverse_(weights.getMap()), r_(weights.getMap()) {
    inverse_.reciprocal(weights);
  }
  RCP<const Map> getDomainMap() const override { return M_.getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return M_.getRangeMap(); }
  void apply(const MultiVector& r, MultiVector& z, Teuchos::ETransp, double, double) const override {
    for (std::size_t k = 0; k < r.getNumVectors(); ++k) {
      r_.elementWiseMultiply(1.0, inverse_, *r.getVector(k), 0.0);
      M_.apply(r_, *z.getVectorNonConst(k));
    }
  }

 private:
  const Operator& M_;
  Vector inverse_;
  mutable Vector r_;
};

// x of the rows that hold nothing but their diagonal: known at once and out of every norm (their units and sizes are their own).
void solve_identity_rows(const Matrix& A, const Vector& b, Vector& x) {
  const auto local = A.getLocalMatrixHost();
  const auto rows = A.getRowMap(), columns = A.getColMap();
  const auto from = b.getData();
  auto to = x.getDataNonConst();
  for (int i = 0; i < static_cast<int>(from.size()); ++i) {
    double diagonal = 0;
    bool alone = true;
    for (auto e = local.graph.row_map(i); alone && e < local.graph.row_map(i + 1); ++e) {
      if (local.values(e) == 0) continue;
      alone = columns->getGlobalElement(local.graph.entries(e)) == rows->getGlobalElement(i);
      if (alone) diagonal = local.values(e);
    }
    if (alone && diagonal != 0) to[i] = from[i] / diagonal;
  }
}

// Runs a collective action; a failure on any rank is the failure of all.
template <class Action>
std::string cause_of_failure(const Comm& comm, Action action) {
  std::string cause;
  try {
    action();
  } catch (const std::exception& error) {
    cause = error.what();
  }
  int failed = cause.empty() ? 0 : 1, any = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, failed, Teuchos::outArg(any));
  if (any && cause.empty()) cause = "it failed on another rank";
  return cause;
}

}  // namespace

struct IterativeSolver::Blocks {
  RCP<const Map> map;
  double tolerance;
  int most_iterations;
  BlockPreconditioner preconditioner;
  const Matrix* A = nullptr;  // the matrix it was made for

  // One run of GMRES from zero on  A dx = r,  until the weighted residual has fallen by `reduction`. @return iterations
  int gmres(const Matrix& A, const Vector& r, Vector& dx, double reduction, int iterations_left) const {
    const Vector& weights = preconditioner.row_weights();
    const auto rhs = Teuchos::rcp(new Vector(map)), x = Teuchos::rcp(new Vector(map));
    rhs->elementWiseMultiply(1.0, weights, r, 0.0);
    const auto problem =
        Teuchos::rcp(new Belos::LinearProblem<double, MultiVector, Operator>(Teuchos::rcp(new WeightedRows(A, weights)), x, rhs));
    problem->setRightPrec(Teuchos::rcp(new UnweightedFirst(preconditioner, weights)));
    problem->setProblem();
    const auto list = Teuchos::parameterList();
    const int basis = std::min(restart, iterations_left);
    list->set("Num Blocks", basis);
    list->set("Maximum Iterations", iterations_left);
    list->set("Maximum Restarts", iterations_left / basis + 1);
    list->set("Convergence Tolerance", reduction);
    list->set("Orthogonalization", "ICGS");
    list->set("Verbosity", static_cast<int>(Belos::Errors));
    Belos::PseudoBlockGmresSolMgr<double, MultiVector, Operator> solver(problem, list);
    solver.solve();
    dx.update(1.0, *x, 0.0);
    return solver.getNumIters();
  }

  double weighted_norm(const Vector& r) const {
    Vector product(map);
    product.elementWiseMultiply(1.0, preconditioner.row_weights(), r, 0.0);
    return product.norm2();
  }

  // GMRES, and again on what is left while the residual computed afresh is above the tolerance.
  void iterate(const Matrix& A, const Vector& b, Vector& x, LinearReport& report) const {
    x.putScalar(0.0);
    solve_identity_rows(A, b, x);
    Vector r(b, Teuchos::Copy), dx(map);
    const auto renew_residual = [&] {
      r.update(1.0, b, 0.0);
      A.apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
    };
    const double size = b.norm2();
    renew_residual();
    const double start = weighted_norm(r);
    for (int run = 0; run < 8; ++run) {
      const double weighted = start > 0 ? weighted_norm(r) / start : 0.0;
      report.true_residual = size > 0 ? r.norm2() / size : r.norm2();
      const double excess = std::max(weighted, report.true_residual) / tolerance;
      report.solved = excess <= 1;
      const int left = most_iterations - report.iterations;
      if (report.solved || !std::isfinite(excess) || left <= 0) break;
      report.iterations += gmres(A, r, dx, std::min(0.1, 0.9 / excess), left);
      x.update(1.0, dx, 1.0);
      renew_residual();
    }
    if (!report.solved)
      report.cause =
          fmt::format("GMRES stopped after {} iterations at |r|/|b| = {:.2e}", report.iterations, report.true_residual);
  }
};

IterativeSolver::IterativeSolver(const RCP<const Map>& map, long long n_positions, const SolverOptions& options)
    : blocks_(new Blocks{map, options.linear_tolerance, options.linear_iterations,
                         BlockPreconditioner(map, n_positions, options.fill_level)}) {}
IterativeSolver::~IterativeSolver() = default;
IterativeSolver::IterativeSolver(IterativeSolver&&) noexcept = default;

LinearReport IterativeSolver::prepare(const Matrix& A) {
  LinearReport report;
  blocks_->A = &A;
  if (!std::isfinite(A.getFrobeniusNorm())) {
    report.cause = "the matrix is not finite";
    return report;
  }
  report.cause = cause_of_failure(*blocks_->map->getComm(), [&] { blocks_->preconditioner.update(A); });
  report.solved = report.cause.empty();
  if (!report.solved) report.cause = "the preconditioner could not be built: " + report.cause;
  return report;
}

LinearReport IterativeSolver::solve(const Vector& b, Vector& x) {
  LinearReport report;
  x.putScalar(0.0);
  if (!std::isfinite(b.norm2())) {
    report.cause = "the right-hand side is not finite";
    return report;
  }
  const std::string cause = cause_of_failure(*blocks_->map->getComm(), [&] { blocks_->iterate(*blocks_->A, b, x, report); });
  if (!cause.empty()) {
    report.solved = false;
    report.cause = fmt::format("GMRES broke down after {} iterations: {}", report.iterations, cause);
  }
  return report;
}

LinearReport IterativeSolver::solve(const Matrix& A, const Vector& b, Vector& x) {
  const LinearReport prepared = prepare(A);
  return prepared.solved ? solve(b, x) : prepared;
}

}  // namespace mortise
