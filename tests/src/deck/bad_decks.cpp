// Decks that must be refused: each with its line, its code and its words.
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

/// A change to `block_deck`, and the one message it must give.
struct BadDeck {
  std::string name;
  std::string from, to;
  std::string place_and_code;  ///< "line:column: error[code]"
  std::vector<std::string> words;
};

void PrintTo(const BadDeck& bad, std::ostream* out) { *out << bad.name; }

class BadDecks : public testing::TestWithParam<BadDeck> {};

TEST_P(BadDecks, GiveOneErrorWithLineCodeAndWords) {
  const BadDeck& bad = GetParam();
  const std::string message = errors_of(with(block_deck, bad.from, bad.to));
  EXPECT_EQ(message.find("deck.xml:" + bad.place_and_code), 0u) << message;
  for (const std::string& word : bad.words) EXPECT_NE(message.find(word), std::string::npos) << word << "\n" << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

std::string name_of(const testing::TestParamInfo<BadDeck>& test) { return test.param.name; }

const std::string ratio = R"(type="double" value="0.25")", modulus = R"(type="double" value="2.5")";
const std::string recipe = parameter("recipe", "string", "block");
const std::string end = parameter("end", "double", "2");

const std::vector<BadDeck> wrong_values{
    {"RatioOfOneHalf",
     ratio,
     R"(type="double" value="0.5")",
     "11:7: error[D08]",
     {R"(materials > rubber > "poissons ratio" = 0.5 - must be in (-1, 0.5); )", "bulk modulus"}},
    {"RatioOfMinusOne", ratio, R"(type="double" value="-1")", "11:7: error[D08]", {"must be in (-1, 0.5)"}},
    {"ModulusOfZero", modulus, R"(type="double" value="0")", "10:7: error[D08]", {"\"youngs modulus\" = 0 - must be > 0"}},
    {"WordForNumber", modulus, R"(type="double" value="abc")", "10:7: error[D09]", {"= \"abc\" - is not a number", "youngs"}},
    {"DecimalComma",
     modulus,
     R"(type="double" value="1,5")",
     "10:7: error[D09]",
     {"is not a number (the decimal sign is a point)"}},
    {"CutExponent", modulus, R"(type="double" value="1e")", "10:7: error[D09]", {"is not a number"}},
    {"Hexadecimal", modulus, R"(type="double" value="0x10")", "10:7: error[D09]", {"is not a number"}},
    {"Infinity", modulus, R"(type="double" value="inf")", "10:7: error[D09]", {"not a finite number"}},
    {"NotANumber", modulus, R"(type="double" value="nan")", "10:7: error[D09]", {"not a finite number"}},
    {"TooLarge", modulus, R"(type="double" value="1e999")", "10:7: error[D09]", {"too large"}},
    {"EmptyNumber", modulus, R"(type="double" value="")", "10:7: error[D09]", {"is empty"}},
    {"StringForDouble", modulus, R"(type="string" value="2")", "10:7: error[D09]", {"must have type=\"double\", not \"string\""}},
    {"FractionDeclaredInt", modulus, R"(type="int" value="2.5")", "10:7: error[D09]", {"is not an integer"}},
    {"UnknownType", modulus, R"(type="doubel" value="2")", "10:7: error[D03]", {"did you mean \"double\"? allowed: string"}},
    {"UnknownModel", R"("neo-hookean")", R"("neo-hokean")", "9:7: error[D10]", {"did you mean \"neo-hookean\"?", "saint venant"}},
    {"StepOfZero", R"(value="0.5")", R"(value="0")", "28:5: error[D08]", {"time > \"step\" = 0 - must be > 0"}},
    {"StepBeyondEnd", R"(value="0.5")", R"(value="5")", "28:5: error[D08]", {"must be at most \"end\" = 2"}},
    {"LargestStepBelowStep",
     end,
     end + parameter("largest step", "double", "0.1"),
     "27:52: error[D08]",
     {"must be at least \"step\" = 0.5"}},
    {"SmallestStepAboveStep",
     end,
     end + parameter("smallest step", "double", "1"),
     "27:52: error[D08]",
     {"must be at most \"step\" = 0.5"}},
    {"UnsortedStops", end, end + parameter("stops", "Array(double)", "{1, 1}"), "27:52: error[D17]", {"strictly ascending"}},
    {"StopBeyondEnd",
     end,
     end + parameter("stops", "Array(double)", "{1, 3}"),
     "27:52: error[D08]",
     {"must be at most \"end\" = 2"}},
    {"StopAtZero", end, end + parameter("stops", "Array(double)", "{0, 1}"), "27:52: error[D08]", {"entry 1, 0, must be > 0"}},
    {"EmptyArray", end, end + parameter("stops", "Array(double)", "{}"), "27:52: error[D18]", {"must have entries"}},
    {"ArrayWithoutBraces", end, end + parameter("stops", "Array(double)", "1, 2"), "27:52: error[D09]", {"is not an array"}},
    {"WordInArray",
     recipe,
     recipe + parameter("size", "Array(double)", "{1, two, 3}"),
     "4:61: error[D09]",
     {"entry 2, \"two\", is not a number"}},
    {"ShortArray",
     recipe,
     recipe + parameter("size", "Array(double)", "{1, 2}"),
     "4:61: error[D09]",
     {"has 2 entries, must have 3"}},
    {"NegativeSize",
     recipe,
     recipe + parameter("size", "Array(double)", "{1, -2, 1}"),
     "4:61: error[D08]",
     {"entry 2, -2, must be > 0"}},
    {"NoElements",
     recipe,
     recipe + parameter("elements", "Array(int)", "{1, 0, 1}"),
     "4:61: error[D08]",
     {"entry 2, 0, must be in [1, 1000000]"}},
    {"TooManyElements",
     recipe,
     recipe + parameter("elements", "Array(int)", "{10000, 10000, 100}"),
     "4:61: error[D08]",
     {"fewer than 2^31 nodes"}},
    {"TooLargeInteger",
     recipe,
     recipe + parameter("elements", "Array(int)", "{1, 2147483648, 1}"),
     "4:61: error[D09]",
     {"out of the range of integers"}},
    {"NoAxis",
     recipe,
     recipe + parameter("rotation", "Array(double)", "{0, 0, 0, 5}"),
     "4:61: error[D08]",
     {"an axis that is not zero"}},
};
INSTANTIATE_TEST_SUITE_P(WrongValues, BadDecks, testing::ValuesIn(wrong_values), name_of);

const std::vector<BadDeck> wrong_names{
    {"MisspeltParameter",
     "youngs modulus",
     "young modulus",
     "10:7: error[D06]",
     {R"(materials > rubber > "young modulus" = 2.5 - unknown parameter; did you mean "youngs modulus"? allowed: model, youngs modulus)"}},
    {"MisspeltList",
     R"(<ParameterList name="supports">)",
     R"(<ParameterList name="suports">)",
     "20:3: error[D06]",
     {"suports - unknown list; did you mean \"supports\"? allowed: title"}},
    {"MissingParameter",
     parameter("model", "string", "neo-hookean"),
     "",
     "8:5: error[D07]",
     {"materials > rubber - required \"model\" is missing"}},
    {"MissingEnd", end, "", "26:3: error[D07]", {"time - required \"end\" is missing"}},
    {"RepeatedParameter",
     recipe,
     recipe + "\n" + recipe,
     "5:1: error[D05]",
     {"\"recipe\" is repeated; it stands in line 4 already"}},
    {"ListInPlaceOfParameter",
     recipe,
     R"(<ParameterList name="recipe"/><Parameter name="file" type="string" value="a"/>)",
     "4:7: error[D09]",
     {"must be a Parameter, not a ParameterList"}},
    {"ParameterInPlaceOfList",
     R"(<ParameterList name="time">)",
     R"(<Parameter name="solver" type="int" value="1"/><ParameterList name="time">)",
     "26:3: error[D09]",
     {"\"solver\" = 1 - must be a ParameterList"}},
    {"UnknownMesh",
     R"("mesh" type="string" value="cube")",
     R"("mesh" type="string" value="cub")",
     "16:7: error[D14]",
     {R"(bodies > cube > "mesh" = "cub" - there is no mesh "cub"; did you mean "cube"? allowed: cube)"}},
    {"UnknownMaterial",
     R"(value="rubber")",
     R"(value="steel")",
     "17:7: error[D14]",
     {"there is no material \"steel\"; allowed: rubber"}},
    {"SetWithoutMesh", "cube/bottom", "bottom", "22:7: error[D14]", {"must be written \"mesh/set\""}},
    {"SetOfUnknownMesh", "cube/bottom", "kube/bottom", "22:7: error[D14]", {"did you mean \"cube\"?"}},
    {"NameWithDot",
     R"(<ParameterList name="bottom">)",
     R"(<ParameterList name="bot.tom">)",
     "21:5: error[D11]",
     {"supports > bot.tom - a name must not contain a comma, dot, slash or quote"}},
    {"EmptyName", R"(<ParameterList name="bottom">)", R"(<ParameterList name="">)", "21:5: error[D11]", {"must not be empty"}},
    {"FileAndRecipe",
     recipe,
     recipe + parameter("file", "string", "a.exo"),
     "4:61: error[D12]",
     {R"("file" = "a.exo")", R"(exactly one of "file", "recipe" must be set)"}},
    {"NeitherFileNorRecipe", recipe, "", "3:5: error[D12]", {"meshes > cube - exactly one of", "none is"}},
    {"SizeOfAFile",
     recipe,
     parameter("file", "string", "a.exo") + parameter("size", "Array(double)", "{1, 1, 1}"),
     "4:59: error[D13]",
     {"\"size\"", "is set but unused: it has a meaning only with \"recipe\""}},
    {"GradingOfAnEvenBlock",
     recipe,
     recipe + parameter("grading", "Array(double)", "{1, 1, 2}"),
     "4:61: error[D13]",
     {"unused", "\"graded block\""}},
    {"BlockOfTwoBodies",
     R"(<ParameterList name="bodies">)",
     R"(<ParameterList name="bodies"><ParameterList name="ball">)" + parameter("mesh", "string", "cube") +
         parameter("blocks", "Array(string)", "{2}") + parameter("material", "string", "rubber") + "</ParameterList>",
     "16:7: error[D19]",
     {"some blocks of this mesh belong to body \"ball\" already"}},
    {"NoComponent",
     parameter("z", "string", "0"),
     "",
     "21:5: error[D12]",
     {R"(supports > bottom - at least one of "x", "y", "z" must be set)"}},
    {"NumberForFormula",
     parameter("z", "string", "0"),
     parameter("z", "double", "0"),
     "23:7: error[D09]",
     {"must have type=\"string\" (a formula in t, x, y, z), not \"double\""}},
    {"OpenFormula",
     R"(value="0"/>)",
     R"(value="sin("/>)",
     "23:7: error[D16]",
     {R"(supports > bottom > "z" = "sin(" - cannot be compiled: )"}},
    {"UnknownVariable", R"(value="0"/>)", R"(value="2*T"/>)", "23:7: error[D16]", {"cannot be compiled", "did you mean \"t\"?"}},
};
INSTANTIATE_TEST_SUITE_P(WrongNames, BadDecks, testing::ValuesIn(wrong_names), name_of);

const std::vector<BadDeck> wrong_text{
    {"UnclosedList", "</ParameterList>\n</ParameterList>", "</ParameterList>", "29:19: error[D01]", {"XML: "}},
    {"MismatchedTag", "</ParameterList>", "</Parameters>", "5:7: error[D01]", {"mismatch"}},
    {"Doctype",
     "<ParameterList name=\"block\">",
     "<!DOCTYPE a [<!ENTITY b \"c\">]>\n<ParameterList name=\"block\">",
     "1:1",
     {"error[D01]", "DOCTYPE is refused"}},
    {"Nul", "cube", std::string("cu\0be", 5), "3:28: error[D01]", {"NUL byte"}},
    {"Latin1",
     "cube",
     "c\xFC"
     "be",
     "3:27: error[D01]",
     {"not UTF-8"}},
    {"UnknownElement", recipe, recipe + "<Paramter/>", "4:61: error[D02]", {"<Paramter>; did you mean \"Parameter\"?"}},
    {"TextBetween", recipe, recipe + "recipe", "4:61: error[D02]", {"unexpected text \"recipe\""}},
    {"UnknownAttribute",
     modulus,
     modulus + R"( unit="Pa")",
     "10:7: error[D03]",
     {"unknown attribute \"unit\"", "allowed: name, type, value"}},
    {"RepeatedAttribute", modulus, modulus + R"( value="3")", "10:7: error[D03]", {"given twice"}},
    {"MissingValue", modulus, R"(type="double")", "10:7: error[D03]", {"attribute \"value\" of <Parameter> is missing"}},
    {"MissingType", modulus, R"(value="2.5")", "10:7: error[D03]", {"attribute \"type\""}},
    {"TwoTops",
     "<ParameterList name=\"block\">",
     "<ParameterList/><ParameterList name=\"block\">",
     "1:17: error[D02]",
     {"second top"}},
};
INSTANTIATE_TEST_SUITE_P(WrongText, BadDecks, testing::ValuesIn(wrong_text), name_of);

}  // namespace
}  // namespace mortise::test
