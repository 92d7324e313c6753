// Directions through the lattice points on the surface of a square or cube: what makes round shapes of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mortise::recipes {

/// Unit vector through a lattice point c of the surface of the square or cube max |c_i| = n, equiangular on each face:
///   d = t / |t|,  t_i = tan(pi/4 c_i / n);
/// exact mirror images and permutations of c give exact ones of d.
template <std::size_t N>
std::array<double, N> cube_direction(const std::array<int, N>& c, int n) {
  constexpr double pi = 3.14159265358979323846;
  std::array<double, N> t{}, squares{};
  for (std::size_t i = 0; i < N; ++i) {
    const double size = std::abs(c[i]) == n ? 1.0 : std::tan(0.25 * pi * std::abs(c[i]) / n);
    t[i] = c[i] < 0 ? -size : size;
    squares[i] = size * size;
  }
  std::sort(squares.begin(), squares.end());  // so that the sum does not depend on the order of the axes
  double sum = 0;
  for (double square : squares) sum += square;
  const double length = std::sqrt(sum);
  for (double& component : t) component /= length;
  return t;
}

}  // namespace mortise::recipes
