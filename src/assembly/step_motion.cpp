// The motion side of a step's equations: what follows from its unknowns, energies and momenta, and how motion starts.
#include <algorithm>
#include <cmath>

#include "assembly/step_problem.hpp"
#include "assembly/vectors.hpp"
#include "mesh/angles.hpp"
#include "physics/rotation.hpp"

namespace mortise {

double StepProblem::local_error(const State& from, const State& to) const {
  if (from.a.is_null() || !stage().time.error_tolerance) return 0;
  Vector change(*to.a, Teuchos::Copy);
  change.update(-1.0, *from.a, 1.0);
  const double dt = to.time - from.time;
  return dt * dt / 12 * change.normInf();
}

// What the residual looked at already is not looked at again: mean and algorithmic forces know the end of the step.
bool StepProblem::is_admissible_at_end(const Vector& x) const {
  const bool is_seen = !scheme_.is_explicit_in_position && (scheme_.theta == 1 || scheme_.forces != ForceReading::at_point);
  const auto has_been_seen = [&](const BodyTerm& body) {
    return is_seen && !(scheme_.forces == ForceReading::algorithmic && body.has_constant_tangent());
  };
  const auto overlap_x = to_overlap(x);
  Vector unused(dofs_.overlap_map());
  int is_good = 1;
  for (const auto& body : bodies_)
    if (!has_been_seen(*body) && !body->add_force(data(static_cast<const Vector&>(*overlap_x)), data(unused))) is_good = 0;
  return all_reduced(*dofs_.comm(), Teuchos::REDUCE_MIN, is_good) != 0;
}

void StepProblem::finish_step(const State& from, State& to) const {
  if (!stage().scheme.has_inertia()) return;
  const auto combined = [&](const Combination& c) {
    const auto sum = Teuchos::rcp(new Vector(dofs_.owned_map()));
    sum->update(1.0, *to.x, -1.0, *from.x, 0.0);  // the increment first, as in the forces
    sum->scale(c.dq);
    sum->update(c.v, *from.v, c.a, *from.a, 1.0);
    double* values = data(*sum);
    for (int k = dofs_.n_owned_positions(); k < dofs_.n_owned(); ++k) values[k] = 0;
    return sum;
  };
  to.v = combined(kinematics_.velocity);
  to.a = combined(kinematics_.acceleration);
  if (!stage().scheme.is_explicit_in_position) return;
  to.x = Teuchos::rcp(new Vector(*from.x, Teuchos::Copy));
  to.x->update(dt_, *from.v, 1.0);
}

double StepProblem::kinetic_energy(const RCP<Vector>& v) const {
  if (v.is_null()) return 0;
  const auto overlap_v = to_overlap(*v);
  double energy = 0;
  for (const auto& term : inertias_) energy += term.kinetic_energy(data(*overlap_v));
  return all_reduced(*dofs_.comm(), Teuchos::REDUCE_SUM, energy);
}

RCP<Vector> StepProblem::momenta(const Vector& v) const {
  const auto overlap_v = to_overlap(v);
  Vector shares(dofs_.overlap_map());
  for (const auto& term : inertias_) term.add_force(data(*overlap_v), data(shares));
  return owned_sum(shares);
}

std::pair<double, Vec3<double>> StepProblem::mass_and_centre(const InertiaTerm& term, const Vector& x) const {
  const auto overlap_x = to_overlap(x);
  const auto mine = term.mass_and_moment(data(*overlap_x));
  std::vector<double> sum(mine.begin(), mine.end());
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, sum);
  return {sum[0], {sum[1] / sum[0], sum[2] / sum[0], sum[3] / sum[0]}};
}

// What another run left, at the nodes that have something of it.
void StepProblem::add_carried(const std::vector<Vec3<double>>& values, Vector& to) const {
  double* at = data(to);
  for (int node = 0; node < dofs_.n_nodes(); ++node)
    if (scene_.carried->has[node] && dofs_.owned(node))
      for (int i = 0; i < 3; ++i) at[dofs_.local(node) + i] += values[node][i];
}

// Nodes that two bodies share move as the later one of the deck says, those of masses as these.
void StepProblem::place_bodies(Vector& positions) const {
  double* x = data(positions);
  if (scene_.carried) add_carried(scene_.carried->displacement, positions);
  for (const auto& term : inertias_) {
    if (!term.initial() || !term.initial()->rotation) continue;
    const Vec3<double> centre = centre_of_turning(term, *reference_state());
    const auto [ax, ay, az, degrees] = *term.initial()->rotation;
    const Vec3<double> axis{ax, ay, az};
    const auto [sine, cosine] = sine_cosine(degrees);
    for (int node : term.nodes()) {
      if (!dofs_.owned(node)) continue;
      const Vec3<double> arm = vec3(scene_.mesh.mesh.coordinates[node]) - centre;
      const Vec3<double> q = centre + turned_about((1 / norm(axis)) * axis, sine, cosine, arm);
      for (int i = 0; i < 3; ++i) x[dofs_.local(node) + i] = q[i];
    }
  }
}

RCP<Vector> StepProblem::initial_velocities(const Vector& positions) const {
  const auto velocities = Teuchos::rcp(new Vector(dofs_.owned_map()));
  const double* x = data(positions);
  double* v = data(*velocities);
  for (const auto& term : inertias_) {
    if (!term.initial()) continue;
    const Vec3<double> centre = centre_of_turning(term, positions), velocity = vec3(term.initial()->velocity),
                       spin = vec3(term.initial()->angular_velocity);
    for (int node : term.nodes()) {
      if (!dofs_.owned(node)) continue;
      const int at = dofs_.local(node);
      const Vec3<double> moving = velocity + cross(spin, Vec3<double>{x[at], x[at + 1], x[at + 2]} - centre);
      for (int i = 0; i < 3; ++i) v[at + i] = moving[i];
    }
  }
  if (scene_.carried) add_carried(scene_.carried->velocity, *velocities);
  return velocities;
}

Vec3<double> StepProblem::centre_of_turning(const InertiaTerm& term, const Vector& x) const {
  return term.initial()->centre ? vec3(*term.initial()->centre) : mass_and_centre(term, x).second;
}

State StepProblem::enter_stage(std::size_t next, const State& left) {
  const bool had_inertia = !left.v.is_null();
  stage_ = next;
  State state = left;
  if (!stage().scheme.has_inertia()) {
    state.v = state.a = Teuchos::null;
  } else {
    if (!had_inertia) state.v = initial_velocities(*left.x);
    state.a = Teuchos::rcp(new Vector(dofs_.owned_map()));
  }
  state.x = Teuchos::rcp(new Vector(*left.x, Teuchos::Copy));
  for (const auto& contact : contacts_) {
    const ContactNodes& nodes = contact->nodes();
    if (nodes.activity.acts_after(state.time)) continue;
    for (std::size_t k = 0; k < nodes.secondary_nodes.size(); ++k)
      if (const int point = contact->pressure_point(k); dofs_.owned(point))
        std::fill_n(data(*state.x) + dofs_.local(point), nodes.n_unknowns, 0.0);
  }
  return state;
}

void StepProblem::settle_springs(Vector& x) const {
  if (augmented_springs_.empty()) return;
  const auto overlap_x = to_overlap(x);
  for (const auto& spring : augmented_springs_) spring.settle(data(static_cast<const Vector&>(*overlap_x)), data(x));
}

RCP<Matrix> StepProblem::mass_matrix() {
  if (!matrix_) build_graph();
  matrix_->clear();
  constant_.reset();
  for (const auto& term : inertias_) term.add_tangent(1, *matrix_);
  identity_rows_.assign(dofs_.n_owned(), 0);
  for (int k = dofs_.n_owned_positions(); k < dofs_.n_owned(); ++k) identity_rows_[k] = 1;
  for (const auto& [dof, unused] : prescribed_) identity_rows_[dof] = 1;
  Vector ones(dofs_.owned_map());
  ones.putScalar(1.0);
  const auto mass = momenta(ones);
  for (int k = 0; k < dofs_.n_owned_positions(); ++k)
    if (data(*mass)[k] == 0) identity_rows_[k] = 1;  // a node without mass
  tangent_ = matrix_->assemble();
  put_identity_rows();
  return tangent_;
}

// [N]. Beside stress of the round-off of positions, that of the inertia they make in a short step.
double StepProblem::round_off_of_forces() const {
  double mass = 0;
  for (const auto& term : inertias_) mass = std::max(mass, term.mass_of_element());
  const double h = scene_.size, inertia = mass * std::abs(kinematics_.inertia.dq);
  return scene_.force_floor + 1e-14 * inertia * (h + scene_.extent);
}

}  // namespace mortise
