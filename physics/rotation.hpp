// Rotation about an axis.
#pragma once

#include "physics/tensor.hpp"

namespace mortise {

/// R v for the rotation about a unit axis (Rodrigues):  R v = cos v + sin (axis x v) + (1 - cos) axis (axis . v).
/// Sine and cosine are given, so that the caller can make quarter turns exact.
template <class T>
Vec3<T> turned_about(const Vec3<T>& axis, const T& sine, const T& cosine, const Vec3<T>& v) {
  return cosine * v + sine * cross(axis, v) + T((1.0 - cosine) * dot(axis, v)) * axis;
}

}  // namespace mortise
