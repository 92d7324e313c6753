// The second derivative of nodal normals.
#include <gtest/gtest.h>

#include "assembly/pair_tangent.hpp"
#include "support/gradient_check.hpp"

namespace mortise::test {
namespace {

/// A node with `n_facets` facets round it, each with the usual two neighbours, on a bumpy cone.
NodePatch fan(int n_facets, std::vector<Vec3<double>>& x, Random& random) {
  NodePatch patch;
  x = {random.vector(0.1)};
  for (int k = 0; k < n_facets; ++k) {
    const double angle = 2 * 3.14159265358979 * k / n_facets;
    x.push_back(Vec3<double>{std::cos(angle), std::sin(angle), -0.3} + random.vector(0.2));
    patch.corners.push_back({k + 1, (k + 1) % n_facets + 1});
  }
  for (int k = 0; k <= n_facets; ++k) patch.nodes.push_back(k);
  return patch;
}

std::vector<double> curvature(const NodePatch& patch, const std::vector<Vec3<double>>& x, const Vec3<double>& b) {
  std::vector<double> H(9 * x.size() * x.size(), 0.0);
  add_normal_curvature(patch, x, b, H);
  return H;
}

TEST(NormalCurvature, IsSymmetric) {
  Random random(1);
  for (int n_facets : {3, 4, 5, 12}) {  // 12: more directions than are taken at a time
    std::vector<Vec3<double>> x;
    const auto patch = fan(n_facets, x, random);
    const auto H = curvature(patch, x, random.vector(1));
    const std::size_t n = 3 * x.size();
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < r; ++c) EXPECT_NEAR(H[r * n + c], H[c * n + r], 1e-13);
  }
}

TEST(NormalCurvature, IsTheDerivativeOfThePullBack) {
  Random random(2);
  for (int n_facets : {3, 4, 5, 12}) {
    std::vector<Vec3<double>> x;
    const auto patch = fan(n_facets, x, random);
    const auto b = random.vector(1);
    std::vector<double> flat;
    for (const auto& p : x) flat.insert(flat.end(), {p[0], p[1], p[2]});
    const auto pull_back = [&](const std::vector<double>& at) {
      std::vector<Vec3<double>> moved(x.size()), f;
      for (std::size_t k = 0; k < at.size(); ++k) moved[k / 3][k % 3] = at[k];
      normal_pull_back(patch, moved, b, f);
      std::vector<double> rows;
      for (const auto& p : f) rows.insert(rows.end(), {p[0], p[1], p[2]});
      return rows;
    };
    EXPECT_TRUE(is_derivative(curvature(patch, x, b), pull_back, flat, {1e-3}));
  }
}

TEST(NormalCurvature, IsAddedToWhatIsThere) {
  Random random(3);
  std::vector<Vec3<double>> x;
  const auto patch = fan(4, x, random);
  const auto b = random.vector(1);
  const auto once = curvature(patch, x, b);
  auto twice = once;
  add_normal_curvature(patch, x, b, twice);
  for (std::size_t k = 0; k < once.size(); ++k) EXPECT_DOUBLE_EQ(twice[k], 2 * once[k]);
}

}  // namespace
}  // namespace mortise::test
