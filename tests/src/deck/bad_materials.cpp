// Materials that must be refused: each with its line, its code and its words.
#include "src/deck/bad_deck.hpp"

namespace mortise::test {
namespace {

class BadMaterials : public testing::TestWithParam<BadDeck> {};

TEST_P(BadMaterials, GiveOneErrorWithLineCodeAndWords) { expect_one_error(GetParam()); }

/// The parameters of one material in three lines: the model, the others, nothing.
std::string material(const std::string& model, const std::string& parameters) {
  return parameter("model", "string", model) + "\n" + parameters + "\n";
}
const std::string E = parameter("youngs modulus", "double", "2"), nu = parameter("poissons ratio", "double", "0.3"),
                  mu = parameter("shear modulus", "double", "1"), kappa = parameter("bulk modulus", "double", "5");

std::string lambda(const std::string& value) { return parameter("lame lambda", "double", value); }
std::string c1_c2(const std::string& c1, const std::string& c2) {
  return parameter("c1", "double", c1) + "\n" + parameter("c2", "double", c2);
}
std::string series(const std::string& exponents, const std::string& moduli) {
  return parameter("exponents", "Array(double)", exponents) + "\n" + parameter("moduli", "Array(double)", moduli);
}

const std::vector<BadDeck> wrong_materials{
    {"HalfAPair",
     elastic_parameters,
     material("neo-hookean", E),
     "10:1: error[D12]",
     {R"(materials > rubber > "youngs modulus" = 2 - must belong to exactly one pair of moduli: "youngs modulus" and )",
      R"("poissons ratio", or "shear modulus" and "lame lambda", or "bulk modulus" and "shear modulus"; set: "youngs modulus")"}},
    {"NoModuli",
     elastic_parameters,
     material("linear elastic", ""),
     "8:5: error[D12]",
     {R"(materials > rubber - "youngs modulus" must belong to exactly one pair of moduli)", "set: none"}},
    {"MixedPair",
     elastic_parameters,
     material("neo-hookean power-law", E + mu),
     "10:1: error[D12]",
     {R"(; set: "youngs modulus", "shear modulus")"}},
    {"TwoPairs",
     elastic_parameters,
     material("saint venant-kirchhoff", E + nu + "\n" + mu + lambda("1")),
     "10:1: error[D12]",
     {R"(; set: "youngs modulus", "poissons ratio", "shear modulus", "lame lambda")"}},
    {"PairAndAHalf",
     elastic_parameters,
     material("neo-hookean isochoric-volumetric", mu + lambda("1") + kappa),
     "10:1: error[D12]",
     {R"(; set: "shear modulus", "lame lambda", "bulk modulus")"}},
    {"NegativeShearModulus",
     elastic_parameters,
     material("neo-hookean", parameter("shear modulus", "double", "-1") + lambda("1")),
     "10:1: error[D08]",
     {"\"shear modulus\" = -1 - must be > 0"}},
    {"LambdaWithoutABulkModulus",
     elastic_parameters,
     material("neo-hookean", mu + "\n" + lambda("-0.7")),
     "11:1: error[D08]",
     {R"("lame lambda" = -0.7 - must be > -2/3 "shear modulus")"}},
    {"WeightlessMaterial",
     elastic_parameters,
     elastic_parameters + "\n" + parameter("density", "double", "0"),
     "12:1: error[D08]",
     {"materials > rubber > \"density\" = 0 - must be > 0"}},
    {"PairForMooneyAndRivlin",
     elastic_parameters,
     material("mooney-rivlin incompressible", c1_c2("1", "1") + "\n" + E),
     "12:1: error[D13]",
     {R"("youngs modulus" = 2 - is set but unused: it has a meaning only with "model" = "linear elastic", )"}},
    {"MooneyAndRivlinWithoutShearModulus",
     elastic_parameters,
     material("mooney-rivlin isochoric-volumetric", c1_c2("1", "-1") + "\n" + kappa),
     "10:1: error[D08]",
     {"\"c1\" = 1 - must give with \"c2\" a shear modulus 2 (c1 + c2) > 0"}},
    {"MooneyAndRivlinPressedToNothing",
     elastic_parameters,
     material("mooney-rivlin", c1_c2("1", "-0.6") + "\n" + parameter("c", "double", "10")),
     "11:1: error[D08]",
     {"\"c2\" = -0.6 - must give c1 + 2 c2 > 0: otherwise volume can be pressed to nothing"}},
    {"MooneyAndRivlinWithoutBulkModulus",
     elastic_parameters,
     material("mooney-rivlin", c1_c2("1", "0") + "\n" + parameter("c", "double", "-1")),
     "12:1: error[D08]",
     {"\"c\" = -1 - must give a bulk modulus 2 c + 4 c1/3 + 16 c2/3 > 0"}},
    {"MooneyAndRivlinWithoutC",
     elastic_parameters,
     material("mooney-rivlin", c1_c2("1", "0")),
     "8:5: error[D07]",
     {"materials > rubber - required \"c\" is missing"}},
    {"OgdenWithoutShearModulus",
     elastic_parameters,
     material("ogden incompressible", series("{2, -2}", "{1, 2}")),
     "11:1: error[D08]",
     {R"("moduli" = "{1, 2}" - must give with "exponents" a shear modulus sum(mu a)/2 > 0)"}},
    {"OgdenWithTooFewModuli",
     elastic_parameters,
     material("ogden incompressible", series("{2, -2}", "{1}")),
     "11:1: error[D17]",
     {"must have as many entries as \"exponents\""}},
    {"OgdenWithAnExponentOfZero",
     elastic_parameters,
     material("ogden incompressible", series("{2, 0}", "{1, 2}")),
     "10:1: error[D08]",
     {"entry 2, 0, must be other than 0; a stretch to the power of 0 stores no energy"}},
    {"OgdenWithoutBulkModulus",
     elastic_parameters,
     material("ogden", series("{2}", "{1}") + parameter("volumetric exponent", "double", "9")),
     "8:5: error[D07]",
     {"materials > rubber - required \"bulk modulus\" is missing"}},
    {"OgdenWithNegativeBulkModulus",
     elastic_parameters,
     material("ogden", series("{2}", "{1}") + "\n" + parameter("bulk modulus", "double", "-1") +
                           parameter("volumetric exponent", "double", "9")),
     "12:1: error[D08]",
     {"\"bulk modulus\" = -1 - must be > 0"}},
    {"VolumeOfTheIncompressible",
     elastic_parameters,
     material("neo-hookean incompressible", mu + "\n" + kappa),
     "11:1: error[D13]",
     {"\"bulk modulus\" = 5 - is set but unused"}},
    {"TwoModuliOfTheIncompressible",
     elastic_parameters,
     material("neo-hookean incompressible", mu + "\n" + E),
     "11:1: error[D12]",
     {R"(exactly one of "youngs modulus", "shear modulus" must be set)"}},
    {"MisspeltModelWithParametersOfAnother",
     elastic_parameters,
     material("mooney-rivlim", c1_c2("1", "0") + parameter("c", "double", "1")),
     "9:7: error[D10]",
     {"did you mean \"mooney-rivlin\"?"}},
};
INSTANTIATE_TEST_SUITE_P(Wrong, BadMaterials, testing::ValuesIn(wrong_materials), name_of);

}  // namespace
}  // namespace mortise::test
