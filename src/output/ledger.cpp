#include "output/ledger.hpp"

#include <cmath>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

double strain_energy(StepProblem& problem, const State& state) {
  const auto q = problem.to_overlap(*state.x);
  return all_reduced(*problem.dofs().comm(), Teuchos::REDUCE_SUM, problem.strain_energy(data(*q)));
}

/// Increment of the positions; pressures have none.
Vector increment(const StepProblem& problem, const State& before, const State& now) {
  Vector dq(*now.x, Teuchos::Copy);
  dq.update(-1.0, *before.x, 1.0);
  double* values = data(dq);
  for (int k = problem.dofs().n_owned_positions(); k < problem.dofs().n_owned(); ++k) values[k] = 0;
  return dq;
}

/// Sum of a vector over all nodes, and of its moments about the origin with arms from `x`: f, then x x f.
std::vector<double> resultant(const StepProblem& problem, const Vector& x, const Vector& f) {
  const double *at = data(x), *values = data(f);
  std::vector<double> sum(6, 0.0);
  for (int k = 0; k < problem.dofs().n_owned_positions(); k += 3)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      sum[i] += values[k + i];
      sum[3 + i] += at[k + j] * values[k + l] - at[k + l] * values[k + j];
    }
  all_reduce(*problem.dofs().comm(), Teuchos::REDUCE_SUM, sum);
  return sum;
}

std::vector<double> half(const std::vector<double>& six, int which) {
  return {six.begin() + 3 * which, six.begin() + 3 * which + 3};
}

void find_momenta(Ledger& ledger, const StepProblem& problem, const State& state) {
  std::vector<double> both(6, 0.0);
  if (!state.v.is_null()) both = resultant(problem, *state.x, *problem.momenta(*state.v));
  ledger.linear_momentum = half(both, 0);
  ledger.angular_momentum = half(both, 1);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares);
}

/// What `unbalanced` is made of: forces that supports exert, and what Newton left elsewhere.
struct Rest {
  Vector reaction, residual;
};

Rest rest_of(const StepProblem& problem, const Evaluation& at) {
  Rest rest{Vector(at.unbalanced->getMap()), Vector(*at.unbalanced, Teuchos::Copy)};
  double *reaction = data(rest.reaction), *residual = data(rest.residual);
  for (const auto& p : *at.prescribed) {
    if (!problem.dofs().owned(p.node)) continue;
    const int k = problem.dofs().local(p.node) + p.axis;
    reaction[k] = residual[k];
    residual[k] = 0;
  }
  return rest;
}

/// Work of contact in a step, of which nodes that closed in it did `closing`, and those closed at both ends `both_ends`.
struct ContactWork {
  double whole = 0, closing = 0, both_ends = 0;
  std::vector<double> weighted_gap;
};

ContactWork contact_work(const Ledger& ledger, StepProblem& problem, const State& now, const Evaluation& at, const Vector& dq) {
  ContactWork work;
  work.whole = -at.contact->dot(dq) - at.friction_work;
  const Scene& scene = problem.scene();
  if (scene.n_multipliers == 0) return work;
  const auto gap = problem.gather(*at.gap), area = problem.gather(*at.area), x = problem.gather(*now.x);
  Vector newly(*now.x, Teuchos::Copy);
  double* p = data(newly);
  for (int k = 0; k < scene.n_multipliers; ++k) {
    const int point = problem.dofs().n_nodes() + k;
    const GlobalIndex at = problem.dofs().global(point);
    work.weighted_gap.push_back(gap[at] * area[at]);
    if (!ledger.closed[k]) continue;
    work.both_ends += x[at] * (work.weighted_gap[k] - ledger.weighted_gap[k]);
    if (problem.dofs().owned(point)) p[problem.dofs().local(point)] = 0;
  }
  work.closing = -problem.contact_force(*now.x, newly)->dot(dq);
  return work;
}

/// Work of the forces behind a jump of velocities, of contact and of supports, and their impulses with moments about the origin.
struct JumpWork {
  double contact = 0, reaction = 0;
  std::vector<double> from_outside = std::vector<double>(6, 0.0);
};

JumpWork jump_work(const StepProblem& problem, const State& now, const Evaluation& at) {
  JumpWork work;
  if (!at.jump) return work;
  Vector mean(*now.v, Teuchos::Copy), outside(*at.jump->impulse_of_ground, Teuchos::Copy), reaction(mean.getMap());
  mean.update(-0.5, *at.jump->change, 1.0);
  const auto momenta = problem.momenta(*at.jump->change);
  double* pushed = data(reaction);
  const double *gained = data(*momenta), *by_contact = data(*at.jump->impulse);
  for (const auto& p : *at.prescribed)
    if (problem.dofs().owned(p.node)) {
      const int k = problem.dofs().local(p.node) + p.axis;
      pushed[k] = gained[k] - by_contact[k];
    }
  outside.update(1.0, reaction, 1.0);
  work.contact = at.jump->impulse->dot(mean);
  work.reaction = reaction.dot(mean);
  work.from_outside = resultant(problem, *now.x, outside);
  return work;
}

}  // namespace

double Ledger::linear_mismatch() const { return distance(linear_momentum, linear_balance); }
double Ledger::angular_mismatch() const { return distance(angular_momentum, angular_balance); }

void open_ledger(Ledger& ledger, StepProblem& problem, const State& state, const Evaluation& at) {
  ledger.strain_energy = strain_energy(problem, state);
  ledger.kinetic_energy = problem.kinetic_energy(state.v);
  ledger.weighted_gap.assign(problem.scene().n_multipliers, 0.0);
  ledger.closed = at.closed;
  find_momenta(ledger, problem, state);
  ledger.linear_balance = ledger.linear_momentum;
  ledger.angular_balance = ledger.angular_momentum;
}

void enter_stage(Ledger& ledger, StepProblem& problem, const State& start) {
  const double kinetic_before = ledger.kinetic_energy;
  const std::vector<double> linear_before = ledger.linear_momentum, angular_before = ledger.angular_momentum;
  ledger.kinetic_energy = problem.kinetic_energy(start.v);
  ledger.external += ledger.kinetic_energy - kinetic_before;
  find_momenta(ledger, problem, start);
  for (int i = 0; i < 3; ++i) {
    ledger.linear_balance[i] += ledger.linear_momentum[i] - linear_before[i];
    ledger.angular_balance[i] += ledger.angular_momentum[i] - angular_before[i];
  }
}

void add_step(Ledger& ledger, StepProblem& problem, const State& before, const State& now, const Evaluation& at) {
  const Vector dq = increment(problem, before, now);
  const double kinetic_before = ledger.kinetic_energy;
  double strain_before = ledger.strain_energy;
  if (problem.has_temporary_springs()) {  // what those that come and go store is given or taken from outside
    strain_before = strain_energy(problem, before);
    ledger.external += strain_before - ledger.strain_energy;
  }
  ledger.strain_energy = strain_energy(problem, now);
  ledger.kinetic_energy = problem.kinetic_energy(now.v);

  const Rest rest = rest_of(problem, at);
  const double damping = at.damping.is_null() ? 0 : at.damping->dot(dq), inertia = at.inertia.is_null() ? 0 : at.inertia->dot(dq);
  const JumpWork jump = jump_work(problem, now, at);
  const double internal = at.internal->dot(dq), external = at.external->dot(dq) + rest.reaction.dot(dq) + jump.reaction,
               residual = rest.residual.dot(dq), stored = ledger.strain_energy - strain_before,
               moved = ledger.kinetic_energy - kinetic_before,
               algorithmic = (inertia + jump.contact + jump.reaction - moved) + (internal - stored);
  ContactWork contact = contact_work(ledger, problem, now, at, dq);
  contact.whole += jump.contact;
  contact.closing += jump.contact;
  ledger.external += external;
  ledger.damping += damping;
  ledger.contact += contact.whole;
  ledger.closing += contact.closing;
  ledger.resegmentation += contact.whole - contact.closing - contact.both_ends;
  ledger.algorithmic += algorithmic;
  ledger.residual += residual;
  const double stick = at.stick_energy - ledger.stick_energy;  // what it loses when the area of a node changes counts as friction
  ledger.stick_energy = at.stick_energy;
  ledger.friction += -at.friction_work - stick;
  ledger.mismatch = moved + stored + algorithmic - contact.whole - at.friction_work + damping - external - residual;
  ledger.weighted_gap = contact.weighted_gap;
  ledger.closed = at.closed;

  find_momenta(ledger, problem, now);
  if (now.v.is_null()) return;
  Vector mean(*now.x, Teuchos::Copy), push(*at.external, Teuchos::Copy);
  mean.update(0.5, *before.x, 0.5);
  push.update(1.0, rest.reaction, 1.0, rest.residual, 1.0);
  if (!at.damping.is_null()) push.update(-1.0, *at.damping, 1.0);
  if (const auto ground = problem.force_from_ground(*now.x); !ground.is_null()) push.update(-1.0, *ground, 1.0);
  const auto impulse = resultant(problem, mean, push);
  const double dt = now.time - before.time;
  for (int i = 0; i < 3; ++i) {
    ledger.linear_balance[i] += dt * impulse[i] + jump.from_outside[i];
    ledger.angular_balance[i] += dt * impulse[3 + i] + jump.from_outside[3 + i];
  }
}

}  // namespace mortise
