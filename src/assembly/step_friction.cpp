// The friction side of a step's equations: the law of every node that carries a traction, and what friction did in the step.
#include <Sacado.hpp>
#include <cmath>

#include "assembly/step_problem.hpp"
#include "assembly/vectors.hpp"
#include "contact/laws/friction_bound.hpp"
#include "contact/laws/regularised.hpp"

namespace mortise {
namespace {

using Fad = Sacado::Fad::SFad<double, 10>;  // slip, traction, normal, pressure

FrictionState<Fad> seeded(const Vec3<double>& slip, const Vec3<double>& traction, const Vec3<double>& normal, double pressure) {
  FrictionState<Fad> at;
  for (int i = 0; i < 3; ++i) {
    at.slip[i] = Fad(10, i, slip[i]);
    at.traction[i] = Fad(10, 3 + i, traction[i]);
    at.normal[i] = Fad(10, 6 + i, normal[i]);
  }
  at.pressure = Fad(10, 9, pressure);
  return at;
}

/// The bound, and what it is at rest [Pa].
std::pair<Fad, double> bound_of(const friction::Coulomb& law, const FrictionState<Fad>& at, bool, double t, double dt,
                                double size, std::string& fault) {
  const double speed = slip_speed(at, dt).val(), no_speed = 1e-4 * size / dt;
  const FrictionCoefficient mu = coefficient_at(law, t, at.pressure.val(), speed, no_speed, fault);
  return {coulomb_bound(at, mu, dt), mu.at_rest * at.pressure.val()};
}

std::pair<Fad, double> bound_of(const friction::Tresca& law, const FrictionState<Fad>&, bool is_closed, double t, double, double,
                                std::string& fault) {
  const double bound = tresca_bound(bound_at(law, t, fault), is_closed);
  return {bound, bound};
}

}  // namespace

// Where the forces of contact act in a step: the position between its start and its end.
double StepProblem::contact_theta() const { return contact_passes().back().theta; }

void StepProblem::friction_law(const Vector& x, const RCP<Vector>& overlap_x, const Vector& slips, Evaluation& out,
                               FrictionRows& rows) {
  const auto where = positions_at(contact_theta(), overlap_x);
  const Vector& start = start_x_.is_null() ? *overlap_x : *start_x_;
  const double *unknowns = data(x), *slip_sums = data(slips), *before = data(start);
  double* residual = data(*out.residual);
  std::vector<double*> factor;
  for (const auto& f : rows.factors) factor.push_back(data(*f));
  out.friction.assign(scene_.n_multipliers, FrictionStatus::none);
  std::string fault;
  std::vector<double> works{0, 0};  // of friction, and stored in stick
  for (const auto& term : pairs_) {
    const ContactPair& pair = term->pair();
    if (!pair.friction) continue;
    const Friction& friction = *pair.friction;
    const auto normals = term->normals(data(static_cast<const Vector&>(*where)));
    std::vector<Vec3<double>> normals_before;  // of use to a stick that is a spring
    if (friction.penalty) normals_before = term->normals(before);
    const double part = friction.theta_of(scheme_);
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k) {
      const int point = term->pressure_point(k);
      if (!dofs_.owned(point)) continue;
      const int at = dofs_.local(point), multiplier = pair.first_multiplier + static_cast<int>(k);
      const Vec3<double> traction{unknowns[at + 1], unknowns[at + 2], unknowns[at + 3]},
          traction_before{before[at + 1], before[at + 2], before[at + 3]};
      const double area = slip_sums[at];
      const bool is_covered = out.covered[multiplier] && area > 1e-10 * pair.tributary_area[k];
      if (!is_covered || dt_ == 0) {
        for (int i = 0; i < 3; ++i) {
          identity_rows_[at + 1 + i] = 1;
          residual[at + 1 + i] = dt_ == 0 ? 0 : traction[i];
          out.pressure_residual = std::max(out.pressure_residual, std::abs(residual[at + 1 + i]));
        }
        continue;
      }
      Vec3<double> slip;
      for (int i = 0; i < 3; ++i) slip[i] = slip_sums[at + 1 + i] / area;
      const auto state = seeded(slip, traction, normals[k], unknowns[at]);
      FrictionStatus status = FrictionStatus::none;
      const auto [bound, at_rest] =
          std::visit([&](const auto& of) { return bound_of(of, state, out.closed[multiplier], time_, dt_, pair.size, fault); },
                     friction.law);
      const Vec3<Fad> law =
          friction.regularisation ? regularised_slip(state, bound, *friction.regularisation * dt_, status)
          : friction.penalty
              ? penalised_stick(state, bound, traction_before, normals_before[k], *friction.penalty, status)
              : exact_stick(state, bound, complementarity_constant(pair, k, pair.tributary_area[k]), status, at_rest);
      if (out.closed[multiplier]) out.friction[multiplier] = status;
      const bool is_length = status == FrictionStatus::stick && !friction.penalty;
      for (int i = 0; i < 3; ++i) {
        const int row = at + 1 + i;
        residual[row] = law[i].val();
        if (is_length && term->is_held(k, i)) {
          identity_rows_[row] = 1;
          residual[row] = traction[i];
          out.pressure_residual = std::max(out.pressure_residual, std::abs(traction[i]));
          continue;
        }
        double& greatest = is_length ? out.gap_residual : out.pressure_residual;
        greatest = std::max(greatest, std::abs(residual[row]));
        for (int j = 0; j < 3; ++j) {
          factor[FrictionRows::slip + j][row] = law[i].dx(j) / area;
          factor[FrictionRows::area][row] -= law[i].dx(j) * slip[j] / area;
          factor[FrictionRows::traction + j][row] = law[i].dx(3 + j);
          factor[FrictionRows::normal + j][row] = law[i].dx(6 + j);
        }
        factor[FrictionRows::pressure][row] = law[i].dx(9);
        works[0] += ((1 - part) * traction_before[i] + part * traction[i]) * slip_sums[row];
      }
      if (friction.penalty) works[1] += 0.5 * area * dot(traction, traction) / *friction.penalty;
    }
  }
  out.fault = agreed(*dofs_.comm(), fault);
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_SUM, works);
  out.friction_work = works[0];
  out.stick_energy = works[1];
  std::vector<int> all;
  for (FrictionStatus status : out.friction) all.push_back(static_cast<int>(status));
  all_reduce(*dofs_.comm(), Teuchos::REDUCE_MAX, all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    out.friction[k] = static_cast<FrictionStatus>(all[k]);
    out.n_stick += out.friction[k] == FrictionStatus::stick;
    out.n_slip += out.friction[k] == FrictionStatus::slip;
  }
}

}  // namespace mortise
