// Decks that are good by themselves and contradict their meshes, or themselves at a later time: refused with place, code and
// words, on every rank. Beside them, decks that look odd and are allowed.
#include <gtest/gtest.h>

#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string patch = without_list(input_deck("patch_test/contact.xml"), "expected");
const std::string pressing = "-1e4*t";
const std::string supports = "<ParameterList name=\"supports\">", contact = "<ParameterList name=\"contact\">",
                  end_of_lists = "</ParameterList></ParameterList>\n";

std::string text(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
}
std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}
/// The patch test with a further entry at the end of one of its lists.
std::string patch_with(const std::string& in_list, const std::string& entry) {
  const std::string head = "  <ParameterList name=\"" + in_list + "\">";
  std::string deck = patch;
  return deck.insert(deck.find("\n  </ParameterList>\n", deck.find(head)), "\n" + entry);
}

class HostileScene : public testing::Test {
 protected:
  const ScratchFolder folder;

  Finished run(const std::string& deck, int ranks = 1) {
    folder.write("deck.xml", deck);
    return run_mortise(folder, "run deck.xml -o out --overwrite --quiet", ranks);
  }

  /// The run must end with exit code 2 and one error at the line of `marked`, with all words, on one rank and on two.
  void expect_refused(const std::string& deck, const std::string& marked, const std::vector<std::string>& words) {
    const auto line = 1 + std::count(deck.begin(), deck.begin() + static_cast<long>(deck.find(marked)), '\n');
    for (int ranks : {1, 2}) {
      const auto finished = run(deck, ranks);
      EXPECT_EQ(finished.code, 2) << finished.err;
      EXPECT_EQ(count_of(finished.err, "deck.xml:" + std::to_string(line) + ":"), 1) << line << ": " << finished.err;
      EXPECT_EQ(count_of(finished.err, "error["), 1) << finished.err;
      for (const auto& word : words) EXPECT_EQ(count_of(finished.err, word), 1) << "\"" << word << "\": " << finished.err;
    }
  }

  void expect_done(const std::string& deck) {
    for (int ranks : {1, 2}) {
      const auto finished = run(deck, ranks);
      EXPECT_EQ(finished.code, 0) << ranks << " ranks: " << finished.err;
    }
  }

  Table history() const { return read_history(folder / "out" / "history.csv"); }
};

// ---- supports ---------------------------------------------------------------------------------------------------------

TEST_F(HostileScene, SupportsThatContradictAreNamedBeforeTheRun) {
  expect_refused(
      patch_with("supports", list("edge", text("set", "lower/left") + text("z", "0.5*t"))), "\"0.5*t\"",
      {"error[D21] supports > edge > \"z\" = \"0.5*t\" - ", "of mesh \"lower\", component z, is moved by 0.5 here and by 0",
       "in \"lower bottom\" at t = 1 - one value is needed"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "nothing is written before all is checked";
}

// At the start and at the end both are zero.
TEST_F(HostileScene, SupportsThatContradictInBetweenAreNamedWhenTheyDo) {
  expect_refused(
      patch_with("supports", list("edge", text("set", "lower/left") + text("z", "t*(1-t)"))), "\"t*(1-t)\"",
      {"error[D21]", "is moved by 0.25 here and by 0", "at t = 0.5 - one value is needed", "the last good state is in"});
  EXPECT_EQ(history()["time"], (std::vector<double>{0}));
}

TEST_F(HostileScene, SupportsThatAgreeAreAllowed) {
  expect_done(patch_with("supports", list("edge", text("set", "lower/left") + text("z", "0*t"))));
}

TEST_F(HostileScene, SupportOnSecondaryNodesIsAllowed) {
  const auto held = patch_with("supports", list("sole", text("set", "upper/bottom") + text("x", "0") + text("y", "0")));
  expect_done(held);
  EXPECT_NEAR(history()["contact_force_z.upper on lower"].back(), 36e6, 36e6 * 1e-6);
}

// Without unknowns in the bodies only the pressures are left; without contact nothing at all.
TEST_F(HostileScene, NoFreeUnknownIsAllowed) {
  const auto all = text("x", "0") + text("y", "0");
  std::string deck = patch;
  for (const char* elements : {"{4, 4, 2}", "{3, 3, 2}"}) deck = with(deck, elements, "{2, 1, 1}");
  deck = without_list(without_list(without_list(deck, "loads"), "contact"), "probes");
  deck = with(deck, "displacement, von mises, contact pressure, gap, status", "displacement, reaction");
  for (const std::string side : {"lower/top", "lower/bottom", "upper/top", "upper/bottom"}) {
    std::string name = side;
    name[5] = ' ';
    const std::string z = side == "lower/bottom" ? "0" : "-0.1*t";
    deck = with(deck, supports, supports + list("all of " + name, text("set", side) + all + text("z", z)));
  }
  expect_done(deck);
  EXPECT_EQ(history()["time"].back(), 1);
  EXPECT_NEAR(std::abs(history()["reaction_z.all of lower top"].back()), 1e6 * 3600 * 0.1 / 60 * 1.35, 1e6 * 0.02 * 6);
}

TEST_F(HostileScene, NothingLoadedIsAllowed) {
  expect_done(without_list(patch, "loads"));
  EXPECT_LE(greatest(history()["displacement_z.top"]), 1e-12);
}

// ---- formulas ---------------------------------------------------------------------------------------------------------

// With a frame every 5 steps, the sixth would be lost.
TEST_F(HostileScene, FormulaThatFailsAtTheSeventhStepKeepsTheSixth) {
  auto deck = with(patch, pressing, "-1e4*t + 0/(t &lt; 0.65)");
  deck = with(deck, "type=\"double\" value=\"0.5\"", "type=\"double\" value=\"0.1\"");
  deck = with(deck, "<ParameterList name=\"output\">",
              "<ParameterList name=\"output\"><Parameter name=\"every\" type=\"int\" value=\"5\"/>");
  expect_refused(deck, "&lt; 0.65",
                 {"error[D23] loads > pressing > \"z\" = \"-1e4*t + 0/(t < 0.65)\" - gives ", "nan at t = 0.7",
                  "x = 0, y = 0, z = 120 - must be a finite number; the last good state is in out/results.e"});
  const auto times = history()["time"];
  ASSERT_EQ(times.size(), 7u);
  EXPECT_EQ(read_frames(folder / "out" / "results.e").times, (std::vector<double>{0, times[5], times[6]}));
  EXPECT_EQ(count_of(text_of(folder / "out" / "summary.json"), "\"exit_code\": 2"), 1);
}

TEST_F(HostileScene, DivisionByZeroInASupportIsNamedWhenItHappens) {
  expect_refused(patch_with("supports", list("top", text("set", "upper/top") + text("x", "1e-9/(1-t)"))), "1e-9/",
                 {"error[D23] supports > top > \"x\" = \"1e-9/(1-t)\" - gives inf at t = 1, x = 0, y = 0, z = 120"});
  EXPECT_EQ(history()["time"], (std::vector<double>{0, 0.5}));
}

// ---- sets and blocks --------------------------------------------------------------------------------------------------

TEST_F(HostileScene, SurfacesOfAPairThatShareNodesAreNamed) {
  expect_refused(with(patch, "\"lower/top\"", "\"upper/left\""), "<ParameterList name=\"upper on lower\">",
                 {"error[D19] contact > upper on lower - secondary and primary share 4 nodes (first: node 1 of mesh \"upper\")"});
}

TEST_F(HostileScene, NodesThatAreSecondaryTwiceAreNamed) {
  expect_refused(patch_with("contact", list("again", text("secondary", "upper/bottom") + text("primary", "lower/left"))),
                 "\"again\"",
                 {"error[D19] contact > again > \"secondary\"", "is on the secondary side of \"upper on lower\" too"});
}

TEST_F(HostileScene, PairWithinOneBodyIsAllowed) {
  expect_done(patch_with("contact", list("itself", text("secondary", "lower/left") + text("primary", "lower/right"))));
}

TEST_F(HostileScene, UnknownProbeNodeIsNamed) {
  expect_refused(patch_with("probes", list("far", text("quantity", "gap") + text("mesh", "upper") +
                                                      "<Parameter name=\"node\" type=\"int\" value=\"49\"/>")),
                 "value=\"49\"", {"error[D20] probes > far > \"node\" = 49 - mesh \"upper\" has no node with that number"});
}

/// The patch test whose lower block comes from a file with the element blocks "low" (10) and "up" (20).
class SceneOfTwoBlocks : public HostileScene {
 protected:
  void SetUp() override {
    Mesh mesh = block({60, 60, 60}, {4, 4, 2});
    const auto all = mesh.blocks.front().elements;
    const auto middle = all.begin() + static_cast<long>(all.size() / 2);
    mesh.blocks = {{10, "low", {all.begin(), middle}}, {20, "up", {middle, all.end()}}};
    write_exodus(mesh, folder / "lower.e", "two blocks");
  }
  static std::string deck(const std::string& blocks_of_lower, const std::string& further = "") {
    std::string deck = patch;
    const std::size_t begin = deck.find("      <Parameter name=\"recipe\""), end = deck.find("    </ParameterList>", begin);
    deck.replace(begin, end - begin, "      " + text("file", "lower.e") + "\n");
    const std::string mesh = "<Parameter name=\"mesh\"     type=\"string\" value=\"lower\"/>";
    deck = with(deck, mesh, mesh + "\n<Parameter name=\"blocks\" type=\"Array(string)\" value=\"" + blocks_of_lower + "\"/>");
    return further.empty() ? deck : with(deck, "<ParameterList name=\"bodies\">", "<ParameterList name=\"bodies\">\n" + further);
  }
  static std::string body(const std::string& blocks) {
    return list("base", text("mesh", "lower") + text("material", "rubber") +
                            "<Parameter name=\"blocks\" type=\"Array(string)\" value=\"" + blocks + "\"/>");
  }
};

TEST_F(SceneOfTwoBlocks, BothGivenAreAllowed) { expect_done(deck("{10}", body("{up}"))); }

TEST_F(SceneOfTwoBlocks, BlockWithoutMaterialIsNamed) {
  expect_refused(deck("{low}"), "<ParameterList name=\"bodies\">",
                 {"error[D19] bodies - block \"up\" belongs to no body - every block needs a material"});
}

// By name and by number: only the mesh tells that they are one block.
TEST_F(SceneOfTwoBlocks, BlockWithTwoMaterialsIsNamed) {
  expect_refused(deck("{low, up}", body("{10}")), "<ParameterList name=\"lower\">\n      <Parameter name=\"mesh\"",
                 {"error[D19] bodies > lower - block \"low\" belongs to body \"base\" already - a block has one material"});
}

TEST_F(SceneOfTwoBlocks, UnknownBlockIsNamed) {
  expect_refused(deck("{low, upp, 20}"), "{low, upp, 20}",
                 {"error[D20] bodies > lower > \"blocks\"", "has no block \"upp\"; did you mean \"up\"?; it has: low, up"});
}

}  // namespace
}  // namespace mortise::test
