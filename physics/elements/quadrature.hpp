// Quadrature rules on the reference shapes: tensor products of Gauss rules, and symmetric rules on triangle and tetrahedron.
#pragma once

#include <array>

namespace mortise {

/// A point of a rule: local coordinates, and the weight in the measure of the reference shape.
struct QuadraturePoint {
  std::array<double, 3> xi;
  double weight;
};

template <int n>
using QuadratureRule = std::array<QuadraturePoint, n>;

/// Gauss rule on [-1, 1], exact to degree 2 n - 1, as (point, weight).
template <int n>
constexpr std::array<std::array<double, 2>, n> gauss() {
  static_assert(n >= 1 && n <= 4);
  if constexpr (n == 1) {
    return {{{0, 2}}};
  } else if constexpr (n == 2) {
    constexpr double r = 0.57735026918962576451;  // 1/sqrt(3)
    return {{{-r, 1}, {r, 1}}};
  } else if constexpr (n == 3) {
    constexpr double r = 0.77459666924148337704;  // sqrt(3/5)
    return {{{-r, 5. / 9}, {0, 8. / 9}, {r, 5. / 9}}};
  } else {
    constexpr double r = 0.33998104358485626480, s = 0.86113631159405257522;
    constexpr double a = 0.65214515486254614263, b = 0.34785484513745385737;
    return {{{-s, b}, {-r, a}, {r, a}, {s, b}}};
  }
}

/// n x n x n points on [-1, 1]^3, xi fastest.
template <int n>
constexpr QuadratureRule<n * n * n> hexahedron_rule() {
  QuadratureRule<n * n * n> rule{};
  const auto line = gauss<n>();
  for (int g = 0; g < n * n * n; ++g) {
    const auto &a = line[g % n], &b = line[g / n % n], &c = line[g / n / n];
    rule[g] = {{a[0], b[0], c[0]}, a[1] * b[1] * c[1]};
  }
  return rule;
}

/// n x n points on [-1, 1]^2.
template <int n>
constexpr QuadratureRule<n * n> quadrilateral_rule() {
  QuadratureRule<n * n> rule{};
  const auto line = gauss<n>();
  for (int g = 0; g < n * n; ++g) rule[g] = {{line[g % n][0], line[g / n][0], 0}, line[g % n][1] * line[g / n][1]};
  return rule;
}

/// Three points on the triangle (0,0), (1,0), (0,1): exact to degree 2.
constexpr QuadratureRule<3> triangle_rule_3() {
  constexpr double a = 1. / 6, b = 2. / 3;
  return {{{{a, a, 0}, a}, {{b, a, 0}, a}, {{a, b, 0}, a}}};
}

/// Six points on the triangle: exact to degree 4 (Dunavant 1985).
constexpr QuadratureRule<6> triangle_rule_6() {
  constexpr double a = 0.44594849091596488632, v = 0.5 * 0.22338158967801146570;
  constexpr double b = 0.09157621350977074346, w = 0.5 * 0.10995174365532186764;
  return {{{{a, a, 0}, v},
           {{1 - 2 * a, a, 0}, v},
           {{a, 1 - 2 * a, 0}, v},
           {{b, b, 0}, w},
           {{1 - 2 * b, b, 0}, w},
           {{b, 1 - 2 * b, 0}, w}}};
}

/// A rule of the triangle times a Gauss rule along [-1, 1].
template <int m, int n>
constexpr QuadratureRule<m * n> wedge_rule(const QuadratureRule<m>& triangle) {
  QuadratureRule<m * n> rule{};
  const auto line = gauss<n>();
  for (int g = 0; g < m * n; ++g) {
    const auto& p = triangle[g % m];
    rule[g] = {{p.xi[0], p.xi[1], line[g / m][0]}, p.weight * line[g / m][1]};
  }
  return rule;
}

/// The centroid of the tetrahedron (0,0,0), (1,0,0), (0,1,0), (0,0,1): exact to degree 1.
constexpr QuadratureRule<1> tetrahedron_rule_1() { return {{{{0.25, 0.25, 0.25}, 1. / 6}}}; }

/// Four points on the tetrahedron: exact to degree 2.
constexpr QuadratureRule<4> tetrahedron_rule_4() {
  constexpr double a = 0.13819660112501051518, b = 1 - 3 * a, w = 1. / 24;
  return {{{{a, a, a}, w}, {{b, a, a}, w}, {{a, b, a}, w}, {{a, a, b}, w}}};
}

/// Fourteen points on the tetrahedron: exact to degree 5 (Walkington 2000).
constexpr QuadratureRule<14> tetrahedron_rule_14() {
  QuadratureRule<14> rule{};
  int g = 0;
  constexpr double corner[2][2] = {{0.31088591926330060980, 0.01878132095300264180},
                                   {0.09273525031089122640, 0.01224884051939365826}};
  for (const auto& [a, w] : corner) {
    rule[g++] = {{a, a, a}, w};
    rule[g++] = {{1 - 3 * a, a, a}, w};
    rule[g++] = {{a, 1 - 3 * a, a}, w};
    rule[g++] = {{a, a, 1 - 3 * a}, w};
  }
  constexpr double a = 0.04550370412564964949, b = 0.5 - a, w = 0.00709100346284691107;
  rule[g++] = {{a, a, b}, w};
  rule[g++] = {{a, b, a}, w};
  rule[g++] = {{b, a, a}, w};
  rule[g++] = {{b, b, a}, w};
  rule[g++] = {{b, a, b}, w};
  rule[g++] = {{a, b, b}, w};
  return rule;
}

}  // namespace mortise
