// A point of a line that is stretched: of a string, or the only one of a spring.
#pragma once

#include <vector>

#include "scene_loads.hpp"

namespace mortise {

/// Tangent t = dq/dS = sum_a N'_a q_a of a line at one of its points, and the energy E w(t . t) there.
struct LinePoint {
  std::vector<double> slopes;  ///< N'_a of the nodes [1/m]
  Vec3<double> fixed{};        ///< part of t that does not move: of an anchor
  double energy = 0;           ///< E [J]

  /// @param local first local index of each node  @param x overlap
  Vec3<double> tangent(const std::vector<int>& local, const double* x) const {
    Vec3<double> t = fixed;
    for (std::size_t a = 0; a < slopes.size(); ++a)
      for (int i = 0; i < 3; ++i) t[i] += slopes[a] * x[local[a] + i];
    return t;
  }
};

/// Nodes of a spring.
inline std::vector<int> nodes_of(const NodeSpring& spring) {
  return spring.to ? std::vector<int>{spring.from, *spring.to} : std::vector<int>{spring.from};
}

/// N' = -1/L, 1/L and E = c L^2 (thesis 6.1).
inline LinePoint point_of(const NodeSpring& spring) {
  const double L = spring.rest_length;
  LinePoint point{{-1 / L}, {}, spring.stiffness * L * L};
  if (spring.to) {
    point.slopes.push_back(1 / L);
  } else {
    for (int i = 0; i < 3; ++i) point.fixed[i] = spring.anchor[i] / L;
  }
  return point;
}

}  // namespace mortise
