#include "solve/active_set.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <set>

#include "solve/complementarity_problem.hpp"

namespace mortise {
namespace {

// Few enough wrong nodes to find their influence one by one instead of factoring anew.
constexpr int most_influences = 24;
constexpr int most_factorisations = 8;

// A covered pressure row owned by this rank, and how many rows of a traction follow it.
struct LawRow {
  int local;
  int multiplier;
  int n_tractions;
};

/// The linearised step with one matrix: a set of closed nodes, and the influence of single nodes on all others.
class LinearisedStep {
 public:
  LinearisedStep(const StepProblem& problem, const Vector& x, const Evaluation& at, const Matrix& tangent, LinearSolver& linear)
      : problem_(problem), at_(at), tangent_(tangent), linear_(linear), x_(x), change_(x.getMap()), closed_(at.closed) {
    const DofSpace& dofs = problem.dofs();
    for (const auto& contact : problem.contacts())
      for (std::size_t k = 0; k < contact->nodes().secondary_nodes.size(); ++k) {
        const int point = contact->pressure_point(k), multiplier = point - dofs.n_nodes();
        if (dofs.owned(point) && at.covered[multiplier]) rows_.push_back({dofs.local(point), multiplier, dofs.size(point) - 1});
      }
  }

  const std::vector<char>& closed() const { return closed_; }
  void set_closed(const std::vector<char>& closed) { closed_ = closed; }

  LinearReport factor() {
    const auto A = Teuchos::rcp(new Matrix(tangent_, Teuchos::Copy));
    auto identity_rows = problem_.identity_rows();
    const auto local = A->getLocalMatrixHost();
    for (const LawRow& row : rows_) {
      if (closed_[row.multiplier]) continue;
      for (int k = row.local; k <= row.local + n_identities(row); ++k) {
        identity_rows[k] = 1;
        const int diagonal = A->getColMap()->getLocalElement(A->getRowMap()->getGlobalElement(k));
        for (auto e = local.graph.row_map(k); e < local.graph.row_map(k + 1); ++e)
          local.values(e) = local.graph.entries(e) == diagonal ? 1.0 : 0.0;
      }
    }
    return linear_.factor(A, identity_rows, problem_.graph_number());
  }

  /// The direction for the set.
  LinearReport solve(Vector& direction) {
    Vector b(*at_.residual, Teuchos::Copy);
    b.scale(-1.0);
    if (!rows_.empty()) {
      auto right = b.getDataNonConst();
      const auto pressure = x_.getData(), gap = at_.closing_gap->getData(), compliance = at_.compliance->getData();
      for (const LawRow& row : rows_) {
        const double p = pressure[row.local];
        right[row.local] = closed_[row.multiplier] ? -(gap[row.local] + compliance[row.local] * p) : -p;
        for (int k = row.local + 1; k <= row.local + n_identities(row) && !closed_[row.multiplier]; ++k) right[k] = -pressure[k];
      }
    }
    return linear_.solve(b, direction);
  }

  /// The direction that a unit in one node's law row gives: a pressure if it is open, a gap if it is closed.
  LinearReport solve_influence(int multiplier, Vector& influence) {
    Vector b(x_.getMap());
    for (const LawRow& row : rows_)
      if (row.multiplier == multiplier) b.replaceLocalValue(row.local, 1.0);
    return linear_.solve(b, influence);
  }

  /// What must not be negative, per multiplier and on every rank: the new pressure of a closed node, the new gap of an open one.
  /// For an influence (`of_change`) its share of that.
  std::vector<double> slack(const Vector& d, bool of_change) {
    tangent_.apply(d, change_);
    std::vector<double> mine(closed_.size(), 0.0), all(closed_.size(), 0.0);
    if (!rows_.empty()) {
      const auto pressure = x_.getData(), gap = at_.closing_gap->getData(), compliance = at_.compliance->getData(),
                 dp = d.getData(), row_change = change_.getData();
      for (const LawRow& row : rows_) {
        const int k = row.local;
        const double start = closed_[row.multiplier] ? pressure[k] : gap[k] + compliance[k] * pressure[k];
        mine[row.multiplier] = (closed_[row.multiplier] ? dp[k] : row_change[k]) + (of_change ? 0.0 : start);
      }
    }
    Teuchos::reduceAll(*problem_.dofs().comm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
    return all;
  }

 private:
  // A node that sticks and opens loses its traction; one that slips does so by its own law.
  int n_identities(const LawRow& row) const {
    return row.n_tractions > 0 && at_.friction[row.multiplier] == FrictionStatus::stick ? row.n_tractions : 0;
  }

  const StepProblem& problem_;
  const Evaluation& at_;
  const Matrix& tangent_;
  LinearSolver& linear_;
  const Vector& x_;
  Vector change_;
  std::vector<LawRow> rows_;
  std::vector<char> closed_;
};

/// Nodes with the wrong sign, beyond round-off: gaps below 1e-13 of the facet size, pressures below 1e-12 of the greatest.
class WrongSigns {
 public:
  WrongSigns(const Scene& scene, const std::vector<char>& closed, const std::vector<double>& slack)
      : closed_(closed), no_gap_(closed.size(), 0.0) {
    for (const ContactNodes* contact : scene.contacts())
      for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k)
        no_gap_[contact->first_multiplier + k] = 1e-13 * contact->size;
    no_pressure_ = scene.pressure_floor;
    for (std::size_t k = 0; k < slack.size(); ++k)
      if (closed[k]) no_pressure_ = std::max(no_pressure_, 1e-12 * std::abs(slack[k]));
  }
  double round_off(std::size_t k) const { return closed_[k] ? no_pressure_ : no_gap_[k]; }
  std::vector<int> in(const std::vector<double>& slack) const {
    std::vector<int> wrong;
    for (std::size_t k = 0; k < slack.size(); ++k)
      if (slack[k] < -round_off(k)) wrong.push_back(static_cast<int>(k));
    return wrong;
  }

 private:
  const std::vector<char>& closed_;
  std::vector<double> no_gap_;
  double no_pressure_ = 0;
};

// Settles the wrong nodes with the matrix as it is. @return whether every sign is right now; the direction holds the result if so
bool settle_by_influence(LinearisedStep& step, const WrongSigns& signs, std::vector<int> wrong, const std::vector<double>& slack,
                         Vector& direction, DirectionReport& report) {
  std::vector<int> nodes;                       // of the small problem
  std::vector<std::vector<double>> influences;  // of each of them on all slacks
  std::vector<RCP<Vector>> directions;
  while (!wrong.empty() && nodes.size() + wrong.size() <= most_influences) {
    for (int k : wrong) {
      const auto d = Teuchos::rcp(new Vector(direction.getMap()));
      ++report.solves;
      if (!step.solve_influence(k, *d).solved) return false;
      nodes.push_back(k);
      influences.push_back(step.slack(*d, true));
      directions.push_back(d);
    }
    // Rows are scaled by their round-off, so that gaps and pressures can be compared.
    const std::size_t n = nodes.size();
    std::vector<double> M(n * n), q(n);
    for (std::size_t r = 0; r < n; ++r) {
      q[r] = slack[nodes[r]] / signs.round_off(nodes[r]);
      for (std::size_t c = 0; c < n; ++c) M[r * n + c] = influences[c][nodes[r]] / signs.round_off(nodes[r]);
    }
    const auto z = solve_complementarity(M, q, 1.0);
    if (!z) return false;
    std::vector<double> settled = slack;
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t k = 0; k < settled.size(); ++k) settled[k] += (*z)[c] * influences[c][k];
    wrong.clear();
    for (int k : signs.in(settled))
      if (std::find(nodes.begin(), nodes.end(), k) == nodes.end()) wrong.push_back(k);
    if (!wrong.empty()) continue;
    for (std::size_t c = 0; c < n; ++c) direction.update((*z)[c], *directions[c], 1.0);
    return true;
  }
  return wrong.empty();
}

}  // namespace

DirectionReport find_direction(const StepProblem& problem, const Vector& x, const Evaluation& at, const Matrix& tangent,
                               LinearSolver& linear, Vector& direction) {
  DirectionReport report;
  LinearisedStep step(problem, x, at, tangent, linear);
  std::set<std::vector<char>> met{at.closed};
  for (;;) {
    static_cast<LinearReport&>(report) = step.factor();
    ++report.factorisations;
    if (!report.solved) return report;
    direction.putScalar(0.0);
    const int iterations = report.iterations;
    static_cast<LinearReport&>(report) = step.solve(direction);
    report.iterations += iterations;
    ++report.solves;
    if (!report.solved || problem.scene().n_multipliers == 0) return report;

    const auto slack = step.slack(direction, false);
    const WrongSigns signs(problem.scene(), step.closed(), slack);
    const auto wrong = signs.in(slack);
    if (wrong.empty() || report.factorisations == most_factorisations) return report;
    if (static_cast<int>(wrong.size()) <= most_influences && settle_by_influence(step, signs, wrong, slack, direction, report))
      return report;
    auto closed = step.closed();
    for (int k : wrong) closed[k] = !closed[k];
    if (!met.insert(closed).second) return report;  // with friction there may be no right set: the state moves on
    step.set_closed(closed);
  }
}

}  // namespace mortise
