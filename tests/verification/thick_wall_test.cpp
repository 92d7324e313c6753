// A thick-walled cylinder under pressure from inside, on the ring sector, against Lame's solution.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

constexpr double E = 1, nu = 0.3, a = 1, b = 2;
constexpr double pressure = 1e-7;  // of E: what is not linear in the strain is far below the error of the mesh

/// Radial displacement in plane strain [length], with p inside at r = a and nothing at r = b (Timoshenko & Goodier, section 28):
///   u = (1 + nu)/E  p a^2 / (b^2 - a^2)  [(1 - 2 nu) r + b^2 / r]
double lame(double r) { return (1 + nu) / E * pressure * a * a / (b * b - a * a) * ((1 - 2 * nu) * r + b * b / r); }

/// A quarter of the tube, 2n elements around and n through the wall; the planes x = 0, y = 0 and both ends are planes of
/// symmetry.
std::string deck(int n) {
  const std::string elements = "{" + std::to_string(2 * n) + ", " + std::to_string(n) + ", 1}";
  const auto parameter = [](const std::string& name, const std::string& type, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>\n";
  };
  const auto list = [](const std::string& name, const std::string& content) {
    return "<ParameterList name=\"" + name + "\">\n" + content + "</ParameterList>\n";
  };
  const auto symmetric = [&](const std::string& side, const std::string& axis) {
    return list(side, parameter("set", "string", "tube/" + side) + parameter(axis, "string", "0"));
  };
  const std::string recipe = parameter("recipe", "string", "ring sector") + parameter("inner radius", "double", "1") +
                             parameter("outer radius", "double", "2") + parameter("height", "double", "0.25") +
                             parameter("angle", "double", "90") + parameter("elements", "Array(int)", elements);
  const std::string steel = parameter("model", "string", "neo-hookean") + parameter("youngs modulus", "double", "1") +
                            parameter("poissons ratio", "double", "0.3");
  const std::string inside = parameter("type", "string", "traction") + parameter("set", "string", "tube/inner") +
                             parameter("x", "string", "1e-7*x/sqrt(x^2+y^2)") + parameter("y", "string", "1e-7*y/sqrt(x^2+y^2)");
  return list(
      "thick wall",
      list("meshes", list("tube", recipe)) + list("materials", list("steel", steel)) +
          list("bodies", list("tube", parameter("mesh", "string", "tube") + parameter("material", "string", "steel"))) +
          list("supports", symmetric("start", "y") + symmetric("end", "x") + symmetric("bottom", "z") + symmetric("top", "z")) +
          list("loads", list("pressure", inside)) +
          list("time", parameter("end", "double", "1") + parameter("step", "double", "1")));
}

/// Greatest error of the nodal displacements over the greatest displacement.
double error(int n) {
  TestScene s(deck(n));
  const auto run = s.march({1});
  EXPECT_TRUE(run.converged) << run.cause;
  const auto q = s.gather(*s.state.x);
  double most = 0;
  const auto& X = s.scene.mesh.mesh.coordinates;
  for (std::size_t k = 0; k < X.size(); ++k) {
    const double r = std::hypot(X[k][0], X[k][1]), u = lame(r);
    for (std::size_t i = 0; i < 3; ++i) {
      const double exact = i < 2 ? u * X[k][i] / r : 0;
      most = std::max(most, std::abs(q[3 * k + i] - X[k][i] - exact));
    }
  }
  return most / lame(a);
}

TEST(ThickWall, UnderPressureConvergesToLamesSolutionWithOrder2) {
  const double coarse = error(4), middle = error(8), fine = error(16);
  if (world()->getRank() == 0) std::cout << "error of displacement: " << coarse << ", " << middle << ", " << fine << '\n';
  EXPECT_LT(fine, 0.001);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.1);
}

}  // namespace
}  // namespace mortise::test
