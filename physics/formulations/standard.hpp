// The displacement element: the deformation gradient is that of the shape functions.
#pragma once

#include "physics/formulations/formulation.hpp"

namespace mortise {

/// Isoparametric displacement element (thesis section 4, eq. 4.9-4.15).
template <class E>
struct Standard {
  using Element = E;
  using Geometry = ElementGeometry<E>;
  static constexpr int n_pressures = 0, n_local = 0;

  static Geometry geometry(const ElementNodes<E>& X) { return reference_geometry<E>(X); }

  template <class T, class Law>
  static bool add_residual(const Law& law, const Geometry& geometry, const T* y, T* r) {
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<T> F = deformation_gradient(geometry.grad_N[g], y);
      if (!(value(det(F)) > 0)) return false;
      add_divergence(law.first_piola(F), geometry.grad_N[g], geometry.JxW[g], r);
    }
    return true;
  }

  template <class Law>
  static bool add_tangent(const Law& law, const Geometry& geometry, const double* y, double* r, double* K) {
    constexpr int n = 3 * E::n_nodes;
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], y);
      if (!(det(F) > 0)) return false;
      Tensor3<double> P;
      double A[9][9];
      law.moduli(F, P, A);
      add_divergence(P, geometry.grad_N[g], geometry.JxW[g], r);
      add_moduli(A, geometry.grad_N[g], geometry.JxW[g], K, n);
    }
    mirror(n, K, n);
    return true;
  }

  template <class Law>
  static double strain_energy(const Law& law, const Geometry& geometry, const double* y) {
    double energy = 0;
    for (int g = 0; g < Geometry::n_points; ++g)
      energy += geometry.JxW[g] * law.strain_energy(deformation_gradient(geometry.grad_N[g], y));
    return energy;
  }

  template <class Law>
  static PointState point(const Law& law, const Geometry& geometry, int g, const double* y) {
    const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], y);
    return {F, law.first_piola(F), law.strain_energy(F)};
  }
};

}  // namespace mortise
