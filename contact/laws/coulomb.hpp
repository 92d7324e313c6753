// Coulomb's law of friction at a node as one semismooth equation for its tangential traction.
#pragma once

#include <algorithm>
#include <limits>

#include "physics/tensor.hpp"

namespace mortise {

/// What a node's friction follows from in a step.
template <class T>
struct FrictionState {
  Vec3<T> slip;      ///< of the secondary surface relative to the primary one in the step [m], tangential
  Vec3<T> traction;  ///< unknown: tangential traction on the secondary surface at the end of the step [Pa]
  Vec3<T> normal;    ///< unit, out of the secondary surface
  T pressure;        ///< [Pa]
};

enum class FrictionStatus : char { none, slip, stick };

/// Direction `t` that was tangential to `n_old`, turned with the normal by the smallest rotation that takes `n_old` to `n`.
template <class T>
Vec3<T> turned_with(const Vec3<double>& n_old, const Vec3<T>& n, const Vec3<double>& t) {
  const T along = T(n[0] * t[0] + n[1] * t[1] + n[2] * t[2]), cosine = T(n[0] * n_old[0] + n[1] * n_old[1] + n[2] * n_old[2]);
  const T factor = along / (1.0 + cosine);
  return {T(t[0] - factor * (n_old[0] + n[0])), T(t[1] - factor * (n_old[1] + n[1])), T(t[2] - factor * (n_old[2] + n[2]))};
}

/// Whether a trial traction sticks. A node that slipped in the step before begins the next one at the bound, to round-off: it
/// goes on slipping, lest the first Newton iteration holds it by chance.
template <class T>
bool is_below(const Vec3<T>& trial, double bound) {
  constexpr double at_the_bound = 1e-8;
  const double limit = (1 - at_the_bound) * bound;
  return limit > 0 && value(dot(trial, trial)) <= limit * limit;
}

/// The traction t returned to the bound in the direction of a trial: slip, t = mu p trial/|trial|. Without pressure the
/// derivative knows already which way the traction would go, so that a node that closes does so with its friction.
template <class T>
Vec3<T> slipping(const FrictionState<T>& at, const T& bound, const Vec3<T>& trial) {
  if (!(value(dot(trial, trial)) > 0)) return at.traction;
  return at.traction - T(bound / norm(trial)) * trial;
}

/// Stick while |t - c s| stays below the bound mu p, then s = 0; slip else, then t = mu p (t - c s)/|t - c s|: exact stick, with
/// any c > 0 (Hueber, Stadler & Wohlmuth 2008). The traction's part along the normal vanishes on both branches.
/// @param bound greatest traction mu p [Pa]  @param c complementarity constant [Pa/m]  @param status set to the branch
/// @param at_rest the bound without slip speed [Pa]: what holds is not held by a bound that only its motion would raise
/// @return zero at the solution: [m] for stick, [Pa] else
template <class T>
Vec3<T> exact_stick(const FrictionState<T>& at, const T& bound, double c, FrictionStatus& status,
                    double at_rest = std::numeric_limits<double>::infinity()) {
  const T along = dot(at.normal, at.traction);
  const Vec3<T> trial = at.traction - along * at.normal - T(c) * at.slip;
  const bool sticks = is_below(trial, std::min(value(bound), at_rest));
  status = sticks ? FrictionStatus::stick : FrictionStatus::slip;
  return sticks ? at.slip + T(along / c) * at.normal : slipping(at, bound, trial);
}

/// Stick as a spring: the trial traction t_n - eps s, turned with the normal, is returned to the bound (thesis eqs. 5.123, 5.126,
/// 5.127).
/// @param before traction at the start of the step [Pa]  @param penalty eps [Pa/m]
/// @return zero at the solution [Pa]
template <class T>
Vec3<T> penalised_stick(const FrictionState<T>& at, const T& bound, const Vec3<double>& before, const Vec3<double>& normal_before,
                        double penalty, FrictionStatus& status) {
  const Vec3<T> trial = turned_with(normal_before, at.normal, before) - T(penalty) * at.slip;
  const bool sticks = is_below(trial, value(bound));
  status = sticks ? FrictionStatus::stick : FrictionStatus::slip;
  return sticks ? at.traction - trial : slipping(at, bound, trial);
}

}  // namespace mortise
