// Loads, supports, springs and damping that must be refused: each with its line, its code and its words.
#include "src/deck/bad_deck.hpp"

namespace mortise::test {
namespace {

class BadLoads : public testing::TestWithParam<BadDeck> {};

TEST_P(BadLoads, GiveOneErrorWithLineCodeAndWords) { expect_one_error(GetParam()); }

/// `block_deck` with one further entry of a list, its parameters in lines of their own from the 27th on.
const std::string before_the_time = R"(<ParameterList name="time">)";
std::string entry_of(const std::string& list, const std::string& parameters) {
  return "<ParameterList name=\"" + list + "\"><ParameterList name=\"it\">\n" + parameters + "</ParameterList></ParameterList>" +
         before_the_time;
}
std::string line(const std::string& name, const std::string& type, const std::string& value) {
  return parameter(name, type, value) + "\n";
}
std::string typed(const std::string& type) { return line("type", "string", type); }
/// The same for `supports`, whose list stands there already.
const std::string first_support = R"(<ParameterList name="bottom">)";
std::string support(const std::string& parameters) {
  return "<ParameterList name=\"it\">\n" + parameters + "</ParameterList>" + first_support;
}
const std::string on_top = line("set", "string", "cube/top"), down = line("z", "string", "-t"),
                  body = "      " + parameter("material", "string", "rubber") + "\n";

const std::vector<BadDeck> wrong_loads{
    {"LoadWithoutType", before_the_time, entry_of("loads", on_top + down), "26:31: error[D07]", {"required \"type\" is missing"}},
    {"PressureOfATraction",
     before_the_time,
     entry_of("loads", typed("traction") + on_top + down + line("pressure", "string", "3")),
     "30:1: error[D13]",
     {R"(loads > it > "pressure" = "3" - is set but unused: it has a meaning only with "type" = "pressure")"}},
    {"PressureWithoutValue",
     before_the_time,
     entry_of("loads", typed("pressure") + on_top),
     "26:31: error[D12]",
     {R"(loads > it - at least one of "pressure" must be set)"}},
    {"StartAfterEnd",
     before_the_time,
     entry_of("loads", typed("traction") + on_top + down + line("start", "double", "1") + line("end", "double", "0.5")),
     "30:1: error[D08]",
     {R"(loads > it > "start" = 1 - must be before "end" = 0.5)"}},
    {"StartWhenAllIsOver",
     before_the_time,
     entry_of("springs", typed("nodes") + on_top + line("z", "double", "3") + line("start", "double", "2")),
     "30:1: error[D08]",
     {R"(springs > it > "start" = 2 - must be before time > "end" = 2)"}},
    {"NegativeStart",
     before_the_time,
     entry_of("loads", typed("traction") + on_top + down + line("start", "double", "-1")),
     "30:1: error[D08]",
     {"\"start\" = -1 - must be >= 0"}},
    {"WeightWithoutDensity",
     before_the_time,
     entry_of("loads", typed("body force") + down),
     "8:5: error[D07]",
     {R"(materials > rubber - required "density" is missing: the body force "it" needs it)"}},
    {"WeightOfAnUnknownBody",
     before_the_time,
     entry_of("loads", typed("body force") + line("body", "string", "cub") + down),
     "28:1: error[D14]",
     {"there is no body \"cub\"", "did you mean \"cube\"?"}},
    {"PointForceWithoutAPoint",
     before_the_time,
     entry_of("loads", typed("point force") + down),
     "26:31: error[D12]",
     {R"(exactly one of "set", "node", "nearest" must be set, none is)"}},
    {"PointForceAtANodeOfNoMesh",
     before_the_time,
     entry_of("loads", typed("point force") + line("node", "int", "1") + down),
     "26:31: error[D07]",
     {"\"mesh\" is missing: \"node\" and \"nearest\" are of a mesh"}},
    {"PointForceOnASetWithAMesh",
     before_the_time,
     entry_of("loads", typed("point force") + on_top + line("mesh", "string", "cube") + down),
     "29:1: error[D13]",
     {R"("mesh" = "cube" - is set but unused: it has a meaning only with "node" or "nearest")"}},
    {"PointForceOnAnUnknownMesh",
     before_the_time,
     entry_of("loads", typed("point force") + line("mesh", "string", "tube") + line("node", "int", "1") + down),
     "28:1: error[D14]",
     {"there is no mesh \"tube\""}},
    {"SpringWithoutStiffness",
     before_the_time,
     entry_of("springs", typed("bedding") + on_top),
     "26:33: error[D12]",
     {R"(springs > it - at least one of "x", "y", "z" must be set)"}},
    {"SpringOfZeroStiffness",
     before_the_time,
     entry_of("springs", typed("bedding") + on_top + line("x", "double", "0")),
     "29:1: error[D08]",
     {"must be > 0"}},
    {"SpringWithAFormula",
     before_the_time,
     entry_of("springs", typed("nodes") + on_top + line("x", "string", "3*t")),
     "29:1: error[D09]",
     {"must have type=\"double\""}},
    {"UnknownSupport",
     first_support,
     support(typed("velocty") + on_top + down),
     "22:1: error[D10]",
     {"did you mean \"velocity\"?"}},
    {"RotationAboutNothing",
     first_support,
     support(typed("rotation") + on_top + line("axis", "Array(double)", "{0, 0, 0}") + line("angle", "string", "t")),
     "24:1: error[D08]",
     {"supports > it > \"axis\"", "must not be zero"}},
    {"RotationWithoutAngle",
     first_support,
     support(typed("rotation") + on_top + line("axis", "Array(double)", "{0, 0, 1}")),
     "21:5: error[D12]",
     {R"(at least one of "angle" must be set)"}},
    {"AxisOfADisplacement",
     first_support,
     support(on_top + down + line("axis", "Array(double)", "{0, 0, 1}")),
     "24:1: error[D13]",
     {R"(is set but unused: it has a meaning only with "type" = "rotation")"}},
    {"MotionOfASymmetryPlane",
     first_support,
     support(typed("symmetry") + on_top + down),
     "24:1: error[D13]",
     {R"(it has a meaning only with "type" = "displacement", "velocity", "rotation")"}},
    {"DampingWithoutDensity",
     body,
     body + line("rayleigh mass", "double", "2"),
     "8:5: error[D07]",
     {R"("density" is missing: "rayleigh mass" of body "cube" needs it)"}},
    {"NegativeDamping", body, body + line("rayleigh stiffness", "double", "-2"), "18:1: error[D08]", {"must be >= 0"}},
    {"MassThatNothingUses",
     body,
     body + line("mass", "string", "lumped"),
     "18:1: error[D13]",
     {R"(it has a meaning only with "rayleigh mass" > 0)"}},
    {"DampingOfAMixedFormulation",
     body,
     body + line("rayleigh stiffness", "double", "2") + line("formulation", "string", "mixed"),
     "18:1: error[D19]",
     {"needs a \"formulation\" other than \"mixed\""}},
};
INSTANTIATE_TEST_SUITE_P(WrongLoads, BadLoads, testing::ValuesIn(wrong_loads), name_of);

}  // namespace
}  // namespace mortise::test
