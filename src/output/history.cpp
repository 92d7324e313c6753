#include "output/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "assembly/vectors.hpp"
#include "deck/field_table.hpp"
#include "deck/quantities.hpp"
#include "output/atomic_file.hpp"
#include "output/nodal.hpp"
#include "output/on_root.hpp"

namespace mortise {
namespace {

std::vector<std::string> columns_of(const Scene& scene) {
  std::vector<std::string> columns(step_columns.begin(), step_columns.end());
  for (const ContactNodes* contact : scene.contacts())
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("contact_force_{}.{}", axis, contact->name));
  for (const auto& support : scene.supports)
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("reaction_{}.{}", axis, support.name));
  columns.insert(columns.end(), ledger_columns.begin(), ledger_columns.end());
  for (const auto& probe : scene.probes) columns.push_back(fmt::format("{}.{}", probe.quantity, probe.name));
  for (const char* name :
       {"seconds_search", "seconds_contact", "seconds_elements", "seconds_solve", "seconds_output", "graph_rebuilds"})
    columns.emplace_back(name);
  columns.insert(columns.end(), balance_columns.begin(), balance_columns.end());
  for (const auto& pair : scene.pairs) columns.push_back(fmt::format("closure_error.{}", pair.name));
  return columns;
}

}  // namespace

History::History(const StepProblem& problem, const std::filesystem::path& file)
    : columns_(columns_of(problem.scene())), file_(file) {
  on_root(*problem.dofs().comm(), [&] {
    out_.open(file);
    out_ << fmt::format("{}\n", fmt::join(columns_, ","));
    out_.flush();
    if (!out_) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
  });
}

History::History(const StepProblem& problem, const std::filesystem::path& file, int steps, Ledger ledger)
    : columns_(columns_of(problem.scene())), file_(file), ledger_(std::move(ledger)) {
  const auto refuse = [&](const std::string& why) {
    throw FileError(fmt::format("{}: error[I10] {} - the run cannot go on from its checkpoint", file.string(), why));
  };
  std::ifstream in(file);
  if (!in) refuse("cannot be read");
  std::string line, kept;
  std::getline(in, line);
  if (line != fmt::format("{}", fmt::join(columns_, ","))) refuse("has other columns than this run writes");
  kept = line + '\n';
  while (static_cast<int>(rows_.size()) <= steps && std::getline(in, line)) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::nan(""));
      std::from_chars(cell.data(), cell.data() + cell.size(), row.back());
    }
    if (row.size() != columns_.size() || row[0] != static_cast<double>(rows_.size()))
      refuse(fmt::format("line {} is not the row of step {}", rows_.size() + 2, rows_.size()));
    rows_.push_back(std::move(row));
    kept += line + '\n';
  }
  if (static_cast<int>(rows_.size()) <= steps) refuse(fmt::format("ends before step {}", steps));
  problem.dofs().comm()->barrier();  // every rank has read it
  on_root(*problem.dofs().comm(), [&] {
    write_atomically(file, kept);
    out_.open(file, std::ios::app);
    if (!out_) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
  });
}

int History::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  return found == columns_.end() ? -1 : static_cast<int>(found - columns_.begin());
}

void History::observe(StepProblem& problem, const State& before, const State& now, const Evaluation& at, const StepRecord& record,
                      double seconds_solve, double seconds_output) {
  const Scene& scene = problem.scene();
  if (record.step == 0) {
    open_ledger(ledger_, problem, now, at);
  } else {
    if (record.enters_stage) enter_stage(ledger_, problem, before);
    add_step(ledger_, problem, before, now, at);
  }

  std::vector<double> row{static_cast<double>(record.step),
                          record.time,
                          record.dt,
                          static_cast<double>(record.newton_iterations),
                          static_cast<double>(record.cuts),
                          static_cast<double>(at.n_closed),
                          static_cast<double>(at.n_stick),
                          static_cast<double>(at.n_slip)};
  for (std::size_t k = 0; k < problem.contacts().size(); ++k) {
    const auto force = problem.force_on_secondary(*now.x, k);
    row.insert(row.end(), {force[0], force[1], force[2]});
  }
  std::vector<std::vector<double>> reactions;
  if (!scene.supports.empty()) reactions = nodal_variables(problem, now, at, variables_of_field("reaction"));
  for (std::size_t s = 0; s < scene.supports.size(); ++s) {
    std::array<double, 3> sum{};
    for (const auto& p : *at.prescribed)
      if (p.support == static_cast<int>(s)) sum[p.axis] += reactions[p.axis][p.node];
    row.insert(row.end(), sum.begin(), sum.end());
  }
  const Ledger& l = ledger_;
  row.insert(row.end(),
             {l.kinetic_energy, l.strain_energy, l.stick_energy, l.kinetic_energy + l.strain_energy + l.stick_energy, l.external,
              l.contact, l.closing, l.resegmentation, l.friction, l.damping, l.algorithmic, l.residual, l.mismatch});
  row.insert(row.end(), l.linear_momentum.begin(), l.linear_momentum.end());
  row.insert(row.end(), l.angular_momentum.begin(), l.angular_momentum.end());
  std::vector<std::string> quantities;
  for (const auto& probe : scene.probes) quantities.push_back(probe.quantity);
  const auto followed = nodal_variables(problem, now, at, quantities);
  for (std::size_t k = 0; k < followed.size(); ++k) row.push_back(followed[k][scene.probes[k].node]);
  const auto& counts = problem.counts();
  row.insert(row.end(), {counts.seconds_search, counts.seconds_contact, counts.seconds_elements, seconds_solve, seconds_output,
                         static_cast<double>(counts.graphs), l.linear_mismatch(), l.angular_mismatch()});
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
