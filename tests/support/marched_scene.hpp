// A scene marched to its end with its history, as `mortise run` does it, or stopped and gone on with.
#pragma once

#include <fmt/format.h>

#include <optional>

#include "output/checkpoint.hpp"
#include "output/history.hpp"
#include "support/greatest.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {

constexpr int to_the_end = 1000000;

/// One session of a run. Every rank keeps the rows.
struct MarchedScene {
  TestScene scene;
  MarchSummary summary;
  std::string log;
  std::string checkpoint;  ///< of where it ended

  /// @param most_attempts steps tried before it stops  @param before a session that stopped: this one goes on from its checkpoint
  explicit MarchedScene(const std::string& deck, const RCP<const Comm>& comm = world(), int most_attempts = to_the_end,
                        const MarchedScene* before = nullptr)
      : scene(deck, comm, [](Scene& s) { s.solver.further_iterations = 1; }) {
    Newton newton(scene.problem, scene.scene.solver);
    std::optional<History> history;
    MarchState at;
    if (before) {
      const Checkpoint kept = from_bytes(before->checkpoint);
      at = resume(kept, scene.problem);
      const auto file = folder_.write("history.csv", before->table());
      history.emplace(scene.problem, file, kept.done.steps, kept.ledger);
    } else {
      at = starting(scene.problem.initial_state());
      history.emplace(scene.problem, folder_ / "history.csv");
    }
    int asked = 0;
    MarchParty party;
    party.observers.emplace_back([&](const State& then, const State& now, const Evaluation& e, const StepRecord& record) {
      history->observe(scene.problem, then, now, e, record, 0, 0);
    });
    party.keep = [](const MarchState&) {};
    party.stop = [&] { return asked++ < most_attempts ? ExitCode::done : ExitCode::terminated; };
    party.log = [this](const std::string& line) { log += line; };
    party.progress = [](const std::string&) {};
    summary = march(scene.problem, newton, at, party);
    scene.state = at.state;
    columns_ = history->columns();
    rows_ = history->rows();
    checkpoint = to_bytes(make_checkpoint({}, scene.problem, at, history->ledger(), 0));
  }

  /// A column of the history: the start, then one value per accepted step.
  std::vector<double> operator[](const std::string& name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) throw std::logic_error("no column " + name);
    std::vector<double> values;
    for (const auto& row : rows_) values.push_back(row[static_cast<std::size_t>(found - columns_.begin())]);
    return values;
  }

  /// The value at a time that a step ended at.
  double at(double t, const std::string& name) const {
    const auto times = (*this)["time"];
    for (std::size_t k = 0; k < times.size(); ++k)
      if (std::abs(times[k] - t) < 1e-12) return (*this)[name][k];
    throw std::logic_error("no step ended at " + std::to_string(t));
  }

  /// Positions and pressures at the end, on every rank.
  std::vector<double> unknowns() const { return scene.gather(*scene.state.x); }

  /// Greatest |ledger_mismatch| over the greatest energy or work at any time.
  double relative_mismatch() const {
    double mismatch = 0, energy = 1e-300;
    for (double m : (*this)["ledger_mismatch"]) mismatch = std::max(mismatch, std::abs(m));
    for (const char* name : {"total_energy", "external_work", "damping_dissipation"})
      for (double e : (*this)[name]) energy = std::max(energy, std::abs(e));
    return mismatch / energy;
  }

 private:
  std::string table() const {
    std::string text = fmt::format("{}\n", fmt::join(columns_, ","));
    for (const auto& row : rows_) text += fmt::format("{:.17g}\n", fmt::join(row, ","));
    return text;
  }

  ScratchFolder folder_;
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace mortise::test
