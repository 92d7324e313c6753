// The faces of elements as surfaces: shape functions and rules of quadrilaterals and triangles, linear and quadratic.
#pragma once

#include "physics/elements/hexahedra.hpp"

namespace mortise {

/// A face of a brick on [-1, 1]^2, made of the brick's shape functions on its bottom turned outwards; nodes counter-clockwise,
/// corners before edges before the middle. The quadrilateral is the restriction, so it fits the element exactly.
template <class Brick, int n>
struct Quadrilateral {
  static constexpr int n_nodes = n;
  static constexpr auto rule = quadrilateral_rule<(n > 4 ? 4 : 3)>();

  static double N(int a, const LocalPoint& xi) { return Brick::N(of_brick(a), {xi[0], xi[1], 1}); }
  static LocalPoint dN_dxi(int a, const LocalPoint& xi) { return Brick::dN_dxi(of_brick(a), {xi[0], xi[1], 1}); }

 private:
  /// The side's nodes are those of the brick's top face.
  static constexpr int of_brick(int a) { return a < 4 ? 4 + a : a < 8 ? 12 + a : 22; }
};

using Quad4 = Quadrilateral<Hex8, 4>;
using Quad8 = Quadrilateral<Hex20, 8>;
using Quad9 = Quadrilateral<Hex27, 9>;

/// Linear triangle (0,0), (1,0), (0,1).
struct Tri3 {
  static constexpr int n_nodes = 3;
  static constexpr auto rule = triangle_rule_3();
  static double N(int a, const LocalPoint& xi) { return a == 0 ? 1 - xi[0] - xi[1] : xi[a - 1]; }
  static LocalPoint dN_dxi(int a, const LocalPoint&) {
    constexpr double slope[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    return {slope[a][0], slope[a][1], 0};
  }
};

/// Quadratic triangle: corners, then the middles of the edges 12 23 31.
struct Tri6 {
  static constexpr int n_nodes = 6;
  static constexpr auto rule = triangle_rule_6();
  static double N(int a, const LocalPoint& xi) {
    if (a < 3) return Tri3::N(a, xi) * (2 * Tri3::N(a, xi) - 1);
    return 4 * Tri3::N(a - 3, xi) * Tri3::N((a - 2) % 3, xi);
  }
  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    const int b = a < 3 ? a : a - 3, c = a < 3 ? a : (a - 2) % 3;
    const LocalPoint g_b = Tri3::dN_dxi(b, xi), g_c = Tri3::dN_dxi(c, xi);
    LocalPoint dN{0, 0, 0};
    for (int i = 0; i < 2; ++i)
      dN[i] = a < 3 ? (4 * Tri3::N(b, xi) - 1) * g_b[i] : 4 * (Tri3::N(c, xi) * g_b[i] + Tri3::N(b, xi) * g_c[i]);
    return dN;
  }
};

/// Calls f(Side{}) for the side with so many nodes; a side has 3, 4, 6, 8 or 9.
template <class Function>
decltype(auto) with_side(int n_nodes, Function f) {
  switch (n_nodes) {
    case 3:
      return f(Tri3{});
    case 4:
      return f(Quad4{});
    case 6:
      return f(Tri6{});
    case 8:
      return f(Quad8{});
    default:
      return f(Quad9{});
  }
}

}  // namespace mortise
