// The size of a column of numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace mortise::test {

/// The greatest magnitude; 0 of none.
inline double greatest_of(const std::vector<double>& values) {
  double greatest = 0;
  for (double v : values) greatest = std::max(greatest, std::abs(v));
  return greatest;
}

}  // namespace mortise::test
