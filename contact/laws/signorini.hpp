// Signorini's conditions of unilateral contact as one semismooth equation.
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// Signorini's conditions  g >= 0, p >= 0, p g = 0  as  p - max(0, p - c g) = 0  (thesis eq. 4.129).
/// The derivative of the branch *is* the primal-dual active set: no status array decides anything.
/// @param p contact pressure [Pa]  @param g gap [m]  @param c complementarity constant > 0 [Pa/m]
template <class T>
T complementarity(const T& p, const T& g, double c) {
  const T trial = p - c * g;
  return value(trial) > 0.0 ? T(p - trial) : p;
}

}  // namespace mortise
