// Signorini's conditions of unilateral contact as one semismooth equation.
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// The branch of the law: closed if  p - c g > 0. Nodes at round-off in both stay closed, so that a body that rests without load
/// is held.
/// @param p contact pressure [Pa]  @param g gap [m]  @param c complementarity constant > 0 [Pa/m]  @param round_off pressure that
/// means nothing [Pa]
template <class T>
bool is_closed(const T& p, const T& g, double c, double round_off = 0) {
  return value(p) - c * value(g) > -round_off;
}

/// Signorini's conditions  g >= 0, p >= 0, p g = 0  as  p - max(0, p - c g) = 0  (thesis eq. 4.129).
/// The derivative of the branch *is* the primal-dual active set: no status array decides anything.
template <class T>
T complementarity(const T& p, const T& g, double c, double round_off = 0) {
  return is_closed(p, g, c, round_off) ? T(c * g) : p;
}

/// The same conditions as  g + p/c - sqrt(g^2 + (p/c)^2) = 0 (Fischer 1992): smooth but where both vanish, and there one of its
/// generalised derivatives is taken. A length.
template <class T>
T fischer_burmeister(const T& p, const T& g, double c) {
  using std::sqrt;
  const T r = p / c;
  const T squares = g * g + r * r;
  return value(squares) > 0 ? T(g + r - sqrt(squares)) : T(g + r);
}

}  // namespace mortise
