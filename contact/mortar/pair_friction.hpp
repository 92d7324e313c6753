// What a pair of facets adds to the equations of frictional mortar contact, once D and M are known.
#pragma once

#include <array>

#include "contact/mortar/planar.hpp"

namespace mortise {

/// Shares of one pair in friction.
template <class T>
struct FrictionShares {
  std::array<Vec3<T>, 8> force;  ///< residual share of each node [N]
  std::array<Vec3<T>, 4> slip;   ///< weighted slip of the step at each secondary node [m^3]
};

/// Inverse times vector for a symmetric tensor of full rank.
template <class T>
Vec3<T> solve_symmetric(const Tensor3<T>& A, const Vec3<T>& b) {
  const Tensor3<T> C = cofactor(A);
  const T d = 1.0 / det(A);
  Vec3<T> x;
  for (int i = 0; i < 3; ++i) x[i] = d * (C(0, i) * b[0] + C(1, i) * b[1] + C(2, i) * b[2]);
  return x;
}

/// Slip s_I = P_I (D_IJ dx1_J - M_IK dx2_K) with P_I = I - n_I n_I (thesis eq. 5.124) and the force that is conjugate to it,
/// f . dx = -t_I . s_I in the sense of the residual.
/// `moment_free`: the spin of the eight nodes is taken out of the slip, P_I (... - w x g_I) with g_I = D_IJ x1_J - M_IK x2_K and
/// w the least-squares spin of dx about their mean, and the conjugate force has no moment: objective for finite rotations, for
/// any D and M, where all stands at the middle of the step.
/// @param x 4 secondary, 4 primary nodes [m], best relative to the facet's centre  @param dx their motion in the step [m]
/// @param n unit nodal normals  @param t tractions on the secondary surface that act in the step [Pa]
template <class T>
FrictionShares<T> friction_shares(const std::array<Vec3<T>, 8>& x, const std::array<Vec3<T>, 8>& dx,
                                  const std::array<Vec3<T>, 4>& n, const std::array<Vec3<T>, 4>& t,
                                  const MortarIntegrals<T>& integrals, bool moment_free) {
  const Vec3<T> zero{T(0.0), T(0.0), T(0.0)};
  const auto tangential = [](const Vec3<T>& normal, const Vec3<T>& v) { return v - T(dot(normal, v)) * normal; };
  const auto weighted = [&](int I, const std::array<Vec3<T>, 8>& of) {
    Vec3<T> sum = zero;
    for (int J = 0; J < 4; ++J)
      for (int i = 0; i < 3; ++i) sum[i] += integrals.D[I][J] * of[J][i] - integrals.M[I][J] * of[4 + J][i];
    return sum;
  };
  FrictionShares<T> out;
  out.force.fill(zero);
  std::array<Vec3<T>, 4> pull;
  for (int I = 0; I < 4; ++I) {
    pull[I] = tangential(n[I], t[I]);
    out.slip[I] = weighted(I, dx);
    for (int J = 0; J < 4; ++J)
      for (int i = 0; i < 3; ++i) {
        out.force[J][i] -= integrals.D[I][J] * pull[I][i];
        out.force[4 + J][i] += integrals.M[I][J] * pull[I][i];
      }
  }
  if (moment_free) {
    Vec3<T> mean = zero, turning = zero, moment = zero;
    for (const auto& a : x) mean = mean + T(0.125) * a;
    std::array<Vec3<T>, 8> arm;
    Tensor3<T> inertia{};
    for (auto& row : inertia.a)
      for (T& entry : row) entry = 0.0;
    for (int a = 0; a < 8; ++a) {
      arm[a] = x[a] - mean;
      turning = turning + cross(arm[a], dx[a]);
      const T square = dot(arm[a], arm[a]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inertia(i, j) += (i == j ? square : T(0.0)) - arm[a][i] * arm[a][j];
    }
    const Vec3<T> spin = solve_symmetric(inertia, turning);
    for (int I = 0; I < 4; ++I) {
      const Vec3<T> g = weighted(I, x);
      out.slip[I] = out.slip[I] - cross(spin, g);
      moment = moment + cross(g, pull[I]);
    }
    const Vec3<T> couple = solve_symmetric(inertia, moment);
    for (int a = 0; a < 8; ++a) out.force[a] = out.force[a] + cross(couple, arm[a]);
  }
  for (int I = 0; I < 4; ++I) out.slip[I] = tangential(n[I], out.slip[I]);
  return out;
}

}  // namespace mortise
