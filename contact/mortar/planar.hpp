// The mortar integrals of one pair of facets, as a function of 16 in-plane coordinates only.
#pragma once

#include <algorithm>
#include <vector>

#include "contact/bilinear.hpp"
#include "contact/clipping.hpp"
#include "contact/triangle_rule.hpp"

namespace mortise {

/// Mortar integrals over the overlap of a secondary and a primary facet in the auxiliary plane (thesis eq. 4.124) [m^2]:
///   D_IJ = int N_I N_J da,   M_IK = int N_I N_K(primary) da.
/// D is symmetric (upper triangle filled, mirrored by `planar_integrals`). sum(D) = sum(M) = area of the overlap.
template <class T>
struct MortarIntegrals {
  T D[4][4];
  T M[4][4];
};

/// Area centroid of a polygon: the fan about it keeps D and M continuous when vertices appear. Where matching edges meet there
/// are slivers made of round-off, whose centroid could lie anywhere: there the mean of the vertices serves. @return false if it
/// has no area
template <class T>
bool area_centroid(const Polygon<T>& p, Vec2<T>& centroid) {
  constexpr double sliver = 1e-12;  // area over squared extent; round-off makes 1e-16
  T area = 0.0, mx = 0.0, my = 0.0;
  double extent2 = 0;
  const Vec2<T>& o = p.vertex[0];
  for (int k = 1; k + 1 < p.n; ++k) {
    const Vec2<T> a = p.vertex[k] - o, b = p.vertex[k + 1] - o;
    const T w = cross(a, b);
    area += w;
    mx += w * (a.x + b.x);
    my += w * (a.y + b.y);
    extent2 =
        std::max({extent2, value(a.x) * value(a.x) + value(a.y) * value(a.y), value(b.x) * value(b.x) + value(b.y) * value(b.y)});
  }
  if (!(value(area) > 0)) return false;
  if (value(area) > sliver * extent2) {
    centroid = {T(o.x + mx / (3.0 * area)), T(o.y + my / (3.0 * area))};
  } else {
    T sum_x = 0.0, sum_y = 0.0;
    for (int k = 0; k < p.n; ++k) {
      sum_x += p.vertex[k].x;
      sum_y += p.vertex[k].y;
    }
    centroid = {T(sum_x / static_cast<double>(p.n)), T(sum_y / static_cast<double>(p.n))};
  }
  return true;
}

/// Calls `at_point(weight, N1, N2)` at each quadrature point of one polygon of the overlap, a fan of triangles about its
/// centroid: its share of the area, signed, and both facets' shape functions there.
template <class T, class AtPoint>
void over_polygon(const Polygon<T>& polygon, const Quad<T>& secondary, const Quad<T>& primary,
                  const std::vector<TrianglePoint>& rule, const AtPoint& at_point) {
  Vec2<T> c;
  if (!area_centroid(polygon, c)) return;
  for (int k = 0; k < polygon.n; ++k) {
    const Vec2<T>&v = polygon.vertex[k], &w = polygon.vertex[(k + 1) % polygon.n];
    const T triangle = 0.5 * cross(Vec2<T>(v - c), Vec2<T>(w - c));  // signed: no root, and slivers cancel instead of adding up
    for (const auto& point : rule) {
      const Vec2<T> x{T(point.b0 * c.x + point.b1 * v.x + point.b2 * w.x), T(point.b0 * c.y + point.b1 * v.y + point.b2 * w.y)};
      at_point(T(point.weight * triangle), shape_at(secondary, x), shape_at(primary, x));
    }
  }
}

/// Calls `at_point` as `over_polygon` over the whole overlap of a projected pair. Facets with a reflex corner are split; facets
/// without area have no points.
/// @param y in-plane coordinates [m], x and y of the 4 secondary nodes, then of the 4 primary nodes
template <class T, class AtPoint>
void over_overlap(const T* y, const std::vector<TrianglePoint>& rule, const AtPoint& at_point) {
  Quad<T> secondary, primary;
  for (int a = 0; a < 4; ++a) {
    secondary[a] = {y[2 * a], y[2 * a + 1]};
    primary[a] = {y[8 + 2 * a], y[8 + 2 * a + 1]};
  }
  std::array<Polygon<T>, 2> subjects, clips;
  const int n_subjects = convex_pieces(primary, subjects), n_clips = convex_pieces(secondary, clips);
  for (int s = 0; s < n_subjects; ++s)
    for (int c = 0; c < n_clips; ++c) {
      const auto overlap = clip_polygon(subjects[s], clips[c]);
      if (overlap.n > 0) over_polygon(overlap, secondary, primary, rule, at_point);
    }
}

/// D and M of a projected pair.
/// Derivative: exact for T an AD type, except at crossings of nearly parallel edges (see `crossing`).
/// @param y as in `over_overlap`
template <class T>
MortarIntegrals<T> planar_integrals(const T* y, const std::vector<TrianglePoint>& rule) {
  MortarIntegrals<T> sum;
  for (int I = 0; I < 4; ++I)
    for (int J = 0; J < 4; ++J) sum.D[I][J] = sum.M[I][J] = 0.0;
  over_overlap(y, rule, [&sum](const T& weight, const std::array<T, 4>& N1, const std::array<T, 4>& N2) {
    for (int I = 0; I < 4; ++I) {
      const T weighted = weight * N1[I];
      for (int J = I; J < 4; ++J) sum.D[I][J] += weighted * N1[J];
      for (int K = 0; K < 4; ++K) sum.M[I][K] += weighted * N2[K];
    }
  });
  for (int I = 0; I < 4; ++I)
    for (int J = 0; J < I; ++J) sum.D[I][J] = sum.D[J][I];
  return sum;
}

}  // namespace mortise
