// Tetrahedra of 4 and 10 nodes: shape functions in the barycentric coordinates of (0,0,0), (1,0,0), (0,1,0), (0,0,1); rules.
#pragma once

#include "physics/elements/hexahedra.hpp"

namespace mortise {

/// Barycentric coordinate a of a point, and its constant gradient.
inline double barycentric(int a, const LocalPoint& xi) { return a == 0 ? 1 - xi[0] - xi[1] - xi[2] : xi[a - 1]; }
inline LocalPoint barycentric_gradient(int a) {
  if (a == 0) return {-1, -1, -1};
  LocalPoint gradient{0, 0, 0};
  gradient[a - 1] = 1;
  return gradient;
}

/// Linear tetrahedron.
struct Tet4 {
  static constexpr int n_nodes = 4;
  static constexpr auto stiffness_rule = tetrahedron_rule_1();
  static constexpr auto mass_rule = tetrahedron_rule_4();

  static constexpr double node[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  static double N(int a, const LocalPoint& xi) { return barycentric(a, xi); }
  static LocalPoint dN_dxi(int a, const LocalPoint&) { return barycentric_gradient(a); }
};

/// Quadratic tetrahedron in Exodus node order: corners, then the middles of the edges 12 23 13 14 24 34.
struct Tet10 {
  static constexpr int n_nodes = 10;
  static constexpr auto stiffness_rule = tetrahedron_rule_4();  ///< exact for straight edges and a linear material
  static constexpr auto mass_rule = tetrahedron_rule_14();
  static constexpr int edge[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};

  static constexpr double node[10][3] = {{0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
                                         {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};

  static double N(int a, const LocalPoint& xi) {
    if (a < 4) return barycentric(a, xi) * (2 * barycentric(a, xi) - 1);
    return 4 * barycentric(edge[a - 4][0], xi) * barycentric(edge[a - 4][1], xi);
  }

  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    const int b = a < 4 ? a : edge[a - 4][0], c = a < 4 ? a : edge[a - 4][1];
    const double L_b = barycentric(b, xi), L_c = barycentric(c, xi);
    const LocalPoint g_b = barycentric_gradient(b), g_c = barycentric_gradient(c);
    LocalPoint dN;
    for (int i = 0; i < 3; ++i) dN[i] = a < 4 ? (4 * L_b - 1) * g_b[i] : 4 * (L_c * g_b[i] + L_b * g_c[i]);
    return dN;
  }
};

}  // namespace mortise
