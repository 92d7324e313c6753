#include "solve/active_set.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <set>

namespace mortise {
namespace {

// A covered pressure row owned by this rank.
struct LawRow {
  int local;
  int multiplier;
  bool closed;
};

std::vector<LawRow> law_rows(const StepProblem& problem, const Evaluation& at) {
  std::vector<LawRow> rows;
  const DofSpace& dofs = problem.dofs();
  for (const auto& pair : problem.pairs())
    for (std::size_t k = 0; k < pair->pair().secondary_nodes.size(); ++k) {
      const int point = pair->pressure_point(k), multiplier = point - dofs.n_nodes();
      if (dofs.owned(point) && at.covered[multiplier]) rows.push_back({dofs.local(point), multiplier, at.closed[multiplier] != 0});
    }
  return rows;
}

// Rows of open nodes become identities.
void open_rows(const std::vector<LawRow>& rows, Matrix& A) {
  const auto local = A.getLocalMatrixHost();
  for (const LawRow& row : rows) {
    if (row.closed) continue;
    const int diagonal = A.getColMap()->getLocalElement(A.getRowMap()->getGlobalElement(row.local));
    for (auto e = local.graph.row_map(row.local); e < local.graph.row_map(row.local + 1); ++e)
      local.values(e) = local.graph.entries(e) == diagonal ? 1.0 : 0.0;
  }
}

}  // namespace

DirectionReport find_direction(const StepProblem& problem, const Vector& x, const Evaluation& at, const Matrix& tangent, LinearSolver& linear,
                               Vector& direction) {
  constexpr int most_sets = 12;
  DirectionReport report;
  const Comm& comm = *problem.dofs().comm();
  auto rows = law_rows(problem, at);
  std::set<std::vector<char>> tried;
  std::vector<char> closed(at.closed);
  Vector change(x.getMap());
  for (;;) {
    Matrix A(tangent, Teuchos::Copy);
    open_rows(rows, A);
    Vector b(*at.residual, Teuchos::Copy);
    b.scale(-1.0);
    auto identity_rows = problem.identity_rows();
    if (!rows.empty()) {
      auto right = b.getDataNonConst();
      const auto pressure = x.getData(), gap = at.gap->getData(), compliance = at.compliance->getData();
      for (const LawRow& row : rows) {
        const double p = pressure[row.local];
        right[row.local] = row.closed ? -(gap[row.local] + compliance[row.local] * p) : -p;
        identity_rows[row.local] = !row.closed;
      }
    }
    direction.putScalar(0.0);
    const LinearReport solved = linear.solve(A, b, direction, identity_rows, problem.graph_number());
    static_cast<LinearReport&>(report) = solved;
    ++report.solves;
    if (!solved.solved || problem.scene().n_multipliers == 0) return report;

    tried.insert(closed);
    tangent.apply(direction, change);
    std::vector<int> mine(closed.size(), 0), all(closed.size(), 0);
    if (!rows.empty()) {
      const auto pressure = x.getData(), gap = at.gap->getData(), compliance = at.compliance->getData(), dp = direction.getData(),
                 change_of_row = change.getData();
      for (LawRow& row : rows) {
        // Where open, p + dp = 0: what the row gives beyond the pressure's share is the new gap.
        const int k = row.local;
        row.closed = row.closed ? pressure[k] + dp[k] > 0 : gap[k] + change_of_row[k] + compliance[k] * pressure[k] < 0;
        mine[row.multiplier] = row.closed;
      }
    }
    Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(mine.size()), mine.data(), all.data());
    const std::vector<char> before = closed;
    std::copy(all.begin(), all.end(), closed.begin());
    if (closed == before || report.solves == most_sets || tried.count(closed) > 0) return report;
  }
}

}  // namespace mortise
