// Every recipe: sound, whole, as large as its formula says, its surface named once, the same each time, and refusing bad data.
#include "mesh/recipes/recipes.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "mesh/angles.hpp"
#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/cube_direction.hpp"
#include "scratch.hpp"
#include "support/text.hpp"

namespace mortise {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Simpson's rule on n intervals.
double integral(double from, double to, const std::function<double(double)>& f, int n = 400) {
  double sum = f(from) + f(to);
  for (int k = 1; k < n; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(from + (to - from) * k / n);
  return sum * (to - from) / (3 * n);
}

// ---- one example of each recipe: data that are refined `times` over, its volume, the areas of its sides -------------------

struct BlockCase {
  using Kind = recipes::Block;
  static Kind data(int times) { return {{2, 3, 5}, {times, 2 * times, times}}; }
  static double volume() { return 30; }
  static std::map<std::string, double> areas() {
    return {{"left", 15}, {"right", 15}, {"front", 10}, {"back", 10}, {"bottom", 6}, {"top", 6}};
  }
};

struct GradedBlockCase : BlockCase {
  using Kind = recipes::GradedBlock;
  static Kind data(int times) { return {{2, 3, 5}, {2 * times, 2 * times, 3 * times}, {2, 1, 0.1}}; }
};

struct HollowSphereCase {
  using Kind = recipes::HollowSphere;
  static Kind data(int times) { return {1.5, 2, {3 * times, times}, 2}; }
  static double volume() { return 4. / 3 * pi * (8 - 3.375); }
  static std::map<std::string, double> areas() { return {{"inner", 9 * pi}, {"outer", 16 * pi}}; }
};

struct TorusCase {
  using Kind = recipes::Torus;
  static Kind data(int times) { return {76, 19.5, 24, {13 * times, 5 * times, times}, 0.5}; }
  static double volume() { return 2 * pi * pi * 76 * (24 * 24 - 19.5 * 19.5); }
  static std::map<std::string, double> areas() { return {{"inner", 4 * pi * pi * 76 * 19.5}, {"outer", 4 * pi * pi * 76 * 24}}; }
};

struct CylinderCase {
  using Kind = recipes::Cylinder;
  static Kind data(int times) { return {2, 3, {2 * times, times, times}, {0.7, 3}}; }
  static double volume() { return 12 * pi; }
  static std::map<std::string, double> areas() { return {{"outer", 12 * pi}, {"bottom", 4 * pi}, {"top", 4 * pi}}; }
};

struct HollowCylinderCase {
  using Kind = recipes::HollowCylinder;
  static Kind data(int times) { return {1, 2, 3, {7 * times, times, 2 * times}, {2, 0.5}}; }
  static double volume() { return 9 * pi; }
  static std::map<std::string, double> areas() {
    return {{"inner", 6 * pi}, {"outer", 12 * pi}, {"bottom", 3 * pi}, {"top", 3 * pi}};
  }
};

struct RingSectorCase {
  using Kind = recipes::RingSector;
  static Kind data(int times) { return {1, 2, 3, 250, {5 * times, times, times}, {2, 1, 1}}; }
  static double volume() { return 9 * pi * 250 / 360; }
  static std::map<std::string, double> areas() {
    const double share = 250. / 360;
    return {{"inner", 6 * pi * share},  {"outer", 12 * pi * share}, {"start", 3}, {"end", 3},
            {"bottom", 3 * pi * share}, {"top", 3 * pi * share}};
  }
};

/// The lower face is cut from a block l x w x h by a cylinder of radius R.
struct CylindricalIndenterCase {
  static constexpr double l = 2, w = 1, h = 0.9, R = 1.25;
  using Kind = recipes::CurvedIndenter;
  static Kind data(int times) { return {{l, w, h}, R, Kind::Shape::cylinder, {3 * times, times, times}, {2, 1, 0.5}}; }
  static double sagged() { return l * R - (0.5 * l * std::sqrt(R * R - l * l / 4) + R * R * std::asin(0.5 * l / R)); }
  static double volume() { return w * (l * h - sagged()); }
  static std::map<std::string, double> areas() {
    const double side = w * (h - (R - std::sqrt(R * R - l * l / 4))), profile = l * h - sagged();
    return {
        {"left", side}, {"right", side}, {"front", profile}, {"back", profile}, {"bottom", 2 * w * R * std::asin(0.5 * l / R)},
        {"top", l * w}};
  }
};

/// The same by a sphere.
struct SphericalIndenterCase {
  static constexpr double l = 2, w = 1, h = 0.9, R = 2;
  using Kind = recipes::CurvedIndenter;
  static Kind data(int times) { return {{l, w, h}, R, Kind::Shape::sphere, {4 * times, 2 * times, times}, {1, 2, 1}}; }
  static double sagged(double a, double b) { return R - std::sqrt(R * R - a * a - b * b); }
  static double over_face(const std::function<double(double, double)>& f) {
    return integral(-l / 2, l / 2, [&](double a) { return integral(-w / 2, w / 2, [&](double b) { return f(a, b); }); });
  }
  static double volume() {
    return over_face([](double a, double b) { return h - sagged(a, b); });
  }
  static std::map<std::string, double> areas() {
    const double side = integral(-w / 2, w / 2, [](double b) { return h - sagged(l / 2, b); }),
                 front = integral(-l / 2, l / 2, [](double a) { return h - sagged(a, w / 2); });
    return {{"left", side},
            {"right", side},
            {"front", front},
            {"back", front},
            {"bottom", over_face([](double a, double b) { return R / std::sqrt(R * R - a * a - b * b); })},
            {"top", l * w}};
  }
};

struct WedgeCase {
  using Kind = recipes::Wedge;
  static Kind data(int times) { return {{4, 1, 2}, -0.25, {2 * times, times, times}, {2, 1, 3}}; }
  static double volume() { return 6; }
  static std::map<std::string, double> areas() {
    return {{"left", 2}, {"right", 1}, {"front", 6}, {"back", 6}, {"bottom", 4}, {"top", 4 * std::hypot(1, 0.25)}};
  }
};

using Recipes = testing::Types<BlockCase, GradedBlockCase, HollowSphereCase, TorusCase, CylinderCase, HollowCylinderCase,
                               RingSectorCase, CylindricalIndenterCase, SphericalIndenterCase, WedgeCase>;

// ---- measures of a mesh -----------------------------------------------------------------------------------------------

const Point& at(const Mesh& mesh, int a) { return mesh.coordinates[static_cast<std::size_t>(a)]; }

double norm(const Point& x) { return std::hypot(x[0], x[1], x[2]); }
double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

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

/// The error must fall by four when elements are halved, or be round-off where the shape is flat.
void expect_order_2(const std::array<double, 3>& values, double exact, const std::string& what) {
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) error[i] = std::abs(values[i] - exact) / exact;
  if (error[0] < 1e-13 && error[1] < 1e-13 && error[2] < 1e-13) return;
  EXPECT_LT(error[2], 0.01) << what;
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.1) << what << ": " << error[0] << ", " << error[1] << ", " << error[2];
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

TEST(Wedge, RefusesASlopeThatLeavesNoHeight) {
  expect_words(mesh_error_of([] {
                 make(recipes::Wedge{{4, 1, 1}, -0.25, {2, 2, 2}, {1, 1, 1}});
               }),
               {"M41", "\"slope\" = -0.25 - must leave the right side a positive height"});
  expect_words(mesh_error_of([] { make(recipes::Wedge{{4, 1, 1}, std::nan(""), {2, 2, 2}, {1, 1, 1}}); }), {"M41", "slope"});
}

}  // namespace
}  // namespace mortise
