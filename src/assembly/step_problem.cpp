#include "assembly/step_problem.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_Time.hpp>
#include <cmath>

#include "contact/laws/signorini.hpp"
#include "errors.hpp"

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

double* data(Vector& v) { return v.getDataNonConst().getRawPtr(); }
const double* data(const Vector& v) { return v.getData().getRawPtr(); }

template <class T>
void all_reduce(const Comm& comm, Teuchos::EReductionType type, std::vector<T>& values) {
  std::vector<T> local = values;
  if (!local.empty()) Teuchos::reduceAll(comm, type, static_cast<int>(local.size()), local.data(), values.data());
}

double evaluate_at(const Formula& formula, double t, const Point& X, const std::string& where) {
  const double v = formula(t, X);
  if (!std::isfinite(v))
    throw DeckError(
        fmt::format("{}gives {} at t = {}, x = {}, y = {}, z = {} - must be a finite number", where, v, t, X[0], X[1], X[2]));
  return v;
}

}  // namespace

/// Factors of the derivatives that make up a pressure's row, on the owned map.
struct StepProblem::LawRows {
  explicit LawRows(const RCP<const Map>& map) : gap(map), covered(map), whole(map) {}
  Vector gap, covered, whole;
};

StepProblem::StepProblem(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm)
    : scene_(scene), dofs_(scene, partition, comm) {
  for (const auto& body : scene.bodies) bodies_.push_back(std::make_unique<BodyTerm>(scene, body, partition, dofs_));
  for (const auto& pair : scene.pairs) pairs_.push_back(std::make_unique<MortarTerm>(scene, pair, partition, dofs_));
  external_ = Teuchos::rcp(new Vector(dofs_.owned_map()));
  identity_rows_.assign(dofs_.n_owned(), 0);
}

RCP<Vector> StepProblem::to_overlap(const Vector& owned) const {
  auto overlap = Teuchos::rcp(new Vector(dofs_.overlap_map()));
  overlap->doImport(owned, *dofs_.importer(), Tpetra::INSERT);
  return overlap;
}

std::vector<double> StepProblem::gather(const Vector& owned) const {
  std::vector<double> all(3 * static_cast<std::size_t>(dofs_.n_nodes()) + scene_.n_multipliers, 0.0);
  const auto values = owned.getData();
  for (int k = 0; k < dofs_.n_owned(); ++k) all[dofs_.owned_map()->getGlobalElement(k)] = values[k];
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, all);
  return all;
}

void StepProblem::begin_step(const State& from, double t) {
  time_ = t;
  start_x_ = to_overlap(*from.x);
  const auto& X = scene_.mesh.mesh.coordinates;
  prescribed_.clear();
  for (const auto& p : scene_.prescribed) {
    // Evaluated on every rank, so that a bad value ends all of them alike.
    const auto& support = scene_.supports[p.support];
    const double u = evaluate_at(*support.displacement[p.axis], t, X[p.node], support.where[p.axis]);
    if (dofs_.owned(p.node)) prescribed_.emplace_back(dofs_.local(p.node) + p.axis, X[p.node][p.axis] + u);
  }
  external_->putScalar(0.0);
  double* f = data(*external_);
  for (const auto& traction : scene_.tractions)
    for (const auto& [node, weight] : traction.weights)
      for (int i = 0; i < 3; ++i) {
        if (!traction.traction[i]) continue;
        const double t_i = evaluate_at(*traction.traction[i], t, X[node], traction.where[i]);
        if (dofs_.owned(node)) f[dofs_.local(node) + i] += weight * t_i;
      }
}

void StepProblem::build_graph() {
  const Stopwatch watch(counts_.seconds_assembly);
  std::vector<Cell> cells;
  for (auto& body : bodies_) body->append_cells(cells);
  for (auto& pair : pairs_) pair->append_cells(cells);
  matrix_ = std::make_unique<SystemMatrix>(dofs_, cells);
  ++counts_.graphs;
}

// Greatest motion of a contact node between two overlap vectors [m]; the same on all ranks.
double StepProblem::greatest_motion(const Vector& from, const Vector& to) const {
  const double *a = data(from), *b = data(to);
  std::vector<double> greatest{0.0};
  for (const auto& pair : scene_.pairs)
    for (const auto* surface : {&pair.secondary, &pair.primary})
      for (const auto& facet : surface->facets)
        for (int node : facet) {
          const int k = dofs_.local(node);
          greatest[0] = std::max(greatest[0], std::hypot(b[k] - a[k], b[k + 1] - a[k + 1], b[k + 2] - a[k + 2]));
        }
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, greatest);
  return greatest[0];
}

// Surfaces that did not overlap at the start of the step are apart or inside each other by no more than they have moved since.
// The lists of candidates hold as long as the reach they were made with covers that, and both surfaces' motion since the search.
void StepProblem::update_search(const Vector& overlap_x) {
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
  if (matrix_ && !search_x_.is_null() && depth + 2 * greatest_motion(*search_x_, overlap_x) <= reach_) return;
  const Stopwatch watch(counts_.seconds_search);
  reach_ = 2 * skin + depth;
  std::vector<int> changed{0};
  for (auto& pair : pairs_)
    if (pair->search(data(overlap_x), reach_, is_start ? 5 * size : 0.0))
      changed[0] = 1;  // nobody knows yet how deep they are inside
  search_x_ = Teuchos::rcp(new Vector(overlap_x, Teuchos::Copy));
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, changed);
  if (changed[0] || !matrix_) build_graph();
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
  std::vector<int> finite{std::isfinite(x.norm2()) ? 1 : 0};
  if (!finite[0]) return out;
  update_search(*overlap_x);
  if (with_tangent) matrix_->zero();

  Vector internal(dofs_.overlap_map()), contact(dofs_.overlap_map());
  NodalSums sums(dofs_);
  std::vector<int> admissible{1};
  {
    const Stopwatch watch(counts_.seconds_elements);
    for (auto& body : bodies_) {
      const bool good = with_tangent ? body->add_tangent(data(*overlap_x), data(internal), *matrix_)
                                     : body->add_force(data(*overlap_x), data(internal));
      if (!good) admissible[0] = 0;
      if (with_tangent) counts_.element_tangents += static_cast<long>(body->n_elements());
    }
    all_reduce(*dofs_.comm(), Teuchos::REDUCE_MIN, admissible);
  }
  if (!admissible[0]) return out;
  out.admissible = true;
  {
    const Stopwatch watch(counts_.seconds_contact);
    for (auto& pair : pairs_) pair->integrate(data(*overlap_x), with_tangent, data(contact), sums);
  }

  const auto owned_sum = [&](const Vector& shares) {
    auto sum = Teuchos::rcp(new Vector(dofs_.owned_map()));
    sum->doExport(shares, *dofs_.importer(), Tpetra::ADD);
    return sum;
  };
  out.internal = owned_sum(internal);
  out.contact = owned_sum(contact);
  out.external = external_;
  out.gap = owned_sum(sums.weighted_gap);  // weighted until the law divides by the area
  out.area = owned_sum(sums.covered_area);
  out.residual = Teuchos::rcp(new Vector(*out.internal, Teuchos::Copy));
  out.residual->update(1.0, *out.contact, -1.0, *external_, 1.0);

  identity_rows_.assign(dofs_.n_owned(), 0);
  LawRows rows(dofs_.owned_map());
  if (!pairs_.empty()) law(x, *owned_sum(sums.whole_area), out, rows);

  std::vector<double> greatest{0, out.gap_residual, out.pressure_residual, out.pressure_scale};
  {
    double* r = data(*out.residual);
    const double* q = data(x);
    for (const auto& [dof, position] : prescribed_) {
      r[dof] = q[dof] - position;
      identity_rows_[dof] = 1;
      greatest[0] = std::max(greatest[0], std::abs(r[dof]));
    }
    std::vector<double> squares{0};
    for (int point : dofs_.overlap_points()) {
      if (!dofs_.owned(point) || dofs_.size(point) != 3) continue;
      for (int i = 0; i < 3; ++i) {
        const int k = dofs_.local(point) + i;
        if (!identity_rows_[k]) squares[0] += r[k] * r[k];
      }
    }
    all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, squares);
    out.force_residual = std::sqrt(squares[0]);
  }
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, greatest);
  out.support_residual = greatest[0];
  out.gap_residual = greatest[1];
  out.pressure_residual = greatest[2];
  out.pressure_scale = greatest[3];
  out.force_scale = std::max({out.internal->norm2(), out.external->norm2(), out.contact->norm2()});

  if (with_tangent) {
    {
      const Stopwatch watch(counts_.seconds_contact);
      const auto a = to_overlap(rows.gap), b = to_overlap(rows.covered), c = to_overlap(rows.whole);
      for (auto& pair : pairs_) pair->add_tangent(data(*a), data(*b), data(*c), *matrix_);
    }
    const Stopwatch watch(counts_.seconds_assembly);
    if (!out.compliance.is_null()) {
      const double* s = data(*out.compliance);
      for (int k = 0; k < dofs_.n_owned(); ++k)
        if (s[k] > 0) matrix_->add_diagonal(k, s[k]);
    }
    tangent_ = matrix_->assemble();
    const auto local = tangent_->getLocalMatrixHost();
    const auto row_map = tangent_->getRowMap(), col_map = tangent_->getColMap();
    for (int k = 0; k < dofs_.n_owned(); ++k) {
      if (!identity_rows_[k]) continue;
      const int diagonal = col_map->getLocalElement(row_map->getGlobalElement(k));
      for (auto entry = local.graph.row_map(k); entry < local.graph.row_map(k + 1); ++entry)
        local.values(entry) = local.graph.entries(entry) == diagonal ? 1.0 : 0.0;
    }
  }
  return out;
}

// A node that is partly covered constrains the same motion as its neighbours, with less area to press on, and its gap changes as
// the edge of the other surface moves: the first touch of an edge would make its pressure jump, and pressing may even deepen its
// gap. So the law yields there: gap + s p = 0 with s growing as the cover shrinks, and s = 0 where the node is fully covered. A
// tenth of both sides' h/E [m/Pa] is the least that keeps the ironing with the coarse side as secondary solvable in every step.
double yielding_rate(const ContactPair& pair) {
  return 0.1 * (pair.size / pair.youngs_modulus + pair.primary_size / pair.primary_youngs_modulus);
}

void StepProblem::law(const Vector& x, const Vector& whole_area, Evaluation& out, LawRows& rows) {
  out.compliance = Teuchos::rcp(new Vector(dofs_.owned_map()));
  double *gap = data(*out.gap), *residual = data(*out.residual), *compliance = data(*out.compliance);
  double *d_gap = data(rows.gap), *d_covered = data(rows.covered), *d_whole = data(rows.whole);
  const double *area = data(*out.area), *pressure = data(x), *whole = data(whole_area);
  out.closed.assign(scene_.n_multipliers, 0);
  out.covered.assign(scene_.n_multipliers, 0);
  for (const auto& pair : pairs_) {
    const ContactPair& p = pair->pair();
    for (std::size_t k = 0; k < p.secondary_nodes.size(); ++k) {
      const int point = pair->pressure_point(k);
      if (!dofs_.owned(point)) continue;
      const int at = dofs_.local(point), multiplier = p.first_multiplier + static_cast<int>(k);
      const bool covered = area[at] > 1e-10 * p.tributary_area[k];
      out.covered[multiplier] = covered;
      identity_rows_[at] = !covered;
      if (!covered) {
        gap[at] = 0;
        residual[at] = pressure[at];
        out.pressure_residual = std::max(out.pressure_residual, std::abs(pressure[at]));
        continue;
      }
      gap[at] /= area[at];
      // mean gap = weighted gap / area: where little is covered, both change quickly and their quotient does not
      d_gap[at] = 1 / area[at];
      d_covered[at] = -gap[at] / area[at];
      const double lacking = whole[at] / area[at] - 1 - 1e-6;  // quadrature on warped facets leaves 1e-7 where all is covered
      if (lacking > 0) {
        const double rate = yielding_rate(p);
        compliance[at] = rate * lacking;
        d_covered[at] -= rate * pressure[at] * whole[at] / (area[at] * area[at]);
        d_whole[at] = rate * pressure[at] / area[at];
      }
      const double c = complementarity_constant(p, k, area[at]);
      const bool closed = is_closed(pressure[at], gap[at], c, scene_.pressure_floor());
      out.closed[multiplier] = closed;
      // The law over c where closed, an equation between lengths that may yield; the pressure itself where open.
      residual[at] =
          closed ? gap[at] + compliance[at] * pressure[at] : complementarity(pressure[at], gap[at], c, scene_.pressure_floor());
      double& greatest = closed ? out.gap_residual : out.pressure_residual;
      greatest = std::max(greatest, std::abs(residual[at]));
      if (closed) out.pressure_scale = std::max(out.pressure_scale, std::abs(pressure[at]));
    }
  }
  std::vector<int> all(out.closed.begin(), out.closed.end());
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, all);
  for (std::size_t k = 0; k < all.size(); ++k) out.n_closed += out.closed[k] = static_cast<char>(all[k]);
}

// c_n [Pa/m]: both bodies' normal stiffness per area in series, k_I / A_I of the secondary node and E/h of the primary body, so
// that the softer one rules. (The stiff side's own k_I / A_I would open every node of a hard indenter at the slightest residual
// gap.)
double StepProblem::complementarity_constant(const ContactPair& pair, std::size_t k, double covered_area) const {
  const double secondary = std::max(normal_stiffness_[pair.first_multiplier + k] / covered_area, pair.youngs_modulus / pair.size);
  return 1 / (1 / secondary + pair.primary_size / pair.primary_youngs_modulus);
}

// Normal stiffness k_I of each secondary node in the reference configuration.
void StepProblem::find_normal_stiffness() {
  normal_stiffness_.assign(scene_.n_multipliers, 0.0);
  Vector X(dofs_.owned_map());
  RCP<Matrix> K;
  double* q = data(X);
  for (int n = 0; n < dofs_.n_nodes(); ++n)
    if (dofs_.owned(n))
      for (int i = 0; i < 3; ++i) q[dofs_.local(n) + i] = scene_.mesh.mesh.coordinates[n][i];
  const auto saved = std::move(prescribed_);
  prescribed_.clear();
  linearise(X, K);
  prescribed_ = saved;
  const auto local = K->getLocalMatrixHost();
  const auto overlap_x = to_overlap(X);
  for (const auto& pair : pairs_) {
    const auto normals = pair->normals(data(*overlap_x));
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const int node = pair->pair().secondary_nodes[k];
      if (!dofs_.owned(node)) continue;
      double stiffness = 0;
      for (int i = 0; i < 3; ++i) {
        const int row = dofs_.local(node) + i;
        for (auto entry = local.graph.row_map(row); entry < local.graph.row_map(row + 1); ++entry) {
          const GlobalIndex j = K->getColMap()->getGlobalElement(local.graph.entries(entry)) - 3LL * node;
          if (j >= 0 && j < 3) stiffness += normals[k][i] * local.values(entry) * normals[k][j];
        }
      }
      normal_stiffness_[pair->pair().first_multiplier + k] = stiffness;
    }
  }
}

State StepProblem::initial_state() {
  State state;
  state.x = Teuchos::rcp(new Vector(dofs_.owned_map()));
  double* x = data(*state.x);
  for (int n = 0; n < dofs_.n_nodes(); ++n)
    if (dofs_.owned(n))
      for (int i = 0; i < 3; ++i) x[dofs_.local(n) + i] = scene_.mesh.mesh.coordinates[n][i];
  if (pairs_.empty()) return state;

  find_normal_stiffness();
  const Evaluation at_rest = evaluate(*state.x);
  const double *gap = data(*at_rest.gap), *area = data(*at_rest.area);
  std::vector<int> deep(scene_.n_multipliers, 0);
  std::vector<double> depth(scene_.n_multipliers, 0.0);
  for (const auto& pair : pairs_) {
    const ContactPair& p = pair->pair();
    for (std::size_t k = 0; k < p.secondary_nodes.size(); ++k) {
      const int point = pair->pressure_point(k), at = dofs_.local(point), multiplier = p.first_multiplier + static_cast<int>(k);
      if (!dofs_.owned(point) || !(area[at] > 1e-10 * p.tributary_area[k])) continue;
      const double touch = 1e-8 * p.size;
      if (gap[at] < -touch) {
        deep[multiplier] = 1;
        depth[multiplier] = -gap[at];
      } else if (gap[at] <= touch) {
        x[at] = 2 * touch * complementarity_constant(p, k, area[at]);
      }
    }
  }
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, deep);
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, depth);
  std::vector<std::string> messages;
  for (const auto& pair : scene_.pairs)
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k)
      if (deep[pair.first_multiplier + k])
        messages.push_back(fmt::format("{}{} penetrates by {:.3g} h at the start (h = {:.3g}) - move the mesh apart",
                                       pair.where_penetrating, describe_node(scene_.mesh, pair.secondary_nodes[k]),
                                       depth[pair.first_multiplier + k] / pair.size, pair.size));
  if (!messages.empty()) throw MeshError(messages);
  return state;
}

Vec3<double> StepProblem::force_on_secondary(const Vector& x, std::size_t k) {
  const auto overlap_x = to_overlap(x);
  Vector shares(dofs_.overlap_map());
  NodalSums sums(dofs_);
  pairs_[k]->integrate(data(*overlap_x), false, data(shares), sums);
  Vector force(dofs_.owned_map());
  force.doExport(shares, *dofs_.importer(), Tpetra::ADD);
  const double* f = data(force);
  std::vector<double> sum(3, 0.0);
  for (int node : scene_.pairs[k].secondary_nodes)
    if (dofs_.owned(node))
      for (int i = 0; i < 3; ++i) sum[i] -= f[dofs_.local(node) + i];
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, sum);
  return {sum[0], sum[1], sum[2]};
}

RCP<Vector> StepProblem::contact_force(const Vector& x, const Vector& pressures) {
  Vector mixed(x, Teuchos::Copy);
  double* to = data(mixed);
  const double* from = data(pressures);
  for (int point : dofs_.overlap_points())
    if (dofs_.owned(point) && dofs_.size(point) == 1) to[dofs_.local(point)] = from[dofs_.local(point)];
  const auto overlap_x = to_overlap(mixed);
  Vector contact(dofs_.overlap_map());
  NodalSums sums(dofs_);
  for (auto& pair : pairs_) pair->integrate(data(*overlap_x), false, data(contact), sums);
  auto sum = Teuchos::rcp(new Vector(dofs_.owned_map()));
  sum->doExport(contact, *dofs_.importer(), Tpetra::ADD);
  return sum;
}

}  // namespace mortise
