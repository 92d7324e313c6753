// The enhanced-strain element: a displacement element whose gradients bend by unknowns of its own, so that it does not lock.
#pragma once

#include "physics/elements/hexahedra.hpp"
#include "physics/formulations/formulation.hpp"

namespace mortise {

/// Enhanced assumed strain for large deformation (Simo & Armero 1992; frame-indifferent form of Glaser & Armero 1997):
///   Ftilde = F + F_0 M,   M = sum_k alpha_k M_k,   Pi = sum_g W(Ftilde_g) JxW_g,  stationary in q and alpha,
/// F_0 = F at the centre. M_k, k = 3 K + I, is the gradient of an incompatible displacement along the side K that is quadratic in
/// the local coordinate I, scaled by (det at the centre) / (det at the point): its mean over the element is zero, which is the
/// patch test. Since F = sum_a q_a (x) grad_N_a, the enhancement changes gradients: grad_N_a + M^T grad_N_a(centre).
/// Under strong compression it may show hourglass modes (Wriggers & Reese 1996), as all elements of this kind.
template <class E>
struct Enhanced {
  using Element = E;
  static constexpr int n_pressures = 0, n_local = 9;

  struct Geometry : ElementGeometry<E> {
    double centre[E::n_nodes][3];                                 ///< grad_N at the centre [1/m]
    Tensor3<double> mode[ElementGeometry<E>::n_points][n_local];  ///< M_k [-]
  };

  static Geometry geometry(const ElementNodes<E>& X) {
    Geometry geometry{reference_geometry<E>(X), {}, {}};
    const std::array<double, 3> centre{0, 0, 0};
    const double J_0 = reference_gradients<E>(X, centre, geometry.centre);
    const Tensor3<double> side = element_map<E>(X, centre), dual = cofactor(side);  // columns; grad xi_I = dual(:, I) / J_0
    for (int g = 0; g < Geometry::n_points; ++g) {
      const auto& point = E::stiffness_rule[g];
      const double scale = point.weight / geometry.JxW[g];  // J_0 is cancelled by that of grad xi
      for (int k = 0; k < n_local; ++k)
        for (int r = 0; r < 9; ++r)
          geometry.mode[g][k](r / 3, r % 3) = scale * side(r / 3, k / 3) * dual(r % 3, k % 3) * point.xi[k % 3];
    }
    assert(J_0 > 0);
    return geometry;
  }

  template <class T, class Law>
  static bool add_residual(const Law& law, const Geometry& geometry, const T* y, T* r) {
    const Tensor3<T> F_0 = deformation_gradient(geometry.centre, y);
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<T> M = enhancement(geometry, g, y);
      const Tensor3<T> F = sum(deformation_gradient(geometry.grad_N[g], y), F_0 * M);
      if (!(value(det(F)) > 0)) return false;
      const Tensor3<T> P = law.first_piola(F);
      add_divergence(P, geometry.grad_N[g], geometry.JxW[g], r);
      add_divergence(times_transpose(P, M), geometry.centre, geometry.JxW[g], r);
      const Tensor3<T> on_modes = transpose_times(F_0, P);
      for (int k = 0; k < n_local; ++k)
        for (int l = 0; l < 9; ++l)
          r[n_positions + k] += geometry.JxW[g] * geometry.mode[g][k](l / 3, l % 3) * on_modes(l / 3, l % 3);
    }
    return true;
  }

  template <class Law>
  static bool add_tangent(const Law& law, const Geometry& geometry, const double* y, double* r, double* K) {
    constexpr int width = n_positions + n_local;
    const Tensor3<double> F_0 = deformation_gradient(geometry.centre, y);
    for (int g = 0; g < Geometry::n_points; ++g) {
      const double JxW = geometry.JxW[g];
      const Tensor3<double> M = enhancement(geometry, g, y);
      double grad_N[E::n_nodes][3];
      for (int a = 0; a < E::n_nodes; ++a)
        for (int J = 0; J < 3; ++J) {
          grad_N[a][J] = geometry.grad_N[g][a][J];
          for (int L = 0; L < 3; ++L) grad_N[a][J] += M(L, J) * geometry.centre[a][L];
        }
      const Tensor3<double> F = deformation_gradient(grad_N, y);
      if (!(det(F) > 0)) return false;
      Tensor3<double> P;
      double A[9][9];
      law.moduli(F, P, A);
      add_divergence(P, grad_N, JxW, r);
      add_moduli(A, grad_N, JxW, K, width);
      Tensor3<double> dF[n_local];  // dF/dalpha_k
      for (int k = 0; k < n_local; ++k) dF[k] = F_0 * geometry.mode[g][k];
      for (int k = 0; k < n_local; ++k) {
        Tensor3<double> dP{};  // A : dF_k
        for (int l = 0; l < 9; ++l)
          for (int m = 0; m < 9; ++m) dP(l / 3, l % 3) += A[l][m] * dF[k](m / 3, m % 3);
        r[n_positions + k] += JxW * double_dot(P, dF[k]);
        double column[n_positions] = {};
        add_divergence(dP, grad_N, JxW, column);
        add_divergence(times_transpose(P, geometry.mode[g][k]), geometry.centre, JxW, column);
        for (int a = 0; a < n_positions; ++a) K[a * width + n_positions + k] += column[a];
        for (int l = k; l < n_local; ++l) K[(n_positions + k) * width + n_positions + l] += JxW * double_dot(dP, dF[l]);
      }
    }
    mirror(width, K, width);
    return true;
  }

  template <class Law>
  static double strain_energy(const Law& law, const Geometry& geometry, const double* y) {
    double energy = 0;
    for (int g = 0; g < Geometry::n_points; ++g) energy += geometry.JxW[g] * law.strain_energy(enhanced(geometry, g, y));
    return energy;
  }

  template <class Law>
  static PointState point(const Law& law, const Geometry& geometry, int g, const double* y) {
    const Tensor3<double> F = enhanced(geometry, g, y);
    return {F, law.first_piola(F), law.strain_energy(F)};
  }

 private:
  static constexpr int n_positions = 3 * E::n_nodes;

  template <class T>
  static Tensor3<T> enhancement(const Geometry& geometry, int g, const T* y) {
    Tensor3<T> M;
    for (int l = 0; l < 9; ++l) {
      M(l / 3, l % 3) = 0.0;
      for (int k = 0; k < n_local; ++k) M(l / 3, l % 3) += y[n_positions + k] * geometry.mode[g][k](l / 3, l % 3);
    }
    return M;
  }

  static Tensor3<double> enhanced(const Geometry& geometry, int g, const double* y) {
    return sum(deformation_gradient(geometry.grad_N[g], y),
               deformation_gradient(geometry.centre, y) * enhancement(geometry, g, y));
  }
};

}  // namespace mortise
