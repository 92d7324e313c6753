// The trilinear brick: shape functions, quadrature and the reference gradients that every body integral needs.
#pragma once

#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// Trilinear brick in Exodus node order (bottom 1 2 3 4 counter-clockwise, then top 5 6 7 8).
struct Hex8 {
  static constexpr int n_nodes = 8;
  static constexpr int n_points = 8;  ///< 2 x 2 x 2 Gauss rule, weights 1
  static constexpr double corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                          {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

  /// Local coordinates of Gauss point g.
  static std::array<double, 3> point(int g) {
    constexpr double r = 0.57735026918962576451;  // 1/sqrt(3)
    return {r * corner[g][0], r * corner[g][1], r * corner[g][2]};
  }

  /// N_a at local coordinates xi in [-1, 1]^3.
  static double N(int a, const std::array<double, 3>& xi) {
    return 0.125 * (1 + corner[a][0] * xi[0]) * (1 + corner[a][1] * xi[1]) * (1 + corner[a][2] * xi[2]);
  }

  /// dN_a/dxi.
  static std::array<double, 3> dN_dxi(int a, const std::array<double, 3>& xi) {
    const double* c = corner[a];
    const double f0 = 1 + c[0] * xi[0], f1 = 1 + c[1] * xi[1], f2 = 1 + c[2] * xi[2];
    return {0.125 * c[0] * f1 * f2, 0.125 * f0 * c[1] * f2, 0.125 * f0 * f1 * c[2]};
  }
};

/// What an element keeps of its reference configuration: grad_N = dN/dX [1/m] and JxW [m^3] at each Gauss point.
struct Hex8Geometry {
  double grad_N[Hex8::n_points][Hex8::n_nodes][3];
  double JxW[Hex8::n_points];
};

/// Reference geometry of one element from its nodal positions X [m].
/// JxW <= 0 at some point means an inverted element: meshes are checked for that when they are read.
inline Hex8Geometry hex8_geometry(const std::array<std::array<double, 3>, 8>& X) {
  Hex8Geometry geometry;
  for (int g = 0; g < Hex8::n_points; ++g) {
    const auto xi = Hex8::point(g);
    Tensor3<double> dX_dxi{};
    for (int a = 0; a < 8; ++a) {
      const auto dN = Hex8::dN_dxi(a, xi);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) dX_dxi(i, j) += X[a][i] * dN[j];
    }
    const double J = det(dX_dxi);
    const Tensor3<double> cof = cofactor(dX_dxi);
    for (int a = 0; a < 8; ++a) {
      const auto dN = Hex8::dN_dxi(a, xi);
      for (int i = 0; i < 3; ++i) geometry.grad_N[g][a][i] = (cof(i, 0) * dN[0] + cof(i, 1) * dN[1] + cof(i, 2) * dN[2]) / J;
    }
    geometry.JxW[g] = J;
  }
  return geometry;
}

}  // namespace mortise
