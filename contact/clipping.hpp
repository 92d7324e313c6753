// The overlap of two projected facets: Sutherland-Hodgman clipping without tolerances in its values, with bounded derivatives.
#pragma once

#include "contact/plane.hpp"

namespace mortise {

/// Cuts a quadrilateral (either orientation) into convex, counter-clockwise pieces: itself, or two triangles from a reflex
/// corner. A self-crossing or flat quadrilateral has no pieces. @return number of pieces, 0 to 2
template <class T>
int convex_pieces(const Quad<T>& quad, std::array<Polygon<T>, 2>& pieces) {
  Quad<T> q = quad;
  if (value(twice_area(q)) < 0) std::swap(q[1], q[3]);
  int reflex = -1, n_reflex = 0;
  for (int k = 0; k < 4; ++k) {
    const auto a = value(q[(k + 3) % 4]), b = value(q[k]), c = value(q[(k + 1) % 4]);
    if (cross(b - a, c - b) < 0) {
      reflex = k;
      ++n_reflex;
    }
  }
  if (n_reflex > 1 || !(value(twice_area(q)) > 0)) return 0;
  pieces[0].n = pieces[1].n = 0;
  if (n_reflex == 0) {
    for (const auto& v : q) pieces[0].add(v);
    return 1;
  }
  for (int piece = 0; piece < 2; ++piece) {
    pieces[piece].add(q[reflex]);
    pieces[piece].add(q[(reflex + 1 + piece) % 4]);
    pieces[piece].add(q[(reflex + 2 + piece) % 4]);
  }
  return 2;
}

/// Where the edge p-q of a polygon crosses the clip edge a-b, given their signed distances d_p, d_q to it (of unlike sign).
/// Edges that are parallel within 1e-5 cross at a point that slides by (motion / angle): its derivative is useless although the
/// overlap hardly changes. There the vertex keeps its place on a-b, an element of the generalised derivative, which stays
/// bounded.
template <class T>
Vec2<T> crossing(const Vec2<T>& p, const Vec2<T>& q, const T& d_p, const T& d_q, const Vec2<T>& a, const Vec2<T>& b) {
  constexpr double parallel = 1e-5;  // sine of the angle
  const auto edge = value(b) - value(a), side = value(q) - value(p);
  const double drop = value(d_p) - value(d_q);
  const double length2 = edge.x * edge.x + edge.y * edge.y, side2 = side.x * side.x + side.y * side.y;
  if (drop * drop > parallel * parallel * length2 * side2) {
    const T t = d_p / (d_p - d_q);
    return {T(p.x + t * (q.x - p.x)), T(p.y + t * (q.y - p.y))};
  }
  const double t = value(d_p) / drop;
  const double along =
      ((value(p.x) + t * side.x - value(a.x)) * edge.x + (value(p.y) + t * side.y - value(a.y)) * edge.y) / length2;
  return {T(a.x + along * (b.x - a.x)), T(a.y + along * (b.y - a.y))};
}

/// The part of `subject` inside the convex, counter-clockwise `clip`; the result is empty, or has at least 3 vertices.
template <class T>
Polygon<T> clip_polygon(const Polygon<T>& subject, const Polygon<T>& clip) {
  Polygon<T> in = subject;
  for (int k = 0; k < clip.n && in.n > 0; ++k) {
    const Vec2<T>&a = clip.vertex[k], &b = clip.vertex[(k + 1) % clip.n];
    const Vec2<T> edge = b - a;
    std::array<T, 24> d;
    for (int i = 0; i < in.n; ++i) d[i] = cross(edge, Vec2<T>(in.vertex[i] - a));
    Polygon<T> out;
    for (int i = 0; i < in.n; ++i) {
      const int j = (i + 1) % in.n;
      const bool i_inside = value(d[i]) >= 0, j_inside = value(d[j]) >= 0;
      if (i_inside) out.add(in.vertex[i]);
      if (i_inside != j_inside) out.add(crossing(in.vertex[i], in.vertex[j], d[i], d[j], a, b));
    }
    in = out;
  }
  if (in.n < 3) in.n = 0;
  return in;
}

}  // namespace mortise
