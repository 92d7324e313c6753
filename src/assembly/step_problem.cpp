#include "assembly/step_problem.hpp"

#include <fmt/format.h>

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

/// Adds the seconds of a scope to a counter.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), start_(Teuchos::Time::wallTime()) {}
  ~Stopwatch() { seconds_ += Teuchos::Time::wallTime() - start_; }

 private:
  double& seconds_;
  double start_;
};

}  // namespace

StepProblem::StepProblem(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm)
    : scene_(scene), dofs_(scene, partition, comm), dead_loads_(scene, partition, dofs_) {
  for (const auto& body : scene.bodies) bodies_.push_back(std::make_unique<BodyTerm>(scene, body, partition, dofs_));
  for (const auto& pair : scene.pairs) {
    auto term = std::make_unique<MortarTerm>(pair, partition, dofs_);
    pairs_.push_back(term.get());
    contacts_.push_back(std::move(term));
  }
  for (const auto& tie : scene.ties) contacts_.push_back(std::make_unique<TieTerm>(scene, tie, partition, dofs_));
  for (const auto& obstacle : scene.obstacles) contacts_.push_back(std::make_unique<ObstacleTerm>(scene, obstacle, dofs_));
  for (const auto& load : scene.loads)
    if (load.follows()) followers_.emplace_back(scene, load, partition, dofs_);
  for (const auto& spring : scene.springs) springs_.emplace_back(scene, spring, partition, dofs_);
  for (const auto& spring : scene.node_springs) {
    if (spring.augmented) {
      augmented_springs_.emplace_back(scene, spring, dofs_);
    } else {
      stretches_.emplace_back(spring, dofs_);
    }
  }
  for (const auto& string : scene.strings) stretches_.emplace_back(scene, string, partition, dofs_);
  for (const auto& body : bodies_)
    if (body->body().rayleigh.exists()) dampings_.emplace_back(scene, *body, data(*to_overlap(*reference_state())), dofs_);
  if (scene.has_inertia()) {
    for (const auto& body : bodies_) inertias_.emplace_back(scene, *body, dofs_);
    for (const auto& string : scene.strings) inertias_.emplace_back(scene, string, partition, dofs_);
    for (const auto& masses : scene.masses) inertias_.emplace_back(masses, dofs_);
  }
  for (int point : dofs_.overlap_points())
    if (!dofs_.is_node(point) && point < scene.spring_point(0))
      for (int i = 0; i < dofs_.size(point); ++i) overlap_pressures_.push_back(dofs_.local(point) + i);
  scheme_ = stage().scheme.at_rest();
  acting_time_ = just_after(0);
  kinematics_ = scheme_.kinematics(0);
  dead_ = Teuchos::rcp(new Vector(dofs_.owned_map()));
  identity_rows_.assign(dofs_.n_owned(), 0);
  for (const auto& body : scene.bodies)
    for (int e : body.elements)
      for (int m = 0; m < n_pressures(body.formulation, element_type(scene.mesh.mesh, e)); ++m)
        if (const int point = scene.pressure_point(e, m); dofs_.owned(point))
          constraint_rows_.push_back({dofs_.local(point), body.size * body.size * body.size, 0});
  for (const auto& spring : augmented_springs_)
    if (spring.is_here())
      constraint_rows_.push_back({spring.unknowns() + 1, 1, 1e-14 * (1 + scene.extent / spring.rest_length())});
  if (!contacts_.empty()) find_normal_stiffness();
}

RCP<Vector> StepProblem::to_overlap(const Vector& owned) const {
  auto overlap = Teuchos::rcp(new Vector(dofs_.overlap_map()));
  overlap->doImport(owned, *dofs_.importer(), Tpetra::INSERT);
  return overlap;
}

std::vector<double> StepProblem::gather(const Vector& owned) const {
  std::vector<double> all(dofs_.n_unknowns(), 0.0);
  const auto values = owned.getData();
  for (int k = 0; k < dofs_.n_owned(); ++k) all[dofs_.owned_map()->getGlobalElement(k)] = values[k];
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, all);
  return all;
}

RCP<Vector> StepProblem::scatter(const std::vector<double>& all) const {
  auto owned = Teuchos::rcp(new Vector(dofs_.owned_map()));
  auto values = owned->getDataNonConst();
  for (int k = 0; k < dofs_.n_owned(); ++k) values[k] = all[dofs_.owned_map()->getGlobalElement(k)];
  return owned;
}

void StepProblem::resume_counts(const WorkCounts& counts, const std::vector<ContactCounts>& of_pairs) {
  counts_ = counts;
  for (std::size_t k = 0; k < pairs_.size(); ++k) pairs_[k]->resume_counts(of_pairs[k]);
}

RCP<Vector> StepProblem::owned_sum(const Vector& shares) const {
  auto sum = Teuchos::rcp(new Vector(dofs_.owned_map()));
  sum->doExport(shares, *dofs_.importer(), Tpetra::ADD);
  return sum;
}

double StepProblem::strain_energy(const double* x) const {
  double energy = 0;
  for (const auto& body : bodies_) energy += body->strain_energy(x);
  for (const auto& spring : springs_)
    if (spring.acts_at(acting_time_)) energy += spring.energy(x);
  for (const auto& term : stretches_)
    if (term.acts_at(acting_time_)) energy += term.energy(x);
  for (const auto& spring : augmented_springs_)
    if (spring.acts_at(acting_time_)) energy += spring.energy(x);
  return energy;
}

bool StepProblem::has_temporary_springs() const {
  const auto comes_or_goes = [](const auto& spring) { return !spring.activity.always(); };
  return std::any_of(scene_.springs.begin(), scene_.springs.end(), comes_or_goes) ||
         std::any_of(scene_.node_springs.begin(), scene_.node_springs.end(), comes_or_goes);
}

void StepProblem::build_graph() {
  const Stopwatch watch(counts_.seconds_assembly);
  std::vector<Cell> cells;
  for (auto& body : bodies_) body->append_cells(cells);
  for (auto& contact : contacts_) contact->append_cells(cells);
  for (auto& term : followers_) term.append_cells(cells);
  for (auto& term : springs_) term.append_cells(cells);
  for (auto& term : stretches_) term.append_cells(cells);
  for (auto& term : augmented_springs_) term.append_cells(cells);
  for (auto& term : dampings_) term.append_cells(cells);
  for (auto& term : inertias_) term.append_cells(cells);
  matrix_ = std::make_unique<SystemMatrix>(dofs_, cells);
  constant_.reset();
  ++counts_.graphs;
}

// What does not depend on positions is added once, and stays until the graph or what it depends on changes.
void StepProblem::refresh_constants() {
  ConstantPart now{
      scheme_.theta, dampings_.empty() ? 0.0 : kinematics_.damping.dq, inertias_.empty() ? 0.0 : kinematics_.inertia.dq, {}};
  for (const auto& spring : springs_) now.acting.push_back(spring.acts_at(acting_time_));
  if (constant_ == now) return;
  matrix_->clear();
  bool is_empty = true;
  Vector unused(dofs_.overlap_map());
  const auto reference = to_overlap(*reference_state());
  for (const auto& body : bodies_) {
    if (!body->has_constant_tangent()) continue;
    body->add_tangent(data(*reference), now.theta, data(unused), *matrix_);
    counts_.element_tangents += static_cast<long>(body->n_elements());
    is_empty = false;
  }
  for (const auto& spring : springs_)
    if (spring.acts_at(acting_time_)) {
      spring.add_stiffness(now.theta, *matrix_);
      is_empty = false;
    }
  if (now.damping != 0)
    for (const auto& term : dampings_) {
      term.add_tangent(now.damping, *matrix_);
      is_empty = false;
    }
  if (now.inertia != 0)
    for (const auto& term : inertias_) {
      term.add_tangent(now.inertia, *matrix_);
      is_empty = false;
    }
  if (!is_empty) matrix_->keep_as_constant();
  constant_ = now;
}

// Euclidean norm over the rows of positions, of all ranks [N].
double StepProblem::norm_of_forces(const Vector& f) const {
  const double* values = data(f);
  double squares = 0;
  for (int k = 0; k < dofs_.n_owned_positions(); ++k) squares += values[k] * values[k];
  return std::sqrt(all_reduced(*dofs_.comm(), Teuchos::REDUCE_SUM, squares));
}

// Greatest motion of a contact node between two overlap vectors [m]; the same on all ranks.
double StepProblem::greatest_motion(const Vector& from, const Vector& to) const {
  const double *a = data(from), *b = data(to);
  double greatest = 0;
  for (const auto& pair : scene_.pairs)
    for (const auto* surface : {&pair.secondary, &pair.primary})
      for (const auto& facet : surface->facets)
        for (int node : facet) {
          const int k = dofs_.local(node);
          greatest = std::max(greatest, std::hypot(b[k] - a[k], b[k + 1] - a[k + 1], b[k + 2] - a[k + 2]));
        }
  return all_reduced(*dofs_.comm(), Teuchos::REDUCE_MAX, greatest);
}

// Surfaces that did not overlap at the start of the step are apart or inside each other by no more than they have moved since.
// The lists of candidates hold as long as the reach they were made with covers that, and both surfaces' motion since the search.
void StepProblem::update_search(const Vector& x, const Vector& overlap_x) {
  if (pairs_.empty()) {
    if (!matrix_) build_graph();
    return;
  }
  double skin = 0, size = 0;
  for (const auto& pair : scene_.pairs) {
    skin = std::max(skin, 0.25 * pair.size);
    size = std::max({size, pair.size, pair.primary_size});
  }
  const bool is_start = start_x_.is_null();
  const double depth = is_start ? 0.0 : 2 * greatest_motion(*start_x_, overlap_x);
  if (matrix_ && !search_x_.is_null() && depth + 2 * greatest_motion(*search_x_, overlap_x) <= search_.reach) return;
  // At the start nobody knows yet how deep they are inside.
  search_at({Teuchos::rcp(new Vector(x, Teuchos::Copy)), 2 * skin + depth, is_start ? 5 * size : 0.0});
}

void StepProblem::search_at(const Search& where) {
  const Stopwatch watch(counts_.seconds_search);
  search_ = where;
  search_x_ = to_overlap(*where.x);
  int changed = 0;
  for (auto& pair : pairs_)
    if (pair->search(data(*search_x_), where.reach, where.inward)) changed = 1;
  if (all_reduced(*dofs_.comm(), Teuchos::REDUCE_MAX, changed) || !matrix_) build_graph();
}

Evaluation StepProblem::evaluate(const Vector& x) { return evaluate(x, false); }

Evaluation StepProblem::linearise(const Vector& x, RCP<Matrix>& tangent) {
  Evaluation out = evaluate(x, true);
  tangent = tangent_;
  return out;
}

Evaluation StepProblem::evaluate(const Vector& x, bool with_tangent) {
  Evaluation out;
  ++counts_.evaluations;
  if (with_tangent) ++counts_.tangents;
  const auto overlap_x = to_overlap(x);
  if (!std::isfinite(x.norm2())) return out;
  update_search(x, *overlap_x);

  const auto at_theta = scheme_.forces == ForceReading::mean ? overlap_x : positions_at(scheme_.theta, overlap_x);
  Vector internal(dofs_.overlap_map()), contact(dofs_.overlap_map());
  RCP<Vector> of_step;
  NodalSums sums(dofs_);
  int admissible = 1;
  {
    const Stopwatch watch(counts_.seconds_elements);
    if (with_tangent) {
      refresh_constants();
      matrix_->reset();
    }
    admissible = add_internal(*overlap_x, *at_theta, with_tangent, internal) && add_of_step(*overlap_x, with_tangent, of_step);
    admissible = all_reduced(*dofs_.comm(), Teuchos::REDUCE_MIN, admissible);
  }
  if (!admissible) return out;
  out.admissible = true;
  const double weight_at_end = contact_weight_at_end();
  const RCP<Vector> slips = scene_.has_friction() ? Teuchos::rcp(new Vector(dofs_.overlap_map())) : Teuchos::null;
  {
    const Stopwatch watch(counts_.seconds_contact);
    NodalSums between(dofs_);
    between.slip = slips;
    add_contact_between(overlap_x, with_tangent, 0, contacts_.size(), between, contact);
    Vector at_end(dofs_.overlap_map());
    if (contact_theta() == 1) sums.slip = slips;
    for (auto& term : contacts_)
      if (acts(*term)) term->integrate(data(*overlap_x), with_tangent, data(at_end), sums);
    contact.update(weight_at_end, at_end, 1.0);
  }

  add_springs(*at_theta, internal);
  out.internal = owned_sum(internal);
  if (scheme_.forces == ForceReading::mean) out.internal->update(1 - scheme_.theta, *internal_before_, scheme_.theta);
  if (!of_step.is_null()) out.internal->update(1.0, *owned_sum(*of_step), 1.0);
  out.damping = damping(*overlap_x);
  out.inertia = inertia(*overlap_x);
  out.contact = owned_sum(contact);
  out.external = external(*at_theta, with_tangent);
  out.gap = owned_sum(sums.weighted_gap);  // weighted until the law divides by the area
  out.area = owned_sum(sums.covered_area);
  out.unbalanced = Teuchos::rcp(new Vector(*out.internal, Teuchos::Copy));
  out.unbalanced->update(1.0, *out.contact, -1.0, *out.external, 1.0);
  if (!out.damping.is_null()) out.unbalanced->update(1.0, *out.damping, 1.0);
  if (!out.inertia.is_null()) out.unbalanced->update(1.0, *out.inertia, 1.0);
  out.residual = Teuchos::rcp(new Vector(*out.unbalanced, Teuchos::Copy));
  out.prescribed = acting_;

  identity_rows_.assign(dofs_.n_owned(), 0);
  for (const auto& spring : augmented_springs_)
    if (spring.is_here() && !spring.acts_at(acting_time_))
      for (int m = 0; m < 2; ++m) identity_rows_[spring.unknowns() + m] = 1;
  LawRows rows(dofs_.owned_map());
  if (!contacts_.empty()) law(x, *owned_sum(sums.whole_area), out, rows);
  std::optional<FrictionRows> friction_rows;
  if (!slips.is_null()) friction_law(x, overlap_x, *owned_sum(*slips), out, friction_rows.emplace(dofs_.owned_map()));
  if (!out.fault.empty()) {
    out.admissible = false;
    return out;
  }

  std::vector<double> greatest{0, out.gap_residual, out.pressure_residual, out.pressure_scale, 0};
  {
    double* r = data(*out.residual);
    const double* q = data(x);
    for (const auto& [dof, position] : prescribed_) {
      r[dof] = q[dof] - position;
      identity_rows_[dof] = 1;
      greatest[0] = std::max(greatest[0], std::abs(r[dof]));
    }
    double squares = 0;
    for (int k = 0; k < dofs_.n_owned_positions(); ++k)
      if (!identity_rows_[k]) squares += r[k] * r[k];
    for (const auto& spring : augmented_springs_)
      if (spring.is_here()) squares += std::pow(2 / spring.rest_length() * r[spring.unknowns()], 2);
    for (const auto& [row, scale, floor] : constraint_rows_)
      if (const double missed = std::abs(r[row]) / scale; missed > floor) greatest[4] = std::max(greatest[4], missed);
    out.force_residual = std::sqrt(all_reduced(*dofs_.comm(), Teuchos::REDUCE_SUM, squares));
  }
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, greatest);
  out.support_residual = greatest[0];
  out.gap_residual = greatest[1];
  out.pressure_residual = greatest[2];
  out.pressure_scale = greatest[3];
  out.constraint_residual = greatest[4];
  out.force_scale = std::max({norm_of_forces(*out.internal), norm_of_forces(*out.external), norm_of_forces(*out.contact),
                              out.inertia.is_null() ? 0.0 : norm_of_forces(*out.inertia)});
  out.force_floor = round_off_of_forces();

  if (with_tangent) {
    {
      const Stopwatch watch(counts_.seconds_contact);
      const auto a = to_overlap(rows.gap), b = to_overlap(rows.covered), c = to_overlap(rows.whole);
      for (auto& term : contacts_)
        if (acts(*term)) term->add_tangent(data(*a), data(*b), data(*c), weight_at_end, *matrix_);
      if (friction_rows) {
        for (auto& factor : friction_rows->factors) factor = to_overlap(*factor);
        for (auto& term : contacts_)
          if (acts(*term)) term->add_friction_tangent(*friction_rows, contact_theta(), *matrix_);
      }
    }
    const Stopwatch watch(counts_.seconds_assembly);
    if (!out.compliance.is_null()) {
      const double* s = data(*out.compliance);
      for (int k = 0; k < dofs_.n_owned(); ++k)
        if (s[k] > 0) matrix_->add_diagonal(k, s[k]);
    }
    tangent_ = matrix_->assemble();
    put_identity_rows();
  }
  return out;
}

void StepProblem::put_identity_rows() {
  const auto local = tangent_->getLocalMatrixHost();
  const auto row_map = tangent_->getRowMap(), col_map = tangent_->getColMap();
  for (int k = 0; k < dofs_.n_owned(); ++k) {
    if (!identity_rows_[k]) continue;
    const int diagonal = col_map->getLocalElement(row_map->getGlobalElement(k));
    for (auto entry = local.graph.row_map(k); entry < local.graph.row_map(k + 1); ++entry)
      local.values(entry) = local.graph.entries(entry) == diagonal ? 1.0 : 0.0;
  }
}

Vec3<double> StepProblem::force_on_secondary(const Vector& x, std::size_t k) {
  const auto force = contact_force_of(to_overlap(x), k, k + 1, true);
  const double* f = data(*force);
  std::vector<double> sum(3, 0.0);
  for (int node : contacts_[k]->nodes().secondary_nodes)
    if (dofs_.owned(node))
      for (int i = 0; i < 3; ++i) sum[i] -= f[dofs_.local(node) + i];
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, sum);
  return {sum[0], sum[1], sum[2]};
}

RCP<Vector> StepProblem::contact_force(const Vector& x, const Vector& pressures) {
  Vector mixed(x, Teuchos::Copy);
  double* to = data(mixed);
  const double* from = data(pressures);
  for (int k : overlap_pressures_)
    if (k < dofs_.n_owned()) to[k] = from[k];
  return contact_force_of(to_overlap(mixed), 0, contacts_.size(), false);
}

}  // namespace mortise
