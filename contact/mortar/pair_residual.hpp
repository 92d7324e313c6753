// What a pair of facets adds to the equations of frictionless mortar contact, once D and M are known.
#pragma once

#include <array>

#include "contact/mortar/planar.hpp"

namespace mortise {

/// Shares of one pair, reading `thesis` of the contact force (thesis eq. 4.123 without friction; conventions, section 5):
/// the variation of  sum_I p_I (n_I . g_I),  g_I = D_IJ x1_J - M_IK x2_K,  with D and M held.
template <class T>
struct PairShares {
  std::array<Vec3<T>, 8> force;  ///< residual share of each node [N]: p_I n_I D_IJ on the secondary, -p_I n_I M_IK on the primary
  std::array<Vec3<T>, 4> n_load;  ///< conjugate to the nodal normal: p_I g_I [N m]
  std::array<T, 4> weighted_gap;  ///< -n_I . g_I [m^3], positive when open
};

/// @param x 4 secondary, 4 primary nodes [m], best relative to the facet's centre  @param n unit nodal normals  @param p nodal
/// pressures [Pa]
template <class T>
PairShares<T> pair_shares(const std::array<Vec3<T>, 8>& x, const std::array<Vec3<T>, 4>& n, const std::array<T, 4>& p,
                          const MortarIntegrals<T>& integrals) {
  PairShares<T> out;
  for (auto& f : out.force) f = {T(0.0), T(0.0), T(0.0)};
  for (int I = 0; I < 4; ++I) {
    Vec3<T> g{T(0.0), T(0.0), T(0.0)};
    const Vec3<T> traction = p[I] * n[I];
    for (int J = 0; J < 4; ++J)
      for (int i = 0; i < 3; ++i) {
        g[i] += integrals.D[I][J] * x[J][i] - integrals.M[I][J] * x[4 + J][i];
        out.force[J][i] += integrals.D[I][J] * traction[i];
        out.force[4 + J][i] -= integrals.M[I][J] * traction[i];
      }
    out.weighted_gap[I] = -dot(n[I], g);
    out.n_load[I] = p[I] * g;
  }
  return out;
}

/// Turns the shares into those of the reading `interpolated normal`: the weighted gap counts along the interpolated nodal normal,
///   g_I = int N_I n_h . (x2_h - x1_h) da,   n_h = N_J n_J / |N_J n_J|  (Popp, Gitterle, Gee & Wall 2010),
/// and nothing acts on the normals, so that the forces' moment is that of the gap they leave out.
/// @param y in-plane coordinates as in `over_overlap`, in the same scalar  @param x, n as in `pair_shares`
template <class T>
void interpolate_normals(const T* y, const std::array<Vec3<T>, 8>& x, const std::array<Vec3<T>, 4>& n,
                         const std::vector<TrianglePoint>& rule, PairShares<T>& shares) {
  for (int I = 0; I < 4; ++I) {
    shares.n_load[I] = {T(0.0), T(0.0), T(0.0)};
    shares.weighted_gap[I] = 0.0;
  }
  over_overlap(y, rule, [&](const T& weight, const std::array<T, 4>& N1, const std::array<T, 4>& N2) {
    Vec3<T> jump{T(0.0), T(0.0), T(0.0)}, normal = jump;
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i) {
        jump[i] += N2[a] * x[4 + a][i] - N1[a] * x[a][i];
        normal[i] += N1[a] * n[a][i];
      }
    const T gap = weight * dot(normal, jump) / norm(normal);
    for (int I = 0; I < 4; ++I) shares.weighted_gap[I] += N1[I] * gap;
  });
}

}  // namespace mortise
