// The core of round bodies: squares that grow rounder outwards.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "mesh/recipes/cube_direction.hpp"

namespace mortise::recipes {

/// Position in the core of unit radius to its corners of the lattice point c, max |c_i| <= n; its rim lies halfway between a
/// square and a circle:
///   P = rho ((1 - w rho) q / sqrt(2) + w rho d),  w = 1/2,  rho = max |c_i| / n,  q = c / max |c_i|,  d the direction through q.
inline std::array<double, 2> in_core(const std::array<int, 2>& c, int n) {
  constexpr double roundness = 0.5;  // of the core's rim: between a square (0) and a circle (1)
  const int ring = std::max(std::abs(c[0]), std::abs(c[1]));
  if (ring == 0) return {0, 0};
  const double rho = static_cast<double>(ring) / n, w = roundness * rho;
  const auto d = cube_direction(c, ring);
  std::array<double, 2> P{};
  for (std::size_t i = 0; i < 2; ++i) P[i] = rho * ((1 - w) * std::sqrt(0.5) * c[i] / ring + w * d[i]);
  return P;
}

}  // namespace mortise::recipes
