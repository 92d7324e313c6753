// Random numbers that are the same on every machine.
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "physics/tensor.hpp"

namespace mortise::test {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double in(double low, double high) { return low + (high - low) * (engine_() * 0x1p-32); }

  /// Each component uniform in [-size, size).
  Vec3<double> vector(double size) {
    const double x = in(-size, size), y = in(-size, size), z = in(-size, size);
    return {x, y, z};
  }

  /// A rotation: by an angle in [0, pi) about a random axis.
  Tensor3<double> rotation() {
    Vec3<double> w = vector(1);
    while (norm(w) < 0.1) w = vector(1);
    const Vec3<double> a = (1 / norm(w)) * w;
    const double angle = in(0, 3.14159), c = std::cos(angle), s = std::sin(angle);
    Tensor3<double> Q{{{c, -s * a[2], s * a[1]}, {s * a[2], c, -s * a[0]}, {-s * a[1], s * a[0], c}}};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) Q(i, j) += (1 - c) * a[i] * a[j];
    return Q;
  }

 private:
  std::mt19937 engine_;
};

inline Vec3<double> rotate(const Tensor3<double>& Q, const Vec3<double>& x) {
  return {Q(0, 0) * x[0] + Q(0, 1) * x[1] + Q(0, 2) * x[2], Q(1, 0) * x[0] + Q(1, 1) * x[1] + Q(1, 2) * x[2],
          Q(2, 0) * x[0] + Q(2, 1) * x[1] + Q(2, 2) * x[2]};
}

}  // namespace mortise::test
