// The tangent of an element by every route: two levels of automatic differentiation, complex step, differences.
#pragma once

#include <Sacado.hpp>
#include <algorithm>
#include <complex>
#include <limits>

#include "assembly/tangent_kind.hpp"
#include "physics/formulations/formulation.hpp"

namespace mortise {

/// Adds r(y) and K = dr/dy, (all x all) row-major, by AD of the whole residual, at most 24 directions at a time.
template <class Formulation, class Law, class Geometry>
bool whole_element_tangent(const Law& law, const Geometry& geometry, const double* y, double* r, double* K) {
  constexpr int n = Count<Formulation>::all, chunk = n < 24 ? n : 24;
  using Fad = Sacado::Fad::SFad<double, chunk>;
  for (int first = 0; first < n; first += chunk) {
    const int n_seeds = std::min(chunk, n - first);
    Fad y_ad[n], r_ad[n];
    for (int k = 0; k < n; ++k) {
      y_ad[k] = y[k];
      r_ad[k] = 0.0;
    }
    for (int s = 0; s < n_seeds; ++s) y_ad[first + s].fastAccessDx(s) = 1;
    if (!Formulation::add_residual(law, geometry, y_ad, r_ad)) return false;
    for (int k = 0; k < n; ++k) {
      if (first == 0) r[k] += r_ad[k].val();
      for (int s = 0; s < n_seeds; ++s) K[k * n + first + s] += r_ad[k].fastAccessDx(s);
    }
  }
  return true;
}

/// The same by complex step (thesis eq. D.5): Im r(y + i h) / h, exact to round-off for any small h = `relative_step` x scale.
template <class Formulation, class Law, class Geometry>
bool complex_step_tangent(const Law& law, const Geometry& geometry, double relative_step, const double* y, const double* scale,
                          double* r, double* K) {
  constexpr int n = Count<Formulation>::all;
  if (!Formulation::add_residual(law, geometry, y, r)) return false;
  for (int l = 0; l < n; ++l) {
    const double h = relative_step * scale[l];
    std::complex<double> y_c[n], r_c[n];
    std::copy(y, y + n, y_c);
    y_c[l] += std::complex<double>(0, h);
    if (!Formulation::add_residual(law, geometry, y_c, r_c)) return false;
    for (int k = 0; k < n; ++k) K[k * n + l] += r_c[k].imag() / h;
  }
  return true;
}

/// The same by differences of first or second order (thesis eq. D.1-D.4) with steps `relative_step` x scale.
template <class Formulation, class Law, class Geometry>
bool difference_tangent(const Law& law, const Geometry& geometry, TangentKind kind, double relative_step, const double* y,
                        const double* scale, double* r, double* K) {
  constexpr int n = Count<Formulation>::all;
  double here[n] = {};
  if (!Formulation::add_residual(law, geometry, y, here)) return false;
  for (int k = 0; k < n; ++k) r[k] += here[k];
  const bool looks_ahead = kind != TangentKind::backward_differences, looks_behind = kind != TangentKind::forward_differences;
  const double steps = looks_ahead && looks_behind ? 2 : 1;
  for (int l = 0; l < n; ++l) {
    const double h = relative_step * scale[l];
    double y_h[n], plus[n] = {}, minus[n] = {};
    std::copy(y, y + n, y_h);
    y_h[l] = y[l] + h;
    if (looks_ahead && !Formulation::add_residual(law, geometry, y_h, plus)) return false;
    y_h[l] = y[l] - h;
    if (looks_behind && !Formulation::add_residual(law, geometry, y_h, minus)) return false;
    for (int k = 0; k < n; ++k)
      K[k * n + l] += ((looks_ahead ? plus[k] : here[k]) - (looks_behind ? minus[k] : here[k])) / (steps * h);
  }
  return true;
}

/// The step, relative to the scale of an unknown: for differences where truncation and round-off balance, for the complex step
/// where truncation is below any round-off.
inline double best_step(TangentKind kind) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  if (kind == TangentKind::complex_step) return 1e-30;
  return kind == TangentKind::central_differences ? std::cbrt(eps) : std::sqrt(eps);
}

/// Whether a kind takes steps, whose lengths are relative to scales.
inline bool takes_steps(TangentKind kind) {
  return kind != TangentKind::quadrature_point && kind != TangentKind::analytic && kind != TangentKind::whole_element;
}

/// r and K by any kind; both are added to.
/// @param relative_step  of kinds that take steps  @param scale size of each unknown; likewise
/// @return false for an inadmissible state
template <class Formulation, class Law, class Geometry>
bool element_tangent(TangentKind kind, double relative_step, const Law& law, const Geometry& geometry, const double* y,
                     const double* scale, double* r, double* K) {
  switch (kind) {
    case TangentKind::quadrature_point:
    case TangentKind::analytic:  // the law knows which
      return Formulation::add_tangent(law, geometry, y, r, K);
    case TangentKind::whole_element:
      return whole_element_tangent<Formulation>(law, geometry, y, r, K);
    case TangentKind::complex_step:
      return complex_step_tangent<Formulation>(law, geometry, relative_step, y, scale, r, K);
    default:
      return difference_tangent<Formulation>(law, geometry, kind, relative_step, y, scale, r, K);
  }
}

}  // namespace mortise
