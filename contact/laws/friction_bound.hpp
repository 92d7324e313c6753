// What bounds the tangential traction of a node: Coulomb's and Tresca's laws.
#pragma once

#include "contact/laws/coulomb.hpp"

namespace mortise {

/// A coefficient of friction at some pressure and slip speed, and its derivatives there: all that AD needs of a function it
/// cannot look into.
struct FrictionCoefficient {
  double value = 0;        ///< mu [-]
  double at_rest = 0;      ///< mu at that pressure without slip speed [-]
  double of_pressure = 0;  ///< dmu/dp [1/Pa]
  double of_speed = 0;     ///< dmu/dv [s/m]
};

/// Slip speed |s|/dt [m/s]. At rest its derivative is that against the traction, the way slip will go, or 0 without any.
/// @param dt length of the step [s]
template <class T>
T slip_speed(const FrictionState<T>& at, double dt) {
  if (value(dot(at.slip, at.slip)) > 0) return norm(at.slip) / dt;
  const Vec3<double> t{value(at.traction[0]), value(at.traction[1]), value(at.traction[2])};
  const double scale = norm(t) * dt;
  return scale > 0 ? T(-(t[0] * at.slip[0] + t[1] * at.slip[1] + t[2] * at.slip[2]) / scale) : T(0.0);
}

/// Coulomb's bound mu(p, v) p [Pa]. @param mu at this very state
template <class T>
T coulomb_bound(const FrictionState<T>& at, const FrictionCoefficient& mu, double dt) {
  const T& p = at.pressure;
  const T v = slip_speed(at, dt);
  return (mu.value + mu.of_pressure * (p - value(p)) + mu.of_speed * (v - value(v))) * p;
}

/// Tresca's bound: the same at every pressure, as long as there is contact [Pa].
inline double tresca_bound(double greatest_traction, bool is_closed) { return is_closed ? greatest_traction : 0; }

}  // namespace mortise
