// A small contact problem in matrix form for the tests of linear solvers: two elastic blocks and pressures between them.
#pragma once

#include <Tpetra_Core.hpp>
#include <array>
#include <functional>
#include <vector>

#include "assembly/tpetra.hpp"

namespace mortise {

/// How the blocks are cut, held and pressed together.
struct SaddleOptions {
  int n = 4;        ///< elements per edge of each block
  double size = 1;  ///< edge length of a block
  double youngs_modulus = 1;
  bool contact = true;     ///< are there pressures at all
  bool upper_held = true;  ///< is the upper block's top held; else it hangs on the contact alone (and on its sides' x, y)
  bool lower_held = true;  ///< is the lower block's bottom held; if not, K is singular
  bool spread = false;     ///< nodes dealt out along x, so that every rank has pressures; else along z: few ranks have
  std::function<bool(int, int)> open = [](int i, int j) { return (i + j) % 3 == 0; };  ///< which pressures are open
};

/// A x = b with known x.
struct SaddleSystem {
  RCP<const Map> map;
  long long n_positions = 0;
  int n_closed = 0;  ///< on all ranks
  RCP<Matrix> A;
  RCP<Vector> x, b;
  std::vector<char> identity_rows;  ///< per owned row
  std::vector<int> group;           ///< node of each global unknown
};

/// 24 x 24 stiffness of a cube of linear elastic material, by the 2 x 2 x 2 rule.
using CubeStiffness = std::array<std::array<double, 24>, 24>;
CubeStiffness cube_stiffness(double edge, double youngs_modulus, double poissons_ratio);

/// K and its contact blocks are assembled with the columns of held positions left in; b = A x for a smooth x.
SaddleSystem saddle_system(const SaddleOptions& options);

/// |x - exact| / |exact|, positions and pressures each by their own norm; the greater of both.
double relative_error(const SaddleSystem& system, const Vector& x);

}  // namespace mortise
