#include "deck/scheme_options.hpp"

namespace mortise {
namespace {

/// v_{n+1} by the weight in dq = dt ((1 - w) v_n + w v_{n+1}).
TimeScheme of_velocity(double weight, ForceReading forces, double theta, double constraint_theta) {
  TimeScheme scheme;
  scheme.velocity_weight = weight;
  scheme.forces = forces;
  scheme.theta = theta;
  scheme.constraint_theta = constraint_theta;
  return scheme;
}

TimeScheme of_alpha(const AlphaNumbers& numbers, ForceReading forces) {
  TimeScheme scheme;
  scheme.alpha = numbers;
  scheme.forces = forces;
  scheme.theta = scheme.constraint_theta = 1 - numbers.alpha_f;
  return scheme;
}

AlphaNumbers numbers_of(const schemes::GeneralisedAlpha& o) {
  if (o.alpha_m && o.alpha_f && o.beta && o.gamma) return {*o.alpha_m, *o.alpha_f, *o.beta, *o.gamma};
  return AlphaNumbers::from_spectral_radius(o.spectral_radius.value_or(0.8));
}
AlphaNumbers numbers_of(const schemes::Newmark& o) { return {0, 0, o.beta, o.gamma}; }
AlphaNumbers numbers_of(const schemes::Hht& o) { return AlphaNumbers::second_order(0, o.alpha); }
AlphaNumbers numbers_of(const schemes::Wbz& o) { return AlphaNumbers::second_order(-o.alpha, 0); }

TimeScheme scheme(const schemes::Static&) { return {}; }
TimeScheme scheme(const schemes::ForwardEuler&) {
  TimeScheme explicit_scheme = of_velocity(1, ForceReading::at_point, 0, 0);
  explicit_scheme.is_explicit_in_position = true;
  return explicit_scheme;
}
TimeScheme scheme(const schemes::BackwardEuler&) { return of_velocity(1, ForceReading::at_point, 1, 1); }
TimeScheme scheme(const schemes::Trapezoidal&) { return of_velocity(0.5, ForceReading::mean, 0.5, 0.5); }
TimeScheme scheme(const schemes::Midpoint&) { return of_velocity(0.5, ForceReading::at_point, 0.5, 0.5); }
// p_{n+1} = p_n - dt f(q_alpha) and q_{n+1} = q_n + dt M^-1 (p_n - (1 - alpha) dt f(q_alpha)): w = 1 - alpha.
TimeScheme scheme(const schemes::VariationalMidpoint& o) { return of_velocity(1 - o.alpha, ForceReading::at_point, o.alpha, 0); }
TimeScheme scheme(const schemes::EnergyMomentum&) {
  TimeScheme keeps_energy = of_velocity(0.5, ForceReading::algorithmic, 0.5, 0.5);
  keeps_energy.has_discrete_contact = true;
  return keeps_energy;
}
TimeScheme scheme(const schemes::EnergyMomentumMidpointContact&) { return of_velocity(0.5, ForceReading::algorithmic, 0.5, 0.5); }
template <class Kind>
TimeScheme scheme(const Kind& o) {
  return of_alpha(numbers_of(o), o.reading);
}

std::string fault(const schemes::AlphaForces& o, const AlphaNumbers& n, bool has_multipliers) {
  if (o.allow_unstable) return "";
  if (!n.is_unconditionally_stable())
    return "its numbers are unstable at great steps, where alpha m <= alpha f <= 1/2 and beta >= 1/4 + (alpha f - alpha m)/2 do "
           "not hold - change them, or say \"allow unstable\" = true";
  if (has_multipliers && n.alpha_m == 0 && n.alpha_f == 0 && n.gamma == 0.5)
    return "the average acceleration with contact pressures at the end of the step is unstable: a bar that meets a wall leaves "
           "it with 3 to 23 times its energy - take \"midpoint\", \"energy momentum midpoint contact\" or \"generalised alpha\", "
           "or say \"allow unstable\" = true";
  return "";
}

template <class Kind>
std::string fault_of(const Kind& o, bool has_multipliers) {
  if constexpr (std::is_base_of_v<schemes::AlphaForces, Kind>) {
    return fault(o, numbers_of(o), has_multipliers);
  } else {
    return "";
  }
}

}  // namespace

TimeScheme scheme_of(const SchemeKind& kind) {
  return std::visit([](const auto& o) { return scheme(o); }, kind);
}

std::string instability(const SchemeKind& kind, bool has_multipliers) {
  return std::visit([&](const auto& o) { return fault_of(o, has_multipliers); }, kind);
}

}  // namespace mortise
