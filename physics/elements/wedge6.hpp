// The linear wedge: a triangle (0,0), (1,0), (0,1) drawn along [-1, 1].
#pragma once

#include "physics/elements/hexahedra.hpp"

namespace mortise {

/// Linear wedge in Exodus node order: the triangle at -1, then the one at +1.
struct Wedge6 {
  static constexpr int n_nodes = 6;
  static constexpr auto stiffness_rule = wedge_rule<3, 2>(triangle_rule_3());
  static constexpr auto mass_rule = wedge_rule<6, 3>(triangle_rule_6());

  static constexpr double node[6][3] = {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};

  static double N(int a, const LocalPoint& xi) { return triangle(a % 3, xi) * 0.5 * (1 + node[a][2] * xi[2]); }

  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    constexpr double slope[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    const double along = 0.5 * (1 + node[a][2] * xi[2]);
    return {slope[a % 3][0] * along, slope[a % 3][1] * along, 0.5 * node[a][2] * triangle(a % 3, xi)};
  }

 private:
  static double triangle(int a, const LocalPoint& xi) { return a == 0 ? 1 - xi[0] - xi[1] : xi[a - 1]; }
};

}  // namespace mortise
