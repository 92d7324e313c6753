// What a step knows of the deck's forces and motions: supports, loads, springs and damping at its time.
#include <algorithm>

#include "assembly/step_problem.hpp"
#include "assembly/vectors.hpp"
#include "prescribed_motion.hpp"

namespace mortise {
namespace {}  // namespace

std::string StepProblem::begin_step(const State& from, double t) {
  std::string fault;
  time_ = t;
  dt_ = t - from.time;
  acting_time_ = dt_ > 0 ? t : just_after(t);
  start_x_ = to_overlap(*from.x);
  pressure_before_ = from.x;
  if (!from.search.x.is_null() && from.search.x != search_.x) search_at(from.search);
  scheme_ = dt_ > 0 ? stage().scheme : stage().scheme.at_rest();
  kinematics_ = scheme_.kinematics(dt_);
  start_v_ = from.v.is_null() ? Teuchos::null : to_overlap(*from.v);
  start_a_ = from.a.is_null() ? Teuchos::null : to_overlap(*from.a);
  if (scheme_.forces == ForceReading::mean) find_forces_before(from.time, fault);
  move_supports(from, t, fault);
  const double t_force = scheme_.forces == ForceReading::mean ? t : from.time + scheme_.theta * dt_;
  dead_ = dead(t_force, fault);
  for (auto& follower : followers_) follower.set_time(acting_time_, t_force, fault);
  for (const auto& term : pairs_)
    if (dt_ > 0 && term->pair().friction && acts(*term)) check(*term->pair().friction, t, fault);
  for (auto& contact : contacts_) contact->begin_step(data(static_cast<const Vector&>(*start_x_)), dt_ == 0, scheme_, *acting_);
  find_gaps_before(*from.x);
  return agreed(*dofs_.comm(), fault);
}

RCP<Vector> StepProblem::dead(double t, std::string& fault) const {
  if (dead_loads_.empty()) return Teuchos::rcp(new Vector(dofs_.owned_map()));
  Vector shares(dofs_.overlap_map());
  dead_loads_.add(acting_time_, t, data(shares), fault);
  return owned_sum(shares);
}

// Of schemes that take the mean of the forces at both ends: those at the start, where the step knows them already.
void StepProblem::find_forces_before(double t_before, std::string& fault) {
  Vector internal(dofs_.overlap_map());
  for (const auto& body : bodies_) body->add_force(data(*start_x_), data(internal));
  for (const auto& term : stretches_)
    if (term.acts_at(acting_time_)) term.add_force(nullptr, data(*start_x_), data(internal));
  add_springs(*start_x_, internal);
  internal_before_ = owned_sum(internal);
  const auto external = dead(t_before, fault);
  if (!followers_.empty()) {
    Vector shares(dofs_.overlap_map());
    for (auto& follower : followers_) {
      follower.set_time(acting_time_, t_before, fault);
      follower.add_force(data(*start_x_), data(shares));
    }
    external->update(1.0, *owned_sum(shares), 1.0);
  }
  external_before_ = external;
}

RCP<Vector> StepProblem::positions_at(double theta, const RCP<Vector>& overlap_x) const {
  if (theta == 1) return overlap_x;
  const auto between = Teuchos::rcp(new Vector(*overlap_x, Teuchos::Copy));
  between->update(1 - theta, *start_x_, theta);
  double* to = data(*between);
  const double* pressures = data(static_cast<const Vector&>(*overlap_x));
  for (int k : overlap_pressures_) to[k] = pressures[k];
  return between;
}

// Formulas are evaluated on every rank, so that most faults are the same on all; where a node was only its owner knows.
void StepProblem::move_supports(const State& from, double t, std::string& fault) {
  auto acting = std::make_shared<std::vector<PrescribedDof>>();
  prescribed_.clear();
  const double* q_n = data(*start_x_);
  double u_acting = 0;
  for (const auto& p : scene_.prescribed) {
    const Support& support = scene_.supports[p.support];
    if (!support.activity.acts_at(acting_time_)) continue;
    const Point& X = scene_.mesh.mesh.coordinates[p.node];
    const bool is_mine = dofs_.owned(p.node);
    double u = prescribed_displacement(support, p.axis, X, from.time, t, fault);
    if (is_increment(support) && is_mine) u += q_n[dofs_.local(p.node) + p.axis] - X[p.axis];
    if (!acting->empty() && acting->back().node == p.node && acting->back().axis == p.axis) {
      const bool is_known = is_mine || !(is_increment(support) || is_increment(scene_.supports[acting->back().support]));
      if (fault.empty() && is_known) fault = contradiction(scene_, acting->back(), p, u_acting, u, t);
      continue;
    }
    acting->push_back(p);
    u_acting = u;
    if (is_mine) prescribed_.emplace_back(dofs_.local(p.node) + p.axis, X[p.axis] + u);
  }
  acting_ = acting;
}

// Adds the forces of bodies and lines, on the overlap. @return false: a state is inadmissible on this rank
bool StepProblem::add_internal(const Vector& overlap_x, const Vector& at_theta, bool with_tangent, Vector& internal) {
  const bool is_algorithmic = scheme_.forces == ForceReading::algorithmic;
  const double *x = data(overlap_x), *x_theta = data(at_theta), *x_n = is_algorithmic ? data(*start_x_) : nullptr;
  double* f = data(internal);
  bool is_good = true;
  for (auto& body : bodies_) {
    const bool adds_tangent = with_tangent && !body->has_constant_tangent();
    if (adds_tangent) counts_.element_tangents += static_cast<long>(body->n_elements());
    // Where the stress is linear in the positions the mean positions give the discrete gradient too.
    if (is_algorithmic && !body->has_constant_tangent()) {
      is_good &= adds_tangent ? body->add_algorithmic_tangent(x_n, x, f, *matrix_) : body->add_algorithmic_force(x_n, x, f);
    } else {
      is_good &= adds_tangent ? body->add_tangent(x_theta, scheme_.theta, f, *matrix_) : body->add_force(x_theta, f);
    }
  }
  for (const auto& term : stretches_) {
    if (!term.acts_at(acting_time_)) continue;
    const double* at = is_algorithmic ? x : x_theta;
    is_good &=
        with_tangent ? term.add_tangent(x_n, at, is_algorithmic ? 1 : scheme_.theta, f, *matrix_) : term.add_force(x_n, at, f);
  }
  return is_good;
}

// The forces that are one for the whole step, whatever its reading of forces: of augmented springs, on the overlap; null without.
// @return as above
bool StepProblem::add_of_step(const Vector& overlap_x, bool with_tangent, RCP<Vector>& of_step) {
  if (augmented_springs_.empty()) return true;
  of_step = Teuchos::rcp(new Vector(dofs_.overlap_map()));
  const double *x = data(overlap_x), *start = start_x_.is_null() ? x : data(static_cast<const Vector&>(*start_x_));
  bool is_good = true;
  for (const auto& spring : augmented_springs_) {
    if (!spring.acts_at(acting_time_)) continue;
    is_good &= with_tangent ? spring.add_tangent(scheme_, start, x, data(*of_step), *matrix_)
                            : spring.add_force(scheme_, start, x, data(*of_step));
  }
  return is_good;
}

void StepProblem::add_springs(const Vector& overlap_x, Vector& internal) {
  for (const auto& spring : springs_) {
    if (!spring.acts_at(acting_time_)) continue;
    spring.add_force(data(overlap_x), data(internal));
  }
}

// dq, v_n and a_n combined, at the rows of positions on the overlap.
RCP<Vector> StepProblem::in_motion(const Combination& c, const Vector& overlap_x) const {
  const auto sum = Teuchos::rcp(new Vector(dofs_.overlap_map()));
  if (dt_ > 0) {  // the increment first: it is free of the round-off that c.dq q has
    sum->update(1.0, overlap_x, -1.0, *start_x_, 0.0);
    sum->scale(c.dq);
  }
  if (!start_v_.is_null() && c.v != 0) sum->update(c.v, *start_v_, 1.0);
  if (!start_a_.is_null() && c.a != 0) sum->update(c.a, *start_a_, 1.0);
  return sum;
}

RCP<Vector> StepProblem::force_from_ground(const Vector& x) {
  const auto is_anchored = [](const auto& term) { return term.is_anchored(); };
  const bool has_springs = !springs_.empty() || std::any_of(stretches_.begin(), stretches_.end(), is_anchored) ||
                           std::any_of(augmented_springs_.begin(), augmented_springs_.end(), is_anchored);
  if (!has_springs && scene_.obstacles.empty()) return Teuchos::null;
  const bool is_mean = scheme_.forces == ForceReading::mean, is_algorithmic = scheme_.forces == ForceReading::algorithmic;
  const auto overlap_x = to_overlap(x);
  const auto of_springs = [&](const Vector& at, const double* x_n, const Vector& stretched_at) {
    Vector shares(dofs_.overlap_map());
    add_springs(at, shares);
    for (const auto& term : stretches_)
      if (term.is_anchored() && term.acts_at(acting_time_)) term.add_force(x_n, data(stretched_at), data(shares));
    return owned_sum(shares);
  };
  const auto at_theta = is_mean ? overlap_x : positions_at(scheme_.theta, overlap_x);
  const auto force = of_springs(*at_theta, is_algorithmic ? data(*start_x_) : nullptr, is_algorithmic ? *overlap_x : *at_theta);
  if (is_mean) force->update(1 - scheme_.theta, *of_springs(*start_x_, nullptr, *start_x_), scheme_.theta);
  if (!augmented_springs_.empty()) {
    Vector of_step(dofs_.overlap_map());
    for (const auto& spring : augmented_springs_)
      if (spring.is_anchored() && spring.acts_at(acting_time_))
        spring.add_force(scheme_, data(*start_x_), data(*overlap_x), data(of_step));
    force->update(1.0, *owned_sum(of_step), 1.0);
  }
  force->update(1.0, *contact_force_of(overlap_x, contacts_.size() - scene_.obstacles.size(), contacts_.size(), true), 1.0);
  return force;
}

RCP<Vector> StepProblem::damping(const Vector& overlap_x) {
  if (dampings_.empty()) return Teuchos::null;
  Vector force(dofs_.overlap_map());
  const auto velocity = in_motion(kinematics_.damping, overlap_x);
  for (const auto& term : dampings_) term.add_force(data(*velocity), data(force));
  return owned_sum(force);
}

RCP<Vector> StepProblem::inertia(const Vector& overlap_x) {
  if (!stage().scheme.has_inertia()) return Teuchos::null;
  Vector force(dofs_.overlap_map());
  const auto acceleration = in_motion(kinematics_.inertia, overlap_x);
  for (const auto& term : inertias_) term.add_force(data(*acceleration), data(force));
  return owned_sum(force);
}

RCP<Vector> StepProblem::external(const Vector& overlap_x, bool with_tangent) {
  const bool is_mean = scheme_.forces == ForceReading::mean;
  if (followers_.empty() && !is_mean) return dead_;
  Vector shares(dofs_.overlap_map());
  for (const auto& follower : followers_) {
    if (with_tangent) {
      follower.add_tangent(data(overlap_x), scheme_.theta, data(shares), *matrix_);
    } else {
      follower.add_force(data(overlap_x), data(shares));
    }
  }
  const auto sum = owned_sum(shares);
  const double weight = is_mean ? scheme_.theta : 1;
  sum->update(weight, *dead_, weight);
  if (is_mean) sum->update(1 - scheme_.theta, *external_before_, 1.0);
  return sum;
}

// Where contact forces act, and with which weight. At the end of the step the pass that finds the gaps gives them too.
std::vector<StepProblem::ContactPass> StepProblem::contact_passes() const {
  if (scheme_.forces == ForceReading::mean) return {{0, 1 - scheme_.theta}, {1, scheme_.theta}};
  return {{scheme_.constraint_theta, 1}};
}

double StepProblem::contact_weight_at_end() const {
  double weight = 0;
  for (const auto& pass : contact_passes())
    if (pass.theta == 1) weight += pass.weight;
  return weight;
}

// Adds the forces of contacts [first, end) that do not act at the end of the step, with pressures from there.
// @param sums gets what belongs to their positions: of use are the slips alone
void StepProblem::add_contact_between(const RCP<Vector>& overlap_x, bool with_tangent, std::size_t first, std::size_t end,
                                      NodalSums& sums, Vector& contact) {
  for (const auto& pass : contact_passes()) {
    if (pass.theta == 1 || pass.weight == 0) continue;
    const auto x = positions_at(pass.theta, overlap_x);
    Vector force(dofs_.overlap_map());
    for (std::size_t k = first; k < end; ++k) {
      if (!acts(*contacts_[k])) continue;
      contacts_[k]->integrate(data(*x), with_tangent, data(force), sums);
      if (with_tangent) contacts_[k]->add_force_tangent(pass.weight, pass.theta, *matrix_);
    }
    contact.update(pass.weight, force, 1.0);
  }
}

RCP<Vector> StepProblem::contact_force_of(const RCP<Vector>& overlap_x, std::size_t first, std::size_t end, bool with_friction) {
  Vector contact(dofs_.overlap_map());
  NodalSums unused(dofs_);
  unused.with_friction = with_friction;
  add_contact_between(overlap_x, false, first, end, unused, contact);
  if (const double weight = contact_weight_at_end(); weight != 0) {
    Vector force(dofs_.overlap_map());
    for (std::size_t k = first; k < end; ++k)
      if (acts(*contacts_[k])) contacts_[k]->integrate(data(*overlap_x), false, data(force), unused);
    contact.update(weight, force, 1.0);
  }
  return owned_sum(contact);
}

RCP<Vector> StepProblem::push(const Vector& x, std::size_t k) {
  const auto force = contact_force_of(to_overlap(x), k, k + 1, false);
  force->scale(-1.0);
  return force;
}

RCP<Vector> StepProblem::push_at_end(const Vector& x, std::size_t k) {
  const auto overlap_x = to_overlap(x);
  Vector force(dofs_.overlap_map());
  NodalSums unused(dofs_);
  unused.with_friction = false;
  if (acts(*contacts_[k])) contacts_[k]->integrate(data(*overlap_x), false, data(force), unused);
  const auto push = owned_sum(force);
  push->scale(-1.0);
  return push;
}

}  // namespace mortise
