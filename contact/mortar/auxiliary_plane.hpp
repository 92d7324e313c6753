// The auxiliary plane of a pair: projection of eight nodes, and the way derivatives come back from it.
#pragma once

#include <array>

#include "physics/tensor.hpp"

namespace mortise {

/// The plane through the centre of the secondary facet, normal to the mean of its nodal normals (Puso & Laursen 2004).
struct AuxiliaryPlane {
  Vec3<double> centre;  ///< mean of the secondary nodes [m]
  Vec3<double> n;       ///< unit normal
  Vec3<double> t1, t2;  ///< orthonormal in-plane axes
  double sum_n;         ///< |n_1 + n_2 + n_3 + n_4|
  double y[16];         ///< in-plane coordinates [m]: secondary nodes, then primary nodes
  double height[8];     ///< distance of each node from the plane along n [m]

  /// Projects a pair. @param x the 4 secondary, then the 4 primary nodes [m]  @param normals unit nodal normals of the secondary
  /// facet
  static AuxiliaryPlane project(const std::array<Vec3<double>, 8>& x, const std::array<Vec3<double>, 4>& normals) {
    AuxiliaryPlane p;
    p.centre = 0.25 * ((x[0] + x[1]) + (x[2] + x[3]));
    const Vec3<double> sum = (normals[0] + normals[1]) + (normals[2] + normals[3]);
    p.sum_n = norm(sum);
    p.n = (1 / p.sum_n) * sum;
    int smallest = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(p.n[i]) < std::abs(p.n[smallest])) smallest = i;
    Vec3<double> axis{};
    axis[smallest] = 1;
    const Vec3<double> t = cross(p.n, axis);
    p.t1 = (1 / norm(t)) * t;
    p.t2 = cross(p.n, p.t1);
    for (int a = 0; a < 8; ++a) {
      const Vec3<double> r = x[a] - p.centre;
      p.y[2 * a] = dot(p.t1, r);
      p.y[2 * a + 1] = dot(p.t2, r);
      p.height[a] = dot(p.n, r);
    }
    return p;
  }

  /// Chain rule for a quantity that depends on y alone and not on the frame (D, M): from d/dy to d/d(x of 8 nodes, normals of 4).
  ///   dy_a(node J) = t_a . dx_J - h_J t_a . dn,   t_a . dn = t_a . sum(dn_I) / |sum n_I|
  /// The motion of the centre and the spin of the axes drop out: D and M do not notice them.
  /// @param dy 16 entries  @param out 36 entries: 8 x 3 for nodes, then 4 x 3 for normals
  void pull_back(const double* dy, double* out) const {
    double lever1 = 0, lever2 = 0;
    for (int a = 0; a < 8; ++a) {
      const double g1 = dy[2 * a], g2 = dy[2 * a + 1];
      for (int i = 0; i < 3; ++i) out[3 * a + i] = g1 * t1[i] + g2 * t2[i];
      lever1 += g1 * height[a];
      lever2 += g2 * height[a];
    }
    for (int i = 0; i < 3; ++i) {
      const double tilt = -(lever1 * t1[i] + lever2 * t2[i]) / sum_n;
      for (int I = 0; I < 4; ++I) out[24 + 3 * I + i] = tilt;
    }
  }
};

}  // namespace mortise
