// Positions of nodes along one direction of a recipe: uniform or graded.
#pragma once

#include <cstddef>
#include <vector>

namespace mortise::recipes {

/// Positions of the n + 1 nodes from one end to the other; element sizes form a geometric sequence, last / first = grading.
///   x_k = from + (to - from) (r^k - 1) / (r^n - 1),  r = grading^(1/(n-1)); both ends exact.
/// Precondition: n >= 1, grading > 0
std::vector<double> graded_axis(double from, double to, int n, double grading);

/// Positions of the n + 1 nodes from -half to half, symmetric to the last bit; the size of elements grows from the middle to
/// both ends:
///   x = half sign(xi) (g^|xi| - 1) / (g - 1),  xi = 2k/n - 1,
/// whose derivatives at the end and in the middle have the ratio g = grading.
/// Precondition: n >= 1, grading > 0
std::vector<double> axis_graded_from_middle(double half, int n, double grading);

/// Position of node k of an axis.
inline double at(const std::vector<double>& axis, int k) { return axis[static_cast<std::size_t>(k)]; }

}  // namespace mortise::recipes
