// The exact area of the overlap of two convex polygons with small integer coordinates, as a rational number.
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace mortise::test {

/// A fraction of 128-bit integers: sums and products of those below stay far within them.
class Rational {
 public:
  using Integer = __int128;
  Rational(Integer numerator = 0, Integer denominator = 1) : n_(numerator), d_(denominator) {
    const Integer g = divisor(n_, d_);
    n_ /= d_ < 0 ? -g : g;
    d_ /= d_ < 0 ? -g : g;
  }
  friend Rational operator+(const Rational& a, const Rational& b) {
    const Integer g = divisor(a.d_, b.d_);
    return {a.n_ * (b.d_ / g) + b.n_ * (a.d_ / g), a.d_ / g * b.d_};
  }
  friend Rational operator-(const Rational& a, const Rational& b) { return a + Rational(-b.n_, b.d_); }
  friend Rational operator*(const Rational& a, const Rational& b) { return {a.n_ * b.n_, a.d_ * b.d_}; }
  friend bool operator<(const Rational& a, const Rational& b) { return a.n_ * b.d_ < b.n_ * a.d_; }
  friend bool operator==(const Rational& a, const Rational& b) { return a.n_ == b.n_ && a.d_ == b.d_; }
  explicit operator double() const { return static_cast<double>(static_cast<long double>(n_) / static_cast<long double>(d_)); }

 private:
  static Integer divisor(Integer a, Integer b) {
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    while (b != 0) a = std::exchange(b, a % b);
    return a == 0 ? 1 : a;
  }
  Integer n_, d_;  ///< in lowest terms, d_ > 0
};

using IntegerPoint = std::array<long, 2>;
using IntegerPolygon = std::vector<IntegerPoint>;

inline long cross(const IntegerPoint& a, const IntegerPoint& b) { return a[0] * b[1] - a[1] * b[0]; }
inline IntegerPoint operator-(const IntegerPoint& a, const IntegerPoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// The part of the edges of `of` that bounds the overlap with `in`, as its share of twice the area (Green's theorem): an edge
/// from P to Q that is inside for t in [t0, t1] gives (t1 - t0) P x Q.
/// @param with_shared whether an edge counts that lies on an edge of `in` (only one of two polygons' may)
inline Rational share_of_edges(const IntegerPolygon& of, const IntegerPolygon& in, bool with_shared) {
  Rational twice;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const IntegerPoint &P = of[k], &Q = of[(k + 1) % of.size()], d = Q - P;
    Rational first = 0, last = 1;
    bool is_outside = d == IntegerPoint{0, 0};
    for (std::size_t l = 0; l < in.size() && !is_outside; ++l) {
      const IntegerPoint &a = in[l], e = in[(l + 1) % in.size()] - a;
      if (e == IntegerPoint{0, 0}) continue;
      const long distance = cross(e, P - a), rise = cross(e, d);  // inside: distance + t rise >= 0
      if (rise > 0) {
        first = std::max(first, Rational(-distance, rise));
      } else if (rise < 0) {
        last = std::min(last, Rational(-distance, rise));
      } else {
        is_outside = distance < 0 || (distance == 0 && !(with_shared && d[0] * e[0] + d[1] * e[1] > 0));
      }
    }
    if (!is_outside && first < last) twice = twice + (last - first) * cross(P, Q);
  }
  return twice;
}

/// Area of the overlap of two convex, counter-clockwise polygons; corners may coincide or lie in line.
inline Rational exact_overlap(const IntegerPolygon& a, const IntegerPolygon& b) {
  return (share_of_edges(a, b, true) + share_of_edges(b, a, false)) * Rational(1, 2);
}

}  // namespace mortise::test
