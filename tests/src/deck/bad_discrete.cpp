// Decks of point masses, springs between nodes and strings: good ones are read, bad ones give their place and words.
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

std::string deck_parameter(const std::string& name, const std::string& type, const std::string& value) {
  return parameter(name, type, value) + "\n";
}
std::string word(const std::string& name, const std::string& value) { return deck_parameter(name, "string", value); }
std::string number(const std::string& name, const std::string& value) { return deck_parameter(name, "double", value); }
std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">\n" + content + "</ParameterList>\n";
}

/// Two masses, a spring between them and a string, all lists replaceable.
struct Discrete {
  std::string masses = list("balls", word("set", "balls") + number("mass", "1"));
  std::string spring = word("from", "balls/1") + word("to", "balls/2") + number("stiffness", "10");
  std::string string = word("mesh", "rope") + number("area", "0.1") + number("youngs modulus", "5") + number("density", "2");
  std::string others, other_springs, scheme = "midpoint";

  operator std::string() const {
    const std::string meshes =
        list("balls", word("recipe", "points") + deck_parameter("coordinates", "Array(double)", "{0, 0, 0, 1, 0, 0}")) +
        list("rope", word("recipe", "line") + deck_parameter("order", "int", "2"));
    return list("d", list("meshes", meshes) + (masses.empty() ? "" : list("masses", masses)) +
                         (spring.empty() ? "" : list("springs", list("it", word("type", "between") + spring) + other_springs)) +
                         (string.empty() ? "" : list("strings", list("rope", string))) + others +
                         list("time", word("scheme", scheme) + number("step", "1") + number("end", "2")));
  }
};

TEST(DiscreteDeck, NeedsNeitherBodiesNorMaterials) {
  Discrete deck;
  deck.others = list("initial conditions", list("balls", deck_parameter("velocity", "Array(double)", "{1, 0, 0}")) +
                                               list("rope", deck_parameter("velocity", "Array(double)", "{1, 0, 0}"))) +
                list("loads", list("weight", word("type", "body force") + word("body", "rope") + word("z", "-1")));
  const Deck read = Deck::from_text("deck.xml", deck);
  EXPECT_EQ(read.options().masses[0].second.mass, 1);
  const auto& spring = std::get<springs::Between>(*read.options().springs[0].second.kind);
  EXPECT_EQ(*spring.to, "balls/2");
  EXPECT_EQ(spring.law, StretchLaw::saint_venant);
  EXPECT_EQ(read.options().strings[0].second.area, 0.1);
}

struct Fault {
  std::string name;
  Discrete deck;
  std::vector<std::string> words;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

Discrete with_spring(const std::string& spring) {
  Discrete deck;
  deck.spring = spring;
  return deck;
}
Discrete with_masses(const std::string& masses) {
  Discrete deck;
  deck.masses = masses;
  return deck;
}
Discrete with_string(const std::string& string) {
  Discrete deck;
  deck.string = string;
  return deck;
}
Discrete with_others(const std::string& others) {
  Discrete deck;
  deck.others = others;
  return deck;
}
Discrete augmented_with(const std::string& others, const std::string& scheme = "midpoint") {
  Discrete deck = with_others(others);
  deck.spring += word("formulation", "augmented");
  deck.scheme = scheme;
  return deck;
}
Discrete with_spring_at_nodes(const std::string& more) {
  Discrete deck;
  deck.other_springs = list("ground", word("type", "nodes") + word("set", "balls/1") + number("x", "1") + more);
  return deck;
}
Discrete without_anything() {
  Discrete deck;
  deck.masses = deck.string = deck.spring = "";
  return deck;
}

const std::string anchor = deck_parameter("anchor", "Array(double)", "{0, 0, 1}"), stiff = number("stiffness", "10"),
                  from = word("from", "balls/1"), to = word("to", "balls/2");
const std::vector<Fault> faults{
    {"NothingMoves", without_anything(), {"error[D07]", "\"bodies\" is missing: something must move"}},
    {"SpringWithOneEnd", with_spring(from + stiff), {"error[D12]", R"(exactly one of "to", "anchor" must be set, none is)"}},
    {"SpringWithThreeEnds", with_spring(from + to + anchor + stiff), {"error[D12]", R"(but "to" is set already)"}},
    {"SpringFromAndToOneNode", with_spring(from + word("to", "balls/1") + stiff), {"error[D19]", "it needs two ends"}},
    {"SpringWithoutStiffness", with_spring(from + to), {"error[D07]", "required \"stiffness\" is missing"}},
    {"SpringWithNegativeLength",
     with_spring(from + to + stiff + number("rest length", "-1")),
     {"error[D08]", "\"rest length\" = -1 - must be > 0"}},
    {"SpringOfAnUnknownLaw",
     with_spring(from + to + stiff + word("law", "hooke")),
     {"error[D10]", "allowed: saint venant, neo-hookean, logarithmic"}},
    {"SpringOfAnUnknownFormulation",
     with_spring(from + to + stiff + word("formulation", "augmentd")),
     {"error[D10]", "allowed: displacement, augmented", "did you mean \"augmented\"?"}},
    {"SpringsAtNodesAugmented",
     with_spring_at_nodes(word("formulation", "augmented")),
     {"error[D13]", "springs > ground > \"formulation\""}},
    {"AugmentedSpringWithGmres",
     augmented_with(list("solver", word("linear", "iterative"))),
     {"error[D19]", "springs > it > \"formulation\" = \"augmented\" - \"augmented\" needs the direct solver"}},
    {"AugmentedSpringByAnExplicitScheme",
     augmented_with("", "forward euler"),
     {"error[D19]", "springs > it > \"formulation\"", "time > \"scheme\" = \"forward euler\", which is explicit"}},
    {"SpringInAnUnknownMesh", with_spring(word("from", "ball/1") + to + stiff), {"error[D14]", "did you mean \"balls\"?"}},
    {"SpringBetweenWithASet", with_spring(from + to + stiff + word("set", "balls/1")), {"error[D13]", "\"set\""}},
    {"MassOfZero", with_masses(list("balls", word("set", "balls") + number("mass", "0"))), {"error[D08]", "must be > 0"}},
    {"MassOfAnUnknownMesh",
     with_masses(list("balls", word("set", "bals") + number("mass", "1"))),
     {"error[D14]", "there is no mesh \"bals\""}},
    {"StringWithoutDensity",
     with_string(word("mesh", "rope") + number("area", "0.1") + number("youngs modulus", "5")),
     {"error[D07]", "strings > rope - required \"density\" is missing: time > \"scheme\" = \"midpoint\" needs it"}},
    {"StringNamedAsMasses",
     with_masses(list("rope", word("set", "balls") + number("mass", "1"))),
     {"error[D11]", "strings > rope - this is the name of a body or masses already"}},
    {"StartOfNothing",
     with_others(list("initial conditions", list("bals", deck_parameter("velocity", "Array(double)", "{1, 0, 0}")))),
     {"error[D14]", "initial conditions > bals", "did you mean \"balls\"?"}},
};

class BadDiscrete : public testing::TestWithParam<Fault> {};

TEST_P(BadDiscrete, GivesOneErrorWithItsWords) {
  const std::string message = errors_of(GetParam().deck);
  for (const std::string& one : GetParam().words) EXPECT_NE(message.find(one), std::string::npos) << one << "\n" << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

INSTANTIATE_TEST_SUITE_P(Decks, BadDiscrete, testing::ValuesIn(faults), [](const auto& test) { return test.param.name; });

TEST(DiscreteDeck, PointsAreNotCutIntoOtherElements) {
  const std::string message =
      errors_of(with(Discrete{}, word("recipe", "line"), word("recipe", "line") + word("element type", "tet4")));
  EXPECT_NE(message.find("error[D13]"), std::string::npos) << message;
  EXPECT_NE(message.find("a \"recipe\" of hexahedra"), std::string::npos) << message;
}

}  // namespace
}  // namespace mortise::test
