// Points and polygons in the plane onto which a pair of facets is projected.
#pragma once

#include <array>
#include <cassert>
#include <cmath>

#include "physics/tensor.hpp"

namespace mortise {

template <class T>
struct Vec2 {
  T x, y;
};

template <class T>
Vec2<T> operator-(const Vec2<T>& a, const Vec2<T>& b) {
  return {T(a.x - b.x), T(a.y - b.y)};
}

template <class T>
T cross(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class T>
Vec2<double> value(const Vec2<T>& a) {
  return {value(a.x), value(a.y)};
}

template <class T>
using Quad = std::array<Vec2<T>, 4>;

/// A polygon with at most 24 vertices. Two quadrilaterals meet in 8 at most; round-off on nearly collinear edges can add a few.
template <class T>
struct Polygon {
  std::array<Vec2<T>, 24> vertex;
  int n = 0;
  void add(const Vec2<T>& v) {
    assert(n < 24);
    vertex[n++] = v;
  }
};

/// Twice the signed area of a quadrilateral: positive when counter-clockwise.
template <class T>
T twice_area(const Quad<T>& q) {
  return cross(Vec2<T>(q[2] - q[0]), Vec2<T>(q[3] - q[1]));
}

}  // namespace mortise
