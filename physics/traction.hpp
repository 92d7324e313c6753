// Dead traction on a side of an element: force per unit reference area in a fixed direction.
#pragma once

#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// Nodal weights W_a = int N_a dA [m^2] of a bilinear side in the reference configuration; the force on node a is W_a t.
/// @param X positions of the four nodes [m], in order around the side
inline std::array<double, 4> side_weights(const std::array<std::array<double, 3>, 4>& X) {
  constexpr double r =
      0.57735026918962576451;  // 1/sqrt(3): the rule is exact for a flat parallelogram, 2nd order on warped sides
  constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::array<double, 4> weights{};
  for (const auto& p : corner) {
    const double s = r * p[0], t = r * p[1];
    Vec3<double> dX_ds{}, dX_dt{};
    double N[4];
    for (int a = 0; a < 4; ++a) {
      const double fs = 1 + corner[a][0] * s, ft = 1 + corner[a][1] * t;
      N[a] = 0.25 * fs * ft;
      for (int i = 0; i < 3; ++i) {
        dX_ds[i] += 0.25 * corner[a][0] * ft * X[a][i];
        dX_dt[i] += 0.25 * fs * corner[a][1] * X[a][i];
      }
    }
    const double dA = norm(cross(dX_ds, dX_dt));
    for (int a = 0; a < 4; ++a) weights[a] += N[a] * dA;
  }
  return weights;
}

}  // namespace mortise
