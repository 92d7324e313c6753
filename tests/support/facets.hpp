// Facets for contact tests: flat meshes in space or in the plane, and random pairs.
#pragma once

#include <algorithm>
#include <vector>

#include "contact/clipping.hpp"
#include "contact/mortar/auxiliary_plane.hpp"
#include "support/random.hpp"

namespace mortise::test {

/// A mesh of quadrilaterals in the plane z = 0.
struct FlatMesh {
  std::vector<Vec3<double>> x;
  std::vector<std::array<int, 4>> facets;
};

/// n x n facets on [low, low + size]^2, x fastest.
inline FlatMesh square(int n, double low = 0, double size = 1) {
  FlatMesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.x.push_back({low + size * i / n, low + size * j / n, 0});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      mesh.facets.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return mesh;
}

/// Moves all nodes off the edge of the square by at most `size` in each direction of the plane.
inline void shake_inside(FlatMesh& mesh, double size, Random& random) {
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (const auto& p : mesh.x)
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  for (auto& p : mesh.x) {
    const auto move = random.vector(size);
    if (p[0] == low[0] || p[0] == high[0] || p[1] == low[1] || p[1] == high[1]) continue;
    for (int i = 0; i < 2; ++i) p[i] += move[i];
  }
}

/// Turns the mesh over, as a primary surface lies: normals down.
inline FlatMesh upside_down(FlatMesh mesh) {
  for (auto& facet : mesh.facets) std::swap(facet[1], facet[3]);
  return mesh;
}

inline void place(FlatMesh& mesh, const Tensor3<double>& Q, const Vec3<double>& shift) {
  for (auto& p : mesh.x) p = rotate(Q, p) + shift;
}

inline std::array<Vec3<double>, 8> pair_nodes(const FlatMesh& secondary, int s, const FlatMesh& primary, int p) {
  std::array<Vec3<double>, 8> x;
  for (int a = 0; a < 4; ++a) {
    x[a] = secondary.x[secondary.facets[s][a]];
    x[4 + a] = primary.x[primary.facets[p][a]];
  }
  return x;
}

template <class T>
T area_of(const Polygon<T>& polygon) {
  T twice = 0.0;
  for (int k = 1; k + 1 < polygon.n; ++k)
    twice += cross(Vec2<T>(polygon.vertex[k] - polygon.vertex[0]), Vec2<T>(polygon.vertex[k + 1] - polygon.vertex[0]));
  return 0.5 * twice;
}

struct Overlap {
  double area = 0;
  int most_vertices = 0;
};

/// The overlap of two quadrilaterals, through their convex pieces.
inline Overlap overlap_of(const Quad<double>& secondary, const Quad<double>& primary) {
  std::array<Polygon<double>, 2> subjects, clips;
  const int n_subjects = convex_pieces(primary, subjects), n_clips = convex_pieces(secondary, clips);
  Overlap overlap;
  for (int s = 0; s < n_subjects; ++s)
    for (int c = 0; c < n_clips; ++c) {
      const auto polygon = clip_polygon(subjects[s], clips[c]);
      overlap.area += area_of(polygon);
      overlap.most_vertices = std::max(overlap.most_vertices, polygon.n);
    }
  return overlap;
}

/// Quads from 16 in-plane coordinates.
inline std::array<Quad<double>, 2> quads(const double* y) {
  std::array<Quad<double>, 2> both;
  for (int a = 0; a < 8; ++a) both[a / 4][a % 4] = {y[2 * a], y[2 * a + 1]};
  return both;
}

/// A convex quadrilateral about (cx, cy): a square of edge `size`, its corners moved by up to `distortion` edges, turned at
/// random.
inline Quad<double> random_quad(Random& random, double cx, double cy, double size, double distortion) {
  const double angle = random.in(0, 6.283), c = std::cos(angle), s = std::sin(angle);
  constexpr double corner[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  Quad<double> q;
  for (int a = 0; a < 4; ++a) {
    const double x = size * (corner[a][0] + random.in(-distortion, distortion)),
                 y = size * (corner[a][1] + random.in(-distortion, distortion));
    q[a] = {cx + c * x - s * y, cy + s * x + c * y};
  }
  return q;
}

}  // namespace mortise::test
