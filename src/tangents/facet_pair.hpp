// The residual of a facet pair with everything it depends on, over any scalar: without stages and closed forms.
#pragma once

#include "assembly/pair_tangent.hpp"

namespace mortise {

/// The shares of a facet pair in the shape of a formulation (physics/formulations/formulation.hpp), so that the element's ways to
/// differentiate serve here too. Unknowns: 24 positions [m], 12 components of normals, 4 pressures [Pa], as in `PairTangent`;
/// rows 40 to 43 are the covered areas [m^2], to which belong four unknowns that nothing depends on.
struct FacetPair {
  struct Element {
    static constexpr int n_nodes = 0;
  };
  static constexpr int n_pressures = 44, n_local = 0;

  /// @param rule takes the place of the law  @return false if the facets do not overlap
  template <class T>
  static bool add_residual(const std::vector<TrianglePoint>& rule, const FacetPair&, const T* y, T* r) {
    std::array<Vec3<T>, 8> x;
    std::array<Vec3<T>, 4> n;
    std::array<T, 4> p;
    for (int k = 0; k < 24; ++k) x[k / 3][k % 3] = y[k];
    for (int k = 0; k < 12; ++k) n[k / 3][k % 3] = y[24 + k];
    for (int I = 0; I < 4; ++I) p[I] = y[36 + I];
    // The plane of `AuxiliaryPlane`, with derivatives in all of it.
    const Vec3<T> centre = T(0.25) * ((x[0] + x[1]) + (x[2] + x[3])), sum = (n[0] + n[1]) + (n[2] + n[3]);
    const Vec3<T> up = T(1.0 / norm(sum)) * sum;
    int smallest = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(value(up[i])) < std::abs(value(up[smallest]))) smallest = i;
    Vec3<T> axis{T(0.0), T(0.0), T(0.0)};
    axis[smallest] = 1.0;
    const Vec3<T> side = cross(up, axis), t1 = T(1.0 / norm(side)) * side, t2 = cross(up, t1);
    T plane[16];
    for (int a = 0; a < 8; ++a) {
      x[a] = x[a] - centre;
      plane[2 * a] = dot(t1, x[a]);
      plane[2 * a + 1] = dot(t2, x[a]);
    }
    const auto integrals = planar_integrals(plane, rule);
    const auto shares = pair_shares(x, n, p, integrals);
    double area = 0;
    for (int I = 0; I < 4; ++I) {
      const T covered = integrals.D[I][0] + integrals.D[I][1] + integrals.D[I][2] + integrals.D[I][3];
      area += value(covered);
      for (int i = 0; i < 3; ++i) r[24 + 3 * I + i] += shares.n_load[I][i];
      r[36 + I] += shares.weighted_gap[I];
      r[40 + I] += covered;
    }
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) r[3 * a + i] += shares.force[a][i];
    return area > 0;
  }

  /// By the code that the solver uses. @return false if the facets do not overlap
  static bool add_tangent(const std::vector<TrianglePoint>& rule, const FacetPair&, const double* y, double* r, double* K) {
    PairInput input;
    for (int k = 0; k < 24; ++k) input.x[k / 3][k % 3] = y[k];
    for (int k = 0; k < 12; ++k) input.normal[k / 3][k % 3] = y[24 + k];
    for (int I = 0; I < 4; ++I) input.pressure[I] = y[36 + I];
    PairTangent tangent;
    if (!pair_tangent(input, rule, tangent)) return false;
    for (int k = 0; k < 40; ++k) {
      r[k] += tangent.row[k];
      for (int l = 0; l < 40; ++l) K[k * n_pressures + l] += tangent.d[k][l];
    }
    for (int I = 0; I < 4; ++I) {
      r[40 + I] += tangent.covered_area[I];
      for (int l = 0; l < 36; ++l) K[(40 + I) * n_pressures + l] += tangent.d_area[I][l];
    }
    return true;
  }
};

}  // namespace mortise
