// Fields by name: what decks may ask for, and what a scene does not have.
#include "deck/field_table.hpp"

#include <set>
#include <sstream>

#include "src/deck/bad_deck.hpp"

namespace mortise::test {
namespace {

const std::string time_list = "<ParameterList name=\"time\">";

/// With the list `output` (or another) before the list `time`, on line 26.
std::string and_list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>" + time_list;
}

std::string fields(const std::string& words) {
  return and_list("output", parameter("fields", "Array(string)", "{" + words + "}"));
}

std::string probe_of(const std::string& quantity) {
  return and_list("probes", "<ParameterList name=\"corner\">" + parameter("quantity", "string", quantity) +
                                parameter("mesh", "string", "cube") + parameter("node", "int", "1") + "</ParameterList>");
}

class BadFields : public testing::TestWithParam<BadDeck> {};

TEST_P(BadFields, GiveOneErrorWithLineCodeAndWords) { expect_one_error(GetParam()); }

const std::vector<BadDeck> bad_fields{
    {"VelocityInStatics",
     time_list,
     fields("displacement, velocity"),
     "26:32: error[D19]",
     {R"(output > "fields" = "{displacement, velocity}" - there is no "velocity": )", "static run",
      "fields of this deck: displacement, von mises"}},
    {"AccelerationInStatics", time_list, fields("acceleration"), "26:32: error[D19]", {"there is no \"acceleration\": "}},
    {"PressureWithoutContact",
     time_list,
     fields("contact pressure"),
     "26:32: error[D19]",
     {"there is no \"contact pressure\": the deck has no contact; fields of this deck: ", "cauchy stress, reaction, position, "}},
    {"GapWithoutContact", time_list, fields("gap"), "26:32: error[D19]", {"the deck has no contact"}},
    {"StatusWithoutContact", time_list, fields("status"), "26:32: error[D19]", {"the deck has no contact"}},
    {"ReactionWithoutSupports",
     R"(<ParameterList name="supports">
    <ParameterList name="bottom">
      <Parameter name="set" type="string" value="cube/bottom"/>
      <Parameter name="z" type="string" value="0"/>
    </ParameterList>
  </ParameterList>
)",
     "<ParameterList name=\"output\">" + parameter("fields", "Array(string)", "{reaction}") + "</ParameterList>\n",
     "20:32: error[D19]",
     {"the deck has no supports"}},
    {"ProbeOfAVelocity",
     time_list,
     probe_of("velocity_x"),
     "26:61: error[D19]",
     {R"(probes > corner > "quantity" = "velocity_x" - there is no "velocity_x": )", "static run"}},
    {"ProbeOfAGapWithoutContact", time_list, probe_of("gap"), "26:61: error[D19]", {"the deck has no contact"}},
    {"ProbeOfAFieldInsteadOfAComponent",
     time_list,
     probe_of("displacement"),
     "26:61: error[D10]",
     {"did you mean \"displacement_x\"?"}},
    {"NodalFieldAtPoints",
     time_list,
     and_list("output", parameter("element fields", "Array(string)", "{displacement}")),
     "26:32: error[D10]",
     {"does not know \"displacement\"", "allowed: von mises, cauchy stress"}},
    {"ElementFieldTwice",
     time_list,
     and_list("output", parameter("element fields", "Array(string)", "{von mises, von mises}")),
     "26:32: error[D05]",
     {"repeats \"von mises\""}},
    {"MisspeltMeasure", time_list, fields("second piola stres"), "26:32: error[D10]", {"did you mean \"second piola stress\"?"}},
};
INSTANTIATE_TEST_SUITE_P(Fields, BadFields, testing::ValuesIn(bad_fields), name_of);

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

TEST(Fields, OfTheIssueAreAllAccepted) {
  const std::string words =
      "displacement, reaction, cauchy stress, first piola stress, second piola stress, kirchhoff stress, principal stresses, "
      "principal directions, von mises, green-lagrange strain, almansi strain, volume ratio, energy density";
  const auto output = read_text(with(block_deck, time_list, fields(words))).output;
  EXPECT_EQ(joined(output.fields), words);
  EXPECT_TRUE(output.element_fields.empty());
}

TEST(Fields, OfPointsAreAllAcceptedAsElementFields) {
  const std::string words = joined(point_field_names());
  const auto list = and_list("output", parameter("element fields", "Array(string)", "{" + words + "}"));
  const auto output = read_text(with(block_deck, time_list, list)).output;
  EXPECT_EQ(joined(output.element_fields), words);
  EXPECT_EQ(output.element_fields.size(), 11u);
  EXPECT_EQ(output.fields, OutputOptions{}.fields);
}

TEST(Fields, HaveVariablesWithNamesOfTheirOwn) {
  std::set<std::string> names, variables;
  std::size_t n_variables = 0;
  for (const FieldEntry& entry : field_table) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(field_named(entry.name), entry.field);
    const auto of_field = variables_of_field(entry.name);
    n_variables += of_field.size();
    for (std::size_t c = 0; c < of_field.size(); ++c) {
      variables.insert(of_field[c]);
      const auto found = component_named(of_field[c]);
      EXPECT_EQ(found.field, entry.field) << of_field[c];
      EXPECT_EQ(found.component, c) << of_field[c];
    }
  }
  EXPECT_EQ(variables.size(), n_variables);
}

TEST(Fields, KeepTheNamesThatFilesAlwaysHad) {
  EXPECT_EQ(joined(variables_of_field("displacement")), "displacement_x, displacement_y, displacement_z");
  EXPECT_EQ(joined(variables_of_field("cauchy stress")), "stress_xx, stress_yy, stress_zz, stress_xy, stress_yz, stress_zx");
  EXPECT_EQ(joined(variables_of_field("von mises")), "von_mises");
  EXPECT_EQ(joined(variables_of_field("contact pressure")), "contact_pressure");
  EXPECT_EQ(joined(variables_of_field("reaction")), "reaction_x, reaction_y, reaction_z");
  EXPECT_EQ(variables_of_field("first piola stress").size(), 9u);
}

TEST(Fields, StandInTheReferenceWithUnitAndMeaning) {
  std::ostringstream out;
  print_reference(out, "output");
  std::string text = out.str();
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return std::isspace(a) && std::isspace(b); }),
             text.end());
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (const FieldEntry& entry : field_table) EXPECT_NE(text.find(entry.name), std::string::npos) << entry.name;
  for (const char* words : {"averaged over the points", "weighted with volume", "volume ratio: J = det F",
                            "energy density [force/length^2]", "at nodes of the mean Cauchy stress"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST(Fields, ThatNobodyKnowsAreErrorsOfTheProgram) {
  EXPECT_THROW(field_named("stress_xx"), std::logic_error);
  EXPECT_THROW(component_named("displacement"), std::logic_error);
}

}  // namespace
}  // namespace mortise::test
