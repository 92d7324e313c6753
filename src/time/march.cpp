#include "time/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace mortise {
namespace {

std::string iteration_table(const StepResult& result) {
  std::string text = "  it       |r|   |r|/scale       |gap|  closed\n";
  for (std::size_t k = 0; k < result.log.size(); ++k) {
    const NewtonLine& line = result.log[k];
    text += fmt::format("  {:2}  {:8.2e}    {:8.2e}    {:8.2e}  {:6}", k, line.force_residual,
                        line.force_scale > 0 ? line.force_residual / line.force_scale : 0.0, line.gap_residual, line.closed);
    if (line.opened_now + line.closed_now > 0) text += fmt::format(" (+{} -{})", line.closed_now, line.opened_now);
    if (line.linear_solves > 1) text += fmt::format("  {} factorisations, {} solves", line.factorisations, line.linear_solves);
    if (line.linear_iterations > 0) text += fmt::format("  gmres {}", line.linear_iterations);
    if (line.step_length != 1) text += fmt::format("  step length {:g}", line.step_length);
    text += '\n';
  }
  return text;
}

std::string name_of_multiplier(const Scene& scene, int k) {
  for (const ContactNodes* contact : scene.contacts())
    if (k >= contact->first_multiplier && k < contact->first_multiplier + static_cast<int>(contact->secondary_nodes.size()))
      return fmt::format("{} (\"{}\")", describe_node(scene.mesh, contact->secondary_nodes[k - contact->first_multiplier]),
                         contact->name);
  return "?";
}

std::string unsettled_nodes(const Scene& scene, const std::vector<int>& multipliers) {
  if (multipliers.empty()) return "";
  std::string text = ", unsettled: ";
  for (std::size_t k = 0; k < std::min<std::size_t>(3, multipliers.size()); ++k)
    text += (k ? ", " : "") + name_of_multiplier(scene, multipliers[k]);
  if (multipliers.size() > 3) text += fmt::format(" and {} more", multipliers.size() - 3);
  return text;
}

}  // namespace

StepSize::StepSize(const TimeOptions& options, double dt) : options_(options), stops_(options.stops), dt_(dt) {
  if (stops_.empty() || stops_.back() < options.end) stops_.push_back(options.end);
}

double StepSize::next_time(double t) const {
  const double stop = *std::find_if(stops_.begin(), stops_.end(), [&](double s) { return s > t; });
  // A rest shorter than a thousandth of the step is taken along: no step of round-off length.
  return t + 1.001 * dt_ >= stop ? stop : t + dt_;
}

bool StepSize::is_stop(double t) const { return std::find(stops_.begin(), stops_.end(), t) != stops_.end(); }

// The length that has about the tolerance as its error, which is of third order in it.
double StepSize::fitting(double taken, double error) const {
  return taken * std::clamp(0.9 * std::cbrt(*options_.error_tolerance / std::max(error, 1e-300)), 0.2, options_.growth);
}

void StepSize::accepted(double taken, int newton_iterations, double error) {
  if (newton_iterations <= options_.easy_iterations)
    dt_ = std::min(options_.growth * dt_, options_.largest_step.value_or(options_.step));
  if (options_.error_tolerance) dt_ = std::min(dt_, fitting(taken, error));
}

std::optional<std::pair<double, std::string>> StepSize::repeat(double taken, double error, bool touches) const {
  if (options_.touch_step && touches && taken > 1.001 * *options_.touch_step)
    return std::make_pair(*options_.touch_step, std::string("nodes touch where none did"));
  if (options_.error_tolerance && error > *options_.error_tolerance)
    return std::make_pair(fitting(taken, error),
                          fmt::format("the error of the step, {:.2e}, is above {:.2e}", error, *options_.error_tolerance));
  return std::nullopt;
}

bool StepSize::shorten(double dt) {
  dt_ = dt;
  return dt_ >= options_.smallest_step.value_or(options_.step / 1024);
}

namespace {

/// One march: what its stages and steps share.
class March {
 public:
  March(StepProblem& problem, Newton& newton, MarchState& at, const MarchParty& party)
      : problem_(problem), newton_(newton), at_(at), party_(party), first_time_(at.state.time) {}

  MarchSummary run() {
    const std::vector<Stage>& stages = problem_.scene().stages;
    for (std::size_t k = 0; k < stages.size(); ++k) {
      if (at_.state.time >= stages[k].time.end) continue;
      if (!enter(k)) break;
      StepSize size(stages[k].time, at_.dt);
      while (at_.state.time < stages[k].time.end)
        if (!attempt(size)) return summary_;
    }
    return summary_;
  }

 private:
  /// @return false if the march ends here
  bool enter(std::size_t k) {
    const Stage& stage = problem_.scene().stages[k];
    if (at_.counts.steps > 0 && at_.stage == static_cast<int>(k)) {
      problem_.set_stage(k);
      return true;
    }
    at_.state = problem_.enter_stage(k, at_.state);
    at_.stage = static_cast<int>(k);
    at_.dt = stage.time.step;
    at_.enters_stage = at_.counts.steps > 0;
    if (!stage.name.empty())
      party_.log(fmt::format("stage \"{}\" from t = {:g} to {:g}: {}\n", stage.name, at_.state.time, stage.time.end,
                             name_of_kind(stage.time.scheme)));
    if (stage.scheme.has_inertia())
      if (const std::string fault = newton_.find_acceleration(at_.state); !fault.empty())
        return end(ExitCode::no_convergence, fmt::format("no acceleration at the start: {}", fault));
    if (at_.counts.steps == 0) see_the_start();
    return true;
  }

  void see_the_start() {
    problem_.begin_step(at_.state, at_.state.time);
    const Evaluation evaluation = problem_.evaluate(*at_.state.x);
    at_.n_closed = evaluation.n_closed;
    for (const auto& observe : party_.observers) observe(at_.state, at_.state, evaluation, StepRecord{});
    party_.keep(at_);
  }

  bool attempt(StepSize& size) {
    if (const ExitCode code = party_.stop(); code != ExitCode::done)
      return end(code, fmt::format("stopped by {} after step {}, t = {:.6g}",
                                   code == ExitCode::interrupted ? "SIGINT" : "SIGTERM", at_.counts.steps, at_.state.time));
    const double t = size.next_time(at_.state.time), dt = t - at_.state.time;
    StepResult result = newton_.solve(at_.state, t);
    const std::string head = fmt::format("step {}, t = {:.6g}, dt = {:.4g}", at_.counts.steps + 1, t, dt);
    if (result.is_deck_fault) {
      party_.log(fmt::format("{}: {}\n", head, result.cause));
      return end(ExitCode::deck, result.cause);
    }
    if (!result.converged) return cut(size, result, head, dt);
    const double error = problem_.local_error(at_.state, result.state);
    const bool touches = result.evaluation.n_closed > 0 && at_.n_closed == 0;
    if (const auto again = size.repeat(dt, error, touches)) return repeat(size, result, head, *again);
    accept(size, result, head, dt, error);
    return true;
  }

  void count_rejected(const StepResult& result) {
    ++at_.pending_cuts;
    ++at_.counts.cuts;
    at_.counts.wasted_iterations += result.iterations;
  }

  bool repeat(StepSize& size, const StepResult& result, const std::string& head, const std::pair<double, std::string>& again) {
    count_rejected(result);
    const bool go_on = size.shorten(again.first);
    party_.log(fmt::format("{}: repeated with dt = {:.4g}, {}\n", head, size.dt(), again.second));
    if (!go_on) return end(ExitCode::no_convergence, fmt::format("{}: the smallest step is reached; {}", head, again.second));
    at_.dt = size.dt();
    return true;
  }

  bool cut(StepSize& size, const StepResult& result, const std::string& head, double dt) {
    count_rejected(result);
    const std::string cause = result.cause + unsettled_nodes(problem_.scene(), result.unsettled);
    const bool go_on = size.cut(dt) && !result.is_free;
    const std::string next = go_on ? fmt::format("  next:  dt = {:.4g}", size.dt())
                                   : std::string(result.is_free ? "  next:  nothing, a smaller step holds no free body"
                                                                : "  next:  nothing, the smallest step is reached");
    party_.log(fmt::format("{}: not converged after {} iterations\n{}  cause: {}\n{}\n", head, result.iterations,
                           iteration_table(result), cause, next));
    party_.progress(fmt::format("{}: not converged, {}", head, cause));
    if (!go_on)
      return end(ExitCode::no_convergence,
                 fmt::format("{}: no step converged{}; {}", head, result.is_free ? "" : " at the smallest dt", cause));
    at_.dt = size.dt();
    return true;
  }

  void accept(StepSize& size, const StepResult& result, const std::string& head, double dt, double error) {
    const double t = result.state.time;
    ++at_.counts.steps;
    at_.counts.newton_iterations += result.iterations;
    party_.log(fmt::format("{}: converged in {} iterations\n{}", head, result.iterations, iteration_table(result)));
    if (const Evaluation& e = result.evaluation; e.n_partly_covered > 0)
      party_.log(fmt::format("  {} closed nodes are partly covered and yield, first: {}\n", e.n_partly_covered,
                             name_of_multiplier(problem_.scene(), e.first_partly_covered)));
    const StepRecord record{
        at_.counts.steps, t, dt, result.iterations, at_.pending_cuts, size.is_stop(t), std::exchange(at_.enters_stage, false)};
    for (const auto& observe : party_.observers) observe(at_.state, result.state, result.evaluation, record);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double to_go = elapsed * (problem_.scene().end() - t) / (t - first_time_);
    party_.progress(fmt::format("{}: {} Newton iterations, {} nodes in contact, {:.0f} s to go", head, result.iterations,
                                result.evaluation.n_closed, to_go));
    size.accepted(dt, result.iterations, error);
    at_.state = result.state;
    at_.n_closed = result.evaluation.n_closed;
    at_.dt = size.dt();
    at_.pending_cuts = 0;
    party_.keep(at_);
  }

  /// The march ends before its time. @return false
  bool end(ExitCode code, std::string cause) {
    summary_ = {code, std::move(cause)};
    return false;
  }

  StepProblem& problem_;
  Newton& newton_;
  MarchState& at_;
  const MarchParty& party_;
  MarchSummary summary_;
  const double first_time_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

MarchSummary march(StepProblem& problem, Newton& newton, MarchState& at, const MarchParty& party) {
  return March(problem, newton, at, party).run();
}

}  // namespace mortise
