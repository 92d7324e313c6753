// The reference geometry of a bar at the points of a rule.
#pragma once

#include <cmath>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/elements/bars.hpp"

namespace mortise {

/// What a bar has at one point: weights of its nodes, their derivatives along the reference line, and the length behind the
/// point.
struct PointOfBar {
  BarValues N, dN_dS;  ///< dN_dS [1/m]
  double length;       ///< |dX/dxi| weight [m]
};

inline std::vector<PointOfBar> points_of_bar(const Mesh& mesh, ElementNodeList nodes, int n_points) {
  std::vector<PointOfBar> points;
  for (const BarPoint& at : bar_rule(n_points)) {
    PointOfBar point{bar_shapes(nodes.size(), at.xi), bar_derivatives(nodes.size(), at.xi), 0};
    Point along{0, 0, 0};
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t i = 0; i < 3; ++i) along[i] += point.dN_dS[a] * mesh.coordinates[static_cast<std::size_t>(nodes[a])][i];
    const double measure = std::hypot(along[0], along[1], along[2]);
    for (double& slope : point.dN_dS) slope /= measure;
    point.length = at.weight * measure;
    points.push_back(point);
  }
  return points;
}

}  // namespace mortise
