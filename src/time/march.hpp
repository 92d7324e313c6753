// The march: from the initial state through accepted steps to the end, with cut and growth of the step.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "solve/newton.hpp"

namespace mortise {

/// An accepted step (or the initial state, step 0), as observers see it.
struct StepRecord {
  int step = 0;
  double time = 0, dt = 0;
  int newton_iterations = 0;
  int cuts = 0;               ///< rejected attempts since the step before
  bool is_stop = false;       ///< a time the deck asked for, or the end of a stage
  bool enters_stage = false;  ///< the first step of a stage after the first one
};

/// Called after every accepted step; must not change anything the march can see.
using Observer = std::function<void(const State& before, const State& now, const Evaluation& at, const StepRecord& record)>;

/// Work of a march since its start.
struct MarchCounts {
  int steps = 0, cuts = 0;
  long newton_iterations = 0;  ///< of accepted steps
  long wasted_iterations = 0;  ///< of rejected attempts
};

/// Where a march stands between two attempts: all that the next one depends on. A march goes on from it as if it had not stopped.
struct MarchState {
  State state;
  double dt = 0;         ///< size of the next step; at the start of a stage its own
  int pending_cuts = 0;  ///< attempts rejected since the last accepted step
  MarchCounts counts;
  int n_closed = 0;           ///< nodes in contact
  int stage = -1;             ///< that was entered last; -1: none yet
  bool enters_stage = false;  ///< no step of it has been accepted yet, and there was a stage before
};

/// Before the first step, at a state that `StepProblem::initial_state` made.
inline MarchState starting(State state) { return {std::move(state), 0, 0, {}, 0, -1, false}; }

/// How a march ended.
struct MarchSummary {
  ExitCode code = ExitCode::done;
  std::string cause;  ///< why early, in words
};

/// The next step size: grows after an easy step, is halved after a failure, meets every stop exactly.
class StepSize {
 public:
  /// @param dt the first step
  StepSize(const TimeOptions& options, double dt);

  double dt() const { return dt_; }

  /// Time at the end of the next step that starts at `t`.
  double next_time(double t) const;
  bool is_stop(double t) const;

  /// @param error estimated, see `TimeOptions::error_tolerance`
  void accepted(double taken, int newton_iterations, double error);
  /// Halves the step just tried. @return false if that would fall below the smallest step
  bool cut(double tried) { return shorten(0.5 * tried); }
  /// Whether a step that has been solved must be repeated with another length: its error is too great, or contact closed in it.
  /// @param touches nodes are closed, and none were before  @return the length and why
  std::optional<std::pair<double, std::string>> repeat(double taken, double error, bool touches) const;
  /// The next step is at most so long. @return false if that is below the smallest step
  bool shorten(double dt);

 private:
  double fitting(double taken, double error) const;
  TimeOptions options_;
  std::vector<double> stops_;
  double dt_;
};

/// Text for one step, told line by line as it happens.
using Reporter = std::function<void(const std::string&)>;

/// Who takes part in a march besides its equations.
struct MarchParty {
  std::vector<Observer> observers;
  std::function<void(const MarchState&)> keep;  ///< told where the march stands after every accepted step, to keep it
  std::function<ExitCode()> stop;  ///< asked after every attempt: anything but `done` ends the march there; collective
  Reporter log;                    ///< gets every iteration
  Reporter progress;               ///< gets one line per step
};

/// Marches a scene from where it stands through its stages to the end; `at` is then where it ended. At step 0 the observers see
/// the initial state.
MarchSummary march(StepProblem& problem, Newton& newton, MarchState& at, const MarchParty& party);

}  // namespace mortise
