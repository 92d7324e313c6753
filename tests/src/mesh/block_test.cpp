// The hex8 side table and the brick recipes.
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

TEST(Hex8Sides, FollowTheExodusTable) {
  const Mesh mesh = block({1, 1, 1}, {1, 1, 1});
  const ElementNodeList n = element_nodes(mesh, 0);
  const std::array<std::array<int, 4>, 6> table{
      {{1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {1, 5, 8, 4}, {1, 4, 3, 2}, {5, 6, 7, 8}}};
  for (int face = 0; face < 6; ++face)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(side_nodes(mesh, {0, face})[i], n[static_cast<std::size_t>(table[static_cast<std::size_t>(face)][i] - 1)]);
}

TEST(Hex8Sides, HaveNormalsThatPointOutOfTheElement) {
  const Mesh mesh = graded_block({2, 3, 4}, {2, 2, 2}, {2, 1, 0.5});
  for (int e = 0; e < n_elements(mesh); ++e) {
    Point middle{};
    for (int a : element_nodes(mesh, e))
      for (std::size_t i = 0; i < 3; ++i) middle[i] += mesh.coordinates[static_cast<std::size_t>(a)][i] / 8;
    for (int face = 0; face < 6; ++face) {
      const Point A = area_vector(mesh, {e, face}), c = centre(mesh, {e, face});
      EXPECT_GT(A[0] * (c[0] - middle[0]) + A[1] * (c[1] - middle[1]) + A[2] * (c[2] - middle[2]), 0);
    }
  }
}

TEST(BlockRecipe, HasTheVolumeOfTheBrick) {
  const Mesh mesh = block({9, 4, 3}, {20, 5, 3});
  EXPECT_EQ(n_elements(mesh), 300);
  EXPECT_EQ(n_nodes(mesh), 21 * 6 * 4);
  double sum = 0;
  for (int e = 0; e < n_elements(mesh); ++e) sum += volume(mesh, e);
  EXPECT_NEAR(sum, 108, 1e-10);
}

TEST(BlockRecipe, HasSixNamedSidesThatFaceTheirWay) {
  const std::array<double, 3> size{2, 3, 5};
  const Mesh mesh = graded_block(size, {3, 4, 5}, {1, 3, 0.2});
  const std::array<std::string, 6> names{"left", "right", "front", "back", "bottom", "top"};
  ASSERT_EQ(mesh.side_sets.size(), 6U);
  ASSERT_EQ(mesh.node_sets.size(), 6U);
  for (std::size_t s = 0; s < 6; ++s) {
    const std::size_t axis = s / 2;
    const bool upper = s % 2 == 1;
    EXPECT_EQ(mesh.side_sets[s].name, names[s]);
    EXPECT_EQ(mesh.node_sets[s].name, names[s]);
    Point total{};
    for (const Side& side : mesh.side_sets[s].sides)
      for (std::size_t i = 0; i < 3; ++i) total[i] += area_vector(mesh, side)[i];
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(total[i], i == axis ? (upper ? 1 : -1) * size[0] * size[1] * size[2] / size[axis] : 0, 1e-12) << names[s];
    std::size_t n_on_plane = 0;
    for (const Point& x : mesh.coordinates) n_on_plane += x[axis] == (upper ? size[axis] : 0.0);
    EXPECT_EQ(mesh.node_sets[s].nodes.size(), n_on_plane) << names[s];
    for (int a : mesh.node_sets[s].nodes)
      EXPECT_EQ(mesh.coordinates[static_cast<std::size_t>(a)][axis], upper ? size[axis] : 0.0);
  }
}

TEST(BlockRecipe, CountsFromOneWithXFastest) {
  const Mesh mesh = block({1, 1, 1}, {2, 1, 1});
  EXPECT_EQ(mesh.node_numbers.front(), 1);
  EXPECT_EQ(mesh.node_numbers.back(), 12);
  EXPECT_EQ(mesh.element_numbers, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(mesh.coordinates[1], (Point{0.5, 0, 0}));
}

TEST(GradedBlock, GivesTheLastElementTheRatioAskedFor) {
  for (double ratio : {0.1, 0.9999999, 1.0000001, 8.0}) {
    const Mesh mesh = graded_block({3, 1, 1}, {7, 1, 1}, {ratio, 1, 1});
    const auto x = [&](std::size_t i) { return mesh.coordinates[i][0]; };
    EXPECT_NEAR((x(7) - x(6)) / (x(1) - x(0)), ratio, 1e-13 * 7 * ratio / std::min(ratio, 1.0));
    for (std::size_t i = 2; i < 7; ++i) EXPECT_NEAR((x(i + 1) - x(i)) / (x(i) - x(i - 1)), std::pow(ratio, 1.0 / 6), 1e-12);
    EXPECT_EQ(x(0), 0);
    EXPECT_EQ(x(7), 3);
  }
}

TEST(GradedBlock, WithRatioOneIsTheUniformBlock) {
  EXPECT_EQ(graded_block({3, 2, 0.1}, {7, 3, 9}, {1, 1, 1}).coordinates, block({3, 2, 0.1}, {7, 3, 9}).coordinates);
}

TEST(GradedBlock, RefusesImpossibleData) {
  expect_words(mesh_error_of([] { block({1, -2, 1}, {1, 1, 0}); }), {"M41", "\"size\" = {1, -2, 1}", "\"elements\" = {1, 1, 0}"});
  expect_words(mesh_error_of([] {
                 graded_block({1, 1, 1}, {1, 1, 1}, {0, 1, 1});
               }),
               {"M41", "\"grading\" = {0, 1, 1} - entry 1, 0, must be in [1e-06, 1000000]"});
  expect_words(mesh_error_of([] { block({1, 1, std::nan("")}, {1, 1, 1}); }), {"M41", "size"});
  expect_words(mesh_error_of([] { block({1, 1, 1}, {100000, 100000, 100000}); }), {"M41", "\"elements\"", "2^31 nodes"});
}

}  // namespace
}  // namespace mortise
