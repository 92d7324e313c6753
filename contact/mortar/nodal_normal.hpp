// Averaged nodal normals of a surface, and the force that arises because they turn with it.
#pragma once

#include <array>
#include <vector>

#include "physics/tensor.hpp"

namespace mortise {

/// The facets round a node: for each, the positions (in the list of patch nodes) of the next and previous node around that facet.
struct NodePatch {
  std::vector<int> nodes;                   ///< patch nodes; the node itself is nodes[0]
  std::vector<std::array<int, 2>> corners;  ///< per facet: next, previous (indices into `nodes`)
};

/// Cross product of the two edges that leave the node in one facet; its direction is the facet's normal at the node.
template <class T>
Vec3<T> corner_normal(const std::vector<Vec3<T>>& x, const std::array<int, 2>& corner) {
  return cross(Vec3<T>(x[corner[0]] - x[0]), Vec3<T>(x[corner[1]] - x[0]));
}

/// Unit nodal normal: mean of the facets' unit normals at the node, made a unit vector (thesis section 4.2; Popp et al. 2010).
/// @param x positions of the patch nodes [m]
template <class T>
Vec3<T> nodal_normal(const NodePatch& patch, const std::vector<Vec3<T>>& x) {
  Vec3<T> sum{T(0.0), T(0.0), T(0.0)};
  for (const auto& corner : patch.corners) {
    const Vec3<T> c = corner_normal(x, corner);
    sum = sum + T(1.0 / norm(c)) * c;
  }
  return T(1.0 / norm(sum)) * sum;
}

/// (dn/dx)^T b for every patch node: the nodal force that belongs to a load b on the normal, written once for values (b a unit
/// vector gives a row of dn/dx) and for AD types (gives the second derivative of the normal).
/// @param b load on the normal  @param force one vector per patch node, overwritten
template <class T>
void normal_pull_back(const NodePatch& patch, const std::vector<Vec3<T>>& x, const Vec3<T>& b, std::vector<Vec3<T>>& force) {
  Vec3<T> sum{T(0.0), T(0.0), T(0.0)};
  for (const auto& corner : patch.corners) {
    const Vec3<T> c = corner_normal(x, corner);
    sum = sum + T(1.0 / norm(c)) * c;
  }
  const T length = norm(sum);
  const Vec3<T> n = T(1.0 / length) * sum;
  const Vec3<T> on_sum = T(1.0 / length) * (b - T(dot(n, b)) * n);
  force.assign(x.size(), Vec3<T>{T(0.0), T(0.0), T(0.0)});
  for (const auto& corner : patch.corners) {
    const Vec3<T> c = corner_normal(x, corner);
    const T size = norm(c);
    const Vec3<T> m = T(1.0 / size) * c;
    const Vec3<T> on_c = T(1.0 / size) * (on_sum - T(dot(m, on_sum)) * m);
    // c = e1 x e2:  dc . b = de1 . (e2 x b) + de2 . (b x e1)
    const Vec3<T> e1 = x[corner[0]] - x[0], e2 = x[corner[1]] - x[0];
    const Vec3<T> f1 = cross(e2, on_c), f2 = cross(on_c, e1);
    force[corner[0]] = force[corner[0]] + f1;
    force[corner[1]] = force[corner[1]] + f2;
    force[0] = force[0] - (f1 + f2);
  }
}

}  // namespace mortise
