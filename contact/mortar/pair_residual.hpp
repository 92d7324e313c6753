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

}  // namespace mortise
