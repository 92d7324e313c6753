// The F-bar element: the volumetric part of the deformation gradient is the element's mean, so that it does not lock.
#pragma once

#include "physics/formulations/formulation.hpp"
#include "physics/materials/invariants.hpp"

namespace mortise {

/// Displacement element that sees Fbar = (theta / J)^(1/3) F, theta = (current volume) / (reference volume) of the element.
///   Pi = sum_g W(Fbar_g) JxW_g
/// The mean-dilatation form (Nagtegaal, Parks & Rice 1974; Moran, Ortiz & Shih 1990) of F-bar (de Souza Neto et al. 1996), which
/// takes J at the centre for theta: the mean gives a symmetric tangent, an energy, and the patch test on distorted bricks.
template <class E>
struct FBar {
  using Element = E;
  using Geometry = ElementGeometry<E>;
  static constexpr int n_pressures = 0, n_local = 0;

  static Geometry geometry(const ElementNodes<E>& X) { return reference_geometry<E>(X); }

  template <class T, class Law>
  static bool add_residual(const Law& law, const Geometry& geometry, const T* y, T* r) {
    Points<T> points;
    if (!kinematics(geometry, y, points)) return false;
    T slope = 0.0;  // dPi/dtheta
    std::array<Tensor3<T>, n_points> P;
    for (int g = 0; g < n_points; ++g) {
      const Tensor3<T> F_bar = scaled(points.scale[g], points.F[g]), P_bar = law.first_piola(F_bar);
      const T s = double_dot(P_bar, F_bar);
      slope += geometry.JxW[g] * s / (3.0 * points.theta);
      for (int k = 0; k < 9; ++k)
        P[g](k / 3, k % 3) = points.scale[g] * P_bar(k / 3, k % 3) - s / (3.0 * points.J[g]) * points.cof[g](k / 3, k % 3);
    }
    const T share = slope / volume(geometry);  // theta is the mean of J, and dJ/dF = cof F
    for (int g = 0; g < n_points; ++g) {
      add_scaled(P[g], share, points.cof[g]);
      add_divergence(P[g], geometry.grad_N[g], geometry.JxW[g], r);
    }
    return true;
  }

  template <class Law>
  static bool add_tangent(const Law& law, const Geometry& geometry, const double* y, double* r, double* K) {
    constexpr int n = 3 * E::n_nodes;
    Points<double> points;
    if (!kinematics(geometry, y, points)) return false;
    const double theta = points.theta, V = volume(geometry);
    struct {
      Tensor3<double> P, b;  // dW/dF at held theta, and its derivative by theta
      double A[9][9], c;     // derivative by F at held theta, and d2W/dtheta2
    } at[n_points];
    double slope = 0;
    for (int g = 0; g < n_points; ++g) {
      const double scale = points.scale[g];
      const Tensor3<double> F_bar = scaled(scale, points.F[g]), H = scaled(1.0 / points.J[g], points.cof[g]);
      Tensor3<double> P_bar;
      double A_bar[9][9];
      law.moduli(F_bar, P_bar, A_bar);
      Tensor3<double> B;  // A_bar : F_bar + P_bar
      for (int k = 0; k < 9; ++k) {
        B(k / 3, k % 3) = P_bar(k / 3, k % 3);
        for (int l = 0; l < 9; ++l) B(k / 3, k % 3) += A_bar[k][l] * F_bar(l / 3, l % 3);
      }
      const double s = double_dot(P_bar, F_bar), E_s = double_dot(B, F_bar);
      slope += geometry.JxW[g] * s / (3 * theta);
      for (int k = 0; k < 9; ++k) {
        const int i = k / 3, J = k % 3;
        at[g].P(i, J) = scale * P_bar(i, J) - s / 3 * H(i, J);
        at[g].b(i, J) = (scale / 3 * B(i, J) - E_s / 9 * H(i, J)) / theta;
        for (int l = 0; l < 9; ++l) {
          const int m = l / 3, L = l % 3;
          at[g].A[k][l] = scale * scale * A_bar[k][l] - scale / 3 * (B(i, J) * H(m, L) + H(i, J) * B(m, L)) +
                          E_s / 9 * H(i, J) * H(m, L) + s / 3 * H(i, L) * H(m, J);
        }
      }
      at[g].c = (E_s - 3 * s) / (9 * theta * theta);
    }
    double d_theta[n] = {}, d_slope[n] = {}, c = 0;  // d_slope at held theta
    for (int g = 0; g < n_points; ++g) {
      add_moduli_of_volume(points.F[g], slope / V, 0, at[g].P, at[g].A);
      add_divergence(at[g].P, geometry.grad_N[g], geometry.JxW[g], r);
      add_moduli(at[g].A, geometry.grad_N[g], geometry.JxW[g], K, n);
      add_divergence(points.cof[g], geometry.grad_N[g], geometry.JxW[g] / V, d_theta);
      add_divergence(at[g].b, geometry.grad_N[g], geometry.JxW[g], d_slope);
      c += geometry.JxW[g] * at[g].c;
    }
    for (int k = 0; k < n; ++k)
      for (int l = k; l < n; ++l) K[k * n + l] += d_slope[k] * d_theta[l] + d_theta[k] * d_slope[l] + c * d_theta[k] * d_theta[l];
    mirror(n, K, n);
    return true;
  }

  template <class Law>
  static double strain_energy(const Law& law, const Geometry& geometry, const double* y) {
    Points<double> points;
    kinematics(geometry, y, points);
    double energy = 0;
    for (int g = 0; g < n_points; ++g) energy += geometry.JxW[g] * law.strain_energy(scaled(points.scale[g], points.F[g]));
    return energy;
  }

  template <class Law>
  static PointState point(const Law& law, const Geometry& geometry, int g, const double* y) {
    Points<double> points;
    kinematics(geometry, y, points);
    const Tensor3<double> F_bar = scaled(points.scale[g], points.F[g]);
    return {F_bar, law.first_piola(F_bar), law.strain_energy(F_bar)};
  }

 private:
  static constexpr int n_points = Geometry::n_points;

  template <class T>
  struct Points {
    std::array<Tensor3<T>, n_points> F, cof;
    std::array<T, n_points> J, scale;  ///< det F, (theta / J)^(1/3)
    T theta;
  };

  template <class T>
  static bool kinematics(const Geometry& geometry, const T* y, Points<T>& points) {
    using std::pow;
    points.theta = 0.0;
    for (int g = 0; g < n_points; ++g) {
      points.F[g] = deformation_gradient(geometry.grad_N[g], y);
      points.cof[g] = cofactor(points.F[g]);
      points.J[g] = det(points.F[g]);
      if (!(value(points.J[g]) > 0)) return false;
      points.theta += geometry.JxW[g] * points.J[g];
    }
    points.theta /= volume(geometry);
    for (int g = 0; g < n_points; ++g) points.scale[g] = pow(points.theta / points.J[g], 1.0 / 3.0);
    return true;
  }
};

}  // namespace mortise
