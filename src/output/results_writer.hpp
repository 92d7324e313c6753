// What of a run goes into results.e, and when: the fields of the deck, the columns of the history, at the steps asked for.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/element_fields.hpp"
#include "output/history.hpp"
#include "output/results.hpp"

namespace mortise {

/// The results file, opened on rank 0 and fed with gathered fields. All calls are collective.
class ResultsWriter {
 public:
  /// @param n_frames 0: begins the file; otherwise goes on behind so many frames of a file that is there, or begins a new one
  /// @throws FileError
  ResultsWriter(const StepProblem& problem, const History& history, const std::filesystem::path& file, int n_frames);

  void observe(const StepProblem& problem, const State& now, const Evaluation& at, const StepRecord& record,
               const History& history);

  /// A run that ends early leaves its last good state, whether it was due or not.
  void write_last(const StepProblem& problem, const History& history);

  /// Frames in the file, counted on rank 0.
  int n_frames() const { return file_ ? file_->n_frames() : 0; }

 private:
  void write(const StepProblem& problem, const State& now, const Evaluation& at, const History& history);

  std::vector<std::string> nodal_;
  ElementFields elements_;
  std::vector<std::size_t> columns_;  // of the history: the global variables
  std::optional<ResultsFile> file_;
  std::optional<std::pair<State, Evaluation>> left_out_;  // the last accepted step, while it is not in the file
};

}  // namespace mortise
