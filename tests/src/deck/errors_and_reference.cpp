// Suggestions for misspelt names, many errors at once, files that cannot be read, and the printed reference.
#include <sstream>

#include "deck/codes.hpp"
#include "deck/fields.hpp"
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

TEST(NearestName, IsWithinAThirdOfTheLength) {
  const std::vector<std::string> known{"mortar", "poissons ratio", "x", "size", "slab"};
  EXPECT_EQ(nearest_name("mortr", known), "mortar");
  EXPECT_EQ(nearest_name("mrotar", known), "mortar");
  EXPECT_EQ(nearest_name("poisson ratio", known), "poissons ratio");
  EXPECT_EQ(nearest_name("seize", known), "size");
  EXPECT_EQ(nearest_name("penalty", known), "");
  EXPECT_EQ(nearest_name("blas", known), "");
  EXPECT_EQ(nearest_name("mortar", {}), "");
  EXPECT_EQ(did_you_mean("mortr", known), "; did you mean \"mortar\"?");
  EXPECT_EQ(did_you_mean("penalty", known), "");
  EXPECT_EQ(join({"a", "b", "c"}), "a, b, c");
}

TEST(UserErrors, ListTwentyAndCountTheRest) {
  const UserError error(ExitCode::deck, std::vector<std::string>(23, "one line"));
  EXPECT_EQ(count_lines(error.what()), 21u);
  EXPECT_NE(std::string(error.what()).find("\nand 3 more errors"), std::string::npos);
}

TEST(Deck, WithSeveralErrorsListsAllInTheOrderOfTheText) {
  std::string text = with(block_deck, R"(value="2.5")", R"(value="-2")");
  text = with(text, R"(value="rubber")", R"(value="ruber")");
  text = with(text, R"(value="block")", R"(value="blok")");
  text = with(text, R"(value="cube/bottom")", R"(value="cube/bottom" more="")");
  const std::string messages = errors_of(text);
  const std::size_t first = messages.find("deck.xml:4:7: error[D10]"), second = messages.find("\ndeck.xml:10:7: error[D08]"),
                    third = messages.find("\ndeck.xml:17:7: error[D14]"), fourth = messages.find("\ndeck.xml:22:7: error[D03]");
  EXPECT_EQ(first, 0u) << messages;
  EXPECT_LT(first, second) << messages;
  EXPECT_LT(second, third) << messages;
  EXPECT_LT(third, fourth) << messages;
  EXPECT_EQ(count_lines(messages), 4u) << messages;
}

TEST(Deck, WithLabelsOfUnitsShowsThemInErrors) {
  const std::string text = with(block_deck, R"(value="2.5")", R"(value="-2")");
  const std::string units = R"(<ParameterList name="units"><Parameter name="length" type="string" value="mm"/>
  <Parameter name="force" type="string" value="N"/></ParameterList>)";
  EXPECT_NE(errors_of(with(text, "<ParameterList name=\"meshes\">", units + "<ParameterList name=\"meshes\">"))
                .find("\"youngs modulus\" = -2 N/mm^2 - must be > 0"),
            std::string::npos);
}

std::string error_of_lists(const std::string& lists) { return errors_of(with_lists(lists)); }

TEST(Contact, WithOneSurfaceOnBothSidesIsRefused) {
  const std::string message = error_of_lists(R"(<ParameterList name="contact"><ParameterList name="pair">
  <Parameter name="secondary" type="string" value="cube/top"/>
  <Parameter name="primary" type="string" value="cube/top"/>
  </ParameterList></ParameterList>)");
  EXPECT_EQ(message.find("deck.xml:32:3: error[D19] contact > pair > \"primary\" = \"cube/top\" - is the secondary"), 0u)
      << message;
}

std::string with_friction_of(const std::string& parameters, const std::string& solver = "") {
  return R"(<ParameterList name="contact"><ParameterList name="pair">
  <Parameter name="secondary" type="string" value="cube/top"/>
  <Parameter name="primary" type="string" value="cube/bottom"/>
  )" + parameters +
         R"(
  </ParameterList></ParameterList>)" +
         solver;
}

TEST(Contact, WithFrictionThatCannotBeIsRefused) {
  const std::string coefficient = R"(<Parameter name="friction coefficient" type="double" value="0.3"/>)";
  std::string message =
      error_of_lists(with_friction_of(R"(<Parameter name="friction coefficient" type="double" value="-0.3"/>)"));
  EXPECT_NE(message.find("error[D08] contact > pair > \"friction coefficient\" = -0.3 - must be >= 0"), std::string::npos)
      << message;
  message = error_of_lists(with_friction_of(R"(<Parameter name="tangential penalty" type="double" value="1e3"/>)"));
  EXPECT_NE(message.find("error[D13] contact > pair > \"tangential penalty\""), std::string::npos) << message;
  EXPECT_NE(message.find("only with \"friction coefficient\""), std::string::npos) << message;
  message = error_of_lists(with_friction_of(coefficient, R"(<ParameterList name="solver">
  <Parameter name="linear" type="string" value="iterative"/></ParameterList>)"));
  EXPECT_NE(message.find("error[D19] solver > \"linear\""), std::string::npos) << message;
  message = errors_of(with(with_lists(with_friction_of(coefficient)), "name=\"time\">",
                           "name=\"time\"><Parameter name=\"scheme\" type=\"string\" value=\"trapezoidal\"/>"));
  EXPECT_NE(message.find("error[D19] contact > pair > \"friction coefficient\""), std::string::npos) << message;
}

TEST(Contact, WithAMisspeltMethodOrALowQuadratureDegreeIsRefusedWithTheReason) {
  const std::string message = error_of_lists(R"(<ParameterList name="contact"><ParameterList name="pair">
  <Parameter name="secondary" type="string" value="cube/top"/>
  <Parameter name="primary" type="string" value="cube/bottom"/>
  <Parameter name="method" type="string" value="mortr"/>
  <Parameter name="quadrature degree" type="int" value="2"/>
  </ParameterList></ParameterList>)");
  EXPECT_EQ(message.find("deck.xml:33:3: error[D10]"), 0u) << message;
  EXPECT_NE(message.find("did you mean \"mortar\"? allowed: mortar"), std::string::npos) << message;
  EXPECT_NE(message.find("deck.xml:34:3: error[D08]"), std::string::npos) << message;
  EXPECT_NE(message.find("must be in [3, 8]; products of two bilinear"), std::string::npos) << message;
}

TEST(Expected, DeclaredButEmptyIsRefused) {
  const std::string message = error_of_lists(R"(<ParameterList name="expected"/>)");
  EXPECT_EQ(message.find("deck.xml:30:1: error[D18] expected - is declared but empty"), 0u) << message;
}

std::string expected_value(const std::string& parameters, const std::string& quantity = "reaction_z.bottom") {
  return error_of_lists(R"(<ParameterList name="expected"><ParameterList name="force">
  <Parameter name="quantity" type="string" value=")" +
                        quantity + R"("/>
  <Parameter name="value" type="double" value="1"/>)" +
                        parameters + "</ParameterList></ParameterList>");
}

TEST(Expected, NeedsOneTimeThatIsAStopAndAPositiveTolerance) {
  const std::string tolerance = parameter("tolerance", "double", "0.1");
  const std::string at = R"(<Parameter name="at time" type="double" value=")",
                    mean = R"(<Parameter name="mean from" type="double" value=")";
  const auto has = [](const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; };
  EXPECT_EQ(expected_value(tolerance + at + "2\"/>"), "");
  EXPECT_EQ(expected_value(tolerance + mean + "0\"/>"), "");
  EXPECT_TRUE(has(expected_value(tolerance), "error[D12]"));
  EXPECT_TRUE(has(expected_value(tolerance + at + "2\"/>" + mean + "1\"/>"), "error[D12]"));
  EXPECT_TRUE(has(expected_value(tolerance + at + "1.5\"/>"), "must be one of time > \"stops\" or the end: 2"));
  EXPECT_TRUE(has(expected_value(tolerance + mean + "2\"/>"), "must be before"));
  EXPECT_TRUE(has(expected_value(parameter("tolerance", "double", "0") + at + "2\"/>"), "= 0 - must be > 0"));
  EXPECT_TRUE(has(expected_value(tolerance + at + "2\"/>", "reaction_z.botom"), "did you mean \"reaction_z.bottom\"?"));
  EXPECT_EQ(expected_value(tolerance + at + "2\"/>", "strain_energy"), "");
}

TEST(Loads, NeedAKnownTypeAndAComponent) {
  const auto message = [](const std::string& type) {
    return error_of_lists(R"(<ParameterList name="loads"><ParameterList name="push">
  <Parameter name="type" type="string" value=")" +
                          type + R"("/>
  <Parameter name="set" type="string" value="cube/top"/>
  </ParameterList></ParameterList>)");
  };
  const std::string unknown = message("tracton"), empty = message("traction");
  EXPECT_NE(unknown.find("error[D10] loads > push > \"type\" = \"tracton\""), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("did you mean \"traction\"?"), std::string::npos) << unknown;
  EXPECT_NE(empty.find("error[D12] loads > push - at least one of"), std::string::npos) << empty;
}

TEST(Tables, ThatAreFaultyOrUnusedAreRefused) {
  const auto table = [](const std::string& name, const std::string& arguments, const std::string& values) {
    return error_of_lists("<ParameterList name=\"tables\"><ParameterList name=\"" + name +
                          "\"><Parameter name=\"arguments\" type=\"Array(double)\" value=\"" + arguments +
                          "\"/><Parameter name=\"values\" type=\"Array(double)\" value=\"" + values +
                          "\"/></ParameterList></ParameterList>");
  };
  const auto has = [](const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; };
  EXPECT_TRUE(has(table("ramp", "{0, 1}", "{0, 1}"), "error[D15] tables > ramp - is not used by any formula"));
  EXPECT_TRUE(has(table("ramp", "{0, 0}", "{0, 1}"), "error[D17]"));
  EXPECT_TRUE(has(table("ramp", "{0}", "{0}"), "at least 2"));
  EXPECT_TRUE(has(table("ramp", "{0, 1}", "{0, 1, 2}"), "as many entries"));
  EXPECT_TRUE(has(table("up ramp", "{0, 1}", "{0, 1}"), "error[D11]"));
  EXPECT_TRUE(has(table("sin", "{0, 1}", "{0, 1}"), "has a meaning in formulas already"));
}

TEST(Solver, ParametersOfGmresAreUnusedWithADirectSolver) {
  const std::string message = error_of_lists(R"(<ParameterList name="solver">
  <Parameter name="linear" type="string" value="direct"/>
  <Parameter name="fill level" type="int" value="2"/></ParameterList>)");
  EXPECT_EQ(message.find("deck.xml:32:3: error[D13] solver > \"fill level\" = 2 - is set but unused"), 0u) << message;
}

TEST(Unused, MeshAndMaterialAreRefused) {
  std::string text =
      with(block_deck, "<ParameterList name=\"meshes\">",
           "<ParameterList name=\"meshes\"><ParameterList name=\"idle\"><Parameter name=\"recipe\" type=\"string\" "
           "value=\"block\"/></ParameterList>");
  text = with(text, "<ParameterList name=\"rubber\">",
              "<ParameterList name=\"steel\"><Parameter name=\"model\" type=\"string\" value=\"neo-hookean\"/><Parameter "
              "name=\"youngs modulus\" type=\"double\" value=\"1\"/><Parameter name=\"poissons ratio\" type=\"double\" "
              "value=\"0\"/></ParameterList><ParameterList name=\"rubber\">");
  const std::string messages = errors_of(text);
  EXPECT_NE(messages.find("error[D15] meshes > idle - is not used by any body"), std::string::npos) << messages;
  EXPECT_NE(messages.find("error[D15] materials > steel - is not used by any body"), std::string::npos) << messages;
  EXPECT_EQ(count_lines(messages), 2u) << messages;
}

/// The message of a file that cannot be read; empty if it can.
std::string file_error_of(const std::filesystem::path& file) {
  try {
    Deck::read(file);
  } catch (const FileError& error) {
    EXPECT_EQ(error.code(), ExitCode::input_output);
    return error.what();
  } catch (const DeckError& error) {
    ADD_FAILURE() << error.what();
  }
  return "";
}

TEST(DeckFile, ThatIsMissingOrAFolderOrALoopIsAFileError) {
  EXPECT_EQ(file_error_of("/nowhere/deck.xml"), "/nowhere/deck.xml: error[I01] no such file");
  EXPECT_EQ(file_error_of("/tmp"), "/tmp: error[I01] is a directory, not a file");
  EXPECT_EQ(file_error_of("/dev/null"), "/dev/null: error[I01] not a file");
  const std::filesystem::path loop = write_file("").parent_path() / "loop.xml";
  std::filesystem::create_symlink("loop.xml", loop);
  EXPECT_EQ(file_error_of(loop), loop.string() + ": error[I01] Too many levels of symbolic links");
}

TEST(DeckFile, WithoutPermissionToReadIsAFileError) {
  const std::filesystem::path file = write_file(block_deck, "closed.xml");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  constexpr uid_t nobody = 65534;
  const uid_t before = geteuid();  // root may read everything
  ASSERT_TRUE(before != 0 || seteuid(nobody) == 0);
  const std::string message = file_error_of(file);
  ASSERT_TRUE(before != 0 || seteuid(before) == 0);
  EXPECT_EQ(message, file.string() + ": error[I01] cannot be opened: Permission denied");
}

TEST(DeckFile, ThatIsEmptyIsADeckError) {
  EXPECT_EQ(errors_of(""), "deck.xml:1:1: error[D01] the file is empty");
  EXPECT_EQ(errors_of(" \n"), "deck.xml:1:1: error[D01] the file is empty");
}

TEST(DeckFile, CutAnywhereIsRefusedCleanly) {
  for (std::size_t length = 0; length + 2 < block_deck.size(); length += 7) {
    EXPECT_NE(errors_of(block_deck.substr(0, length)), "") << length;
  }
}

TEST(DeckFile, ThatIsVeryDeepOrVeryLargeIsRefused) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<ParameterList name=\"a\">";
  for (int i = 0; i < 100000; ++i) deep += "</ParameterList>";
  EXPECT_NE(errors_of(deep).find("error[D04] lists are nested deeper than 32"), std::string::npos);
  EXPECT_NE(errors_of(std::string((16u << 20) + 1, ' ')).find("error[D04]"), std::string::npos);
  const std::string unclosed = errors_of(deep.substr(0, deep.size() / 2));
  EXPECT_NE(unclosed.find("error[D01] XML: "), std::string::npos) << unclosed;
}

TEST(DeckFile, WithAnAttributeOf100MegabytesIsRefusedUnread) {
  const std::filesystem::path file = write_file("<ParameterList name=\"", "large.xml");
  std::filesystem::resize_file(file, 100u << 20);  // a hole on the disk
  try {
    Deck::read(file);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_EQ(std::string(error.what()), file.string() + ":1:1: error[D04] the file has 104857600 bytes - must be at most 16 MB");
  }
}

TEST(DeckFile, WithAnAttributeOf15MegabytesGetsAShortMessage) {
  const std::string message = errors_of(with(block_deck, "neo-hookean", std::string(15u << 20, 'n')));
  EXPECT_EQ(message.find("deck.xml:9:7: error[D10]"), 0u) << message.substr(0, 200);
  const std::string choices = join(names_of_kinds<MaterialModel>());
  ASSERT_NE(message.find(choices), std::string::npos) << message.substr(0, 500);
  EXPECT_LT(message.size() - choices.size(), 200u);
}

std::string reference(const std::string& list = "") {
  std::ostringstream out;
  print_reference(out, list);
  return out.str();
}

TEST(Reference, NamesEveryParameterAndCode) {
  std::string text = " " + reference();
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (const char* name : {"title",
                           "length",
                           "force",
                           "file",
                           "recipe",
                           "size",
                           "elements",
                           "grading",
                           "origin",
                           "rotation",
                           "model",
                           "youngs modulus",
                           "poissons ratio",
                           "mesh",
                           "blocks",
                           "material",
                           "tangent",
                           "arguments",
                           "values",
                           "set",
                           "x",
                           "y",
                           "z",
                           "type",
                           "secondary",
                           "primary",
                           "method",
                           "contact force",
                           "quadrature degree",
                           "scheme",
                           "end",
                           "step",
                           "largest step",
                           "smallest step",
                           "growth",
                           "easy iterations",
                           "stops",
                           "linear",
                           "tolerance",
                           "newton iterations",
                           "further iterations",
                           "linear tolerance",
                           "linear iterations",
                           "fill level",
                           "fields",
                           "every",
                           "quantity",
                           "node",
                           "nearest",
                           "at time",
                           "mean from",
                           "value",
                           "source"}) {
    EXPECT_NE(text.find(std::string(" ") + name + " "), std::string::npos) << name;
  }
  for (const DeckCode& one : deck_codes) EXPECT_NE(text.find(one.code), std::string::npos) << one.code;
  EXPECT_NE(text.find("in (-1, 0.5)"), std::string::npos);
  EXPECT_NE(text.find("default 25"), std::string::npos);
}

TEST(Reference, NamesEachRecipeWithItsOwnParameters) {
  const std::string text = reference("meshes");
  for (const std::string& name : names_of_kinds<Recipe>()) {
    EXPECT_NE(text.find("recipe = \"" + name + "\": "), std::string::npos) << name;
  }
  const std::size_t torus = text.find("recipe = \"torus\""), ring = text.find("ring radius "),
                    next = text.find("recipe = \"cylinder\"");
  EXPECT_LT(torus, ring);
  EXPECT_LT(ring, next);
}

TEST(Reference, NamesEachMaterialWithItsOwnParameters) {
  const std::string text = reference("materials");
  for (const std::string& name : names_of_kinds<MaterialModel>()) {
    EXPECT_NE(text.find("model = \"" + name + "\": "), std::string::npos) << name;
  }
  const std::size_t ogden = text.find("model = \"ogden\""), exponents = text.find("exponents "),
                    volumetric = text.find("volumetric exponent "), next = text.find("model = \"neo-hookean isochoric"),
                    density = text.find("density ");
  EXPECT_LT(ogden, exponents);
  EXPECT_LT(exponents, volumetric);
  EXPECT_LT(volumetric, next);
  EXPECT_LT(next, density);
  EXPECT_NE(text.find("[mass/length^3], > 0, optional"), std::string::npos);
  EXPECT_NE(text.find("Rule: \"youngs modulus\" must belong to exactly one pair of moduli"), std::string::npos);
}

TEST(Reference, OfOneListHasOnlyThatList) {
  const std::string text = reference("contact");
  EXPECT_NE(text.find("quadrature degree"), std::string::npos);
  EXPECT_EQ(text.find("youngs modulus"), std::string::npos);
  EXPECT_EQ(text.find("title"), std::string::npos);
}

TEST(Reference, OfAnUnknownListSuggestsTheNearest) {
  try {
    reference("contakt");
    FAIL();
  } catch (const UserError& error) {
    EXPECT_EQ(error.code(), ExitCode::command_line);
    EXPECT_NE(std::string(error.what()).find("did you mean \"contact\"?"), std::string::npos);
  }
}

}  // namespace
}  // namespace mortise::test
