// Reduction of angles to where their sines are exact or shared.
#include "mesh/angles.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace mortise {

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

std::array<double, 2> sine_cosine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (std::remainder(turn, 90.0) == 0.0) {
    constexpr std::array<std::array<double, 2>, 4> quarters{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
    return quarters[static_cast<std::size_t>((std::lround(turn / 90) + 4) % 4)];
  }
  return {std::sin(turn * pi / 180), std::cos(turn * pi / 180)};
}

std::array<double, 2> point_on_circle(int i, int n) {
  // In units of a quarter turn the angle is 4 i / n = quarter + rest / n.
  const std::int64_t quarters = 4 * static_cast<std::int64_t>(i);
  const std::int64_t quarter = quarters / n % 4, rest = quarters % n;
  const std::int64_t in_octant = 2 * rest <= n ? rest : n - rest;  // mirrored about 45 degrees
  const double angle = 0.5 * pi * static_cast<double>(in_octant) / n;
  double c = std::cos(angle), s = std::sin(angle);
  if (2 * rest == n) c = s = std::sqrt(0.5);
  if (2 * rest > n) std::swap(c, s);
  switch (quarter) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace mortise
