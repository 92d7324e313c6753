// One example of each recipe, with its volume and the areas of its sides; orders and lengths that the tests of recipes measure
// by.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "mesh/recipes/recipes.hpp"

namespace mortise {

inline constexpr double pi = 3.14159265358979323846;

/// Simpson's rule on n intervals.
inline double integral(double from, double to, const std::function<double(double)>& f, int n = 400) {
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

/// A quarter of the block that is cut by a sphere, twice as wide each way.
struct QuarterIndenterCase : SphericalIndenterCase {
  static Kind data(int times) {
    return {{l / 2, w / 2, h}, R, Kind::Shape::sphere, {2 * times, times, times}, {3, 2, 1}, Kind::Part::quarter};
  }
  static double volume() { return SphericalIndenterCase::volume() / 4; }
  static std::map<std::string, double> areas() {
    const auto whole = SphericalIndenterCase::areas();
    return {{"left", integral(0, w / 2, [](double b) { return h - sagged(0, b); })},
            {"right", whole.at("right") / 2},
            {"front", integral(0, l / 2, [](double a) { return h - sagged(a, 0); })},
            {"back", whole.at("back") / 2},
            {"bottom", whole.at("bottom") / 4},
            {"top", l * w / 4}};
  }
};

/// A quarter of a round block, cut by a sphere.
struct RoundQuarterCase {
  static constexpr double r = 1, h = 0.9, R = 1.5;
  using Kind = recipes::QuarterIndenter;
  static Kind data(int times) { return {R, r, 0.4, h, {2 * times, 2 * times, times}, {2, 0.5}}; }
  static double rise() { return R - std::sqrt(R * R - r * r); }
  static double volume() { return pi / 4 * (r * r * h - R * r * r + 2. / 3 * (R * R * R - std::pow(R * R - r * r, 1.5))); }
  static std::map<std::string, double> areas() {
    const double profile = r * h - (r * R - (r * std::sqrt(R * R - r * r) + R * R * std::asin(r / R)) / 2);
    return {{"left", profile},
            {"front", profile},
            {"bottom", pi / 2 * R * rise()},
            {"top", pi / 4 * r * r},
            {"outer", pi / 2 * r * (h - rise())}};
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

struct LBlockCase {
  using Kind = recipes::LBlock;
  static Kind data(int times) { return {{4, 1, 5}, {1, 2}, {times, 2 * times, times, times, 2 * times}}; }
  static double volume() { return 4 * 2 + 1 * 3; }
  static std::map<std::string, double> areas() {
    return {{"left", 5},   {"right", 2}, {"front", 11},      {"back", 11},
            {"bottom", 4}, {"top", 1},   {"inner right", 3}, {"inner top", 3}};
  }
};

/// Cook's membrane, graded along it.
struct HexahedronCase {
  using Kind = recipes::Hexahedron;
  static Kind data(int times) {
    return {{0, 0, 0, 48, 44, 0, 48, 60, 0, 0, 44, 0, 0, 0, 1, 48, 44, 1, 48, 60, 1, 0, 44, 1},
            {2 * times, 2 * times, times},
            {2, 1, 0.5}};
  }
  static double volume() { return 48 * (44 + 16) / 2; }
  static std::map<std::string, double> areas() {
    return {{"left", 44},     {"right", 16}, {"front", std::hypot(48, 44)}, {"back", std::hypot(48, 16)},
            {"bottom", 1440}, {"top", 1440}};
  }
};

using Recipes = testing::Types<BlockCase, GradedBlockCase, HollowSphereCase, TorusCase, CylinderCase, HollowCylinderCase,
                               RingSectorCase, CylindricalIndenterCase, SphericalIndenterCase, QuarterIndenterCase,
                               RoundQuarterCase, WedgeCase, LBlockCase, HexahedronCase>;

// ---- measures ---------------------------------------------------------------------------------------------------------

inline const Point& at(const Mesh& mesh, int a) { return mesh.coordinates[static_cast<std::size_t>(a)]; }

inline double norm(const Point& x) { return std::hypot(x[0], x[1], x[2]); }
inline double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// The error must fall by four when elements are halved, or be round-off where the shape is flat.
inline void expect_order_2(const std::array<double, 3>& values, double exact, const std::string& what) {
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) error[i] = std::abs(values[i] - exact) / exact;
  if (error[0] < 1e-13 && error[1] < 1e-13 && error[2] < 1e-13) return;
  EXPECT_LT(error[2], 0.01) << what;
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.1) << what << ": " << error[0] << ", " << error[1] << ", " << error[2];
}

}  // namespace mortise
