// What a step knows of the deck's forces and motions: supports, loads, springs and damping at its time.
#include "assembly/step_problem.hpp"
#include "assembly/vectors.hpp"
#include "prescribed_motion.hpp"

namespace mortise {
namespace {

/// The message of the first rank that has one, on all ranks.
std::string agreed(const Comm& comm, const std::string& fault) {
  const int none = comm.getSize();
  const int rank = all_reduced(comm, Teuchos::REDUCE_MIN, fault.empty() ? none : comm.getRank());
  if (rank == none) return "";
  std::string message = fault;
  int size = static_cast<int>(message.size());
  Teuchos::broadcast(comm, rank, &size);
  message.resize(static_cast<std::size_t>(size));
  Teuchos::broadcast(comm, rank, size, message.data());
  return message;
}

}  // namespace

std::string StepProblem::begin_step(const State& from, double t) {
  std::string fault;
  time_ = t;
  dt_ = t - from.time;
  start_x_ = to_overlap(*from.x);
  if (!from.search.x.is_null() && from.search.x != search_.x) search_at(from.search);
  move_supports(from, t, fault);
  if (!dead_loads_.empty()) {
    Vector shares(dofs_.overlap_map());
    dead_loads_.add(t, data(shares), fault);
    dead_ = owned_sum(shares);
  }
  for (auto& follower : followers_) follower.set_time(t, fault);
  return agreed(*dofs_.comm(), fault);
}

// Formulas are evaluated on every rank, so that most faults are the same on all; where a node was only its owner knows.
void StepProblem::move_supports(const State& from, double t, std::string& fault) {
  auto acting = std::make_shared<std::vector<PrescribedDof>>();
  prescribed_.clear();
  const double* q_n = data(*start_x_);
  double u_acting = 0;
  for (const auto& p : scene_.prescribed) {
    const Support& support = scene_.supports[p.support];
    if (!support.activity.acts_at(t)) continue;
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

void StepProblem::add_springs(const Vector& overlap_x, Vector& internal) {
  for (const auto& spring : springs_) {
    if (!spring.acts_at(time_)) continue;
    spring.add_force(data(overlap_x), data(internal));
  }
}

RCP<Vector> StepProblem::damping(const Vector& overlap_x) {
  if (dampings_.empty()) return Teuchos::null;
  Vector velocity(dofs_.overlap_map()), force(dofs_.overlap_map());
  if (dt_ > 0) velocity.update(1 / dt_, overlap_x, -1 / dt_, *start_x_, 0.0);
  for (const auto& term : dampings_) {
    term.add_force(data(velocity), data(force));
  }
  return owned_sum(force);
}

RCP<Vector> StepProblem::external(const Vector& overlap_x, bool with_tangent) {
  if (followers_.empty()) return dead_;
  Vector shares(dofs_.overlap_map());
  for (const auto& follower : followers_) {
    if (with_tangent) {
      follower.add_tangent(data(overlap_x), data(shares), *matrix_);
    } else {
      follower.add_force(data(overlap_x), data(shares));
    }
  }
  const auto sum = owned_sum(shares);
  sum->update(1.0, *dead_, 1.0);
  return sum;
}

}  // namespace mortise
