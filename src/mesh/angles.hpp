// Sines and cosines that are exact where a mesh shows it: at quarter turns, and between the points of a closed ring.
#pragma once

#include <array>

namespace mortise {

/// {sine, cosine} of an angle in degrees, exact at multiples of 90, so that a turned brick keeps flat sides.
std::array<double, 2> sine_cosine(double degrees);

/// Point i of n on the unit circle, {cos, sin} of 2 pi i / n. The points are mirrored from one octant, so that they are symmetric
/// to the last bit about every axis about which i -> i' of the n points is.
/// Precondition: n >= 1, i >= 0
std::array<double, 2> point_on_circle(int i, int n);

}  // namespace mortise
