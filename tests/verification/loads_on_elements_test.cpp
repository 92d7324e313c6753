// Loads, bedding and damping on one element of each type, read from a mesh file.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "mesh/exodus.hpp"
#include "support/bar_deck.hpp"
#include "support/elements.hpp"
#include "support/gradient_check.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

class LoadsOn : public testing::TestWithParam<ElementType> {
 protected:
  const ScratchFolder folder;

  /// A distorted element, its first side "first" and all its sides "all".
  std::filesystem::path mesh_file() const {
    Mesh mesh;
    ElementList one(GetParam());
    std::vector<int> nodes;
    Random random(4);
    with_element(GetParam(), [&](auto element) {
      for (const Point& X : distorted<decltype(element)>(random, 0.1)) {
        nodes.push_back(static_cast<int>(nodes.size()));
        mesh.coordinates.push_back(X);
        mesh.node_numbers.push_back(static_cast<std::int64_t>(nodes.size()));
      }
    });
    one.push_back(nodes);
    mesh.blocks.push_back({1, "one", one});
    mesh.element_numbers = {1};
    SideSet all{2, "all", {}};
    for (std::size_t f = 0; f < topology(GetParam()).faces.size(); ++f) all.sides.push_back({0, static_cast<int>(f)});
    mesh.side_sets = {{1, "first", {all.sides[0]}}, all};
    write_exodus(mesh, folder / "one.e", "one element");
    return folder / "one.e";
  }

  std::string deck(const std::string& lists, const std::string& of_body = "") const {
    const std::string rubber =
        word("model", "neo-hookean") + number("youngs modulus", "100") + number("poissons ratio", "0.3") + number("density", "2");
    return list("one", list("meshes", list("one", word("file", mesh_file().string()))) +
                           list("materials", list("rubber", rubber)) +
                           list("bodies", list("one", word("mesh", "one") + word("material", "rubber") + of_body)) + lists +
                           list("time", number("end", "1") + number("step", "1")));
  }

  static std::vector<double> deformed(const TestScene& s) {
    Random random(8);
    return s.random_state(random, 0.05, 0, 0);
  }
};

TEST_P(LoadsOn, TangentOfEveryLoadAndBeddingAndDampingIsTheDerivative) {
  const std::string loads =
      list("loads", list("a", word("type", "pressure") + word("set", "one/all") + word("pressure", "5+x")) +
                        list("b", word("type", "cauchy traction") + word("set", "one/first") + vector_of("1", "2*y", "-3")) +
                        list("c", word("type", "traction") + word("set", "one/all") + word("y", "z")));
  const std::string bedding =
      list("springs", list("d", word("type", "bedding") + word("set", "one/first") + number("x", "3") + number("z", "7")));
  TestScene s(deck(loads + bedding, number("rayleigh mass", "0.5") + number("rayleigh stiffness", "0.2")), alone());
  ASSERT_EQ(s.problem.begin_step(s.state, 0.5), "");
  const auto x = deformed(s);
  RCP<Matrix> K;
  ASSERT_TRUE(s.problem.linearise(*s.scatter(x), K).admissible);
  const std::size_t n = s.n_unknowns();
  std::vector<double> J(n * n), unit(n, 0.0);
  Vector product(s.problem.dofs().owned_map());
  for (std::size_t c = 0; c < n; ++c) {
    unit[c] = 1;
    K->apply(*s.scatter(unit), product);
    unit[c] = 0;
    const auto column = s.gather(product);
    for (std::size_t r = 0; r < n; ++r) J[r * n + c] = column[r];
  }
  GradientCheck check;
  check.first_step = 1e-3;
  EXPECT_TRUE(is_derivative(
      J, [&](const auto& y) { return s.gather(*s.problem.evaluate(*s.scatter(y)).residual); }, x, check));
}

TEST_P(LoadsOn, PressureOnTheWholeSurfaceHasNoForceAndNoMoment) {
  TestScene s(deck(list("loads", list("a", word("type", "pressure") + word("set", "one/all") + word("pressure", "5")))), alone());
  const auto x = deformed(s);
  const auto f = s.gather(*s.problem.evaluate(*s.scatter(x)).external);
  Vec3<double> force{0, 0, 0}, moment{0, 0, 0};
  double greatest = 0;
  for (std::size_t a = 0; a < f.size(); a += 3) {
    const Vec3<double> on_node{f[a], f[a + 1], f[a + 2]}, arm{x[a], x[a + 1], x[a + 2]};
    force = force + on_node;
    moment = moment + cross(arm, on_node);
    greatest = std::max(greatest, norm(on_node));
  }
  EXPECT_GT(greatest, 0.1);
  EXPECT_LE(norm(force), 1e-13 * greatest);
  EXPECT_LE(norm(moment), 1e-13 * greatest);
}

// rho g V on the one element, and mass damping that holds it: M g = a M v in one step.
TEST_P(LoadsOn, FreeFallOfAMassDampedElementIsUniform) {
  const bool is_tetrahedron = GetParam() == ElementType::tet4 || GetParam() == ElementType::tet10;
  for (const std::string mass : {"consistent", "consistent 2x2x2", "lumped"}) {
    const std::string text = deck(list("loads", list("a", word("type", "body force") + word("z", "-3"))),
                                  number("rayleigh mass", "2") + word("mass", mass));
    if (is_tetrahedron && mass == "consistent 2x2x2") {
      EXPECT_THROW(scene_of(text), DeckError);  // fewer points than nodes
      continue;
    }
    TestScene s(text, alone());
    const auto run = s.march({1});
    ASSERT_TRUE(run.converged) << mass << ": " << run.cause;
    const auto x = s.gather(*s.state.x);
    double mean = 0;
    for (std::size_t a = 2; a < x.size(); a += 3) mean += (x[a] - s.scene.mesh.mesh.coordinates[a / 3][2]) / (x.size() / 3);
    for (std::size_t a = 2; a < x.size() && mass == "consistent"; a += 3) {
      EXPECT_NEAR(x[a] - s.scene.mesh.mesh.coordinates[a / 3][2], -1.5, 1e-9) << "node " << a / 3;
    }
    EXPECT_LT(mean, -1) << mass;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryElement, LoadsOn, testing::ValuesIn(element_types),
                         [](const auto& info) { return topology(info.param).name; });

}  // namespace
}  // namespace mortise::test
