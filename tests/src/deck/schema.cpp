// The schema of decks, judged by xmllint: what we ship is valid, and every misspelt name, wrong type or wrong word is refused.
#include <functional>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

namespace fs = std::filesystem;

const fs::path inputs = fs::path(MORTISE_SOURCE_DIR) / "inputs";

std::string text_of_file(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What xmllint says of each file. @throws std::runtime_error if it does not judge all of them, or finds fault with the schema
std::map<std::string, bool> are_valid(const std::vector<fs::path>& files) {
  std::ostringstream schema;
  print_schema(schema);
  const fs::path schema_file = write_file(schema.str(), "schema.rng"), report = write_file("", "report.txt");
  std::string command = "xmllint --noout --relaxng '" + schema_file.string() + "'";
  for (const fs::path& file : files) command += " '" + file.string() + "'";
  const int status = std::system((command + " >/dev/null 2>'" + report.string() + "'").c_str());
  std::map<std::string, bool> verdicts;
  std::istringstream lines(text_of_file(report));
  for (std::string line; std::getline(lines, line);) {
    for (const fs::path& file : files) {
      if (line == file.string() + " validates") verdicts[file.string()] = true;
      if (line == file.string() + " fails to validate") verdicts[file.string()] = false;
    }
  }
  if (verdicts.size() != files.size())
    throw std::runtime_error("xmllint: " + std::to_string(status) + ", " + text_of_file(report));
  return verdicts;
}

bool is_valid(const std::string& text) { return are_valid({write_file(text, "one.xml")}).begin()->second; }

bool reader_refuses(const std::string& text) { return !errors_of(text).empty(); }

/// Changes to a deck that the schema must refuse, each with its name.
using Mutants = std::vector<std::pair<std::string, std::string>>;

/// The schema refuses all of them, and so does the reader: the schema asks for nothing of its own.
void expect_refused(const Mutants& mutants) {
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < mutants.size(); ++k) {
    files.push_back(write_file(mutants[k].second, "mutant_" + std::to_string(k) + ".xml"));
    EXPECT_TRUE(reader_refuses(mutants[k].second)) << mutants[k].first;
  }
  const auto verdicts = are_valid(files);
  for (std::size_t k = 0; k < mutants.size(); ++k) EXPECT_FALSE(verdicts.at(files[k].string())) << mutants[k].first;
}

/// One mutant for every element of the deck that `is_meant`.
Mutants mutants_of(const std::string& deck, const std::string& what, const std::function<bool(const pugi::xml_node&)>& is_meant,
                   const std::function<void(pugi::xml_node)>& change) {
  pugi::xml_document original;
  original.load_string(deck.c_str());
  const pugi::xpath_node_set elements = original.select_nodes("/ParameterList//*");
  Mutants mutants;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (!is_meant(elements[k].node())) continue;
    pugi::xml_document mutant;
    mutant.reset(original);
    const pugi::xml_node element = mutant.select_nodes("/ParameterList//*")[k].node();
    std::string name = what + ":";
    for (pugi::xml_node above = element; above; above = above.parent())
      name += std::string(" ") + above.attribute("name").value();
    change(element);
    std::ostringstream text;
    mutant.save(text);
    mutants.emplace_back(name, text.str());
  }
  EXPECT_GT(mutants.size(), 0u) << what;
  return mutants;
}

bool is_parameter(const pugi::xml_node& element) { return std::string(element.name()) == "Parameter"; }
bool is_list(const pugi::xml_node& element) { return !is_parameter(element); }
/// Such as `meshes`: its name is ours.
bool is_top_list(const pugi::xml_node& element) { return is_list(element) && !element.parent().parent().parent(); }
bool is_of_the_users_name(const pugi::xml_node& element) { return is_list(element) && !is_top_list(element); }

TEST(Schema, AcceptsEveryShippedDeckAndRecipe) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(inputs)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  ASSERT_GE(files.size(), 12u);
  for (const auto& [file, valid] : are_valid(files)) EXPECT_TRUE(valid) << file;
}

TEST(Schema, AcceptsWhatTheReaderAcceptsInWhateverOrderAndSpelling) {
  EXPECT_TRUE(is_valid(ironing_deck));
  for (const std::string number : {"1", " 2.5\t", "+3", ".5", "1.", "1E-2", "1e+2"}) {
    const std::string deck = with(block_deck, R"("2.5")", "\"" + number + "\"");
    EXPECT_TRUE(is_valid(deck) && !reader_refuses(deck)) << number;
  }
  for (const auto& [type, value] : {std::pair{"Array(double)", "{1,2e0, 3.}"}, {"Array(int)", " { 1, 2 ,3 } "}}) {
    const std::string recipe = parameter("recipe", "string", "block");
    const std::string deck = with(block_deck, recipe, parameter("size", type, value) + "<!-- size -->" + recipe);
    EXPECT_TRUE(is_valid(deck) && !reader_refuses(deck)) << value;
  }
  const std::string integer = with(block_deck, R"(type="double" value="2.5")", R"(type="int" value="2")");
  EXPECT_TRUE(is_valid(integer) && !reader_refuses(integer));
  const std::string no_fields =
      with_lists("<ParameterList name=\"output\">" + parameter("fields", "Array(string)", "{ }") + "</ParameterList>");
  EXPECT_TRUE(is_valid(no_fields) && !reader_refuses(no_fields));
}

TEST(Schema, KnowsTheParametersOfEveryMaterial) {
  const auto with_model = [](const std::string& name, const std::string& parameters) {
    return with(block_deck, elastic_parameters, parameter("model", "string", name) + parameters);
  };
  const std::string series =
      parameter("exponents", "Array(double)", "{1.3, 5, -2}") + parameter("moduli", "Array(double)", "{6300, 12, -100}");
  const std::string c1_c2 = parameter("c1", "double", "2") + parameter("c2", "int", "1");
  for (const auto& deck :
       {with_model("mooney-rivlin", c1_c2 + parameter("c", "double", "5")), with_model("ogden incompressible", series),
        with_model("neo-hookean power-law", parameter("shear modulus", "double", "2") + parameter("lame lambda", "double", "0") +
                                                parameter("density", "double", "1e-9"))})
    EXPECT_TRUE(is_valid(deck) && !reader_refuses(deck)) << deck;
  expect_refused({{"misspelt model", with_model("ogdon incompressible", series)},
                  {"one number for a series", with_model("ogden incompressible", with(series, "\"{1.3, 5, -2}\"", "\"1.3\""))},
                  {"misspelt c1", with_model("mooney-rivlin incompressible", with(c1_c2, "\"c1\"", "\"C1\""))}});
}

TEST(Schema, RefusesEveryMisspeltName) {
  const auto misspell = [](pugi::xml_node element) {
    element.attribute("name") = (std::string(element.attribute("name").value()) + "q").c_str();
  };
  expect_refused(mutants_of(ironing_deck, "parameter", is_parameter, misspell));
  expect_refused(mutants_of(ironing_deck, "list", is_top_list, misspell));
  expect_refused(mutants_of(ironing_deck, "second blank", is_parameter, [](pugi::xml_node element) {
    element.attribute("name") = (std::string(" ") + element.attribute("name").value()).c_str();
  }));
  expect_refused(mutants_of(ironing_deck, "dot", is_of_the_users_name, [](pugi::xml_node element) {
    element.attribute("name") = (std::string(element.attribute("name").value()) + ".1").c_str();
  }));
}

TEST(Schema, RefusesEveryWrongType) {
  expect_refused(mutants_of(ironing_deck, "bool", is_parameter, [](pugi::xml_node element) {
    element.attribute("type") = "bool";
    element.attribute("value") = "true";
  }));
  expect_refused(
      mutants_of(ironing_deck, "float", is_parameter, [](pugi::xml_node element) { element.attribute("type") = "float"; }));
  expect_refused(mutants_of(
      ironing_deck, "double for string",
      [](const pugi::xml_node& element) { return std::string(element.attribute("type").value()) == "string"; },
      [](pugi::xml_node element) {
        element.attribute("type") = "double";
        element.attribute("value") = "1";
      }));
}

TEST(Schema, RefusesEveryEmptyValueAndEveryWordForANumber) {
  expect_refused(
      mutants_of(ironing_deck, "blank", is_parameter, [](pugi::xml_node element) { element.attribute("value") = " "; }));
  const auto is_number = [](const pugi::xml_node& element) {
    const std::string type = element.attribute("type").value();
    return is_parameter(element) && type != "string" && type != "Array(string)";
  };
  expect_refused(mutants_of(ironing_deck, "word", is_number, [](pugi::xml_node element) { element.attribute("value") = "one"; }));
  expect_refused(mutants_of(ironing_deck, "word in array", is_number,
                            [](pugi::xml_node element) { element.attribute("value") = "{1, b, 3}"; }));
}

TEST(Schema, RefusesForeignAttributesElementsAndText) {
  const auto any = [](const pugi::xml_node&) { return true; };
  expect_refused(
      mutants_of(ironing_deck, "attribute", any, [](pugi::xml_node element) { element.append_attribute("unit") = "Pa"; }));
  expect_refused(mutants_of(ironing_deck, "no name", any, [](pugi::xml_node element) { element.remove_attribute("name"); }));
  expect_refused(
      mutants_of(ironing_deck, "no value", is_parameter, [](pugi::xml_node element) { element.remove_attribute("value"); }));
  expect_refused(
      mutants_of(ironing_deck, "no type", is_parameter, [](pugi::xml_node element) { element.remove_attribute("type"); }));
  expect_refused(mutants_of(ironing_deck, "element", any, [](pugi::xml_node element) { element.set_name("List"); }));
  expect_refused(mutants_of(ironing_deck, "text", any,
                            [](pugi::xml_node element) { element.append_child(pugi::node_pcdata).set_value("text"); }));
  expect_refused(
      mutants_of(ironing_deck, "child", is_parameter, [](pugi::xml_node element) { element.append_child("Parameter"); }));
}

TEST(Schema, RefusesWrongWordsAndNumbersThatAreNone) {
  Mutants mutants;
  for (const std::string number : {"abc", "1,5", "1e", "0x10", "inf", "INF", "nan", "NaN", "++1", "1 2", "1.5m"}) {
    mutants.emplace_back(number, with(block_deck, R"("2.5")", "\"" + number + "\""));
  }
  for (const std::string integer : {"2.5", "1e3", "2147483648", "18446744073709551616"}) {
    mutants.emplace_back(integer, with(block_deck, R"(type="double" value="2.5")", "type=\"int\" value=\"" + integer + "\""));
  }
  for (const auto& [type, value] : {std::pair{"Array(double)", "{1, 2}"},
                                    {"Array(double)", "{1, 2, 3, 4}"},
                                    {"Array(double)", "1, 2, 3"},
                                    {"Array(double)", "{1, , 3}"},
                                    {"Array(int)", "{1, 2.5, 3}"},
                                    {"Array(double)", "{}"}}) {
    const std::string recipe = parameter("recipe", "string", "block");
    mutants.emplace_back(value, with(block_deck, recipe, recipe + parameter("size", type, value)));
  }
  for (const auto& [from, to] : {std::pair{R"("neo-hookean")", R"("neo-hokean")"},
                                 {R"("block")", R"("blok")"},
                                 {R"("mortar")", R"("Mortar")"},
                                 {R"("static")", R"("static ")"},
                                 {"von mises", "von misses"},
                                 {"{displacement, von", "{displacement; von"},
                                 {"gap, status}", "gap, status"}}) {
    mutants.emplace_back(to, with(ironing_deck, from, to));
  }
  mutants.emplace_back("top", with(with(block_deck, "<ParameterList name=\"block\">", "<Deck>"),
                                   "</ParameterList>\n</ParameterList>", "</ParameterList>\n</Deck>"));
  expect_refused(mutants);
}

}  // namespace
}  // namespace mortise::test
