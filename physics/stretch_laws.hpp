// Springs and strings: laws in the stretch nu of a line, and the force that follows from them.
//
// A law is an energy w(s) of s = nu^2, which is quadratic in the positions and does not see rotations. It is measured by c L^2 of
// a spring and by EA per reference length of a string, so that with c = EA/L both are one (thesis eq. 6.7).
#pragma once

#include <cmath>

#include "physics/tensor.hpp"

namespace mortise {

namespace stretch_laws {

/// w = (s - 1)^2 / 8 (thesis eqs. 6.3, 6.4): finite force where the line has shrunk to nothing.
struct SaintVenant {
  template <class T>
  static T energy(const T& s) {
    return 0.125 * (s - 1.0) * (s - 1.0);
  }

  /// (w(s + ds) - w(s)) / ds, and dw/ds where ds = 0. All laws form it without loss of digits for small ds.
  template <class T>
  static T slope(const T& s, const T& ds) {
    return 0.25 * (s + 0.5 * ds - 1.0);
  }
};

/// w = (s - 1/s)^2 / 8 (thesis, after eq. 6.8): four times as stiff at small strain, and grows without bound where s -> 0.
struct NeoHookean {
  template <class T>
  static T energy(const T& s) {
    const T g = s - 1.0 / s;
    return 0.125 * g * g;
  }
  template <class T>
  static T slope(const T& s, const T& ds) {
    const T end = s + ds;
    return 0.125 * (s - 1.0 / s + end - 1.0 / end) * (1.0 + 1.0 / (s * end));
  }
};

/// ln(1 + x) / x, 1 at x = 0. Precondition: x > -1.
template <class T>
T logarithm_quotient(const T& x) {
  using std::log;
  if (std::abs(value(x)) > 0.25) return log(1.0 + x) / x;
  // ln(1 + x) = 2 artanh y,  y = x / (2 + x)
  const T y = x / (2.0 + x), y_2 = y * y;
  T sum = 1. / 23;
  for (int k = 10; k >= 0; --k) sum = sum * y_2 + 1. / (2 * k + 1);
  return 2.0 / (2.0 + x) * sum;
}

/// w = (s - 1 - ln s) / 4, whose force is  N = EA/2 (nu - 1/nu)  (thesis eq. 2.10).
struct Logarithmic {
  template <class T>
  static T energy(const T& s) {
    using std::log;
    return 0.25 * (s - 1.0 - log(s));
  }
  template <class T>
  static T slope(const T& s, const T& ds) {
    return 0.25 * (1.0 - logarithm_quotient(T(ds / s)) / s);
  }
};

}  // namespace stretch_laws

enum class StretchLaw { saint_venant, neo_hookean, logarithmic };

/// Calls f(SaintVenant{}) ...
template <class Function>
decltype(auto) with_stretch_law(StretchLaw law, Function f) {
  switch (law) {
    case StretchLaw::neo_hookean:
      return f(stretch_laws::NeoHookean{});
    case StretchLaw::logarithmic:
      return f(stretch_laws::Logarithmic{});
    default:
      return f(stretch_laws::SaintVenant{});
  }
}

/// Tangent dq/dS of a line in a step to the force in it, over its stiffness: the discrete gradient of w(t . t) that keeps energy
/// and angular momentum (thesis eqs. 6.31-6.36),
///   n = 2 (w(s_1) - w(s_0)) / (s_1 - s_0)  (t_0 + t_1)/2,   s = t . t;
/// with t_0 = t_1 it is the gradient there. s_1 - s_0 = (t_1 - t_0) . (t_0 + t_1) keeps its digits.
/// Precondition: neither tangent is zero, unless the law is Saint Venant's.
template <class Law, class T>
Vec3<T> tension(const Vec3<T>& t_0, const Vec3<T>& t_1) {
  const Vec3<T> sum = t_0 + t_1;
  const T s = dot(t_0, t_0), ds = dot(t_1 - t_0, sum), slope = Law::slope(s, ds);
  return slope * sum;
}

}  // namespace mortise
