// The frame of a facet, which turns with it.
#pragma once

#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// Orthonormal frame of a quadrilateral at its centre: columns a_1/|a_1|, n x a_1/|a_1|, n, with the covariant base vector a_1
/// (thesis section 3.2) and the unit normal n.
/// @param x positions of the nodes [m]; a_1 and the normal must not vanish
template <class T>
Tensor3<T> facet_frame(const std::array<Vec3<T>, 4>& x) {
  const Vec3<T> diagonal = x[2] - x[0], other = x[3] - x[1], along = diagonal - other, across = cross(diagonal, other);
  const Vec3<T> t = T(1.0 / norm(along)) * along, n = T(1.0 / norm(across)) * across, s = cross(n, t);
  return {{{t[0], s[0], n[0]}, {t[1], s[1], n[1]}, {t[2], s[2], n[2]}}};
}

/// Rotation that took a facet from where its frame was `reference` to where its nodes are now: objective, and the identity where
/// nothing has turned.
template <class T>
Tensor3<T> facet_rotation(const std::array<Vec3<T>, 4>& x, const Tensor3<double>& reference) {
  const Tensor3<T> frame = facet_frame(x);
  Tensor3<T> R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      R(i, j) = frame(i, 0) * reference(j, 0) + frame(i, 1) * reference(j, 1) + frame(i, 2) * reference(j, 2);
  return R;
}

}  // namespace mortise
