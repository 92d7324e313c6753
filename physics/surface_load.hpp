// Forces on a side of an element over the area that it has now: traction of fixed direction, and pressure that follows the side.
#pragma once

#include "physics/traction.hpp"

namespace mortise {

template <class Side, class T>
using SidePositions = std::array<std::array<T, 3>, Side::n_nodes>;

/// A value at each point of the side's rule.
template <class Side, class Value>
using AtSidePoints = std::array<Value, Side::rule.size()>;

/// Adds the nodal forces [N] of a traction over the area that the positions `x` span (thesis eq. 4.17; with x = X: a dead load):
///   f_a = int N_a t |x,xi x x,eta| dxi
/// @param x positions of the nodes [m]  @param t traction [Pa] at the points of the rule  @param f 3 n_nodes values, node by node
/// Precondition: the side has not collapsed, x,xi x x,eta != 0.
template <class Side, class T>
void add_traction_force(const SidePositions<Side, T>& x, const AtSidePoints<Side, Vec3<double>>& t, T* f) {
  for (std::size_t g = 0; g < Side::rule.size(); ++g) {
    const auto& point = Side::rule[g];
    const auto [along, across] = side_tangents<Side>(x, point.xi);
    const T da = point.weight * norm(cross(along, across));
    for (int a = 0; a < Side::n_nodes; ++a)
      for (int i = 0; i < 3; ++i) f[3 * a + i] += Side::N(a, point.xi) * t[g][i] * da;
  }
}

/// Adds the nodal forces [N] of a pressure that follows the side, positive where it pushes against the outward normal:
///   f_a = -int N_a p (x,xi x x,eta) dxi
/// No square root: the area vector is a polynomial of the positions, so a collapsed side is no exception.
/// @param p pressure [Pa] at the points of the rule; the others as above
template <class Side, class T>
void add_pressure_force(const SidePositions<Side, T>& x, const AtSidePoints<Side, double>& p, T* f) {
  for (std::size_t g = 0; g < Side::rule.size(); ++g) {
    const auto& point = Side::rule[g];
    const auto [along, across] = side_tangents<Side>(x, point.xi);
    const Vec3<T> area = cross(along, across);
    for (int a = 0; a < Side::n_nodes; ++a)
      for (int i = 0; i < 3; ++i) f[3 * a + i] -= point.weight * Side::N(a, point.xi) * p[g] * area[i];
  }
}

/// Position [m] of the point at local coordinates xi of a side.
template <class Side>
std::array<double, 3> point_of_side(const SidePositions<Side, double>& X, const LocalPoint& xi) {
  std::array<double, 3> point{};
  for (int a = 0; a < Side::n_nodes; ++a)
    for (int i = 0; i < 3; ++i) point[i] += Side::N(a, xi) * X[a][i];
  return point;
}

/// S_ab = int N_a N_b dA [m^2] over the reference side, n x n row-major: times a bedding modulus the stiffness of an elastic
/// bedding. Positive definite, unlike lumped weights, which vanish or change sign at corners of quadratic sides.
template <class Side>
std::array<double, Side::n_nodes * Side::n_nodes> side_mass_matrix(const SidePositions<Side, double>& X) {
  std::array<double, Side::n_nodes * Side::n_nodes> S{};
  for (const auto& point : Side::rule) {
    const auto [along, across] = side_tangents<Side>(X, point.xi);
    const double dA = point.weight * norm(cross(along, across));
    for (int a = 0; a < Side::n_nodes; ++a)
      for (int b = 0; b < Side::n_nodes; ++b) S[a * Side::n_nodes + b] += Side::N(a, point.xi) * Side::N(b, point.xi) * dA;
  }
  return S;
}

}  // namespace mortise
