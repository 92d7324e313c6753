// Quadrature on triangles by degree (Dunavant 1985): barycentric points and weights that sum to 1.
#pragma once

#include <vector>

namespace mortise {

struct TrianglePoint {
  double b0, b1, b2;  ///< barycentric coordinates
  double weight;      ///< share of the triangle's area
};

/// The smallest of the rules with 6, 7, 12 and 16 points (degree 4, 5, 6, 8) that integrates polynomials of `degree` exactly.
/// @param degree 4 to 8: products of two bilinear functions need 4 already on parallelograms
const std::vector<TrianglePoint>& triangle_rule(int degree);

}  // namespace mortise
