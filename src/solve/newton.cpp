#include "solve/newton.hpp"

#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>
#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Generic.H>
#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <map>

#include "assembly/rigid_modes.hpp"
#include "assembly/vectors.hpp"
#include "solve/active_set.hpp"
#include "solve/newton_group.hpp"
#include "solve/velocity_update.hpp"

namespace mortise {
namespace {

constexpr int most_augmentations = 50;

/// Full steps. Half a step only where the full one cannot be evaluated (det F <= 0), or once after the active set has cycled.
class StepLength : public NOX::LineSearch::Generic {
 public:
  explicit StepLength(std::shared_ptr<NewtonShared> shared) : shared_(std::move(shared)) {}

  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override {
    step = shared_->halve_next ? 0.5 : 1.0;
    shared_->halve_next = false;
    const auto& old = solver.getPreviousSolutionGroup();
    for (int halvings = 0; halvings <= 10; ++halvings, step *= 0.5) {
      group.computeX(old, direction, step);
      if (group.computeF() == NOX::Abstract::Group::Ok) {
        shared_->last_step_length = step;
        return true;
      }
      if (const auto& fault = dynamic_cast<const NewtonGroup&>(group).evaluation().fault; !fault.empty())
        shared_->refused = fault;
    }
    shared_->last_step_length = 0;
    return false;
  }

 private:
  std::shared_ptr<NewtonShared> shared_;
};

class StepLengthFactory : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit StepLengthFactory(std::shared_ptr<NewtonShared> shared) : shared_(std::move(shared)) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new StepLength(shared_));
  }

 private:
  std::shared_ptr<NewtonShared> shared_;
};

/// Convergence of a step (conventions, section 8), the log of the active set, and cycles.
class StepStatus : public NOX::StatusTest::Generic {
 public:
  StepStatus(std::shared_ptr<NewtonShared> shared, const SolverOptions& options, const State& start, StepResult& result)
      : shared_(std::move(shared)), options_(options), start_(start), result_(result), before_(result.iterations) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    const auto& group = dynamic_cast<const NewtonGroup&>(solver.getSolutionGroup());
    const int iteration = solver.getNumIterations();
    status_ = NOX::StatusTest::Unconverged;
    result_.iterations = before_ + iteration;
    if (iteration > 0 && !shared_->last_linear.solved) return fail(shared_->last_linear.cause + free_bodies_in_words());
    if (group.isF() && !group.evaluation().fault.empty()) {
      shared_->refused = group.evaluation().fault;
      return fail("no state along the Newton direction is admissible");
    }
    if (!group.isF() || !group.evaluation().admissible)
      return fail("an element turns inside out (det F <= 0), even after ten halvings of the step");
    const Evaluation& e = group.evaluation();
    if (!std::isfinite(e.force_residual) || !std::isfinite(e.gap_residual)) return fail("the residual is not a finite number");

    const bool settled = compare_sets(e, unwrap(group.getX()));
    NewtonLine line{e.force_residual,
                    e.force_scale,
                    e.gap_residual,
                    e.n_closed,
                    opened_,
                    closed_,
                    shared_->last_linear.iterations,
                    shared_->last_linear.factorisations,
                    shared_->last_linear.solves,
                    shared_->last_step_length};
    result_.log.push_back(line);

    const Scene& scene = shared_->problem.scene();
    const double h = scene.size;
    const bool small = e.force_residual <= std::max(options_.tolerance * e.force_scale, e.force_floor) &&
                       e.gap_residual <= options_.tolerance * h && e.constraint_residual <= options_.tolerance &&
                       e.support_residual <= options_.tolerance * h &&
                       e.pressure_residual <= std::max(options_.tolerance * e.pressure_scale, scene.pressure_floor);
    if (small && settled && iteration > 0) {
      if (further_++ >= options_.further_iterations) status_ = NOX::StatusTest::Converged;
      return status_;
    }
    const bool falls = e.force_residual < 0.5 * last_residual_;  // stiff springs come back from far, a third at a time
    last_residual_ = e.force_residual;
    far_off_ = e.force_residual > 0.3 * e.force_scale && iteration > 1 && !falls ? far_off_ + 1 : 0;
    if (far_off_ >= 5) return fail("Newton diverges: the residual has stayed as large as the forces for five iterations");
    detect_cycle(settled);
    if (e.n_closed > 0) detect_swing(iteration, e.force_residual / e.force_scale);
    if (iteration >= options_.largest_iterations)
      return fail(cycles_ > 0 ? "the active set cycles" : fmt::format("Newton stopped after {} iterations", iteration));
    return status_;
  }

  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  NOX::StatusTest::StatusType fail(const std::string& cause) {
    result_.cause = cause + shared_->refusal_in_words();
    return status_ = NOX::StatusTest::Failed;
  }

  // A singular tangent most often means that nothing holds a body any more: says which, and how it can move.
  std::string free_bodies_in_words() {
    const StepProblem& problem = shared_->problem;
    std::vector<Vec3<double>> normals;
    const auto x = problem.to_overlap(*start_.x);
    for (const auto& contact : problem.contacts())
      for (const auto& n : contact->normals(x->getData().getRawPtr())) normals.push_back(n);
    std::string text;
    for (const auto& body : free_bodies(problem.scene(), previous_, normals, start_.time))
      text += fmt::format("; body \"{}\" is free: {}", body.body, fmt::join(body.modes, ", "));
    result_.is_free = !text.empty();
    if (text.empty())
      for (const auto& body : free_bodies(problem.scene(), std::vector<char>(normals.size(), 0), normals, start_.time))
        text += fmt::format("; without contact body \"{}\" is free: {}", body.body, fmt::join(body.modes, ", "));
    return text;
  }

  // Nodes at round-off in both gap and pressure may flip for ever: their branch does not matter (case C3).
  bool compare_sets(const Evaluation& e, const Vector& x) {
    opened_ = closed_ = 0;
    result_.unsettled.clear();
    set_ = e.closed;
    for (std::size_t k = 0; k < e.friction.size(); ++k)
      if (e.friction[k] == FrictionStatus::stick) set_[k] += 2;
    if (previous_.empty()) {
      previous_ = set_;
      return true;
    }
    std::vector<int> changed;
    for (std::size_t k = 0; k < set_.size(); ++k)
      if (set_[k] != previous_[k]) {
        changed.push_back(static_cast<int>(k));
        const bool was_closed = previous_[k] != 0;
        if (was_closed != static_cast<bool>(e.closed[k])) ++(e.closed[k] ? closed_ : opened_);
      }
    bool settled = true;
    if (!changed.empty()) {
      const auto& map = *x.getMap();
      const auto pressure = x.getData(), gap = e.gap->getData();
      const DofSpace& dofs = shared_->problem.dofs();
      const double no_gap = 1e-12 * shared_->problem.scene().size,
                   no_pressure = std::max(1e-12 * greatest_pressure(x), shared_->problem.scene().pressure_floor);
      std::vector<int> matters(changed.size(), 0), all(changed.size(), 0);
      for (std::size_t k = 0; k < changed.size(); ++k) {
        const int local = map.getLocalElement(dofs.global(dofs.n_nodes() + changed[k]));
        if (local != Teuchos::OrdinalTraits<int>::invalid() &&
            (std::abs(gap[local]) > no_gap || std::abs(pressure[local]) > no_pressure))
          matters[k] = 1;
      }
      Teuchos::reduceAll(*map.getComm(), Teuchos::REDUCE_MAX, static_cast<int>(matters.size()), matters.data(), all.data());
      for (std::size_t k = 0; k < changed.size(); ++k)
        if (all[k]) result_.unsettled.push_back(changed[k]);
      settled = result_.unsettled.empty();
    }
    previous_ = set_;
    return settled;
  }

  double greatest_pressure(const Vector& x) const {
    const auto values = x.getData();
    const DofSpace& dofs = shared_->problem.dofs();
    double greatest = 0, all = 0;
    for (int k = 0; k < shared_->problem.scene().n_multipliers; ++k)
      if (const int point = dofs.n_nodes() + k; dofs.owned(point))
        greatest = std::max(greatest, std::abs(values[dofs.local(point)]));
    Teuchos::reduceAll(*x.getMap()->getComm(), Teuchos::REDUCE_MAX, 1, &greatest, &all);
    return all;
  }

  // A set that was left twice and is met again: the next step is halved, so that the iterates leave the loop.
  void detect_cycle(bool settled) {
    if (settled) return;
    if (++met_[set_] < 3) return;
    ++cycles_;
    shared_->halve_next = true;
    met_.clear();
  }

  // Newton's method that swings between two states, as between two directions of slip: the next steps are halved.
  void detect_swing(int iteration, double residual) {
    std::rotate(residuals_.begin(), residuals_.end() - 1, residuals_.end());
    residuals_[0] = residual;
    if (damped_ > 0) {
      --damped_;
      shared_->halve_next = true;
      return;
    }
    constexpr int first_iteration = 7;  // before that the active set is found
    const auto alike = [this](int a, int b) { return std::abs(residuals_[a] - residuals_[b]) < 0.1 * residuals_[a]; };
    if (iteration < first_iteration || !(residual > 1e-6) || !alike(0, 2) || !alike(1, 3)) return;
    shared_->halve_next = true;
    damped_ = 5;
    residuals_.fill(0);
  }

  std::shared_ptr<NewtonShared> shared_;
  const SolverOptions& options_;
  const State& start_;
  StepResult& result_;
  const int before_;  // iterations of passes before
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  std::vector<char> set_, previous_;      // per multiplier: 0 open, 1 closed, 3 closed and sticking
  std::map<std::vector<char>, int> met_;  // how often each set was arrived at
  int opened_ = 0, closed_ = 0, cycles_ = 0, further_ = 0, far_off_ = 0, damped_ = 0;
  double last_residual_ = 0;
  std::array<double, 4> residuals_{};  // over the scale, the last one first
};

}  // namespace

Newton::Newton(StepProblem& problem, const SolverOptions& options)
    : problem_(problem), options_(options), linear_(problem.scene(), problem.dofs(), options) {}

RCP<Vector> Newton::first_guess(const State& from, double t) {
  const auto x = Teuchos::rcp(new Vector(*from.x, Teuchos::Copy));
  const FirstGuess kind = problem_.stage().time.first_guess;
  if (kind == FirstGuess::old_state) return x;
  const double dt = t - from.time;
  if (kind == FirstGuess::motion) {
    x->update(dt, *from.v, 0.5 * dt * dt, *from.a, 1.0);
  } else {
    RCP<Matrix> tangent;
    const Evaluation at = problem_.linearise(*x, tangent);
    Vector direction(x->getMap());
    if (!at.admissible || !find_direction(problem_, *x, at, *tangent, linear_, direction).solved) return x;
    x->update(1.0, direction, 1.0);
  }
  // A guess that turns an element inside out is none.
  return problem_.evaluate(*x).admissible ? x : Teuchos::rcp(new Vector(*from.x, Teuchos::Copy));
}

StepResult Newton::solve(const State& from, double t) {
  StepResult result;
  result.cause = problem_.begin_step(from, t);
  result.is_deck_fault = !result.cause.empty();
  if (result.is_deck_fault) return result;
  auto x = first_guess(from, t);
  for (int passes = 1;; ++passes) {
    iterate(from, x, result);
    if (!result.converged) return result;
    x = result.state.x;
    const auto excess = problem_.augment(*x, result.evaluation);
    if (!excess) break;
    if (passes < most_augmentations) continue;
    result.converged = false;
    result.cause = fmt::format("augmented Lagrangian: after {} passes a node is {:.3g} times as deep as \"largest penetration\"",
                               passes, *excess);
    return result;
  }
  result.state.time = t;
  result.state.search = problem_.search();
  problem_.finish_step(from, result.state);
  result.cause = update_velocities(problem_, linear_, from, result.state, result.evaluation);
  result.converged = result.cause.empty();
  if (!result.converged) return result;
  // Where forces are those of positions within the step, only now are those at its end looked at.
  if (problem_.stage().scheme.has_inertia() && !problem_.is_admissible_at_end(*result.state.x)) {
    result.converged = false;
    result.cause = "an element is inside out (det F <= 0) at the end of the step";
  }
  return result;
}

// Newton's iterations from `x`: whether they converged, where to, and how many more they were.
void Newton::iterate(const State& from, const RCP<Vector>& x, StepResult& result) {
  auto shared = std::make_shared<NewtonShared>(NewtonShared{problem_, linear_, seconds_linear_});
  const auto group = Teuchos::rcp(new NewtonGroup(shared, x));
  const auto status = Teuchos::rcp(new StepStatus(shared, options_, from, result));

  const auto list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Direction").set("Method", "Newton");
  list->sublist("Direction")
      .sublist("Newton")
      .set("Rescue Bad Newton Solve", true);  // a failed solve ends in StepStatus, not in a throw
  list->sublist("Line Search").set("Method", "User Defined");
  list->sublist("Line Search")
      .set("User Defined Line Search Factory",
           Teuchos::RCP<NOX::LineSearch::UserDefinedFactory>(Teuchos::rcp(new StepLengthFactory(shared))));
  list->sublist("Printing").set("Output Information", 0);
  list->sublist("Printing").set("Output Processor", 0);
  const Teuchos::RCP<std::ostream> silence = Teuchos::rcp(new Teuchos::oblackholestream);  // our own log tells what happens
  list->sublist("Printing").set("Output Stream", silence);
  list->sublist("Printing").set("Error Stream", silence);
  list->sublist("Printing").set("MyPID", problem_.dofs().comm()->getRank());
  list->sublist("Solver Options").set("Status Test Check Type", "Complete");

  const auto solver = NOX::Solver::buildSolver(group, status, list);
  result.converged = solver->solve() == NOX::StatusTest::Converged;
  if (!result.converged) {
    if (result.cause.empty())
      result.cause =
          "the step length fell to nothing: every state along the Newton direction is inadmissible" + shared->refusal_in_words();
    return;
  }
  const auto& solved = dynamic_cast<const NewtonGroup&>(solver->getSolutionGroup());
  result.state.x = Teuchos::rcp(new Vector(unwrap(solved.getX()), Teuchos::Copy));
  result.evaluation = solved.evaluation();
}

std::string Newton::find_acceleration(State& state) {
  state.a->putScalar(0.0);
  if (const std::string fault = problem_.begin_step(state, state.time); !fault.empty()) return fault;
  const Evaluation at = problem_.evaluate(*state.x);
  if (!at.admissible) return "an element is inside out (det F <= 0) at the start";
  const auto mass = problem_.mass_matrix();
  Vector force(*at.unbalanced, Teuchos::Copy);
  double* f = data(force);
  for (int k = 0; k < problem_.dofs().n_owned(); ++k) f[k] = problem_.identity_rows()[k] ? 0 : -f[k];
  LinearReport report = linear_.factor(mass, problem_.identity_rows(), problem_.graph_number());
  if (report.solved) report = linear_.solve(force, *state.a);
  return report.solved ? "" : "the mass matrix: " + report.cause;
}

}  // namespace mortise
