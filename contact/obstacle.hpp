// Rigid obstacles that nodes meet: gap, its gradient, and the gradient over a step that keeps the energy.
#pragma once

#include <variant>

#include "physics/tensor.hpp"

namespace mortise {

namespace shapes {

/// The half-space behind a plane.
struct Plane {
  Vec3<double> point;   ///< [m]
  Vec3<double> normal;  ///< unit length, towards where nodes may be

  template <class T>
  T gap(const Vec3<T>& q) const {
    return normal[0] * (q[0] - point[0]) + normal[1] * (q[1] - point[1]) + normal[2] * (q[2] - point[2]);
  }
  template <class T>
  Vec3<T> gradient(const Vec3<T>&) const {
    return {T(normal[0]), T(normal[1]), T(normal[2])};
  }
  template <class T>
  Vec3<T> discrete_gradient(const Vec3<double>&, const Vec3<T>& q_mid) const {
    return gradient(q_mid);
  }
};

/// A ball; with the sign of a gap, the distance from its surface. As a two-sided constraint: a rod from its centre.
struct Sphere {
  Vec3<double> centre;  ///< [m]
  double radius;        ///< [m]

  template <class T>
  T gap(const Vec3<T>& q) const {
    return norm(arm(q)) - radius;
  }
  template <class T>
  Vec3<T> gradient(const Vec3<T>& q) const {
    const Vec3<T> r = arm(q);
    return T(1.0 / norm(r)) * r;
  }
  /// G-equivariant discrete gradient in the invariant pi = |q - c|^2 (Gonzalez 1999; thesis eq. 5.97): with the gap sqrt(pi) - r
  /// its quotient of differences is 1 / (sqrt(pi_{n+1}) + sqrt(pi_n)), without cancellation.
  template <class T>
  Vec3<T> discrete_gradient(const Vec3<double>& q_n, const Vec3<T>& q_mid) const {
    const Vec3<T> r_mid = arm(q_mid), r_n = arm(Vec3<T>{T(q_n[0]), T(q_n[1]), T(q_n[2])}), r_end = T(2.0) * r_mid - r_n;
    return T(2.0 / (norm(r_n) + norm(r_end))) * r_mid;
  }

 private:
  template <class T>
  Vec3<T> arm(const Vec3<T>& q) const {
    return {T(q[0] - centre[0]), T(q[1] - centre[1]), T(q[2] - centre[2])};
  }
};

}  // namespace shapes

using ObstacleShape = std::variant<shapes::Plane, shapes::Sphere>;

}  // namespace mortise
