// Geometric sequences of element sizes.
#include "mesh/recipes/axis.hpp"

#include <cmath>
#include <cstddef>

namespace mortise::recipes {

std::vector<double> graded_axis(double from, double to, int n, double grading) {
  const double length = to - from;
  std::vector<double> x(static_cast<std::size_t>(n) + 1);
  const double log_r = n > 1 ? std::log(grading) / (n - 1) : 0.0;
  for (int k = 0; k < n; ++k)  // expm1 keeps its digits as r tends to 1
    x[static_cast<std::size_t>(k)] =
        from + (log_r == 0.0 ? length * k / n : length * (std::expm1(k * log_r) / std::expm1(n * log_r)));
  x.back() = to;
  return x;
}

std::vector<double> axis_graded_from_middle(double half, int n, double grading) {
  const double log_g = std::log(grading);
  std::vector<double> x;
  for (int k = 0; k <= n; ++k) {
    const int steps = 2 * k - n;  // of half an element from the middle
    const double xi = std::abs(steps) / static_cast<double>(n);
    const double size = xi == 1 ? half : half * (log_g == 0.0 ? xi : std::expm1(xi * log_g) / std::expm1(log_g));
    x.push_back(steps < 0 ? -size : size);
  }
  return x;
}

}  // namespace mortise::recipes
