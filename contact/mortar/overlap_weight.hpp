// How much of a facet pair's overlap counts: nothing may come or go at once where facets turn away or part.
#pragma once

#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// 0 below 0, 1 above 1, with a continuous slope between.
template <class T>
T smooth_step(const T& s) {
  if (value(s) <= 0) return T(0.0);
  if (value(s) >= 1) return T(1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// 1 where facets face each other within 70 degrees, 0 from 80 degrees on.
/// @param n sum of the secondary facet's nodal normals  @param x primary nodes [m]
template <class T>
T facing_weight(const Vec3<T>& n, const std::array<Vec3<T>, 4>& x) {
  constexpr double cos_70 = 0.3420201433256687, cos_80 = 0.17364817766693033;
  const Vec3<T> across = cross(Vec3<T>(x[2] - x[0]), Vec3<T>(x[3] - x[1]));
  const T cosine = -dot(n, across) / (norm(n) * norm(across));
  return smooth_step(T((cosine - cos_80) / (cos_70 - cos_80)));
}

/// 1 up to four fifths of the farthest gap that counts, 0 from that gap on.
/// @param gap mean gap of the pair [m]  @param farthest [m]
template <class T>
T nearness_weight(const T& gap, double farthest) {
  return 1.0 - smooth_step(T(5.0 * gap / farthest - 4.0));
}

}  // namespace mortise
