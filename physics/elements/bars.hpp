// Bars with 2, 3 and 4 nodes: Lagrange's shape functions of order 1 to 3 on [-1, 1].
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "physics/elements/quadrature.hpp"

namespace mortise {

/// Values of the shape functions of a bar, or of their derivatives; those beyond its nodes are 0.
using BarValues = std::array<double, 4>;

/// Local coordinates of the nodes in Exodus order: both ends, then those between from the first end on.
inline BarValues bar_nodes(std::size_t n) {
  if (n == 3) return {-1, 1, 0, 0};
  return {-1, 1, -1. / 3, 1. / 3};
}

/// N_a(xi) of a bar with `n` nodes: the product of (xi - xi_b)/(xi_a - xi_b) over b != a.
inline BarValues bar_shapes(std::size_t n, double xi) {
  const BarValues at = bar_nodes(n);
  BarValues N{};
  for (std::size_t a = 0; a < n; ++a) {
    N[a] = 1;
    for (std::size_t b = 0; b < n; ++b)
      if (b != a) N[a] *= (xi - at[b]) / (at[a] - at[b]);
  }
  return N;
}

/// dN_a/dxi.
inline BarValues bar_derivatives(std::size_t n, double xi) {
  const BarValues at = bar_nodes(n);
  BarValues dN{};
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t c = 0; c < n; ++c) {
      if (c == a) continue;
      double product = 1 / (at[a] - at[c]);
      for (std::size_t b = 0; b < n; ++b)
        if (b != a && b != c) product *= (xi - at[b]) / (at[a] - at[b]);
      dN[a] += product;
    }
  return dN;
}

struct BarPoint {
  double xi, weight;
};

/// Gauss rule with 1 to 4 points. Of the force of a bar with n nodes: n - 1 points, as many as its stretch has free values; of
/// its mass: n points, exact for straight bars with nodes at equal distances.
inline std::vector<BarPoint> bar_rule(int n_points) {
  std::vector<BarPoint> rule;
  const auto take = [&](const auto& line) {
    for (const auto& [xi, weight] : line) rule.push_back({xi, weight});
  };
  switch (n_points) {
    case 1:
      take(gauss<1>());
      break;
    case 2:
      take(gauss<2>());
      break;
    case 3:
      take(gauss<3>());
      break;
    case 4:
      take(gauss<4>());
      break;
    default:
      throw std::logic_error("a rule for bars has 1 to 4 points");
  }
  return rule;
}

}  // namespace mortise
