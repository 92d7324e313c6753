// A side under a follower load in the shape of a formulation, so that the element's ways to differentiate serve it too.
#pragma once

#include "assembly/element_tangent.hpp"
#include "physics/surface_load.hpp"

namespace mortise {

/// What loads a side: values at the points of its rule [Pa], a pressure as the first component.
struct SideLoad {
  bool is_pressure;
  const Vec3<double>* values;
};

/// Unknowns are the positions of the side's nodes; the load takes the place of the law.
template <class Side>
struct FollowerSide {
  using Element = Side;
  static constexpr int n_pressures = 0, n_local = 0, n = 3 * Side::n_nodes;

  /// Adds -f_ext [N].
  template <class T>
  static bool add_residual(const SideLoad& load, const FollowerSide&, const T* y, T* r) {
    SidePositions<Side, T> x;
    for (int k = 0; k < n; ++k) x[k / 3][k % 3] = y[k];
    T f[n];
    std::fill_n(f, n, T(0.0));
    if (load.is_pressure) {
      AtSidePoints<Side, double> pressure;
      for (std::size_t g = 0; g < pressure.size(); ++g) pressure[g] = load.values[g][0];
      add_pressure_force<Side>(x, pressure, f);
    } else {
      AtSidePoints<Side, Vec3<double>> traction;
      std::copy_n(load.values, traction.size(), traction.begin());
      add_traction_force<Side>(x, traction, f);
    }
    for (int k = 0; k < n; ++k) r[k] -= f[k];
    return true;
  }

  static bool add_tangent(const SideLoad& load, const FollowerSide& side, const double* y, double* r, double* K) {
    return whole_element_tangent<FollowerSide>(load, side, y, r, K);
  }
};

}  // namespace mortise
