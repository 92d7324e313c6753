// Decks that mean harm, or that no reader was made for: each with its line, its code and its words.
#include "src/deck/bad_deck.hpp"

namespace mortise::test {
namespace {

class HostileDecks : public testing::TestWithParam<BadDeck> {};

TEST_P(HostileDecks, GiveOneErrorWithLineCodeAndWords) { expect_one_error(GetParam()); }

/// A list in the line of `time`, which is the 26th; its first parameter stands in column 32.
std::string before_time(const std::string& list) { return list + R"(<ParameterList name="time">)"; }
std::string solver(const std::string& parameters) {
  return before_time(R"(<ParameterList name="solver">)" + parameters + "</ParameterList>");
}
std::string output(const std::string& parameters) {
  return before_time(R"(<ParameterList name="output">)" + parameters + "</ParameterList>");
}
std::string ramp(const std::string& arguments, const std::string& values) {
  return before_time(R"(<ParameterList name="tables"><ParameterList name="ramp">)" +
                     parameter("arguments", "Array(double)", arguments) + parameter("values", "Array(double)", values) +
                     "</ParameterList></ParameterList>");
}
const std::string time_list = R"(<ParameterList name="time">)";
const std::string top = "<ParameterList name=\"block\">";

const std::vector<BadDeck> hostile{
    {"Utf16", top, std::string("\xFF\xFE<\0P\0", 6), "1:1: error[D01]", {"not UTF-8 text"}},
    {"Utf16WithoutMark", top, std::string("<\0P\0", 4), "1:2: error[D01]", {"NUL byte: not a text file"}},
    {"ByteOrderMarkBeforeAnError", top, "\xEF\xBB\xBF" + top + "x", "1:29: error[D02]", {"unexpected text \"x"}},
    {"EntityBomb",
     top,
     "<!DOCTYPE a [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\"><!ENTITY c \"&b;&b;&b;\">]>\n" + top,
     "1:1",
     {"error[D01] DOCTYPE is refused"}},
    {"EntityOfAnotherFile",
     top,
     "<!DOCTYPE a [<!ENTITY b SYSTEM \"file:///etc/passwd\">]>\n" + top,
     "1:1",
     {"error[D01] DOCTYPE is refused"}},
    {"MisspeltAttribute",
     modulus,
     modulus + R"( vlaue="1")",
     "10:7: error[D03]",
     {"unknown attribute \"vlaue\"", "did you mean \"value\"?"}},
    {"ParameterTwiceWithTwoValues",
     recipe,
     recipe + parameter("recipe", "string", "graded block"),
     "4:61: error[D05]",
     {"it stands in line 4 already"}},
    {"IntegerOf2To64",
     time_list,
     solver(parameter("newton iterations", "int", "18446744073709551616")),
     "26:32: error[D09]",
     {"solver > \"newton iterations\" = ", "out of the range of integers, -2147483648 to 2147483647"}},
    {"IntegerOf2To31ForADouble",
     modulus,
     R"(type="int" value="2147483648")",
     "10:7: error[D09]",
     {"out of the range of integers"}},
    {"ValueWithAUnit", modulus, R"(type="double" value="2.5 MPa")", "10:7: error[D09]", {"= \"2.5 MPa\" - is not a number"}},
    {"FeatureThatDoesNotExist",
     time_list,
     before_time(R"(<ParameterList name="contact"><ParameterList name="pair">)" + parameter("secondary", "string", "cube/top") +
                 parameter("primary", "string", "cube/bottom") + parameter("friction coeficient", "double", "-0.1") +
                 "</ParameterList></ParameterList>"),
     "26:181: error[D06]",
     {"unknown parameter"}},
    {"NegativeModulus", modulus, R"(type="double" value="-7850")", "10:7: error[D08]", {"= -7850 - must be > 0"}},
    {"RatioAboveOneHalf",
     ratio,
     R"(type="double" value="0.6")",
     "11:7: error[D08]",
     {"= 0.6 - must be in (-1, 0.5); at 0.5 the bulk"}},
    {"EndOfZero", end, parameter("end", "double", "0"), "27:5: error[D08]", {"time > \"end\" = 0 - must be > 0"}},
    {"NegativeStep", R"(value="0.5")", R"(value="-0.5")", "28:5: error[D08]", {"time > \"step\" = -0.5 - must be > 0"}},
    {"SchemeThatDoesNotExist",
     end,
     end + parameter("scheme", "string", "statics"),
     "27:52: error[D10]",
     {"did you mean \"static\"?"}},
    {"ToleranceOfZero",
     time_list,
     solver(parameter("tolerance", "double", "0")),
     "26:32: error[D08]",
     {"solver > \"tolerance\" = 0 - must be in [1e-15, 0.1]; a relative residual below 1e-15 is round-off"}},
    {"ToleranceOfRoundOff",
     time_list,
     solver(parameter("tolerance", "double", "1e-16")),
     "26:32: error[D08]",
     {"= 1e-16 - must be in"}},
    {"ToleranceAboveOne",
     time_list,
     solver(parameter("tolerance", "double", "1.5")),
     "26:32: error[D08]",
     {"= 1.5 - must be in"}},
    {"NoIteration",
     time_list,
     solver(parameter("newton iterations", "int", "0")),
     "26:32: error[D08]",
     {"\"newton iterations\" = 0 - must be >= 1"}},
    {"TableThatIsNotSorted",
     time_list,
     ramp("{0, 2, 1}", "{0, 1, 2}"),
     "26:59: error[D17]",
     {"\"arguments\" = \"{0, 2, 1}\" - must be strictly ascending"}},
    {"TableWithADuplicate", time_list, ramp("{0, 1, 1}", "{0, 1, 2}"), "26:59: error[D17]", {"must be strictly ascending"}},
    {"TableOfOnePoint", time_list, ramp("{0}", "{0}"), "26:59: error[D17]", {"must have at least 2 entries"}},
    {"TableWithNaN", time_list, ramp("{0, nan}", "{0, 1}"), "26:59: error[D09]", {"entry 2, \"nan\", is not a finite number"}},
    {"UnknownField",
     time_list,
     output(parameter("fields", "Array(string)", "{displacement, von misses}")),
     "26:32: error[D10]",
     {"does not know \"von misses\"; did you mean \"von mises\"? allowed: displacement, von mises"}},
    {"FieldTwice",
     time_list,
     output(parameter("fields", "Array(string)", "{gap, gap}")),
     "26:32: error[D05]",
     {"repeats \"gap\""}},
    {"FrameEveryZeroSteps",
     time_list,
     output(parameter("every", "int", "0")),
     "26:32: error[D08]",
     {"output > \"every\" = 0 - must be >= 1"}},
};
INSTANTIATE_TEST_SUITE_P(Hostile, HostileDecks, testing::ValuesIn(hostile), name_of);

}  // namespace
}  // namespace mortise::test
