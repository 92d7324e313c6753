// Quotients of the exponential function that keep their digits near zero.
#pragma once

#include <cmath>

#include "physics/tensor.hpp"

namespace mortise {

/// The Taylor series of exp from x^order on, divided by x^order:  sum_n x^n / (n + order)!. For |x| <= 1/2, to 1e-16.
template <class T>
T exponential_remainder_series(const T& x, int order) {
  constexpr int n_terms = 14;
  T sum = 1.0;
  for (int n = n_terms; n > 0; --n) sum = 1.0 + sum * x / double(n + order);
  for (int n = 2; n <= order; ++n) sum = sum / double(n);
  return sum;
}

/// (exp(x) - 1) / x, 1 at x = 0.
template <class T>
T exponential_quotient(const T& x) {
  using std::exp;
  if (std::abs(value(x)) < 0.5) return exponential_remainder_series(x, 1);
  return (exp(x) - 1.0) / x;
}

/// (exp(x) - 1 - x) / x^2, 1/2 at x = 0.
template <class T>
T second_exponential_quotient(const T& x) {
  using std::exp;
  if (std::abs(value(x)) < 0.5) return exponential_remainder_series(x, 2);
  return (exp(x) - 1.0 - x) / (x * x);
}

}  // namespace mortise
