// The mixed displacement-pressure element: for materials that hardly change their volume, or do not change it at all.
#pragma once

#include "physics/formulations/formulation.hpp"
#include "physics/materials/invariants.hpp"

namespace mortise {

/// Displacements of `E`, and `n` discontinuous pressures per element: constant (n = 1: Q1P0), or linear in X (n = 4: Q2P1).
///   Pi = int W_iso(F) - p (J - 1) - p^2 / (2 kappa) dV,  stationary in q and p;  p > 0 in compression [Pa]
/// (perturbed Lagrangian; thesis eq. 3.95 with 3.111-3.129 for 1/kappa = 0). Nothing is divided by kappa's inverse, so exact
/// incompressibility is no special case. The pressure modes are orthogonal on the reference element: a pressure is coupled
/// with positions and itself only.
template <class E, int n>
struct Mixed {
  using Element = E;
  static constexpr int n_pressures = n, n_local = 0;
  static_assert(n == 1 || n == 4);

  struct Geometry : ElementGeometry<E> {
    double mode[ElementGeometry<E>::n_points][n];  ///< pressure modes at the points, of mean square 1
  };

  static Geometry geometry(const ElementNodes<E>& X) {
    Geometry geometry{reference_geometry<E>(X), {}};
    for (int g = 0; g < geometry.n_points; ++g) {
      geometry.mode[g][0] = 1;
      for (int m = 1; m < n; ++m) {  // the coordinate X_(m-1) at the point
        geometry.mode[g][m] = 0;
        for (int a = 0; a < E::n_nodes; ++a) geometry.mode[g][m] += E::N(a, E::stiffness_rule[g].xi) * X[a][m - 1];
      }
    }
    const double V = volume<E>(geometry);
    const auto mean_product = [&](int k, int m) {
      double sum = 0;
      for (int g = 0; g < geometry.n_points; ++g) sum += geometry.JxW[g] * geometry.mode[g][k] * geometry.mode[g][m];
      return sum / V;
    };
    for (int m = 1; m < n; ++m) {
      for (int pass = 0; pass < 2; ++pass)  // once more takes out the round-off of large coordinates
        for (int k = 0; k < m; ++k) {
          const double share = mean_product(k, m);
          for (int g = 0; g < geometry.n_points; ++g) geometry.mode[g][m] -= share * geometry.mode[g][k];
        }
      const double size = std::sqrt(mean_product(m, m));
      for (int g = 0; g < geometry.n_points; ++g) geometry.mode[g][m] /= size;
    }
    return geometry;
  }

  /// @param law of the distortional part; r_p = -int N_p (J - 1 + p / kappa) dV [m^3]
  template <class T, class Law>
  static bool add_residual(const Law& law, const Geometry& geometry, const T* y, T* r) {
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<T> F = deformation_gradient(geometry.grad_N[g], y), cof = cofactor(F);
      const T J = det(F), p = pressure(geometry, g, y);
      if (!(value(J) > 0)) return false;
      Tensor3<T> P = law.first_piola(F);
      add_scaled(P, T(-p), cof);
      add_divergence(P, geometry.grad_N[g], geometry.JxW[g], r);
      for (int m = 0; m < n; ++m)
        r[n_positions + m] -= geometry.JxW[g] * geometry.mode[g][m] * (J - 1.0 + law.volumetric_compliance() * p);
    }
    return true;
  }

  template <class Law>
  static bool add_tangent(const Law& law, const Geometry& geometry, const double* y, double* r, double* K) {
    constexpr int width = n_positions + n;
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], y), cof = cofactor(F);
      const double J = det(F), p = pressure(geometry, g, y), JxW = geometry.JxW[g];
      if (!(J > 0)) return false;
      Tensor3<double> P;
      double A[9][9];
      law.moduli(F, P, A);
      add_moduli_of_volume(F, -p, 0, P, A);
      add_divergence(P, geometry.grad_N[g], JxW, r);
      add_moduli(A, geometry.grad_N[g], JxW, K, width);
      double dJ[n_positions] = {};
      add_divergence(cof, geometry.grad_N[g], JxW, dJ);
      for (int m = 0; m < n; ++m) {
        const int row = n_positions + m;
        const double mode = geometry.mode[g][m];
        r[row] -= JxW * mode * (J - 1 + law.volumetric_compliance() * p);
        for (int k = 0; k < n_positions; ++k) K[k * width + row] -= mode * dJ[k];
        K[row * width + row] -= JxW * mode * mode * law.volumetric_compliance();  // the modes are orthogonal
      }
    }
    mirror(width, K, width);
    return true;
  }

  template <class Law>
  static double strain_energy(const Law& law, const Geometry& geometry, const double* y) {
    double energy = 0;
    for (int g = 0; g < Geometry::n_points; ++g)
      energy += geometry.JxW[g] * energy_density(law, deformation_gradient(geometry.grad_N[g], y), pressure(geometry, g, y));
    return energy;
  }

  template <class Law>
  static PointState point(const Law& law, const Geometry& geometry, int g, const double* y) {
    const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], y);
    const double p = pressure(geometry, g, y);
    PointState at{F, law.first_piola(F), energy_density(law, F, p)};
    add_scaled(at.P, -p, cofactor(F));
    return at;
  }

 private:
  static constexpr int n_positions = 3 * E::n_nodes;

  /// W_iso + p^2 / (2 kappa) [J/m^3]
  template <class Law>
  static double energy_density(const Law& law, const Tensor3<double>& F, double p) {
    return law.strain_energy(F) + 0.5 * law.volumetric_compliance() * p * p;
  }

  template <class T>
  static T pressure(const Geometry& geometry, int g, const T* y) {
    T p = geometry.mode[g][0] * y[n_positions];
    for (int m = 1; m < n; ++m) p += geometry.mode[g][m] * y[n_positions + m];
    return p;
  }
};

}  // namespace mortise
