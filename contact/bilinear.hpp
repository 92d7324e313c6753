// The bilinear map of a projected facet: shape functions on the unit square, and the inverse map in closed form.
#pragma once

#include <algorithm>

#include "contact/plane.hpp"

namespace mortise {

/// N_a at (s, t) in [0, 1]^2, nodes in order around the facet.
template <class T>
std::array<T, 4> bilinear_shape(const T& s, const T& t) {
  const T s1 = 1.0 - s, t1 = 1.0 - t;
  return {T(s1 * t1), T(s * t1), T(s * t), T(s1 * t)};
}

/// Local coordinates of `point` in a facet of either orientation, on values: the root of  A s^2 + B s + C = 0  at which the
/// Jacobian of the map, R = B + 2 A s, has the sign of the facet's area. Every point of a facet, reflex corner or not, has just
/// one such source inside the unit square. No iteration.
inline Vec2<double> inverse_bilinear(const Quad<double>& x, const Vec2<double>& point) {
  const auto r = point - x[0], b = x[1] - x[0], c = x[3] - x[0];
  const Vec2<double> d = (x[2] - x[3]) - b;
  const double A = cross(b, d), B = cross(b, c) - cross(r, d), C = -cross(r, c);
  const double R = std::copysign(std::sqrt(std::max(0.0, B * B - 4 * A * C)), twice_area(x));
  const double s = B * R >= 0 ? -2 * C / (B + R) : (R - B) / (2 * A);  // the same root, written without cancellation
  const Vec2<double> along{c.x + s * d.x, c.y + s * d.y};
  const double t = ((r.x - s * b.x) * along.x + (r.y - s * b.y) * along.y) / (along.x * along.x + along.y * along.y);
  return {s, t};
}

/// Shape functions of the facet at `point`. For AD types the values are solved for in double, then one Newton step with the
/// double 2 x 2 matrix is taken in T: by the implicit function theorem that step carries the exact derivative.
template <class T>
std::array<T, 4> shape_at(const Quad<T>& x, const Vec2<T>& point) {
  const Quad<double> x0{value(x[0]), value(x[1]), value(x[2]), value(x[3])};
  const auto [s, t] = inverse_bilinear(x0, value(point));
  if constexpr (std::is_same_v<T, double>) {
    return bilinear_shape(s, t);
  } else {
    const auto N = bilinear_shape(s, t);
    const T rx = point.x - (N[0] * x[0].x + N[1] * x[1].x + N[2] * x[2].x + N[3] * x[3].x);
    const T ry = point.y - (N[0] * x[0].y + N[1] * x[1].y + N[2] * x[2].y + N[3] * x[3].y);
    const double xs = (1 - t) * (x0[1].x - x0[0].x) + t * (x0[2].x - x0[3].x),
                 ys = (1 - t) * (x0[1].y - x0[0].y) + t * (x0[2].y - x0[3].y);
    const double xt = (1 - s) * (x0[3].x - x0[0].x) + s * (x0[2].x - x0[1].x),
                 yt = (1 - s) * (x0[3].y - x0[0].y) + s * (x0[2].y - x0[1].y);
    const double det = xs * yt - xt * ys;
    const T ss = s + (yt * rx - xt * ry) / det, tt = t + (xs * ry - ys * rx) / det;
    return bilinear_shape(ss, tt);
  }
}

/// int N_a da over a whole facet [m^2], exact.
template <class T>
std::array<T, 4> facet_weights(const Quad<T>& x) {
  std::array<T, 4> weights{T(0.0), T(0.0), T(0.0), T(0.0)};
  constexpr double r = 0.21132486540518711775;  // (1 - 1/sqrt(3)) / 2
  const Vec2<T> ds = x[1] - x[0], dt = x[3] - x[0], twist = Vec2<T>(x[2] - x[3]) - ds;
  for (const double s : {r, 1 - r})
    for (const double t : {r, 1 - r}) {
      const Vec2<T> along_s{T(ds.x + t * twist.x), T(ds.y + t * twist.y)}, along_t{T(dt.x + s * twist.x), T(dt.y + s * twist.y)};
      const T area = 0.25 * cross(along_s, along_t);
      const auto N = bilinear_shape(s, t);
      for (int a = 0; a < 4; ++a) weights[a] += N[a] * area;
    }
  return weights;
}

}  // namespace mortise
