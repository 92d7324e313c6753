// Friction without stick: a smooth function of the slip velocity, for comparison.
#pragma once

#include "contact/laws/coulomb.hpp"

namespace mortise {

/// t + bound s / sqrt(s.s + s0^2): friction that is never more than the bound, and that gives way at any load (Oden & Martins
/// 1985 discuss such laws). A body on an incline of angle a creeps by v = v0 tan a / sqrt(mu^2 - tan^2 a).
/// @param bound greatest traction [Pa]  @param scale s0 = v0 dt, slip in the step at which the traction is bound / sqrt(2) [m]
/// @return zero at the solution [Pa]
template <class T>
Vec3<T> regularised_slip(const FrictionState<T>& at, const T& bound, double scale, FrictionStatus& status) {
  using std::sqrt;
  status = FrictionStatus::slip;
  return at.traction + T(bound / sqrt(T(dot(at.slip, at.slip) + scale * scale))) * at.slip;
}

}  // namespace mortise
