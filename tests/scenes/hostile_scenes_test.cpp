// Decks that are good by themselves and contradict their meshes, or themselves at a later time: refused with place, code and
// words, on every rank. Beside them, decks that look odd and are allowed.
#include <gtest/gtest.h>

#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "support/frames.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string patch = without_list(input_deck("patch_test/contact.xml"), "expected");
const std::string pressing = "-1e4*t";
/// Of the rubber, which has Poisson's ratio 0.3: stress over strain without and with the sides held [N/mm^2].
constexpr double youngs_modulus = 1e6, constrained_modulus = youngs_modulus * 0.7 / (1.3 * 0.4);
const std::string supports = "<ParameterList name=\"supports\">", contact = "<ParameterList name=\"contact\">",
                  end_of_lists = "</ParameterList></ParameterList>\n";

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
      patch_with("supports", list("edge", word("set", "lower/left") + word("z", "0.5*t"))), "\"0.5*t\"",
      {"error[D21] supports > edge > \"z\" = \"0.5*t\" - ", "of mesh \"lower\", component z, is moved by 0.5 here and by 0",
       "in \"lower bottom\" at t = 1 - one value is needed"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "nothing is written before all is checked";
}

// At the start and at the end both are zero.
TEST_F(HostileScene, SupportsThatContradictInBetweenAreNamedWhenTheyDo) {
  expect_refused(patch_with("supports", list("edge", word("set", "lower/left") + word("z", "t*(1-t)"))), "\"t*(1-t)\"",
                 {"error[D21]", "is moved by 0.25 here and by 0", "at t = 0.5 - one value is needed",
                  "the last good state (step 0, t = 0) is in out/results.e"});
  EXPECT_EQ(history()["time"], (std::vector<double>{0}));
}

TEST_F(HostileScene, SupportsThatAgreeAreAllowed) {
  expect_done(patch_with("supports", list("edge", word("set", "lower/left") + word("z", "0*t"))));
}

TEST_F(HostileScene, SupportOnSecondaryNodesIsAllowed) {
  const auto held = patch_with("supports", list("sole", word("set", "upper/bottom") + word("x", "0") + word("y", "0")));
  expect_done(held);
  EXPECT_NEAR(history()["contact_force_z.upper on lower"].back(), 36e6, 36e6 * 1e-6);
}

// Without unknowns in the bodies only the pressures are left; without contact nothing at all.
TEST_F(HostileScene, NoFreeUnknownIsAllowed) {
  const auto all = word("x", "0") + word("y", "0");
  std::string deck = patch;
  for (const char* elements : {"{4, 4, 2}", "{3, 3, 2}"}) deck = with(deck, elements, "{2, 1, 1}");
  deck = without_list(without_list(without_list(deck, "loads"), "contact"), "probes");
  deck = with(deck, "displacement, von mises, contact pressure, gap, status", "displacement, reaction");
  for (const std::string side : {"lower/top", "lower/bottom", "upper/top", "upper/bottom"}) {
    std::string name = side;
    name[5] = ' ';
    const std::string z = side == "lower/bottom" ? "0" : "-0.1*t";
    deck = with(deck, supports, supports + list("all of " + name, word("set", side) + all + word("z", z)));
  }
  expect_done(deck);
  EXPECT_EQ(history()["time"].back(), 1);
  EXPECT_NEAR(-history()["reaction_z.all of lower top"].back(), constrained_modulus * 3600 * 0.1 / 60, 0.01 * 8.1e6);
}

TEST_F(HostileScene, NothingLoadedIsAllowed) {
  expect_done(without_list(patch, "loads"));
  EXPECT_LE(greatest_of(history()["displacement_z.top"]), 1e-12);
}

// ---- formulas ---------------------------------------------------------------------------------------------------------

// With a frame every 5 steps, the sixth would be lost.
TEST_F(HostileScene, FormulaThatFailsAtTheSeventhStepKeepsTheSixth) {
  auto deck = with(patch, pressing, "-1e4*t + 0/(t &lt; 0.65)");
  deck = with(deck, "type=\"double\" value=\"0.5\"", "type=\"double\" value=\"0.1\"");
  deck = with(deck, "<ParameterList name=\"output\">",
              "<ParameterList name=\"output\"><Parameter name=\"every\" type=\"int\" value=\"5\"/>");
  expect_refused(
      deck, "&lt; 0.65",
      {"error[D23] loads > pressing > \"z\" = \"-1e4*t + 0/(t < 0.65)\" - gives ", "nan at t = 0.7", "x = 2.2540", "y = 2.2540",
       "z = 120 - must be a finite number", "the last good state (step 6, t = 0.6) is in out/results.e"});
  const auto times = history()["time"];
  ASSERT_EQ(times.size(), 7u);
  EXPECT_EQ(read_frames(folder / "out" / "results.e").times, (std::vector<double>{0, times[5], times[6]}));
  EXPECT_EQ(count_of(text_of(folder / "out" / "summary.json"), "\"exit_code\": 2"), 1);
}

// Where another support prescribes the same, only this one has no value.
TEST_F(HostileScene, DivisionByZeroInASupportIsNamedWhenItHappens) {
  expect_refused(patch_with("supports", list("wall", word("set", "upper/left") + word("x", "0/(1-t)"))), "0/(1-t)",
                 {"error[D23] supports > wall > \"x\" = \"0/(1-t)\" - gives ", "nan at t = 1, x = 0, y = "});
  EXPECT_EQ(history()["time"], (std::vector<double>{0, 0.5}));
}

// ---- sets and blocks --------------------------------------------------------------------------------------------------

TEST_F(HostileScene, SurfacesOfAPairThatShareNodesAreNamed) {
  expect_refused(with(patch, "\"lower/top\"", "\"upper/left\""), "<ParameterList name=\"upper on lower\">",
                 {"error[D19] contact > upper on lower - secondary and primary share 4 nodes (first: node 1 of mesh \"upper\")"});
}

TEST_F(HostileScene, NodesThatAreSecondaryTwiceAreNamed) {
  const std::string pair = word("secondary", "upper/bottom") + word("primary", "lower/left");
  expect_refused(patch_with("contact", list("again", pair)), pair,
                 {"error[D19] contact > again > \"secondary\"", "is on the secondary side of \"upper on lower\" too"});
}

// The material between them is no gap.
TEST_F(HostileScene, OppositeFacesOfABlockAreNoPair) {
  const auto deck = patch_with("contact", list("itself", word("secondary", "lower/left") + word("primary", "lower/right")));
  for (int ranks : {1, 2}) {
    const auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 3);
    EXPECT_EQ(count_of(finished.err, "error[M51] contact > itself - 15 secondary nodes penetrate at the start"), 1)
        << finished.err;
  }
}

/// Two cubes, one upon the other and not joined, as one element block: the sets of the upper one have names that begin with "up
/// ".
Mesh stack_in_one_block() {
  Mesh mesh = block({60, 60, 60}, {2, 2, 1});
  const Mesh cube = mesh;
  for (auto X : cube.coordinates) mesh.coordinates.push_back({X[0], X[1], X[2] + 60});
  for (const auto& own : cube.blocks.front().elements) {
    std::vector<int> nodes(own.begin(), own.end());
    for (int& node : nodes) node += n_nodes(cube);
    mesh.blocks.front().elements.push_back(nodes);
  }
  for (auto set : cube.side_sets) {
    set.id += 100;
    set.name = "up " + set.name;
    for (Side& side : set.sides) side.element += n_elements(cube);
    mesh.side_sets.push_back(set);
  }
  mesh.node_sets.clear();
  for (int k = n_nodes(cube); k < n_nodes(mesh); ++k) mesh.node_numbers.push_back(k + 1);
  for (int k = n_elements(cube); k < n_elements(mesh); ++k) mesh.element_numbers.push_back(k + 1);
  return mesh;
}

TEST_F(HostileScene, PairWithinOneBlockIsAllowed) {
  write_exodus(stack_in_one_block(), folder / "stack.e", "one block");
  const std::string held = word("x", "0") + word("y", "0");
  expect_done(list(
      "stack",
      list("meshes", list("stack", word("file", "stack.e"))) +
          list("materials", list("rubber", word("model", "neo-hookean") +
                                               "<Parameter name=\"youngs modulus\" type=\"double\" value=\"1e6\"/>"
                                               "<Parameter name=\"poissons ratio\" type=\"double\" value=\"0.3\"/>")) +
          list("bodies", list("stack", word("mesh", "stack") + word("material", "rubber"))) +
          list("supports", list("foot", word("set", "stack/bottom") + held + word("z", "0")) +
                               list("head", word("set", "stack/up top") + held + word("z", "-6*t"))) +
          list("contact", list("seam", word("secondary", "stack/up bottom") + word("primary", "stack/top"))) +
          list("time",
               "<Parameter name=\"end\" type=\"double\" value=\"1\"/><Parameter name=\"step\" type=\"double\" value=\"1\"/>")));
  const double force = history()["contact_force_z.seam"].back(), area_strain = 3600 * 0.05;
  EXPECT_GT(force, youngs_modulus * area_strain);
  EXPECT_LT(force, constrained_modulus * area_strain);
}

TEST_F(HostileScene, UnknownProbeNodeIsNamed) {
  expect_refused(patch_with("probes", list("far", word("quantity", "gap") + word("mesh", "upper") +
                                                      "<Parameter name=\"node\" type=\"int\" value=\"49\"/>")),
                 "value=\"49\"", {"error[D20] probes > far > \"node\" = 49 - mesh \"upper\" has no node with that number"});
}

/// The patch test whose lower block comes from a file with the element blocks "low" (10) and "up" (20).
class SceneOfTwoBlocks : public HostileScene {
 protected:
  void SetUp() override {
    Mesh mesh = block({60, 60, 60}, {4, 4, 2});
    const auto all = mesh.blocks.front().elements;
    const auto middle = all.size() / 2;
    mesh.blocks = {{10, "low", all.part(0, middle)}, {20, "up", all.part(middle, all.size())}};
    write_exodus(mesh, folder / "lower.e", "two blocks");
  }
  static std::string deck(const std::string& blocks_of_lower, const std::string& further = "") {
    std::string deck = patch;
    const std::size_t begin = deck.find("      <Parameter name=\"recipe\""), end = deck.find("    </ParameterList>", begin);
    deck.replace(begin, end - begin, "      " + word("file", "lower.e") + "\n");
    const std::string mesh = "<Parameter name=\"mesh\"     type=\"string\" value=\"lower\"/>";
    deck = with(deck, mesh, mesh + "\n<Parameter name=\"blocks\" type=\"Array(string)\" value=\"" + blocks_of_lower + "\"/>");
    return further.empty() ? deck : with(deck, "<ParameterList name=\"bodies\">", "<ParameterList name=\"bodies\">\n" + further);
  }
  static std::string body(const std::string& blocks) {
    return list("base", word("mesh", "lower") + word("material", "rubber") +
                            "<Parameter name=\"blocks\" type=\"Array(string)\" value=\"" + blocks + "\"/>");
  }
};

TEST_F(SceneOfTwoBlocks, BothGivenAreAllowed) { expect_done(deck("{10}", body("{up}"))); }

TEST_F(SceneOfTwoBlocks, BlockWithoutMaterialIsNamed) {
  expect_refused(deck("{low}"), "<ParameterList name=\"bodies\">",
                 {"error[D19] bodies - block \"lower/up\" belongs to no body - every block needs a material"});
}

// By name and by number: only the mesh tells that they are one block.
TEST_F(SceneOfTwoBlocks, BlockWithTwoMaterialsIsNamed) {
  expect_refused(deck("{low, up}", body("{10}")), "<ParameterList name=\"lower\">\n      <Parameter name=\"mesh\"",
                 {"error[D19] bodies > lower - block \"lower/low\" belongs to body \"base\" already - a block has one material"});
}

TEST_F(SceneOfTwoBlocks, UnknownBlockIsNamed) {
  expect_refused(deck("{low, upp, 20}"), "{low, upp, 20}",
                 {"error[D20] bodies > lower > \"blocks\"", "has no block \"upp\"; did you mean \"up\"?; it has: low, up"});
}

}  // namespace
}  // namespace mortise::test
