// The check of tangents: passes for every formulation and material, and fails for wrong tangents.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "mesh/exodus.hpp"
#include "support/test_scene.hpp"
#include "tangents/perturbation.hpp"
#include "tangents/tangent_check.hpp"

namespace mortise::test {
namespace {

struct Case {
  ElementType type;
  std::string formulation, model, parameters;
};

std::string number(const std::string& name, double value) {
  return fmt::format("<Parameter name=\"{}\" type=\"double\" value=\"{}\"/>", name, value);
}
std::string numbers(const std::string& name, const std::string& values) {
  return fmt::format("<Parameter name=\"{}\" type=\"Array(double)\" value=\"{{{}}}\"/>", name, values);
}
const std::string moduli = number("youngs modulus", 2e5) + number("poissons ratio", 0.3);
const std::string mooney = number("c1", 3e4) + number("c2", 1e4);
const std::string ogden = numbers("exponents", "1.3, 5, -2") + numbers("moduli", "6e5, 1.2e3, -1e4");

/// Every formulation on every type that it exists for, and every material.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (ElementType type : element_types) all.push_back({type, "standard", "neo-hookean", moduli});
  for (const char* formulation : {"f-bar", "enhanced strain"})
    all.push_back({ElementType::hex8, formulation, "neo-hookean", moduli});
  for (ElementType type : {ElementType::hex8, ElementType::hex27})
    all.push_back({type, "mixed", "neo-hookean isochoric-volumetric", moduli});
  for (const char* model :
       {"linear elastic", "saint venant-kirchhoff", "neo-hookean power-law", "neo-hookean isochoric-volumetric"})
    all.push_back({ElementType::hex8, "standard", model, moduli});
  all.push_back({ElementType::hex8, "standard", "mooney-rivlin", mooney + number("c", 1e5)});
  all.push_back({ElementType::hex8, "standard", "mooney-rivlin isochoric-volumetric", mooney + number("bulk modulus", 2e5)});
  all.push_back({ElementType::hex8, "standard", "ogden", ogden + number("bulk modulus", 2e6) + number("volumetric exponent", 9)});
  all.push_back({ElementType::hex8, "mixed", "neo-hookean incompressible", number("youngs modulus", 2e5)});
  all.push_back({ElementType::hex8, "mixed", "mooney-rivlin incompressible", mooney});
  all.push_back({ElementType::hex27, "mixed", "ogden incompressible", ogden});
  return all;
}

/// A block of one element, sheared and stretched, for each case; apart from each other.
Mesh mesh_of(const std::vector<Case>& cases) {
  Mesh mesh;
  for (std::size_t c = 0; c < cases.size(); ++c)
    with_element(cases[c].type, [&](auto element) {
      Block block{static_cast<std::int64_t>(c) + 1, fmt::format("b{}", c), ElementList(cases[c].type)};
      std::vector<int> nodes;
      for (int a = 0; a < element.n_nodes; ++a) {
        const auto& xi = element.node[a];
        nodes.push_back(n_nodes(mesh));
        mesh.coordinates.push_back(
            {0.5 * xi[0] + 0.1 * xi[1] + 2 * static_cast<double>(c), 0.6 * xi[1], 0.4 * xi[2] + 0.1 * xi[0]});
        mesh.node_numbers.push_back(n_nodes(mesh));
      }
      block.elements.push_back(nodes);
      mesh.blocks.push_back(std::move(block));
      mesh.element_numbers.push_back(100 + static_cast<std::int64_t>(c));
    });
  return mesh;
}

std::string deck_of(const std::vector<Case>& cases, const std::filesystem::path& file) {
  std::string materials, bodies;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    materials +=
        fmt::format("<ParameterList name=\"m{}\"><Parameter name=\"model\" type=\"string\" value=\"{}\"/>{}</ParameterList>", c,
                    cases[c].model, cases[c].parameters);
    bodies += fmt::format(
        "<ParameterList name=\"body {0}\"><Parameter name=\"mesh\" type=\"string\" value=\"all\"/>"
        "<Parameter name=\"blocks\" type=\"Array(string)\" value=\"{{b{0}}}\"/>"
        "<Parameter name=\"material\" type=\"string\" value=\"m{0}\"/>"
        "<Parameter name=\"formulation\" type=\"string\" value=\"{1}\"/></ParameterList>",
        c, cases[c].formulation);
  }
  return fmt::format(
      "<ParameterList name=\"d\"><ParameterList name=\"meshes\"><ParameterList name=\"all\"><Parameter name=\"file\" "
      "type=\"string\" value=\"{}\"/></ParameterList></ParameterList><ParameterList name=\"materials\">{}</ParameterList>"
      "<ParameterList name=\"bodies\">{}</ParameterList><ParameterList name=\"time\">{}{}</ParameterList></ParameterList>",
      file.string(), materials, bodies, number("end", 1), number("step", 1));
}

/// A scene of such cases at the deformed state.
struct Checked {
  ScratchFolder folder;
  TestScene scene;
  RCP<Vector> rest, deformed;

  explicit Checked(const std::vector<Case>& cases, const RCP<const Comm>& comm = world())
      : scene(deck_of(cases, written(cases)), comm),
        rest(scene.problem.to_overlap(*scene.problem.reference_state())),
        deformed(scene.problem.to_overlap(*perturbed(scene.problem).x)) {}

  std::filesystem::path written(const std::vector<Case>& cases) const {
    write_exodus(mesh_of(cases), folder / "all.e", "all");
    return folder / "all.e";
  }
  StateResult check(const CheckedTerm& term, const Vector& x) const {
    return check_tangents(term, x.getData().getRawPtr(), *scene.problem.dofs().comm());
  }
};

const std::vector<Case> one{{ElementType::hex8, "standard", "neo-hookean", moduli}};

TEST(TangentCheck, PassesForEveryFormulationAndMaterial) {
  const auto all = cases();
  const Checked checked(all);
  const auto terms = checked_terms(checked.scene.problem, checked.scene.partition, 10);
  ASSERT_EQ(terms.size(), all.size());
  for (std::size_t t = 0; t < terms.size(); ++t) {
    EXPECT_NE(terms[t].name.find(all[t].model), std::string::npos);
    for (const auto& x : {checked.rest, checked.deformed}) {
      const StateResult result = checked.check(terms[t], *x);
      EXPECT_EQ(result.n_pieces, 1);
      for (const auto& line : disagreements(terms[t], "any", result)) ADD_FAILURE() << line;
      if (x == checked.rest || all[t].model == "linear elastic") continue;
      for (std::size_t w = 0; w < terms[t].ways.size(); ++w)
        EXPECT_EQ(result.ways[w].n_orders, expected_order(terms[t].ways[w].kind) > 0) << terms[t].name << terms[t].ways[w].name;
    }
  }
}

TEST(TangentCheck, FailsForAWrongModulus) {
  const Checked checked(one, alone());
  const BodyTerm& body = *checked.scene.problem.bodies().front();
  Material wrong = body.body().material;
  std::get<NeoHookean>(wrong).shear_modulus *= 1 + 1e-6;
  const auto term = checked_elements(checked.scene.problem, body, ElementType::hex8, 10, [&](TangentKind kind) {
    return kind == TangentKind::analytic ? MaterialLaw::whole(wrong, ModuliKind::analytic) : law_of(body.body(), kind);
  });
  const auto lines = disagreements(term, "deformed", checked.check(term, *checked.deformed));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0].find("error[T01] body \"body 0\" (hex8, standard, neo-hookean), deformed state, element 100 of mesh \"all\": "
                    "\"analytic\" differs from \"complex step\" by "),
      0U)
      << lines[0];
}

TEST(TangentCheck, FailsForDifferencesOfTheWrongOrder) {
  const Checked checked(one, alone());
  auto term = checked_terms(checked.scene.problem, checked.scene.partition, 10).front();
  const auto right = term.pieces;
  term.pieces = [right](const double* x) {
    auto pieces = right(x);
    for (auto& piece : pieces)
      piece.tangent = [find = piece.tangent](TangentKind kind, double step, double* K) {
        // Forward differences that pass for central ones.
        return find(kind == TangentKind::central_differences ? TangentKind::forward_differences : kind, step, K);
      };
    return pieces;
  };
  const auto lines = disagreements(term, "deformed", checked.check(term, *checked.deformed));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].find("error[T02]"), 0U);
  EXPECT_NE(lines[0].find("\"central differences\" approach \"complex step\" with order 1.0"), std::string::npos) << lines[0];
}

TEST(TangentCheck, FindsTheSameOnAnyNumberOfRanks) {
  const auto all = cases();
  const Checked here(all), there(all, alone());
  const auto terms = checked_terms(here.scene.problem, here.scene.partition, 10),
             same = checked_terms(there.scene.problem, there.scene.partition, 10);
  for (std::size_t t = 0; t < terms.size(); t += 3) {
    const StateResult a = here.check(terms[t], *here.deformed), b = there.check(same[t], *there.deformed);
    for (std::size_t w = 0; w < a.ways.size(); ++w) {
      EXPECT_EQ(a.ways[w].difference, b.ways[w].difference);
      EXPECT_EQ(a.ways[w].farthest, b.ways[w].farthest);
      EXPECT_EQ(a.ways[w].order, b.ways[w].order);
    }
  }
}

}  // namespace
}  // namespace mortise::test
