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

MarchSummary march(StepProblem& problem, Newton& newton, MarchState& at, const TimeOptions& options, const MarchParty& party) {
  const Scene& scene = problem.scene();
  MarchSummary summary;
  StepSize size(options, at.dt);
  if (at.counts.steps == 0) {
    if (scene.scheme.has_inertia())
      if (const std::string fault = newton.find_acceleration(at.state); !fault.empty())
        return {ExitCode::no_convergence, fmt::format("no acceleration at the start: {}", fault)};
    problem.begin_step(at.state, at.state.time);
    const Evaluation evaluation = problem.evaluate(*at.state.x);
    at.n_closed = evaluation.n_closed;
    for (const auto& observe : party.observers) observe(at.state, at.state, evaluation, StepRecord{});
    party.keep(at);
  }
  const auto begin = std::chrono::steady_clock::now();
  const double first_time = at.state.time;
  while (at.state.time < options.end) {
    if (summary.code = party.stop(); summary.code != ExitCode::done) {
      summary.cause = fmt::format("stopped by {} after step {}, t = {:.6g}",
                                  summary.code == ExitCode::interrupted ? "SIGINT" : "SIGTERM", at.counts.steps, at.state.time);
      break;
    }
    const double t = size.next_time(at.state.time), dt = t - at.state.time;
    StepResult result = newton.solve(at.state, t);
    const std::string head = fmt::format("step {}, t = {:.6g}, dt = {:.4g}", at.counts.steps + 1, t, dt);
    if (result.is_deck_fault) {
      party.log(fmt::format("{}: {}\n", head, result.cause));
      summary.code = ExitCode::deck;
      summary.cause = result.cause;
      break;
    }
    const double error = result.converged ? problem.local_error(at.state, result.state) : 0;
    const bool touches = result.converged && result.evaluation.n_closed > 0 && at.n_closed == 0;
    if (const auto again = result.converged ? size.repeat(dt, error, touches) : std::nullopt) {
      ++at.pending_cuts;
      ++at.counts.cuts;
      at.counts.wasted_iterations += result.iterations;
      const bool go_on = size.shorten(again->first);
      party.log(fmt::format("{}: repeated with dt = {:.4g}, {}\n", head, size.dt(), again->second));
      if (!go_on) {
        summary.code = ExitCode::no_convergence;
        summary.cause = fmt::format("{}: the smallest step is reached; {}", head, again->second);
        break;
      }
      at.dt = size.dt();
      continue;
    }
    if (!result.converged) {
      ++at.pending_cuts;
      ++at.counts.cuts;
      at.counts.wasted_iterations += result.iterations;
      const std::string cause = result.cause + unsettled_nodes(scene, result.unsettled);
      const bool go_on = size.cut(dt) && !result.is_free;
      const std::string next = go_on ? fmt::format("  next:  dt = {:.4g}", size.dt())
                                     : std::string(result.is_free ? "  next:  nothing, a smaller step holds no free body"
                                                                  : "  next:  nothing, the smallest step is reached");
      party.log(fmt::format("{}: not converged after {} iterations\n{}  cause: {}\n{}\n", head, result.iterations,
                            iteration_table(result), cause, next));
      party.progress(fmt::format("{}: not converged, {}", head, cause));
      if (!go_on) {
        summary.code = ExitCode::no_convergence;
        summary.cause = fmt::format("{}: no step converged{}; {}", head, result.is_free ? "" : " at the smallest dt", cause);
        break;
      }
      at.dt = size.dt();
      continue;
    }
    ++at.counts.steps;
    at.counts.newton_iterations += result.iterations;
    party.log(fmt::format("{}: converged in {} iterations\n{}", head, result.iterations, iteration_table(result)));
    if (const Evaluation& e = result.evaluation; e.n_partly_covered > 0)
      party.log(fmt::format("  {} closed nodes are partly covered and yield, first: {}\n", e.n_partly_covered,
                            name_of_multiplier(scene, e.first_partly_covered)));
    const StepRecord record{at.counts.steps, t, dt, result.iterations, at.pending_cuts, size.is_stop(t)};
    for (const auto& observe : party.observers) observe(at.state, result.state, result.evaluation, record);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double to_go = elapsed * (options.end - t) / (t - first_time);
    party.progress(fmt::format("{}: {} Newton iterations, {} nodes in contact, {:.0f} s to go", head, result.iterations,
                               result.evaluation.n_closed, to_go));
    size.accepted(dt, result.iterations, error);
    at.state = result.state;
    at.n_closed = result.evaluation.n_closed;
    at.dt = size.dt();
    at.pending_cuts = 0;
    party.keep(at);
  }
  return summary;
}

}  // namespace mortise
