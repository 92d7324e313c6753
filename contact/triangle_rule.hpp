// Quadrature on triangles by degree (Dunavant 1985): barycentric points and weights that sum to 1.
#pragma once

#include <vector>

namespace mortise {

struct TrianglePoint {
  double b0, b1, b2;  ///< barycentric coordinates
  double weight;      ///< share of the triangle's area
};

/// The smallest of the rules with 4, 6, 7, 12 and 16 points (degree 3, 4, 5, 6, 8) that integrates polynomials of `degree`
/// exactly.
/// @param degree 3 to 8: products of two bilinear functions need 4 already on parallelograms; 3 is the thesis' rule (Tab. 4.1),
/// with a negative weight
const std::vector<TrianglePoint>& triangle_rule(int degree);

}  // namespace mortise
