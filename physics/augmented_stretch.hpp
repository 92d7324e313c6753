// A spring whose squared stretch is an unknown of its own: the redundant formulation (coordinate augmentation).
#pragma once

#include "physics/stretch_laws.hpp"
#include "physics/time_scheme.hpp"

namespace mortise {

/// The residual of a line in a step (thesis eqs. 6.39, 6.40), dual to its tangent t, its squared stretch v and the multiplier.
template <class T>
struct AugmentedStretch {
  Vec3<T> force;  ///< -2 lambda t* [J]
  T balance;      ///< grad_v V + lambda [J]
  T constraint;   ///< Phi = v - t . t at the end of the step [-]
};

/// V(v) = E w(v) with v tied to the positions by the multiplier lambda, constant in the step:  V + lambda Phi  (thesis eqs.
/// 6.37, 6.38). grad_v V is taken as the scheme reads forces: w'(v_theta), the mean of both ends, or the discrete gradient
/// (6.42). t* is at theta of the forces, not where Jacobians of contact stand: the multiplier is an elastic force, and angular
/// momentum needs that along t_theta. At the start Phi holds, so v_n is that of `t_n`.
/// @param energy E [J]  @param t_n, t tangents at the start and at the end  @param v squared stretch at the end [-]
/// @param lambda [J]
/// Precondition: v > 0 and t_n not zero, unless the law is Saint Venant's.
template <class Law, class T>
AugmentedStretch<T> augmented_stretch(const TimeScheme& scheme, double energy, const Vec3<T>& t_n, const Vec3<T>& t, const T& v,
                                      const T& lambda) {
  const double theta = scheme.theta;
  const T v_n = dot(t_n, t_n), none = 0.0;
  T slope = none;
  switch (scheme.forces) {
    case ForceReading::algorithmic:
      slope = Law::slope(v_n, T(v - v_n));
      break;
    case ForceReading::mean:
      slope = (1 - theta) * Law::slope(v_n, none) + theta * Law::slope(v, none);
      break;
    case ForceReading::at_point:
      slope = Law::slope(T((1 - theta) * v_n + theta * v), none);
      break;
  }
  const Vec3<T> t_star = T(1 - theta) * t_n + T(theta) * t;
  return {T(-2.0 * lambda) * t_star, energy * slope + lambda, v - dot(t, t)};
}

}  // namespace mortise
