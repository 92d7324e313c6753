// Recipes as a user meets them: the files of inputs/recipes, and a deck with an indenter.
#include <gtest/gtest.h>

#include <set>

#include "deck/deck.hpp"
#include "deck/fields.hpp"
#include "mesh/combine.hpp"
#include "mesh/exodus.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

namespace fs = std::filesystem;

TEST(RecipeFiles, AreSoundAndNameEveryRecipe) {
  std::set<std::string> seen{"block"};  // inputs/ironing has it
  for (const auto& entry : fs::directory_iterator(std::string(MORTISE_SOURCE_DIR) + "/inputs/recipes")) {
    if (entry.path().extension() != ".xml") continue;
    seen.insert(name_of_kind(read_recipe(entry.path()).recipe.value()));
    EXPECT_NO_THROW(make_mesh(read_recipe(entry.path()), "")) << entry.path();
  }
  const auto names = names_of_kinds<Recipe>();
  EXPECT_EQ(seen, std::set<std::string>(names.begin(), names.end()));
}

TEST(RecipeFiles, GiveTheSameBytesEachTime) {
  const ScratchFolder folder;
  const std::string recipe = std::string("mesh '") + MORTISE_SOURCE_DIR + "/inputs/recipes/torus.xml' -o ";
  for (const std::string file : {"one.e", "two.e"}) {
    const auto made = run_mortise(folder, recipe + file);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  EXPECT_TRUE(text_of(folder / "one.e") == text_of(folder / "two.e"));
  EXPECT_EQ(n_elements(read_exodus(folder / "one.e")), 390);
}

TEST(RecipeFiles, WithBadDataEndWithCode2AndTheWords) {
  const ScratchFolder folder;
  folder.write("torus.xml", R"(<ParameterList name="torus">
  <Parameter name="recipe" type="string" value="torus"/>
  <Parameter name="ring radius" type="double" value="1"/>
  <Parameter name="inner radius" type="double" value="1"/>
  <Parameter name="outer radius" type="double" value="2"/>
  <Parameter name="height" type="double" value="2"/>
</ParameterList>)");
  const auto made = run_mortise(folder, "mesh torus.xml -o torus.e");
  EXPECT_EQ(made.code, 2);
  EXPECT_NE(made.err.find("torus.xml:3:3: error[D08] \"ring radius\" = 1 - must be greater than \"outer radius\" = 2"),
            std::string::npos)
      << made.err;
  EXPECT_NE(made.err.find("torus.xml:6:3: error[D13] \"height\" = 2 - is set but unused"), std::string::npos) << made.err;
  EXPECT_FALSE(fs::exists(folder / "torus.e"));
}

/// The ironing deck with a round indenter that is pressed in a little.
std::string round_indenter_deck() {
  auto deck = without_list(input_deck("ironing/frictionless.xml"), "expected");
  const std::size_t indenter = deck.find("<ParameterList name=\"indenter\">");
  const std::size_t word = deck.find("\"block\"/>", indenter);
  deck.replace(word, 9,
               "\"curved indenter\"/>\n      <Parameter name=\"radius\" type=\"double\" value=\"2\"/>\n"
               "      <Parameter name=\"shape\" type=\"string\" value=\"sphere\"/>");
  deck = with(deck, "-0.7*min(t,1)", "-0.1*t");
  deck = with(deck, "value=\"20\"", "value=\"1\"");  // the end
  return with(deck, "value=\"0.1\"", "value=\"0.5\"");
}

TEST(CurvedIndenter, IsCheckedAndPressedInOnTwoRanks) {
  const ScratchFolder folder;
  folder.write("deck.xml", round_indenter_deck());
  const auto checked = run_mortise(folder, "check deck.xml");
  ASSERT_EQ(checked.code, 0) << checked.err;
  const auto finished = run_mortise(folder, "run deck.xml -o out --quiet", 2);
  ASSERT_EQ(finished.code, 0) << finished.err;
  const auto force = read_history(folder / "out" / "history.csv")["contact_force_z.indenter on slab"];
  ASSERT_EQ(force.size(), 3U);
  EXPECT_EQ(force[0], 0);  // the crown just touches
  EXPECT_GT(force[1], 0);
  EXPECT_GT(force[2], 2 * force[1]);  // the contact spreads: force grows faster than depth
  EXPECT_NE(text_of(folder / "out" / "manifest.txt").find("mesh \"indenter\" recipe curved indenter"), std::string::npos);
}

}  // namespace
}  // namespace mortise::test
