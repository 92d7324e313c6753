// What decks say about friction: numbers and formulas, and what cannot be.
#include "src/deck/bad_deck.hpp"

namespace mortise::test {
namespace {

std::string pair_with(const std::string& parameters) {
  return with_lists(R"(<ParameterList name="contact"><ParameterList name="pair">
  <Parameter name="secondary" type="string" value="cube/top"/><Parameter name="primary" type="string" value="cube/bottom"/>
  )" + parameters + R"(
  </ParameterList></ParameterList>)");
}

FrictionOptions read(const std::string& parameters) { return read_text(pair_with(parameters)).contact[0].second.friction; }

TEST(Friction, IsANumberOrAFormula) {
  EXPECT_FALSE(read("").acts());
  EXPECT_EQ(std::get<double>(*read(parameter("friction coefficient", "double", "0.3")).coefficient), 0.3);
  EXPECT_EQ(std::get<double>(*read(parameter("friction coefficient", "int", "1")).coefficient), 1);
  const FrictionOptions formula = read(parameter("friction coefficient", "string", "0.3*exp(-v) + 0.1*p*t") +
                                       parameter("slip regularisation", "double", "0.01"));
  EXPECT_EQ(std::get<std::string>(*formula.coefficient), "0.3*exp(-v) + 0.1*p*t");
  EXPECT_EQ(formula.slip_regularisation, 0.01);
  const FrictionOptions tresca = read(parameter("friction bound", "string", "2*t"));
  EXPECT_EQ(std::get<std::string>(*tresca.bound), "2*t");
  EXPECT_TRUE(tresca.acts());
}

struct BadFriction {
  std::string name, parameters;
  std::vector<std::string> words;
};
void PrintTo(const BadFriction& bad, std::ostream* out) { *out << bad.name; }

class BadFrictions : public testing::TestWithParam<BadFriction> {};

TEST_P(BadFrictions, AreRefusedWithOneErrorAtTheirPlace) {
  const std::string message = errors_of(pair_with(GetParam().parameters));
  EXPECT_EQ(message.find("deck.xml:32:"), 0u) << message;
  for (const std::string& word : GetParam().words) EXPECT_NE(message.find(word), std::string::npos) << word << "\n" << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

const std::string coefficient = parameter("friction coefficient", "double", "0.3"),
                  bound = parameter("friction bound", "double", "2");
INSTANTIATE_TEST_SUITE_P(
    Decks, BadFrictions,
    testing::Values(
        BadFriction{"Negative", parameter("friction coefficient", "double", "-0.3"), {"error[D08]", "= -0.3 - must be >= 0"}},
        BadFriction{"OfTheWrongType",
                    parameter("friction coefficient", "bool", "true"),
                    {"error[D09]", "must have type=\"double\", or \"string\" (a formula in t, p, v), not \"bool\""}},
        BadFriction{"ByPlace",
                    parameter("friction coefficient", "string", "0.3*x"),
                    {"error[D16] contact > pair > \"friction coefficient\"", "cannot be compiled", "\"x\""}},
        BadFriction{"OfNothing", parameter("friction coefficient", "string", " "), {"error[D16]", "the formula is empty"}},
        BadFriction{"TrescaByPressure", parameter("friction bound", "string", "0.3*p"), {"error[D16]", "\"p\""}},
        BadFriction{"NegativeBound", parameter("friction bound", "double", "-1"), {"error[D08]", "must be >= 0"}},
        BadFriction{"Both", coefficient + bound, {"error[D19]", "contradicts \"friction coefficient\""}},
        BadFriction{"RegularisedWithoutFriction",
                    parameter("slip regularisation", "double", "0.1"),
                    {"error[D13]", "only with \"friction coefficient\" or \"friction bound\""}},
        BadFriction{
            "RegularisedStick",
            coefficient + parameter("slip regularisation", "double", "0.1") + parameter("tangential penalty", "double", "1"),
            {"error[D19]", "\"slip regularisation\"", "contradicts \"tangential penalty\""}},
        BadFriction{"NotRegularised", bound + parameter("slip regularisation", "double", "0"), {"error[D08]", "must be > 0"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace mortise::test
