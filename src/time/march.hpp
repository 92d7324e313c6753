// The march: from the initial state through accepted steps to the end, with cut and growth of the step.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "errors.hpp"
#include "solve/newton.hpp"

namespace mortise {

/// An accepted step (or the initial state, step 0), as observers see it.
struct StepRecord {
  int step = 0;
  double time = 0, dt = 0;
  int newton_iterations = 0;
  int cuts = 0;          ///< rejected attempts since the step before
  bool is_stop = false;  ///< a time the deck asked for, or the end
};

/// Called after every accepted step; must not change anything the march can see.
using Observer = std::function<void(const State& before, const State& now, const Evaluation& at, const StepRecord& record)>;

struct MarchSummary {
  ExitCode code = ExitCode::done;
  int steps = 0, cuts = 0;
  long newton_iterations = 0;  ///< of accepted steps
  long wasted_iterations = 0;  ///< of rejected attempts
  double end_time = 0;
  std::string cause;  ///< why it ended early
};

/// The next step size: grows after an easy step, is halved after a failure, meets every stop exactly.
class StepSize {
 public:
  explicit StepSize(const TimeOptions& options);

  /// Time at the end of the next step that starts at `t`.
  double next_time(double t) const;
  bool is_stop(double t) const;

  void accepted(int newton_iterations);
  /// Halves the step just tried. @return false if that would fall below the smallest step
  bool cut(double tried);

 private:
  TimeOptions options_;
  std::vector<double> stops_;
  double dt_;
};

/// Text for one step, told line by line as it happens.
using Reporter = std::function<void(const std::string&)>;

/// Marches a scene. @param log complete log of every iteration  @param progress one line per step
MarchSummary march(StepProblem& problem, Newton& newton, const State& initial, const TimeOptions& options,
                   const std::vector<Observer>& observers, const Reporter& log, const Reporter& progress);

}  // namespace mortise
