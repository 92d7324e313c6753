// Every recipe: sound, whole, as large as its formula says, its surface named once, the same each time, and refusing bad data.
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "mesh/angles.hpp"
#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/cube_direction.hpp"
#include "recipe_cases.hpp"
#include "scratch.hpp"
#include "support/text.hpp"

namespace mortise {
namespace {

// ---- measures of a mesh -----------------------------------------------------------------------------------------------

/// Volume of a trilinear element: its Jacobian has degree 2 in each direction, which 2 x 2 x 2 Gauss points integrate exactly.
double exact_volume(const Mesh& mesh, int e) {
  constexpr std::array<Point, 8> corner{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  const auto& nodes = element_nodes(mesh, e);
  double sum = 0;
  for (const Point& gauss : corner) {
    double F[3][3] = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const Point& c = corner[a];
      Point s{};
      for (std::size_t i = 0; i < 3; ++i) s[i] = 1 + c[i] * gauss[i] / std::sqrt(3.0);
      const Point slope{c[0] * s[1] * s[2] / 8, c[1] * s[0] * s[2] / 8, c[2] * s[0] * s[1] / 8};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) F[i][j] += at(mesh, nodes[a])[i] * slope[j];
    }
    sum += F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) - F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
  }
  return sum;
}

double exact_volume(const Mesh& mesh) {
  double sum = 0;
  for (int e = 0; e < n_elements(mesh); ++e) sum += exact_volume(mesh, e);
  return sum;
}

double area(const Mesh& mesh, const SideSet& set) {
  double sum = 0;
  for (const Side& side : set.sides) sum += norm(area_vector(mesh, side));
  return sum;
}

using Facet = std::vector<int>;

Facet sorted_nodes(const Mesh& mesh, Side side) {
  Facet nodes = side_nodes(mesh, side);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

// ---- the suite --------------------------------------------------------------------------------------------------------

template <class Case>
class EveryRecipe : public testing::Test {};
TYPED_TEST_SUITE(EveryRecipe, Recipes);

TYPED_TEST(EveryRecipe, PassesTheChecksOfEveryMesh) {
  for (int times : {1, 2, 3}) EXPECT_NO_THROW(check_mesh(recipes::make(TypeParam::data(times)))) << times;
}

TYPED_TEST(EveryRecipe, HasAVolumeAndAreasOfSidesThatConvergeWithOrder2) {
  std::array<double, 3> volumes{};
  std::map<std::string, std::array<double, 3>> areas;
  for (std::size_t i = 0; i < 3; ++i) {
    const Mesh mesh = recipes::make(TypeParam::data(2 << i));
    volumes[i] = exact_volume(mesh);
    for (const SideSet& set : mesh.side_sets) areas[set.name][i] = area(mesh, set);
  }
  expect_order_2(volumes, TypeParam::volume(), "volume");
  ASSERT_EQ(areas.size(), TypeParam::areas().size());
  for (const auto& [name, exact] : TypeParam::areas()) expect_order_2(areas[name], exact, name);
}

TYPED_TEST(EveryRecipe, HasEachFacetOfItsBoundaryInOneSideAndNoOther) {
  const Mesh mesh = recipes::make(TypeParam::data(2));
  std::map<Facet, int> elements_at, sets_at;
  for (int e = 0; e < n_elements(mesh); ++e)
    for (int face = 0; face < 6; ++face) ++elements_at[sorted_nodes(mesh, {e, face})];
  for (const SideSet& set : mesh.side_sets)
    for (const Side& side : set.sides) ++sets_at[sorted_nodes(mesh, side)];
  for (const auto& [facet, n] : elements_at) {
    ASSERT_LE(n, 2);
    EXPECT_EQ(sets_at.count(facet) > 0 ? sets_at[facet] : 0, n == 1 ? 1 : 0);
  }
}

TYPED_TEST(EveryRecipe, HasSidesThatFaceOutwards) {
  const Mesh mesh = recipes::make(TypeParam::data(2));
  Point total{};
  double sum = 0;
  for (const SideSet& set : mesh.side_sets)
    for (const Side& side : set.sides) {
      Point middle{};
      for (int a : element_nodes(mesh, side.element))
        for (std::size_t i = 0; i < 3; ++i) middle[i] += at(mesh, a)[i] / 8;
      const Point A = area_vector(mesh, side), c = centre(mesh, side);
      EXPECT_GT(dot(A, {c[0] - middle[0], c[1] - middle[1], c[2] - middle[2]}), 0) << set.name;
      for (std::size_t i = 0; i < 3; ++i) total[i] += A[i];
      sum += norm(A);
    }
  EXPECT_LT(norm(total), 1e-13 * sum);  // a closed surface
}

TYPED_TEST(EveryRecipe, HasNodeSetsOfItsSides) {
  const Mesh mesh = recipes::make(TypeParam::data(2));
  ASSERT_EQ(mesh.node_sets.size(), mesh.side_sets.size());
  for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
    std::set<int> nodes;
    for (const Side& side : mesh.side_sets[s].sides)
      for (int a : side_nodes(mesh, side)) nodes.insert(a);
    EXPECT_EQ(mesh.node_sets[s].name, mesh.side_sets[s].name);
    EXPECT_EQ(mesh.node_sets[s].nodes, std::vector<int>(nodes.begin(), nodes.end()));
  }
}

TYPED_TEST(EveryRecipe, HasNoNodeTwiceInOnePlace) {
  const Mesh mesh = recipes::make(TypeParam::data(3));
  double closest = INFINITY, size = 0;
  for (std::size_t a = 0; a < mesh.coordinates.size(); ++a) {
    size = std::max(size, norm(mesh.coordinates[a]));
    for (std::size_t b = 0; b < a; ++b) {
      const Point &x = mesh.coordinates[a], &y = mesh.coordinates[b];
      closest = std::min(closest, norm({x[0] - y[0], x[1] - y[1], x[2] - y[2]}));
    }
  }
  EXPECT_GT(closest, 1e-3 * size);
}

TYPED_TEST(EveryRecipe, IsOneBlockNamedAfterTheRecipe) {
  const Mesh mesh = recipes::make(TypeParam::data(1));
  ASSERT_EQ(mesh.blocks.size(), 1U);
  const std::string name = TypeParam::Kind::name;
  EXPECT_EQ(mesh.blocks[0].name, name == "graded block" ? "block" : name);
  EXPECT_EQ(mesh.source, "recipe \"" + name + "\"");
  EXPECT_EQ(mesh.node_numbers.front(), 1);
  EXPECT_EQ(mesh.node_numbers.back(), n_nodes(mesh));
}

TYPED_TEST(EveryRecipe, IsTheSameFileEachTime) {
  const ScratchFolder folder;
  write_exodus(make(Recipe(TypeParam::data(2))), folder / "one.e", "title");
  write_exodus(make(Recipe(TypeParam::data(2))), folder / "two.e", "title");
  const std::string one = test::text_of(folder / "one.e");
  EXPECT_GT(one.size(), 1000U);
  EXPECT_TRUE(one == test::text_of(folder / "two.e"));
}

TYPED_TEST(EveryRecipe, RefusesImpossibleNumbersOfElements) {
  auto data = TypeParam::data(1);
  data.elements[1] = 0;
  expect_words(mesh_error_of([&] { recipes::make(data); }), {"M41", "\"elements\" = {", "entry 2, 0, must be in [1, 1000000]"});
  data.elements.fill(100000);
  expect_words(mesh_error_of([&] { recipes::make(data); }), {"M41", "\"elements\"", "fewer than 2^31 nodes"});
}

// ---- places of nodes --------------------------------------------------------------------------------------------------

/// Largest |f(X) - exact| / exact over a node set.
double deviation(const Mesh& mesh, const std::string& set_name, double exact, const std::function<double(const Point&)>& f) {
  const auto set =
      std::find_if(mesh.node_sets.begin(), mesh.node_sets.end(), [&](const NodeSet& s) { return s.name == set_name; });
  if (set == mesh.node_sets.end()) return INFINITY;
  double most = 0;
  for (int a : set->nodes) most = std::max(most, std::abs(f(at(mesh, a)) - exact) / exact);
  return most;
}
constexpr double few_ulps = 4 * 2.220446049250313e-16;

double from_axis(const Point& x) { return std::hypot(x[0], x[1]); }

TEST(RoundRecipes, HaveTheirNodesOnTheSurface) {
  const Mesh sphere = make(HollowSphereCase::data(3)), cylinder = make(CylinderCase::data(3)), torus = make(TorusCase::data(2)),
             tube = make(HollowCylinderCase::data(2)), sector = make(RingSectorCase::data(2));
  EXPECT_LE(deviation(sphere, "inner", 1.5, norm), few_ulps);
  EXPECT_LE(deviation(sphere, "outer", 2, norm), few_ulps);
  EXPECT_LE(deviation(cylinder, "outer", 2, from_axis), few_ulps);
  EXPECT_LE(deviation(tube, "inner", 1, from_axis), few_ulps);
  EXPECT_LE(deviation(tube, "outer", 2, from_axis), few_ulps);
  EXPECT_LE(deviation(sector, "outer", 2, from_axis), few_ulps);
  const auto from_centre_line = [](const Point& x) { return std::hypot(from_axis(x) - 76, x[2]); };
  EXPECT_LE(deviation(torus, "outer", 24, from_centre_line), 4 * few_ulps);  // the ring radius is 76
}

TEST(CurvedIndenter, HasItsLowerNodesOnTheCurveAndItsCrownAtZero) {
  const Mesh cylindrical = make(CylindricalIndenterCase::data(2)), spherical = make(SphericalIndenterCase::data(1));
  EXPECT_LE(deviation(cylindrical, "bottom", 1.25, [](const Point& x) { return std::hypot(x[0] - 1, x[2] - 1.25); }), few_ulps);
  EXPECT_LE(deviation(spherical, "bottom", 2, [](const Point& x) { return std::hypot(x[0] - 1, x[1] - 0.5, x[2] - 2); }),
            few_ulps);
  const auto lowest = std::min_element(spherical.coordinates.begin(), spherical.coordinates.end(),
                                       [](const Point& x, const Point& y) { return x[2] < y[2]; });
  EXPECT_EQ(*lowest, (Point{1, 0.5, 0}));
}

TEST(CurvedIndenter, HasItsCrownAtTheEdgeOfAPart) {
  using Indenter = recipes::CurvedIndenter;
  Indenter data{{1, 0.5, 1}, 2, Indenter::Shape::sphere, {3, 2, 2}, {3, 1, 1}, Indenter::Part::half};
  const auto from_centre = [](double y) { return [y](const Point& x) { return std::hypot(x[0], x[1] - y, x[2] - 2); }; };
  EXPECT_LE(deviation(make(data), "bottom", 2, from_centre(0.25)), few_ulps);
  data.part = Indenter::Part::quarter;
  const Mesh quarter = make(data);
  EXPECT_LE(deviation(quarter, "bottom", 2, from_centre(0)), few_ulps);
  EXPECT_EQ(at(quarter, 0), (Point{0, 0, 0}));
  EXPECT_NEAR((at(quarter, 3)[0] - at(quarter, 2)[0]) / at(quarter, 1)[0], 3, 1e-12);  // last element over first
}

TEST(QuarterIndenter, HasItsLowerNodesOnTheSphereAndItsOuterOnesOnTheRim) {
  const Mesh mesh = make(RoundQuarterCase::data(2));
  EXPECT_LE(deviation(mesh, "bottom", 1.5, [](const Point& x) { return std::hypot(x[0], x[1], x[2] - 1.5); }), few_ulps);
  EXPECT_LE(deviation(mesh, "outer", 1, from_axis), few_ulps);
  EXPECT_EQ(deviation(mesh, "left", 0, [](const Point& x) { return x[0]; }), 0);
  EXPECT_EQ(deviation(mesh, "front", 0, [](const Point& x) { return x[1]; }), 0);
}

TEST(CurvedIndenter, HasElementsThatGrowFromTheCrownToTheRim) {
  recipes::CurvedIndenter data{{2, 1, 1}, 3, recipes::CurvedIndenter::Shape::cylinder, {40, 1, 1}, {4, 1, 1}};
  const Mesh mesh = make(data);
  const auto x = [&](int i) { return at(mesh, i)[0]; };
  EXPECT_NEAR((x(40) - x(39)) / (x(21) - x(20)), 4, 0.3);  // at the middle of the elements it is 4^(19/20)
  for (int i = 0; i <= 20; ++i) EXPECT_EQ(at(mesh, 20 + i)[2], at(mesh, 20 - i)[2]);  // symmetric to the last bit
}

TEST(Wedge, HasItsTopNodesOnTheInclinedPlane) {
  const Mesh mesh = make(WedgeCase::data(3));
  ASSERT_EQ(mesh.node_sets.back().name, "top");
  for (int a : mesh.node_sets.back().nodes) EXPECT_NEAR(at(mesh, a)[2], 2 - 0.25 * at(mesh, a)[0], 4e-16);
}

TEST(LBlock, HasThreeBoxesWithTheInnerCornerWhereTheyMeet) {
  const Mesh mesh = make(recipes::LBlock{{4, 1, 5}, {1, 2}, {1, 2, 1, 1, 3}});
  EXPECT_EQ(n_elements(mesh), 1 + 2 + 3);
  EXPECT_EQ(n_nodes(mesh), 2 * (2 * 4 + 2 * 3));
  EXPECT_EQ(std::count(mesh.coordinates.begin(), mesh.coordinates.end(), (Point{1, 0, 2})), 1);
  for (const Point& X : mesh.coordinates) EXPECT_TRUE(X[0] <= 1 || X[2] <= 2) << X[0] << " " << X[2];
}

TEST(LBlock, RefusesALegOrAFootThatFillsTheBox) {
  for (const std::array<double, 2> thickness : {std::array<double, 2>{4, 2}, {1, 5}})
    expect_words(mesh_error_of([&] {
                   make(recipes::LBlock{{4, 1, 5}, thickness, {1, 1, 1, 1, 1}});
                 }),
                 {"M41", "\"thickness\" = {", "must be less than \"size\" in x and z"});
}

constexpr std::array<double, 24> twisted{0,   0, 0, 2, 0.1, 0,   1.8, 1.5, 0.2, -0.1, 1,   0,
                                         0.3, 0, 1, 2, 0,   1.6, 2,   1.4, 1.1, 0.2,  1.2, 1.3};

// Elements of a graded lattice share out the one trilinear map: between them they have its volume, and its corners.
TEST(Hexahedron, IsTheTrilinearMapOfItsCornersHoweverItIsDivided) {
  const Mesh one = make(recipes::Hexahedron{twisted, {1, 1, 1}, {1, 1, 1}}),
             many = make(recipes::Hexahedron{twisted, {3, 4, 5}, {2, 0.3, 1}});
  EXPECT_NEAR(exact_volume(many), exact_volume(one), 1e-14);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Point X{twisted[3 * corner], twisted[3 * corner + 1], twisted[3 * corner + 2]};
    for (const Mesh& mesh : {one, many}) EXPECT_EQ(std::count(mesh.coordinates.begin(), mesh.coordinates.end(), X), 1) << corner;
  }
}

TEST(Hexahedron, WithTheCornersOfABlockIsTheBlock) {
  const Mesh box = make(recipes::GradedBlock{{1, 1, 1}, {4, 3, 2}, {3, 1, 0.5}}),
             between_corners = make(recipes::Hexahedron{recipes::Hexahedron{}.corners, {4, 3, 2}, {3, 1, 0.5}});
  ASSERT_EQ(box.coordinates.size(), between_corners.coordinates.size());
  EXPECT_TRUE(box.blocks[0].elements == between_corners.blocks[0].elements);
  for (std::size_t a = 0; a < box.coordinates.size(); ++a)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(box.coordinates[a][i], between_corners.coordinates[a][i], 4e-16);
  for (std::size_t s = 0; s < box.side_sets.size(); ++s) EXPECT_EQ(box.node_sets[s].nodes, between_corners.node_sets[s].nodes);
}

TEST(Hexahedron, BetweenSymmetricCornersIsSymmetric) {
  const Mesh mesh = make(
      recipes::Hexahedron{{-2, 0, 0, 2, 0, 0, 1, 3, 0, -1, 3, 0, -2, 0, 1, 2, 0, 1, 1, 3, 1, -1, 3, 1}, {5, 4, 2}, {1, 2, 1}});
  for (const Point& x : mesh.coordinates) {
    const auto is_image = [&](const Point& y) { return norm({x[0] + y[0], x[1] - y[1], x[2] - y[2]}) < 1e-15; };
    EXPECT_EQ(std::count_if(mesh.coordinates.begin(), mesh.coordinates.end(), is_image), 1);
  }
}

std::set<Point> images(const Mesh& mesh, const std::function<Point(const Point&)>& mirror) {
  std::set<Point> points;
  for (const Point& x : mesh.coordinates) {
    const Point y = mirror(x);
    points.insert({y[0] + 0.0, y[1] + 0.0, y[2] + 0.0});  // -0 becomes 0
  }
  return points;
}
const auto as_it_is = [](const Point& x) { return x; };
const auto x_to_minus_x = [](const Point& x) { return Point{-x[0], x[1], x[2]}; };
const auto y_to_minus_y = [](const Point& x) { return Point{x[0], -x[1], x[2]}; };
const auto z_to_minus_z = [](const Point& x) { return Point{x[0], x[1], -x[2]}; };
const auto x_to_y = [](const Point& x) { return Point{x[1], x[0], x[2]}; };
const auto x_to_y_to_z = [](const Point& x) { return Point{x[2], x[0], x[1]}; };

TEST(RoundRecipes, AreSymmetricToTheLastBit) {
  for (int times : {1, 2, 3}) {
    const Mesh sphere = make(HollowSphereCase::data(times)), cylinder = make(CylinderCase::data(times));
    for (const auto& mirror : {std::function<Point(const Point&)>(x_to_minus_x), {y_to_minus_y}, {x_to_y}}) {
      EXPECT_EQ(images(sphere, mirror), images(sphere, as_it_is));
      EXPECT_EQ(images(cylinder, mirror), images(cylinder, as_it_is));
    }
    EXPECT_EQ(images(sphere, x_to_y_to_z), images(sphere, as_it_is));
    const Mesh torus = make(TorusCase::data(times));
    EXPECT_EQ(images(torus, y_to_minus_y), images(torus, as_it_is));
    EXPECT_EQ(images(torus, z_to_minus_z), images(torus, as_it_is));
  }
}

TEST(Torus, OfTheThesisHas39By10By1Elements) {
  const Mesh mesh = make(recipes::Torus{76, 19.5, 24, {39, 10, 1}, 1});
  EXPECT_EQ(n_elements(mesh), 390);
  EXPECT_EQ(n_nodes(mesh), 780);
}

TEST(PointOnCircle, IsExactAtQuartersAndRightElsewhere) {
  EXPECT_EQ(point_on_circle(0, 7), (std::array<double, 2>{1, 0}));
  EXPECT_EQ(point_on_circle(3, 12)[0] + 0.0, 0.0);
  EXPECT_EQ(point_on_circle(3, 12)[1], 1);
  EXPECT_EQ(point_on_circle(1, 8)[0], point_on_circle(1, 8)[1]);
  for (int n : {3, 5, 8, 12, 39})
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(point_on_circle(i, n)[0], std::cos(2 * pi * i / n), 1e-15) << i << " of " << n;
      EXPECT_NEAR(point_on_circle(i, n)[1], std::sin(2 * pi * i / n), 1e-15) << i << " of " << n;
    }
}

TEST(RoundRecipes, AreGradedOutwards) {
  const Mesh mesh = make(recipes::HollowCylinder{1, 2, 1, {8, 5, 1}, {3, 1}});
  const auto r = [&](int i) { return from_axis(at(mesh, i)); };  // the lattice counts outwards first
  EXPECT_NEAR((r(5) - r(4)) / (r(1) - r(0)), 3, 1e-13);
}

// ---- bad data ---------------------------------------------------------------------------------------------------------

TEST(RoundRecipes, RefuseRadiiThatDoNotFit) {
  expect_words(mesh_error_of([] {
                 make(recipes::HollowSphere{2, 1, {2, 1}, 1});
               }),
               {"recipe \"hollow sphere\": error[M41] \"outer radius\" = 1 - must be greater than \"inner radius\" = 2"});
  expect_words(mesh_error_of([] {
                 make(recipes::HollowSphere{0, 1, {2, 1}, 1});
               }),
               {"M41", "\"inner radius\" = 0 - must be > 0"});
  expect_words(mesh_error_of([] {
                 make(recipes::Torus{1, 0.5, 1, {8, 8, 1}, 1});
               }),
               {"M41", "\"ring radius\" = 1 - must be greater than \"outer radius\" = 1"});
  expect_words(mesh_error_of([] { make(recipes::Cylinder{-1, 1, {2, 1, 1}, {1, 1}}); }), {"M41", "\"radius\" = -1"});
}

TEST(RoundRecipes, RefuseTooFewElementsAround) {
  expect_words(mesh_error_of([] { make(recipes::Torus{3, 0.5, 1, {2, 8, 1}, 1}); }), {"M41", "\"elements\" = {2, 8, 1}", "3"});
  expect_words(mesh_error_of([] { make(recipes::HollowCylinder{1, 2, 1, {2, 1, 1}, {1, 1}}); }), {"M41", "at least 3 around"});
  expect_words(mesh_error_of([] { make(recipes::RingSector{1, 2, 1, 250, {2, 1, 1}, {1, 1, 1}}); }), {"M41", "120 degrees"});
  expect_words(mesh_error_of([] { make(recipes::RingSector{1, 2, 1, 360, {9, 1, 1}, {1, 1, 1}}); }), {"\"angle\" = 360"});
  EXPECT_NO_THROW(make(recipes::HollowCylinder{1, 2, 1, {3, 1, 1}, {1, 1}}));
  EXPECT_NO_THROW(make(recipes::Torus{3, 0.5, 2.9, {3, 3, 1}, 1}));
  EXPECT_NO_THROW(make(recipes::Cylinder{1, 1, {1, 1, 1}, {1, 1}}));
  EXPECT_NO_THROW(make(recipes::HollowSphere{0.01, 1, {1, 1}, 1}));
}

TEST(CurvedIndenter, RefusesARadiusThatDoesNotFitTheBlock) {
  using Shape = recipes::CurvedIndenter::Shape;
  const auto with = [](std::array<double, 3> size, double radius, Shape shape) {
    return [=] { make(recipes::CurvedIndenter{size, radius, shape, {2, 2, 2}, {1, 1, 1}}); };
  };
  expect_words(mesh_error_of(with({2, 2, 5}, 0.9, Shape::cylinder)), {"M41", "\"radius\" = 0.9 - must reach", "1 off"});
  expect_words(mesh_error_of(with({2, 2, 5}, 1.1, Shape::sphere)), {"M41", "\"radius\" = 1.1 - must reach"});
  expect_words(mesh_error_of(with({2, 2, 1}, 1, Shape::cylinder)), {"M41", "\"size\" = {2, 2, 1} - must be higher"});
  EXPECT_NO_THROW(with({2, 2, 5}, 1, Shape::cylinder)());  // half a cylinder
}

TEST(CurvedIndenter, OfWhichAPartIsMeshedReachesTwiceAsFar) {
  using Indenter = recipes::CurvedIndenter;
  const auto part = [](Indenter::Part which) {
    return [=] { make(Indenter{{2, 2, 5}, 1.5, Indenter::Shape::cylinder, {2, 2, 2}, {1, 1, 1}, which}); };
  };
  EXPECT_NO_THROW(part(Indenter::Part::whole)());
  expect_words(mesh_error_of(part(Indenter::Part::half)), {"M41", "\"radius\" = 1.5 - must reach", "2 off"});
  expect_words(mesh_error_of(part(Indenter::Part::quarter)), {"M41", "\"radius\" = 1.5 - must reach", "2 off"});
}

TEST(QuarterIndenter, RefusesRadiiAndAHeightThatDoNotFit) {
  const auto with = [](double radius, double core, double height) {
    return [=] { make(recipes::QuarterIndenter{radius, 1, core, height, {2, 2, 2}, {1, 1}}); };
  };
  expect_words(mesh_error_of(with(2, 1, 2)), {"M41", "\"core radius\" = 1 - must be less than \"rim radius\" = 1"});
  expect_words(mesh_error_of(with(0.9, 0.5, 2)), {"M41", "\"radius\" = 0.9 - must reach to the rim", "1 off"});
  expect_words(mesh_error_of(with(1, 0.5, 1)), {"M41", "\"height\" = 1 - must be higher than the lower face is curved"});
  EXPECT_NO_THROW(with(1, 0.5, 1.1)());
}

TEST(Wedge, RefusesASlopeThatLeavesNoHeight) {
  expect_words(mesh_error_of([] {
                 make(recipes::Wedge{{4, 1, 1}, -0.25, {2, 2, 2}, {1, 1, 1}});
               }),
               {"M41", "\"slope\" = -0.25 - must leave the right side a positive height"});
  expect_words(mesh_error_of([] { make(recipes::Wedge{{4, 1, 1}, std::nan(""), {2, 2, 2}, {1, 1, 1}}); }), {"M41", "slope"});
}

TEST(Hexahedron, RefusesCornersInTheWrongOrderOrWithoutVolume) {
  const auto with_corners = [](std::array<double, 24> corners) {
    return [=] { check_mesh(make(recipes::Hexahedron{corners, {2, 2, 2}, {1, 1, 1}})); };
  };
  EXPECT_NO_THROW(with_corners(twisted)());
  std::array<double, 24> clockwise = twisted, flat = twisted, folded = twisted, nowhere = twisted;
  for (std::size_t k = 0; k < 24; k += 12) std::swap_ranges(&clockwise[k + 3], &clockwise[k + 6], &clockwise[k + 9]);
  std::copy_n(flat.begin(), 12, &flat[12]);
  std::swap_ranges(&folded[0], &folded[3], &folded[3]);
  nowhere[7] = std::nan("");
  for (const auto& corners : {clockwise, flat, folded})
    expect_words(mesh_error_of(with_corners(corners)), {"recipe \"hexahedron\"", "M21"});
  expect_words(mesh_error_of(with_corners(nowhere)), {"recipe \"hexahedron\"", "M16"});
}

}  // namespace
}  // namespace mortise
