#include "output/history.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "assembly/vectors.hpp"
#include "deck/quantities.hpp"
#include "output/on_root.hpp"

#include "output/on_root.hpp"

namespace mortise {
namespace {

double strain_energy(StepProblem& problem, const State& state) {
  const auto q = problem.to_overlap(*state.x);
  double energy = 0;
  for (const auto& body : problem.bodies()) energy += body->strain_energy(q->getData().getRawPtr());
  return all_reduced(*problem.dofs().comm(), Teuchos::REDUCE_SUM, energy);
}

// Increment of the positions; pressures have none.
Vector increment(const StepProblem& problem, const State& before, const State& now) {
  Vector dq(*now.x, Teuchos::Copy);
  dq.update(-1.0, *before.x, 1.0);
  auto values = dq.getDataNonConst();
  for (int point : problem.dofs().overlap_points())
    if (problem.dofs().owned(point) && problem.dofs().size(point) == 1) values[problem.dofs().local(point)] = 0;
  return dq;
}

}  // namespace

History::History(const StepProblem& problem, const std::filesystem::path& file) : file_(file) {
  const Scene& scene = problem.scene();
  columns_.assign(step_columns.begin(), step_columns.end());
  for (const auto& pair : scene.pairs)
    for (const char* axis : {"x", "y", "z"}) columns_.push_back(fmt::format("contact_force_{}.{}", axis, pair.name));
  for (const auto& support : scene.supports)
    for (const char* axis : {"x", "y", "z"}) columns_.push_back(fmt::format("reaction_{}.{}", axis, support.name));
  columns_.insert(columns_.end(), ledger_columns.begin(), ledger_columns.end());
  for (const auto& probe : scene.probes) columns_.push_back(fmt::format("{}.{}", probe.quantity, probe.name));
  for (const char* name :
       {"seconds_search", "seconds_contact", "seconds_elements", "seconds_solve", "seconds_output", "graph_rebuilds"})
    columns_.emplace_back(name);
  for (const auto& pair : scene.pairs) columns_.push_back(fmt::format("closure_error.{}", pair.name));
  on_root(*problem.dofs().comm(), [&] {
    out_.open(file);
    out_ << fmt::format("{}\n", fmt::join(columns_, ","));
    out_.flush();
    if (!out_) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
  });
}

int History::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  return found == columns_.end() ? -1 : static_cast<int>(found - columns_.begin());
}

// The ledger of a static step: forces of the new state work on the increment of positions.
void History::update_works(StepProblem& problem, const State& before, const State& now, const Evaluation& at) {
  const Scene& scene = problem.scene();
  const Vector dq = increment(problem, before, now);
  const double energy_before = strain_energy_;
  strain_energy_ = strain_energy(problem, now);

  Vector out_of_balance(*at.internal, Teuchos::Copy);
  out_of_balance.update(1.0, *at.contact, -1.0, *at.external, 1.0);
  Vector reaction(dq.getMap());
  {
    auto r = reaction.getDataNonConst();
    auto rest = out_of_balance.getDataNonConst();
    for (const auto& p : scene.prescribed) {
      if (!problem.dofs().owned(p.node)) continue;
      const int k = problem.dofs().local(p.node) + p.axis;
      r[k] = rest[k];
      rest[k] = 0;
    }
  }
  const double internal = at.internal->dot(dq), contact = -at.contact->dot(dq),
               external = at.external->dot(dq) + reaction.dot(dq), residual = out_of_balance.dot(dq),
               stored = strain_energy_ - energy_before, algorithmic = internal - stored;
  double closing = 0, both_ends = 0;
  std::vector<double> weighted_gap;
  if (!scene.pairs.empty()) {
    const auto gap = problem.gather(*at.gap), area = problem.gather(*at.area), x = problem.gather(*now.x);
    const std::size_t first = 3 * static_cast<std::size_t>(problem.dofs().n_nodes());
    Vector newly(*now.x, Teuchos::Copy);
    {
      auto p = newly.getDataNonConst();
      for (int k = 0; k < scene.n_multipliers; ++k) {
        weighted_gap.push_back(gap[first + k] * area[first + k]);
        if (!closed_before_[k]) continue;
        both_ends += x[first + k] * (weighted_gap[k] - weighted_gap_before_[k]);
        const int point = problem.dofs().n_nodes() + k;
        if (problem.dofs().owned(point)) p[problem.dofs().local(point)] = 0;
      }
    }
    closing = -problem.contact_force(*now.x, newly)->dot(dq);
  }
  works_.external += external;
  works_.contact += contact;
  works_.closing += closing;
  works_.resegmentation += contact - closing - both_ends;
  works_.algorithmic += algorithmic;
  works_.residual += residual;
  works_.mismatch = stored + algorithmic - contact - external - residual;
  weighted_gap_before_ = weighted_gap;
}

void History::observe(StepProblem& problem, const State& before, const State& now, const Evaluation& at, const StepRecord& record,
                      double seconds_solve, double seconds_output) {
  const Scene& scene = problem.scene();
  if (record.step == 0) {
    strain_energy_ = strain_energy(problem, now);
    weighted_gap_before_.assign(scene.n_multipliers, 0.0);
  } else {
    update_works(problem, before, now, at);
  }
  closed_before_ = at.closed;

  std::vector<double> row{static_cast<double>(record.step),
                          record.time,
                          record.dt,
                          static_cast<double>(record.newton_iterations),
                          static_cast<double>(record.cuts),
                          static_cast<double>(at.n_closed),
                          0.0,
                          0.0};
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const auto force = problem.force_on_secondary(*now.x, k);
    row.insert(row.end(), {force[0], force[1], force[2]});
  }
  std::array<std::vector<double>, 3> reactions;
  if (!scene.supports.empty())
    for (int i = 0; i < 3; ++i) reactions[i] = nodal_quantity(problem, now, at, fmt::format("reaction_{}", "xyz"[i]));
  for (std::size_t s = 0; s < scene.supports.size(); ++s) {
    std::array<double, 3> sum{};
    for (const auto& p : scene.prescribed)
      if (p.support == static_cast<int>(s)) sum[p.axis] += reactions[p.axis][p.node];
    row.insert(row.end(), sum.begin(), sum.end());
  }
  // No inertia, friction or damping in a static scene: their shares are zero because the terms do not exist.
  row.insert(row.end(),
             {0.0, strain_energy_, 0.0, strain_energy_, works_.external, works_.contact, works_.closing, works_.resegmentation,
              0.0, 0.0, works_.algorithmic, works_.residual, works_.mismatch, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  for (const auto& probe : scene.probes) row.push_back(nodal_quantity(problem, now, at, probe.quantity)[probe.node]);
  const auto& counts = problem.counts();
  row.insert(row.end(), {counts.seconds_search, counts.seconds_contact, counts.seconds_elements, seconds_solve, seconds_output,
                         static_cast<double>(counts.graphs)});
  for (const auto& pair : problem.pairs()) {
    row.push_back(all_reduced(*problem.dofs().comm(), Teuchos::REDUCE_MAX, pair->closure().first));
  }
  rows_.push_back(row);
  on_root(*problem.dofs().comm(), [&] {
    out_ << fmt::format("{:.17g}\n", fmt::join(row, ","));
    out_.flush();
    if (!out_) throw FileError(fmt::format("{}: error[I02] cannot be written any more, the disk may be full", file_.string()));
  });
}

}  // namespace mortise
