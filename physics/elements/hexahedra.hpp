// Bricks of 8, 20 and 27 nodes on [-1, 1]^3: shape functions, rules.
#pragma once

#include "physics/elements/quadrature.hpp"

namespace mortise {

using LocalPoint = std::array<double, 3>;

/// Local coordinates of the 27 nodes of a brick in Exodus order: corners, edges, centre, faces -z +z -x +x -y +y.
inline constexpr double hexahedron_node[27][3] = {
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},  {-1, 1, 1}, {0, -1, -1},
    {1, 0, -1},   {0, 1, -1},  {-1, 0, -1}, {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},  {-1, 1, 0}, {0, -1, 1}, {1, 0, 1},
    {0, 1, 1},    {-1, 0, 1},  {0, 0, 0},   {0, 0, -1},  {0, 0, 1},   {-1, 0, 0}, {1, 0, 0},  {0, -1, 0}, {0, 1, 0}};

/// Trilinear brick in Exodus node order (bottom 1 2 3 4 counter-clockwise, then top 5 6 7 8).
struct Hex8 {
  static constexpr int n_nodes = 8;
  static constexpr auto stiffness_rule = hexahedron_rule<2>();
  static constexpr auto mass_rule = hexahedron_rule<3>();  ///< exact, also on distorted bricks
  static constexpr const auto& node = hexahedron_node;

  /// N_a at local coordinates xi.
  static double N(int a, const LocalPoint& xi) {
    const double* c = node[a];
    return 0.125 * (1 + c[0] * xi[0]) * (1 + c[1] * xi[1]) * (1 + c[2] * xi[2]);
  }

  /// dN_a/dxi.
  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    const double* c = node[a];
    const double f0 = 1 + c[0] * xi[0], f1 = 1 + c[1] * xi[1], f2 = 1 + c[2] * xi[2];
    return {0.125 * c[0] * f1 * f2, 0.125 * f0 * c[1] * f2, 0.125 * f0 * f1 * c[2]};
  }
};

/// Serendipity brick: corners, then the middles of the edges.
struct Hex20 {
  static constexpr int n_nodes = 20;
  static constexpr auto stiffness_rule = hexahedron_rule<3>();
  static constexpr auto mass_rule = hexahedron_rule<4>();
  static constexpr const auto& node = hexahedron_node;

  static double N(int a, const LocalPoint& xi) {
    const double* c = node[a];
    double product = 1, sum = -2;
    for (int i = 0; i < 3; ++i) {
      product *= c[i] == 0 ? 1 - xi[i] * xi[i] : 1 + c[i] * xi[i];
      sum += c[i] * xi[i];
    }
    return a < 8 ? 0.125 * product * sum : 0.25 * product;
  }

  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    const double* c = node[a];
    double f[3], d[3], sum = -2;
    for (int i = 0; i < 3; ++i) {
      f[i] = c[i] == 0 ? 1 - xi[i] * xi[i] : 1 + c[i] * xi[i];
      d[i] = c[i] == 0 ? -2 * xi[i] : c[i];
      sum += c[i] * xi[i];
    }
    LocalPoint dN;
    for (int i = 0; i < 3; ++i) {
      const double others = f[(i + 1) % 3] * f[(i + 2) % 3];
      dN[i] = a < 8 ? 0.125 * others * (d[i] * sum + f[i] * c[i]) : 0.25 * d[i] * others;
    }
    return dN;
  }
};

/// Triquadratic brick: the nodes of Hex20, the centre, the middles of the faces.
struct Hex27 {
  static constexpr int n_nodes = 27;
  static constexpr auto stiffness_rule = hexahedron_rule<3>();
  static constexpr auto mass_rule = hexahedron_rule<4>();
  static constexpr const auto& node = hexahedron_node;

  static double N(int a, const LocalPoint& xi) {
    double product = 1;
    for (int i = 0; i < 3; ++i) product *= line(node[a][i], xi[i]);
    return product;
  }

  static LocalPoint dN_dxi(int a, const LocalPoint& xi) {
    LocalPoint dN;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      dN[i] = slope(node[a][i], xi[i]) * line(node[a][j], xi[j]) * line(node[a][k], xi[k]);
    }
    return dN;
  }

 private:
  /// Quadratic Lagrange polynomial of the node at c in {-1, 0, 1}.
  static constexpr double line(double c, double x) { return c == 0 ? 1 - x * x : 0.5 * x * (x + c); }
  static constexpr double slope(double c, double x) { return c == 0 ? -2 * x : x + 0.5 * c; }
};

}  // namespace mortise
