// From the deck to the materials of bodies: what is made, what is warned of, what is refused when the scene is made.
#include "deck/fields.hpp"
#include "make_material.hpp"
#include "scene.hpp"
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

std::string model(const std::string& name) { return parameter("model", "string", name); }
std::string number(const std::string& name, const std::string& value) { return parameter(name, "double", value); }

struct MadeScene {
  Scene scene;
  std::vector<std::string> warnings;
};

MadeScene scene_with(const std::string& parameters) {
  MadeScene made;
  made.scene = make_scene(Deck::from_text("deck.xml", with(block_deck, elastic_parameters, parameters)), made.warnings);
  return made;
}

Material material_with(const std::string& parameters) {
  return make_material(
      Deck::from_text("deck.xml", with(block_deck, elastic_parameters, parameters)).options().materials[0].second);
}

const std::string c1_c2 = number("c1", "3") + number("c2", "1");

/// The thesis' first table of Ogden's parameters, with a bulk modulus. As printed it is 2000.
std::string thesis_ogden(const std::string& bulk_modulus) {
  return model("ogden") + parameter("exponents", "Array(double)", "{1.3, 5, -2}") +
         parameter("moduli", "Array(double)", "{6300, 12, -100}") + number("bulk modulus", bulk_modulus) +
         number("volumetric exponent", "9");
}

TEST(Materials, AreMadeOfEveryModel) {
  const std::string pair = number("shear modulus", "2") + number("lame lambda", "3"), kappa = number("bulk modulus", "50"),
                    series = parameter("exponents", "Array(double)", "{2, -2}") + parameter("moduli", "Array(double)", "{6, -2}");
  const auto linear = std::get<LinearElastic>(material_with(model("linear elastic") + pair));
  EXPECT_EQ((std::array{linear.shear_modulus, linear.lame_lambda}), (std::array{2., 3.}));
  const auto kirchhoff = std::get<SaintVenantKirchhoff>(material_with(model("saint venant-kirchhoff") + pair));
  EXPECT_EQ((std::array{kirchhoff.shear_modulus, kirchhoff.lame_lambda}), (std::array{2., 3.}));
  const auto hooke = std::get<NeoHookean>(material_with(model("neo-hookean") + pair));
  EXPECT_EQ((std::array{hooke.shear_modulus, hooke.lame_lambda}), (std::array{2., 3.}));
  const auto power = std::get<NeoHookeanPowerLaw>(material_with(model("neo-hookean power-law") + pair));
  EXPECT_EQ((std::array{power.shear_modulus, power.volumetric_exponent}), (std::array{2., 0.75}));
  const auto rivlin = std::get<MooneyRivlin>(material_with(model("mooney-rivlin") + c1_c2 + number("c", "7")));
  EXPECT_EQ((std::array{rivlin.c1, rivlin.c2, rivlin.c}), (std::array{3., 1., 7.}));
  const auto ogden = std::get<Ogden>(material_with(model("ogden") + series + kappa + number("volumetric exponent", "9")));
  EXPECT_EQ((std::array{ogden.bulk_modulus, ogden.volumetric_exponent}), (std::array{50., 9.}));
  ASSERT_EQ(ogden.isochoric.terms.size(), 2U);
  EXPECT_EQ((std::array{ogden.isochoric.terms[1].modulus, ogden.isochoric.terms[1].exponent}), (std::array{-2., -2.}));
  const auto isochoric = std::get<NeoHookeanIsochoric>(
      material_with(model("neo-hookean isochoric-volumetric") + kappa + number("shear modulus", "2")));
  EXPECT_EQ(isochoric.isochoric.modulus, 2);
  EXPECT_DOUBLE_EQ(isochoric.bulk_modulus, 50);
  const auto split = std::get<MooneyRivlinIsochoric>(material_with(model("mooney-rivlin isochoric-volumetric") + c1_c2 + kappa));
  EXPECT_EQ((std::array{split.isochoric.c1, split.isochoric.c2, split.bulk_modulus}), (std::array{3., 1., 50.}));
  EXPECT_EQ(std::get<NeoHookeanIncompressible>(material_with(model("neo-hookean incompressible") + number("youngs modulus", "6")))
                .isochoric.modulus,
            2);
  EXPECT_EQ(std::get<MooneyRivlinIncompressible>(material_with(model("mooney-rivlin incompressible") + c1_c2)).isochoric.c1, 3);
  EXPECT_EQ(std::get<OgdenIncompressible>(material_with(model("ogden incompressible") + series)).isochoric.terms.size(), 2U);
}

TEST(Materials, BearTheNameOfTheirModel) {
  int n_models = 0;
  for_each_kind<MaterialModel>([&](auto kind) {
    MaterialOptions o;
    if constexpr (std::is_base_of_v<models::ElasticModuli, decltype(kind)>) kind.youngs_modulus = kind.poissons_ratio = 0.3;
    if constexpr (std::is_same_v<models::NeoHookeanIncompressible, decltype(kind)>) kind.shear_modulus = 1;
    o.model = kind;
    const Material material = make_material(o);
    EXPECT_EQ(std::visit([](const auto& one) { return std::string(one.name); }, material), kind.name);
    ++n_models;
  });
  EXPECT_EQ(n_models, 11);
}

TEST(Materials, AreTheSameFromEveryUsualPair) {
  for (const std::string& pair : {number("youngs modulus", "2.25") + number("poissons ratio", "0.125"),
                                  number("shear modulus", "1") + number("lame lambda", "0.3333333333333333"),
                                  number("bulk modulus", "1") + number("shear modulus", "1")}) {
    const auto material = std::get<NeoHookean>(material_with(model("neo-hookean") + pair));
    EXPECT_NEAR(material.shear_modulus, 1, 1e-15);
    EXPECT_NEAR(material.lame_lambda, 1. / 3, 1e-15);
  }
}

TEST(Bodies, KnowTheirDensityAndYoungsModulusAtSmallStrain) {
  const Body plain = scene_with(elastic_parameters).scene.bodies.at(0);
  EXPECT_DOUBLE_EQ(plain.youngs_modulus, 2.5);
  EXPECT_FALSE(plain.density);
  const Body heavy = scene_with(model("mooney-rivlin") + c1_c2 + number("c", "7") + number("density", "4")).scene.bodies.at(0);
  EXPECT_EQ(heavy.density, 4);
  const double mu = 8, lambda = 18;
  EXPECT_NEAR(heavy.youngs_modulus, mu * (3 * lambda + 2 * mu) / (lambda + mu), 1e-13 * mu);
  EXPECT_EQ(small_strain_moduli(NeoHookeanIncompressible{{2}}).youngs_modulus(), 6);
}

TEST(Warnings, TellOfABulkModulusBelowTheShearModulus) {
  const auto warnings = scene_with(thesis_ogden("2000")).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "materials > rubber: at small strain the bulk modulus (2000) is below the shear modulus (4225), Poisson's ratio is "
            "-0.12 - are all moduli in the same unit?");
  EXPECT_TRUE(scene_with(thesis_ogden("2e4")).warnings.empty());
  EXPECT_EQ(scene_with(model("neo-hookean") + number("youngs modulus", "1") + number("poissons ratio", "-0.2")).warnings.size(),
            1U);
  EXPECT_TRUE(scene_with(elastic_parameters).warnings.empty());
  EXPECT_EQ(oddity(NeoHookeanIncompressible{{2}}), "");
}

TEST(Warnings, TellOfElementsThatLock) {
  const auto warnings = scene_with(thesis_ogden("2e5")).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0],
      "bodies > cube: Poisson's ratio is 0.48951 at small strain, where hex8 elements of \"formulation\" = \"standard\" lock "
      "(too stiff) - f-bar, enhanced strain, mixed or quadratic ones do less");
}

TEST(IncompressibleBodies, AreRefusedWhereElementsHaveNoPressure) {
  try {
    scene_with(model("mooney-rivlin incompressible") + c1_c2);
    FAIL() << "accepted";
  } catch (const DeckError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("error[D19] bodies > cube > \"material\" = \"rubber\" - the material is incompressible"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace mortise::test
