// Decks that must be read, and what they must give.
#include "deck/fields.hpp"
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

TEST(Deck, OfTheConventionsGivesWhatItSays) {
  const DeckOptions o = read_text(ironing_deck);
  EXPECT_EQ(o.title, "Thesis 6.3.1: ironing, frictionless, depth 0.7");
  ASSERT_EQ(o.meshes.size(), 2u);
  EXPECT_EQ(o.meshes[0].first, "slab");
  ASSERT_TRUE(o.meshes[0].second.recipe);
  const auto& slab = std::get<recipes::Block>(*o.meshes[0].second.recipe);
  EXPECT_FALSE(o.meshes[0].second.file);
  EXPECT_EQ(slab.size, (std::array<double, 3>{9, 4, 3}));
  EXPECT_EQ(slab.elements, (std::array<int, 3>{20, 5, 3}));
  EXPECT_EQ(o.meshes[0].second.origin, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(o.meshes[1].second.origin, (std::array<double, 3>{1, 1.5, 3}));
  ASSERT_EQ(o.materials.size(), 2u);
  EXPECT_EQ(o.materials[1].first, "stiff");
  EXPECT_EQ(std::get<models::NeoHookean>(*o.materials[1].second.model).youngs_modulus, 1000);
  EXPECT_EQ(std::get<models::NeoHookean>(*o.materials[1].second.model).poissons_ratio, 0.3);
  ASSERT_EQ(o.bodies.size(), 2u);
  EXPECT_EQ(o.bodies[1].second.mesh, "indenter");
  EXPECT_EQ(o.bodies[1].second.material, "stiff");
  EXPECT_TRUE(o.bodies[1].second.blocks.empty());
  EXPECT_EQ(o.bodies[1].second.tangent, TangentKind::quadrature_point);
  ASSERT_EQ(o.supports.size(), 2u);
  EXPECT_EQ(o.supports[1].second.set, "indenter/top");
  const auto& motion = std::get<supports::Displacement>(o.supports[1].second.kind);
  EXPECT_EQ(motion.displacement[0], "0.15*max(t-1,0)");
  EXPECT_EQ(motion.displacement[2], "-0.7*min(t,1)");
  ASSERT_EQ(o.contact.size(), 1u);
  EXPECT_EQ(o.contact[0].first, "indenter on slab");
  EXPECT_EQ(o.contact[0].second.secondary, "indenter/bottom");
  EXPECT_EQ(o.contact[0].second.primary, "slab/top");
  EXPECT_EQ(o.contact[0].second.quadrature_degree, 5);
  EXPECT_EQ(name_of_kind(o.time.scheme), "static");
  EXPECT_EQ(o.time.end, 20);
  EXPECT_EQ(o.time.step, 0.1);
  EXPECT_EQ(o.time.largest_step, 0.5);
  EXPECT_FALSE(o.time.smallest_step);
  EXPECT_EQ(o.time.stops, std::vector<double>{1});
  EXPECT_EQ(o.output.fields, (std::vector<std::string>{"displacement", "von mises", "contact pressure", "gap", "status"}));
  ASSERT_EQ(o.expected.size(), 2u);
  EXPECT_EQ(o.expected[0].second.at_time, 1);
  EXPECT_EQ(o.expected[0].second.value, 1.722);
  EXPECT_EQ(o.expected[1].second.mean_from, 5);
  EXPECT_EQ(o.expected[1].second.tolerance, 0.045);
  EXPECT_EQ(o.expected[1].second.source, "independent prototype, standard multipliers on the indenter");
}

TEST(Deck, OfFewLinesLeavesDefaults) {
  const DeckOptions o = read_text(block_deck);
  EXPECT_EQ(std::get<recipes::Block>(o.meshes[0].second.recipe.value()).size, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(o.solver.tolerance, SolverOptions{}.tolerance);
  EXPECT_EQ(o.output.fields, OutputOptions{}.fields);
  EXPECT_FALSE(std::get<supports::Displacement>(o.supports[0].second.kind).displacement[0]);
  EXPECT_TRUE(o.contact.empty());
}

TEST(Deck, TakesEveryListOfTheReference) {
  const DeckOptions o = read_text(with_lists(R"deck(
  <ParameterList name="units">
    <Parameter name="length" type="string" value="mm"/>
  </ParameterList>
  <ParameterList name="tables">
    <ParameterList name="ramp">
      <Parameter name="arguments" type="Array(double)" value="{0, 1, 2}"/>
      <Parameter name="values" type="Array(int)" value="{0, 1, 1}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="push">
      <Parameter name="type" type="string" value="traction"/>
      <Parameter name="set" type="string" value="cube/top"/>
      <Parameter name="z" type="string" value="-ramp(t)*sin(pi*x)"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="solver">
    <Parameter name="linear" type="string" value="iterative"/>
    <Parameter name="tolerance" type="double" value="1e-8"/>
    <Parameter name="newton iterations" type="int" value="15"/>
    <Parameter name="further iterations" type="int" value="1"/>
    <Parameter name="linear tolerance" type="double" value="1e-9"/>
    <Parameter name="linear iterations" type="int" value="300"/>
    <Parameter name="fill level" type="int" value="2"/>
  </ParameterList>
  <ParameterList name="probes">
    <ParameterList name="corner">
      <Parameter name="quantity" type="string" value="displacement_z"/>
      <Parameter name="mesh" type="string" value="cube"/>
      <Parameter name="nearest" type="Array(double)" value="{1, 1, 1}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="expected">
    <ParameterList name="sinking">
      <Parameter name="quantity" type="string" value="displacement_z.corner"/>
      <Parameter name="at time" type="double" value="2"/>
      <Parameter name="value" type="double" value="-1"/>
      <Parameter name="tolerance" type="double" value="0.1"/>
    </ParameterList>
  </ParameterList>)deck"));
  EXPECT_EQ(o.units.length, "mm");
  EXPECT_EQ(o.tables[0].second.values, (std::vector<double>{0, 1, 1}));
  EXPECT_EQ(std::get<loads::Traction>(*o.loads[0].second.kind).traction[2], "-ramp(t)*sin(pi*x)");
  EXPECT_EQ(o.solver.linear, LinearSolverKind::iterative);
  EXPECT_EQ(o.solver.largest_iterations, 15);
  EXPECT_EQ(o.solver.further_iterations, 1);
  EXPECT_EQ(o.solver.linear_tolerance, 1e-9);
  EXPECT_EQ(o.solver.linear_iterations, 300);
  EXPECT_EQ(o.solver.fill_level, 2);
  EXPECT_EQ(o.probes[0].second.nearest, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(o.expected[0].second.quantity, "displacement_z.corner");
}

/// `block_deck` with another material.
DeckOptions with_material(const std::string& parameters) { return read_text(with(block_deck, elastic_parameters, parameters)); }

template <class Model>
Model model_of(const DeckOptions& o) {
  return std::get<Model>(*o.materials.at(0).second.model);
}

TEST(Deck, TakesEveryElasticModelByItsName) {
  std::vector<std::string> held;
  const std::vector<std::string> names{"linear elastic", "saint venant-kirchhoff", "neo-hookean", "neo-hookean power-law",
                                       "neo-hookean isochoric-volumetric"};
  for (const auto& name : names)
    held.push_back(name_of_kind(*read_text(with(block_deck, "neo-hookean", name)).materials[0].second.model));
  EXPECT_EQ(held, names);
}

TEST(Deck, TakesTheModelsThatHaveParametersOfTheirOwn) {
  const auto model = [](const std::string& name) { return parameter("model", "string", name); };
  const std::string c1_c2 = parameter("c1", "double", "3") + parameter("c2", "double", "-1"),
                    kappa = parameter("bulk modulus", "double", "50"),
                    series = parameter("exponents", "Array(double)", "{1.3, 5, -2}") +
                             parameter("moduli", "Array(double)", "{6300, 12, -100}");
  const auto mooney_rivlin =
      model_of<models::MooneyRivlin>(with_material(model("mooney-rivlin") + c1_c2 + parameter("c", "double", "7")));
  EXPECT_EQ((std::array{mooney_rivlin.c1, mooney_rivlin.c2, mooney_rivlin.c}), (std::array{3., -1., 7.}));
  const auto isochoric =
      model_of<models::MooneyRivlinIsochoric>(with_material(model("mooney-rivlin isochoric-volumetric") + c1_c2 + kappa));
  EXPECT_EQ((std::array{isochoric.c1, isochoric.c2, isochoric.bulk_modulus}), (std::array{3., -1., 50.}));
  EXPECT_EQ(model_of<models::MooneyRivlinIncompressible>(with_material(model("mooney-rivlin incompressible") + c1_c2)).c2, -1);
  const auto ogden =
      model_of<models::Ogden>(with_material(model("ogden") + series + kappa + parameter("volumetric exponent", "double", "9")));
  EXPECT_EQ(ogden.exponents, (std::vector<double>{1.3, 5, -2}));
  EXPECT_EQ(ogden.moduli, (std::vector<double>{6300, 12, -100}));
  EXPECT_EQ((std::array{ogden.bulk_modulus, ogden.volumetric_exponent}), (std::array{50., 9.}));
  EXPECT_EQ(model_of<models::OgdenIncompressible>(with_material(model("ogden incompressible") + series)).moduli.size(), 3U);
  const std::string incompressible = model("neo-hookean incompressible");
  const auto by_shear = with_material(incompressible + parameter("shear modulus", "double", "4")),
             by_young = with_material(incompressible + parameter("youngs modulus", "double", "12"));
  EXPECT_EQ(model_of<models::NeoHookeanIncompressible>(by_shear).shear_modulus, 4);
  EXPECT_EQ(model_of<models::NeoHookeanIncompressible>(by_young).youngs_modulus, 12);
}

TEST(Deck, TakesAnyUsualPairOfModuliAndADensity) {
  const auto pair = [](const std::string& one, const std::string& other) {
    return parameter("model", "string", "neo-hookean") + parameter(one, "double", "2") + parameter(other, "double", "3");
  };
  const auto lame = model_of<models::NeoHookean>(with_material(pair("shear modulus", "lame lambda")));
  EXPECT_EQ(lame.shear_modulus, 2);
  EXPECT_EQ(lame.lame_lambda, 3);
  EXPECT_FALSE(lame.youngs_modulus || lame.poissons_ratio || lame.bulk_modulus);
  const auto o = with_material(pair("bulk modulus", "shear modulus") + parameter("density", "double", "7.8e-9"));
  EXPECT_EQ(model_of<models::NeoHookean>(o).bulk_modulus, 2);
  EXPECT_EQ(model_of<models::NeoHookean>(o).shear_modulus, 3);
  EXPECT_EQ(o.materials[0].second.density, 7.8e-9);
  EXPECT_FALSE(read_text(block_deck).materials[0].second.density);
}

TEST(Deck, TakesAnIntegerWhereANumberIsWanted) {
  const auto o = read_text(with(block_deck, R"(type="double" value="2.5")", R"(type="int" value="3")"));
  EXPECT_EQ(model_of<models::NeoHookean>(o).youngs_modulus, 3);
}

TEST(Deck, TakesCommentsDeclarationsAndAByteOrderMark) {
  EXPECT_EQ(errors_of("\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- a comment -->\n" + block_deck), "");
}

TEST(Deck, TakesEmptyContactAndSupports) {
  EXPECT_EQ(errors_of(with_lists(R"(<ParameterList name="contact"/>)")), "");
  EXPECT_EQ(errors_of(with_lists(R"(<ParameterList name="loads"></ParameterList>)")), "");
}

TEST(Deck, PointsLaterErrorsAtTheirPlace) {
  const auto file = write_file(block_deck);
  const Deck deck = Deck::read(file);
  EXPECT_EQ(deck.text(), block_deck);
  EXPECT_EQ(deck.file(), file);
  EXPECT_EQ(deck.error("D20", {"supports", "bottom", "set"}, "no such set in the mesh"),
            file.string() + ":22:7: error[D20] supports > bottom > \"set\" = \"cube/bottom\" - no such set in the mesh");
  EXPECT_EQ(deck.error("D21", {"supports", "bottom"}, "clashes"),
            file.string() + ":21:5: error[D21] supports > bottom - clashes");
  EXPECT_EQ(deck.error("D21", {"time", "growth"}, "too much"), file.string() + ":26:3: error[D21] time > \"growth\" - too much");
  EXPECT_EQ(deck.error("D22", {}, "not held"), file.string() + ":1:1: error[D22] not held");
}

TEST(RecipeFile, GivesAMesh) {
  const std::string text = R"deck(<ParameterList name="slab">
  <Parameter name="recipe" type="string" value="graded block"/>
  <Parameter name="size" type="Array(double)" value="{2, 3, 4}"/>
  <Parameter name="elements" type="Array(int)" value="{2, 2, 8}"/>
  <Parameter name="grading" type="Array(double)" value="{1, 1, 0.25}"/>
  <Parameter name="rotation" type="Array(double)" value="{0, 1, 0, 90}"/>
</ParameterList>)deck";
  const MeshOptions mesh = read_recipe(write_file(text, "recipe.xml"));
  ASSERT_TRUE(mesh.recipe);
  EXPECT_EQ(std::get<recipes::GradedBlock>(*mesh.recipe).grading[2], 0.25);
  EXPECT_EQ(mesh.rotation, (std::array<double, 4>{0, 1, 0, 90}));
  EXPECT_THROW(read_recipe(write_file(
                   with(text, R"("recipe" type="string" value="graded block")", R"("file" type="string" value="slab.exo")"),
                   "recipe.xml")),
               DeckError);
}

TEST(RecipeFile, GivesTheKindItNamesWithItsParameters) {
  const std::string text = R"deck(<ParameterList name="indenter">
  <Parameter name="radius" type="double" value="2"/>
  <Parameter name="shape" type="string" value="sphere"/>
  <Parameter name="recipe" type="string" value="curved indenter"/>
</ParameterList>)deck";
  const auto indenter = std::get<recipes::CurvedIndenter>(read_recipe(write_file(text, "recipe.xml")).recipe.value());
  EXPECT_EQ(indenter.radius, 2);
  EXPECT_EQ(indenter.shape, recipes::CurvedIndenter::Shape::sphere);
  EXPECT_EQ(indenter.size, (std::array<double, 3>{1, 1, 1}));
}

TEST(Kinds, AreCountedByTheirNames) {
  EXPECT_EQ(names_of_kinds<std::optional<Recipe>>().size(), std::variant_size_v<Recipe>);
  EXPECT_EQ(names_of_kinds<Recipe>()[3], "torus");
  EXPECT_EQ(name_of_kind(Recipe(recipes::HollowSphere{})), "hollow sphere");
}

}  // namespace
}  // namespace mortise::test
