// Checks a derivative by the order of central differences: half the step, a quarter of the error.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace mortise::test {

/// A function of many numbers with many values.
using ManyToMany = std::function<std::vector<double>(const std::vector<double>&)>;

struct GradientCheck {
  double first_step = 1e-2;      ///< in the units of x; small against the distance to the next kink
  double relative_error = 1e-7;  ///< the best of the differences must come as near as this to the claimed derivative
  int n_directions = 3;
};

/// Compares `jacobian` (row-major, values x inputs) with central differences of `f` at x along random directions, at steps h,
/// h/2, h/4 ... until round-off drowns them. Passes if each halving divides the error by four: a wrong derivative leaves an error
/// that stays.
inline ::testing::AssertionResult is_derivative(const std::vector<double>& jacobian, const ManyToMany& f,
                                                const std::vector<double>& x, const GradientCheck& check = {}) {
  const std::size_t n = x.size(), m = f(x).size();
  if (jacobian.size() != m * n)
    return ::testing::AssertionFailure() << "the Jacobian has " << jacobian.size() << " entries, not " << m * n;
  Random random(1);
  for (int direction = 0; direction < check.n_directions; ++direction) {
    std::vector<double> d(n), claimed(m, 0.0);
    for (double& entry : d) entry = random.in(-1, 1);
    double size = 0;
    for (std::size_t r = 0; r < m; ++r) {
      double terms = 0;
      for (std::size_t c = 0; c < n; ++c) {
        claimed[r] += jacobian[r * n + c] * d[c];
        terms += std::abs(jacobian[r * n + c] * d[c]);
      }
      size = std::max(size, terms);
    }
    double best = std::numeric_limits<double>::infinity(), last = 0;
    for (double h = check.first_step; h > 1e-7 * check.first_step; h /= 2) {
      std::vector<double> ahead = x, behind = x;
      for (std::size_t c = 0; c < n; ++c) {
        ahead[c] += h * d[c];
        behind[c] -= h * d[c];
      }
      const auto f_ahead = f(ahead), f_behind = f(behind);
      double error = 0, noise = 0;
      for (std::size_t r = 0; r < m; ++r) {
        const double miss = std::abs((f_ahead[r] - f_behind[r]) / (2 * h) - claimed[r]);
        if (!(miss < 1e300)) return ::testing::AssertionFailure() << "not a number in row " << r << " at step " << h;
        error = std::max(error, miss);
        noise = std::max(noise, 1e-15 * ((std::abs(f_ahead[r]) + std::abs(f_behind[r])) / h + std::abs(claimed[r])));
      }
      best = std::min(best, error);
      if (error < 10 * noise) break;
      if (last > 0 && h < 0.4 * check.first_step && !(last / error > 3 && last / error < 5))
        return ::testing::AssertionFailure()
               << "from step " << 2 * h << " to " << h << " the error goes from " << last << " to " << error << ", a factor "
               << last / error << " and not 4 (derivative " << size << ")";
      last = error;
    }
    if (!(best <= check.relative_error * size + 1e-300))
      return ::testing::AssertionFailure() << "the best difference misses the derivative " << size << " by " << best;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace mortise::test
