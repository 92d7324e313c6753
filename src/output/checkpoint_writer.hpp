// When a run writes checkpoints: as often as the deck asks, and where it stops.
#pragma once

#include <chrono>
#include <filesystem>

#include "output/checkpoint.hpp"
#include "output/results_writer.hpp"

namespace mortise {

/// Keeps the march of one run in its folder. What a checkpoint counts on in other files reaches the disk before it. All calls are
/// collective.
class CheckpointWriter {
 public:
  CheckpointWriter(const StepProblem& problem, const History& history, const ResultsWriter& results, Origin origin,
                   std::filesystem::path folder);

  /// After an accepted step: writes if one is due (`every` steps, `seconds` since the last one; the first one always).
  /// @throws FileError
  void after_step(const MarchState& at);

  /// Writes unless this state has been kept already. @throws FileError
  void at_stop(const MarchState& at);

 private:
  void write(const MarchState& at);

  const StepProblem& problem_;
  const History& history_;
  const ResultsWriter& results_;
  const Origin origin_;
  const std::filesystem::path folder_;
  std::chrono::steady_clock::time_point last_;
  int kept_steps_ = -1, kept_cuts_ = -1;  // what the last checkpoint holds
};

}  // namespace mortise
