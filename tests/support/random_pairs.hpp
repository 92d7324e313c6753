// Random facet pairs in space: the set that the kernel is measured and tested on.
#pragma once

#include "assembly/pair_tangent.hpp"
#include "support/random.hpp"

namespace mortise::test {

/// A secondary facet near the plane z = 0 with noisy nodal normals and a primary facet over it, turned and shifted so that the
/// overlap has 3 to 8 corners. Edges are about 1, nodes are off by `distortion`, gaps of either sign up to 0.05; all turned at
/// random.
inline PairInput random_pair(Random& random, double distortion = 0.06) {
  constexpr double corner[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  PairInput input;
  const double angle = random.in(0, 6.283), c = std::cos(angle), s = std::sin(angle);
  const double dx = random.in(-0.6, 0.6), dy = random.in(-0.6, 0.6), gap = random.in(-0.05, 0.05);
  const auto Q = random.rotation();
  for (int a = 0; a < 4; ++a) {
    const auto place = [&](double x, double y, double z) { return rotate(Q, Vec3<double>{x, y, z} + random.vector(distortion)); };
    input.x[a] = place(corner[a][0], corner[a][1], 0);
    const double x = corner[3 - a][0], y = corner[3 - a][1];  // the other way round: the primary's normal points down
    input.x[4 + a] = place(dx + c * x - s * y, dy + s * x + c * y, gap);
    const Vec3<double> n = Vec3<double>{0, 0, 1} + random.vector(0.1);
    input.normal[a] = rotate(Q, (1 / norm(n)) * n);
    input.pressure[a] = random.in(0.5, 2);
  }
  return input;
}

/// A random pair whose facets do overlap, with at least `share` of the secondary facet's area.
inline PairInput overlapping_pair(Random& random, double share = 0.01) {
  PairOutput values;
  for (;;) {
    const auto input = random_pair(random);
    if (!pair_values(input, triangle_rule(5), values)) continue;
    if (values.covered_area[0] + values.covered_area[1] + values.covered_area[2] + values.covered_area[3] > share) return input;
  }
}

/// All 40 numbers a pair depends on, in the order of the columns of `PairTangent`.
inline std::vector<double> inputs_of(const PairInput& input) {
  std::vector<double> all;
  for (const auto& x : input.x) all.insert(all.end(), {x[0], x[1], x[2]});
  for (const auto& n : input.normal) all.insert(all.end(), {n[0], n[1], n[2]});
  all.insert(all.end(), input.pressure.begin(), input.pressure.end());
  return all;
}

inline PairInput from_inputs(const std::vector<double>& all) {
  PairInput input;
  for (int k = 0; k < 24; ++k) input.x[k / 3][k % 3] = all[k];
  for (int k = 0; k < 12; ++k) input.normal[k / 3][k % 3] = all[24 + k];
  for (int I = 0; I < 4; ++I) input.pressure[I] = all[36 + I];
  return input;
}

}  // namespace mortise::test
