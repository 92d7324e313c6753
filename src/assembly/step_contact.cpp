// The contact side of a step's equations: the law of every secondary node, its constants, and how contact starts.
#include <fmt/format.h>

#include <Sacado.hpp>
#include <algorithm>
#include <cmath>

#include "assembly/step_problem.hpp"
#include "assembly/vectors.hpp"
#include "contact/laws/signorini.hpp"
#include "errors.hpp"

namespace mortise {
namespace {

// A node that is partly covered constrains the same motion as its neighbours, with less area to press on, and its gap changes as
// the edge of the other surface moves: the first touch of an edge would make its pressure jump, and pressing may even deepen its
// gap. So the law yields there: gap + s p = 0, s = yielding (whole area / covered area - 1)^2, which is 0 where all is covered,
// small where much is, and lets go of slivers. A millionth of both sides' h/E [m/Pa] is about the least with which the ironing
// with the coarse side as secondary needs no cut; it lowers the force there by an eighth.
double yielding(const ContactNodes& nodes) { return 1e-6 * (nodes.size / nodes.youngs_modulus + nodes.opposite_compliance); }

}  // namespace

void StepProblem::law(const Vector& x, const Vector& whole_area, Evaluation& out, LawRows& rows) {
  out.compliance = Teuchos::rcp(new Vector(dofs_.owned_map()));
  out.closing_gap = Teuchos::rcp(new Vector(dofs_.owned_map()));
  double *gap = data(*out.gap), *residual = data(*out.residual), *compliance = data(*out.compliance),
         *closing_gap = data(*out.closing_gap);
  double *d_gap = data(rows.gap), *d_covered = data(rows.covered), *d_whole = data(rows.whole);
  const double *area = data(*out.area), *pressure = data(x), *whole = data(whole_area);
  out.closed.assign(scene_.n_multipliers, 0);
  out.covered.assign(scene_.n_multipliers, 0);
  std::vector<int> partly_covered;
  for (const auto& contact : contacts_) {
    const ContactNodes& nodes = contact->nodes();
    for (std::size_t k = 0; k < nodes.secondary_nodes.size(); ++k) {
      const int point = contact->pressure_point(k);
      if (!dofs_.owned(point)) continue;
      const int at = dofs_.local(point), multiplier = nodes.first_multiplier + static_cast<int>(k);
      if (nodes.is_two_sided) {
        for (int row = at; row < at + nodes.n_unknowns; ++row)
          law_of_two_sided(row, nodes.tributary_area[k], pressure[row], out, rows);
        continue;
      }
      const bool is_covered = area[at] > 1e-10 * nodes.tributary_area[k];
      const double weighted_gap = gap[at];
      gap[at] = is_covered ? weighted_gap / area[at] : 0;
      const bool can_push = is_covered && !contact->is_held(k);
      const std::optional<double> start = can_push ? start_of_closing(nodes, k, at, pressure[at]) : std::nullopt;
      identity_rows_[at] = !start;
      if (!start) {
        residual[at] = pressure[at];
        out.pressure_residual = std::max(out.pressure_residual, std::abs(pressure[at]));
        continue;
      }
      const double mean_gap = (weighted_gap - *start) / area[at];
      closing_gap[at] = mean_gap - gap_of_pressure_before(nodes, at);
      // mean gap = weighted gap / area: where little is covered, both change quickly and their quotient does not
      d_gap[at] = 1 / area[at];
      d_covered[at] = -mean_gap / area[at];
      if (nodes.penalty > 0) compliance[at] = 1 / nodes.penalty;
      out.covered[multiplier] = 1;
      const double lacking = whole[at] / area[at] - 1 - 1e-6;  // quadrature on warped facets leaves 1e-7 where all is covered
      if (lacking > 0) {
        const double factor = yielding(nodes);
        compliance[at] += factor * lacking * lacking;
        d_covered[at] -= 2 * factor * lacking * pressure[at] * whole[at] / (area[at] * area[at]);
        d_whole[at] = 2 * factor * lacking * pressure[at] / area[at];
      }
      const double c = complementarity_constant(nodes, k, area[at]);
      const double round_off = scene_.pressure_floor, law = complementarity(pressure[at], closing_gap[at], c, round_off);
      const bool closed = is_closed(pressure[at], closing_gap[at], c, round_off);
      out.closed[multiplier] = closed;
      if (closed && lacking > 0) partly_covered.push_back(multiplier);
      if (closed) out.pressure_scale = std::max(out.pressure_scale, std::abs(pressure[at]));
      if (nodes.function == Complementarity::fischer_burmeister) {
        // Newton's method takes these rows as they are: no set to settle.
        out.covered[multiplier] = 0;
        using Fad = Sacado::Fad::SFad<double, 2>;
        const Fad p(2, 0, pressure[at]), g(2, 1, closing_gap[at] + compliance[at] * pressure[at]),
            r = fischer_burmeister(p, g, complementarity_constant(nodes, k, nodes.tributary_area[k]));
        residual[at] = r.val();
        for (double* factor : {d_gap, d_covered, d_whole}) factor[at] *= r.dx(1);
        compliance[at] = r.dx(0) + r.dx(1) * compliance[at];
        out.gap_residual = std::max(out.gap_residual, std::abs(residual[at]));
        continue;
      }
      // The law over c where closed, an equation between lengths that may yield; the pressure itself where open.
      residual[at] = closed ? law / c + compliance[at] * pressure[at] : law;
      double& greatest = closed ? out.gap_residual : out.pressure_residual;
      greatest = std::max(greatest, std::abs(residual[at]));
    }
  }
  out.n_partly_covered = all_reduced(*dofs_.comm(), Teuchos::REDUCE_SUM, static_cast<int>(partly_covered.size()));
  if (out.n_partly_covered > 0)
    out.first_partly_covered =
        all_reduced(*dofs_.comm(), Teuchos::REDUCE_MIN, partly_covered.empty() ? scene_.n_multipliers : partly_covered.front());
  std::vector<int> all(out.closed.begin(), out.closed.end());
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, all);
  for (std::size_t k = 0; k < all.size(); ++k) out.n_closed += out.closed[k] = static_cast<char>(all[k]);
}

// The gap [m] of an augmented Lagrangian at which its spring bears the pressure found before.
double StepProblem::gap_of_pressure_before(const ContactNodes& nodes, int at) const {
  const bool is_augmented = nodes.enforcement == Enforcement::augmented_lagrangian && !pressure_before_.is_null();
  return is_augmented ? std::max(0.0, data(static_cast<const Vector&>(*pressure_before_))[at]) / nodes.penalty : 0;
}

// Once more with the pressures found, if the spring of a closed node still bears more than its contact allows.
std::optional<double> StepProblem::augment(const Vector& x, const Evaluation& at) {
  const double *pressure = data(x), *before = data(*pressure_before_);
  double excess = 0;
  for (const auto& contact : contacts_) {
    const ContactNodes& nodes = contact->nodes();
    if (nodes.enforcement != Enforcement::augmented_lagrangian) continue;
    for (std::size_t k = 0; k < nodes.secondary_nodes.size(); ++k) {
      const int point = contact->pressure_point(k), row = dofs_.local(point);
      if (!dofs_.owned(point) || !at.closed[nodes.first_multiplier + k]) continue;
      const double pushed_in = std::abs(pressure[row] - std::max(0.0, before[row])) / nodes.penalty;
      excess = std::max(excess, pushed_in / nodes.largest_penetration);
    }
  }
  excess = all_reduced(*dofs_.comm(), Teuchos::REDUCE_MAX, excess);
  if (excess <= 1) return std::nullopt;
  pressure_before_ = Teuchos::rcp(new Vector(x, Teuchos::Copy));
  return excess;
}

// What is held in both directions has no gap, whatever pushes or pulls; where nothing is opposite, no force.
void StepProblem::law_of_two_sided(int row, double tributary_area, double force, Evaluation& out, LawRows& rows) {
  double *gap = data(*out.gap), *residual = data(*out.residual);
  const double area = data(static_cast<const Vector&>(*out.area))[row];
  if (!(area > 1e-10 * tributary_area)) {
    gap[row] = 0;
    identity_rows_[row] = 1;
    residual[row] = force;
    out.pressure_residual = std::max(out.pressure_residual, std::abs(force));
    return;
  }
  gap[row] /= area;
  data(*out.closing_gap)[row] = residual[row] = gap[row];
  data(rows.gap)[row] = 1 / area;
  out.gap_residual = std::max(out.gap_residual, std::abs(gap[row]));
  out.pressure_scale = std::max(out.pressure_scale, std::abs(force));
}

// The weighted gap [m^3] from which a covered node's closing counts in this step; nothing: the node is not in contact in it.
std::optional<double> StepProblem::start_of_closing(const ContactNodes& nodes, std::size_t k, int at, double pressure) const {
  if (!counts_from_start(nodes.closing) || dt_ == 0) return 0;
  const double before = data(static_cast<const Vector&>(*start_gap_))[at],
               area = data(static_cast<const Vector&>(*start_area_))[at];
  if (nodes.closing == Closing::modified) return pressure > 0 ? before : 0;
  const bool has_touched = area > 1e-10 * nodes.tributary_area[k] && before <= 1e-8 * nodes.size * area;
  return has_touched ? std::optional<double>(before) : std::nullopt;
}

void StepProblem::find_gaps_before(const Vector& x) {
  const bool is_needed = dt_ > 0 && std::any_of(contacts_.begin(), contacts_.end(),
                                                [](const auto& contact) { return counts_from_start(contact->nodes().closing); });
  if (!is_needed) return;
  update_search(x, *start_x_);
  NodalSums sums(dofs_);
  Vector unused(dofs_.overlap_map());
  for (auto& contact : contacts_)
    if (acts(*contact) && counts_from_start(contact->nodes().closing))
      contact->integrate(data(*start_x_), false, data(unused), sums);
  start_gap_ = owned_sum(sums.weighted_gap);
  start_area_ = owned_sum(sums.covered_area);
}

// c_n [Pa/m]: both bodies' normal stiffness per area in series, k_I / A_I of the secondary node and E/h of the primary body, so
// that the softer one rules. (The stiff side's own k_I / A_I would open every node of a hard indenter at the slightest residual
// gap.) The inertia of a step stiffens a node.
double StepProblem::complementarity_constant(const ContactNodes& nodes, std::size_t k, double covered_area) const {
  const std::size_t multiplier = nodes.first_multiplier + k;
  const double stiffness = normal_stiffness_[multiplier] + kinematics_.inertia.dq * normal_mass_[multiplier],
               secondary = std::max(stiffness / covered_area, nodes.youngs_modulus / nodes.size);
  return 1 / (1 / secondary + nodes.opposite_compliance);
}

// Reference positions, no pressure, springs as they are there.
RCP<Vector> StepProblem::reference_state() const {
  auto state = Teuchos::rcp(new Vector(dofs_.owned_map()));
  double* x = data(*state);
  for (int n = 0; n < dofs_.n_nodes(); ++n)
    if (dofs_.owned(n))
      for (int i = 0; i < 3; ++i) x[dofs_.local(n) + i] = scene_.mesh.mesh.coordinates[n][i];
  settle_springs(*state);
  return state;
}

// Normal stiffness k_I of each secondary node in the reference configuration; no support has been set yet.
void StepProblem::find_normal_stiffness() {
  normal_stiffness_.assign(scene_.n_multipliers, 0.0);
  normal_mass_.assign(scene_.n_multipliers, 0.0);
  Vector ones(dofs_.owned_map());
  ones.putScalar(1.0);
  const auto mass = momenta(ones);
  RCP<Matrix> K;
  const auto X = reference_state();
  linearise(*X, K);
  const auto local = K->getLocalMatrixHost();
  const auto overlap_x = to_overlap(*X);
  for (const auto& contact : contacts_) {
    const auto normals = contact->normals(data(*overlap_x));
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const int node = contact->nodes().secondary_nodes[k];
      if (!dofs_.owned(node)) continue;
      double stiffness = 0;
      for (int i = 0; i < 3; ++i) {
        const int row = dofs_.local(node) + i;
        for (auto entry = local.graph.row_map(row); entry < local.graph.row_map(row + 1); ++entry) {
          const GlobalIndex j = K->getColMap()->getGlobalElement(local.graph.entries(entry)) - 3LL * node;
          if (j >= 0 && j < 3) stiffness += normals[k][i] * local.values(entry) * normals[k][j];
        }
      }
      normal_stiffness_[contact->nodes().first_multiplier + k] = stiffness;
      normal_mass_[contact->nodes().first_multiplier + k] = data(*mass)[dofs_.local(node)];
    }
  }
}

State StepProblem::initial_state() {
  State state{0, reference_state(), search_, Teuchos::null, Teuchos::null};
  place_bodies(*state.x);
  if (stage().scheme.has_inertia()) {
    state.v = initial_velocities(*state.x);
    state.a = Teuchos::rcp(new Vector(dofs_.owned_map()));
  }
  settle_springs(*state.x);
  if (contacts_.empty()) return state;

  const Evaluation at_rest = evaluate(*state.x);
  double* x = data(*state.x);
  const double *gap = data(*at_rest.gap), *area = data(*at_rest.area);
  std::vector<int> deep(scene_.n_multipliers, 0);
  std::vector<double> depth(scene_.n_multipliers, 0.0);
  for (const auto& contact : contacts_) {
    const ContactNodes& p = contact->nodes();
    if (p.is_two_sided) continue;
    for (std::size_t k = 0; k < p.secondary_nodes.size(); ++k) {
      const int point = contact->pressure_point(k), at = dofs_.local(point),
                multiplier = p.first_multiplier + static_cast<int>(k);
      if (!dofs_.owned(point) || !(area[at] > 1e-10 * p.tributary_area[k])) continue;
      const double touch = 1e-8 * p.size, carried = scene_.carried ? scene_.carried->pressure[p.secondary_nodes[k]] : 0;
      if (carried > 0) {
        x[at] = carried;
      } else if (gap[at] < -touch) {
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
  for (const ContactNodes* contact : scene_.contacts()) {
    int n_deep = 0, deepest = -1;
    for (int k = 0; k < static_cast<int>(contact->secondary_nodes.size()); ++k) {
      if (!deep[contact->first_multiplier + k]) continue;
      ++n_deep;
      if (deepest < 0 || depth[contact->first_multiplier + k] > (1 + 1e-9) * depth[contact->first_multiplier + deepest])
        deepest = k;
    }
    if (n_deep > 0)
      messages.push_back(
          fmt::format("{}{} secondary nodes penetrate at the start, {} by {:.3g} h (h = {:.3g}) - move the mesh apart",
                      contact->where_penetrating, n_deep, describe_node(scene_.mesh, contact->secondary_nodes[deepest]),
                      depth[contact->first_multiplier + deepest] / contact->size, contact->size));
  }
  if (!messages.empty()) throw MeshError(messages);
  return state;
}

}  // namespace mortise
