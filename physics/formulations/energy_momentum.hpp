// The displacement element of energy-momentum schemes: its forces belong to a step, not to a state.
#pragma once

#include "physics/algorithmic_stress.hpp"
#include "physics/formulations/standard.hpp"

namespace mortise {

/// Counterpart of `Standard` over a time step (thesis eqs. 5.61, 5.62):  f_a = int P* grad_N_a dV,  so that
///   f . (q - q_n) = V(q) - V(q_n),   sum_a f_a = 0,   sum_a (q_a + q_n,a)/2 x f_a = 0
/// for steps of any size. K = df/dq is not symmetric. Where a formulation has a law it has a law `Since` the start of the step.
template <class E>
struct EnergyMomentum {
  using Element = E;
  using Geometry = typename Standard<E>::Geometry;
  static constexpr int n_pressures = 0, n_local = 0;

  static Geometry geometry(const ElementNodes<E>& X) { return reference_geometry<E>(X); }

  /// An objective law, and where the step began.
  template <class Law>
  struct Since {
    const Law& law;
    const double* y_n;  ///< nodal positions at the start of the step [m], n x 3; an admissible state
  };

  /// Adds the forces [N]. @param y positions at the end of the step [m]
  /// @return false where det F <= 0 at the end of the step, or half-way, as after half a turn in one step
  template <class T, class Law>
  static bool add_residual(const Since<Law>& since, const Geometry& geometry, const T* y, T* r) {
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<double> F_n = deformation_gradient(geometry.grad_N[g], since.y_n);
      const Tensor3<T> F = deformation_gradient(geometry.grad_N[g], y);
      if (!is_admissible(F_n, values(F))) return false;
      add_divergence(algorithmic_first_piola(since.law, F_n, F), geometry.grad_N[g], geometry.JxW[g], r);
    }
    return true;
  }

  /// Adds forces [N] and K = df/dq [N/m], all of it.
  template <class Law>
  static bool add_tangent(const Since<Law>& since, const Geometry& geometry, const double* y, double* r, double* K) {
    UnsymmetricStiffness<E::n_nodes> stiffness;
    for (int g = 0; g < Geometry::n_points; ++g) {
      const Tensor3<double> F_n = deformation_gradient(geometry.grad_N[g], since.y_n);
      const Tensor3<double> F = deformation_gradient(geometry.grad_N[g], y);
      if (!is_admissible(F_n, F)) return false;
      Tensor3<double> P;
      double A[9][9];
      algorithmic_moduli(since.law, F_n, F, P, A);
      add_divergence(P, geometry.grad_N[g], geometry.JxW[g], r);
      stiffness.add(A, geometry.grad_N[g], geometry.JxW[g]);
    }
    stiffness.add_to(K, 3 * E::n_nodes);
    return true;
  }

 private:
  static bool is_admissible(const Tensor3<double>& F_n, const Tensor3<double>& F) { return det(F) > 0 && det(sum(F_n, F)) > 0; }
};

}  // namespace mortise
