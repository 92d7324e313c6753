// Scenes at the rim of what users do: values that fail on one rank, disks that fill up, bodies that share nodes or rest without
// load, other units, terraces. All of them once went wrong.
#include <gtest/gtest.h>

#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "support/frames.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

// ---- decks ------------------------------------------------------------------------------------------------------------

const std::string patch = without_list(input_deck("patch_test/contact.xml"), "expected");
const std::string ironing = without_list(input_deck("ironing/frictionless.xml"), "expected");
const std::string pressing = "-1e4*t", end_of_ironing = "name=\"end\"          type=\"double\" value=\"20\"";

std::string support(const std::string& name, const std::string& set, const std::string& z) {
  return list(name, word("set", set) + word("x", "0") + word("y", "0") + word("z", z));
}
/// A body of the one material; `blocks` empty: all of them.
std::string body(const std::string& name, const std::string& mesh, const std::string& blocks = "") {
  return list(name, word("mesh", mesh) + word("material", "rubber") +
                        (blocks.empty() ? "" : deck_parameter("blocks", "Array(string)", blocks)));
}
std::string contact(const std::string& secondary, const std::string& primary) {
  return list("contact", list("pair", word("secondary", secondary) + word("primary", primary)));
}
std::string recipe(const std::string& name, const std::string& size, const std::string& elements, const std::string& origin) {
  return list(name, word("recipe", "block") + deck_parameter("size", "Array(double)", size) +
                        deck_parameter("elements", "Array(int)", elements) + deck_parameter("origin", "Array(double)", origin));
}
/// A deck on the mesh file base.e, held at its bottom.
std::string deck_on_base(const std::string& meshes, const std::string& bodies, const std::string& supports,
                         const std::string& further, const std::string& dt = "0.5") {
  const std::string rubber = word("model", "neo-hookean") + deck_parameter("youngs modulus", "double", "1000") +
                             deck_parameter("poissons ratio", "double", "0.3");
  return list("odd", list("meshes", list("base", word("file", "base.e")) + meshes) + list("materials", list("rubber", rubber)) +
                         list("bodies", bodies) + list("supports", support("base bottom", "base/bottom", "0") + supports) +
                         further + list("time", deck_parameter("end", "double", "1") + deck_parameter("step", "double", dt)));
}

// ---- meshes -----------------------------------------------------------------------------------------------------------

/// A column of unit width and height 2 whose lower half is the block "low" (10) and whose upper half is "up" (20).
Mesh column_of_two_blocks() {
  Mesh mesh = block({1, 1, 2}, {2, 2, 4});
  const auto all = mesh.blocks.front().elements;
  const auto middle = all.size() / 2;
  mesh.blocks = {{10, "low", all.part(0, middle)}, {20, "up", all.part(middle, all.size())}};
  return mesh;
}

/// Two unit blocks side by side in x, not joined, the right one 0.25 lower: both tops are one side set.
Mesh terrace() {
  Mesh mesh = block({1, 1, 1}, {4, 4, 2});
  const Mesh right = block({1, 1, 0.75}, {4, 4, 2});
  const int first_node = n_nodes(mesh), first_element = n_elements(mesh);
  for (auto x : right.coordinates) mesh.coordinates.push_back({x[0] + 1, x[1], x[2]});
  for (const auto& own : right.blocks.front().elements) {
    std::vector<int> nodes(own.begin(), own.end());
    for (int& node : nodes) node += first_node;
    mesh.blocks.front().elements.push_back(nodes);
  }
  for (std::size_t s = 0; s < mesh.side_sets.size(); ++s)
    for (auto side : right.side_sets[s].sides) mesh.side_sets[s].sides.push_back({side.element + first_element, side.face});
  mesh.node_sets.clear();
  for (int k = first_node; k < n_nodes(mesh); ++k) mesh.node_numbers.push_back(k + 1);
  for (int k = first_element; k < n_elements(mesh); ++k) mesh.element_numbers.push_back(k + 1);
  return mesh;
}

// ---- runs -------------------------------------------------------------------------------------------------------------

class OddScene : public testing::Test {
 protected:
  const ScratchFolder folder;

  /// Runs a deck; history and results are then in the folder "out".
  Finished run(const std::string& deck, int ranks = 1) {
    folder.write("deck.xml", deck);
    return run_mortise(folder, "run deck.xml -o out --overwrite --quiet", ranks);
  }
  /// The history of a run that must end well.
  Table history_of(const std::string& deck, int ranks = 1) {
    const auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 0) << finished.err << deck;
    return history();
  }
  Table history() const { return read_history(folder / "out" / "history.csv"); }
  std::vector<double> times_of_results() const { return read_frames(folder / "out" / "results.e").times; }

  static void expect_words(const std::string& in, const std::vector<std::string>& words) {
    for (const auto& word : words) EXPECT_GE(count_of(in, word), 1) << "\"" << word << "\" is not in: " << in;
  }
  /// "deck.xml:LINE:" of the first place of `word`.
  static std::string place_of(const std::string& deck, const std::string& word) {
    return "deck.xml:" + std::to_string(1 + std::count(deck.begin(), deck.begin() + deck.find(word), '\n')) + ":";
  }
};

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double relative, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], relative * greatest_of(b)) << what << ", row " << k;
}

// ---- failures on one rank ---------------------------------------------------------------------------------------------

// The formulas are infinite on one side, or at one node, which one rank owns; the other rank must not wait.
TEST_F(OddScene, FormulaThatIsInfiniteAtOnePlaceEndsAllRanks) {
  const std::string corner = "1/max(40-x,40-y,0)", late = "-1e4*t+1/max(40-x,40-y,0.7-t,0)", in_support = "0/((x-60)^2+(y-60)^2)";
  const std::string z_is_0 = "<Parameter name=\"z\"   type=\"string\" value=\"0\"/>";  // the first is of "lower bottom"
  for (int ranks : {1, 2}) {
    auto deck = with(patch, pressing, corner);
    auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 2) << ranks;
    expect_words(finished.err, {"error[D23] loads > pressing", place_of(deck, corner), "x = 42.2540", "y = 42.2540", "z = 120"});

    deck = with(patch, pressing, late);
    finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 2) << ranks;
    expect_words(finished.err, {"error[D23] loads > pressing", place_of(deck, late), "t = 1"});
    EXPECT_EQ(history()["time"], (std::vector<double>{0, 0.5}));

    deck = with(patch, z_is_0, word("z", in_support));
    finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 2) << ranks;
    expect_words(finished.err, {"error[D23] supports > lower bottom", place_of(deck, in_support), "x = 60, y = 60, z = 0"});
  }
}

// mesh.e is 42 kB and a frame about as much again: the results file meets the limit after some steps. Shared memory of MPI would
// too.
TEST_F(OddScene, FileThatCannotGrowInMidRunEndsAllRanks) {
  folder.write("deck.xml", with(ironing, end_of_ironing, "name=\"end\" type=\"double\" value=\"2\""));
  const auto finished =
      run_mortise(folder, "run deck.xml -o out --quiet", 2, "export OMPI_MCA_btl=self,tcp; trap \"\" XFSZ; ulimit -f 300");
  EXPECT_EQ(finished.code, 5) << finished.err;
  expect_words(finished.err, {"out/results.e: error[I02]", "File too large"});
  EXPECT_GT(history().n_rows(), 2u) << "not in mid-run";
}

// ---- bodies, blocks, columns ------------------------------------------------------------------------------------------

TEST_F(OddScene, BodiesThatShareNodesHoldEachOther) {
  write_exodus(column_of_two_blocks(), folder / "base.e", "two blocks");
  const auto loads = list("loads", list("pull", word("type", "traction") + word("set", "base/top") + word("z", "10*t")));
  const auto one = history_of(deck_on_base("", body("column", "base"), "", loads));
  for (int ranks : {1, 2}) {
    const auto two = history_of(deck_on_base("", body("low", "base", "{low}") + body("up", "base", "{up}"), "", loads), ranks);
    for (const std::string column : {"reaction_z.base bottom", "strain_energy"})
      expect_same(two[column], one[column], 1e-10, column);
    EXPECT_NEAR(two["reaction_z.base bottom"].back(), -10, 1e-8);
  }
}

TEST_F(OddScene, OrderOfBlocksDoesNotMatter) {
  write_exodus(column_of_two_blocks(), folder / "base.e", "two blocks");
  const auto meshes = recipe("punch", "{1, 1, 1}", "{4, 4, 2}", "{0, 0, 2}");
  const auto deck = [&](const std::string& blocks, const std::string& pair) {
    return deck_on_base(meshes, body("column", "base", blocks) + body("punch", "punch"),
                        support("punch top", "punch/top", "-0.05*t"), pair);
  };
  for (const auto& pair : {contact("base/top", "punch/bottom"), contact("punch/bottom", "base/top")}) {
    const auto in_order = history_of(deck("{low, up}", pair));
    EXPECT_GT(greatest_of(in_order["contact_force_z.pair"]), 1);
    for (const std::string blocks : {"{up, low}", "{20, 10}"}) {
      const auto reversed = history_of(deck(blocks, pair));
      for (const std::string column : {"contact_force_z.pair", "reaction_z.base bottom"})
        expect_same(reversed[column], in_order[column], 1e-10, column + " of " + blocks);
    }
  }
}

TEST_F(OddScene, MisspeltColumnOfExpectedIsAnsweredWithTheNearestName) {
  const auto deck = with(input_deck("patch_test/contact.xml"), "value=\"displacement_z.top\"", "value=\"strain_enrgy\"");
  for (int ranks : {1, 2}) {
    const auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 2);
    expect_words(finished.err, {"error[D14]", place_of(deck, "strain_enrgy"), "did you mean \"strain_energy\""});
  }
}

// ---- contact ----------------------------------------------------------------------------------------------------------

TEST_F(OddScene, SurfacesDeepInsideEachOtherAtTheStartAreNamed) {
  const auto deck = with(ironing, "{1, 1.5, 3}", "{1, 1.5, 2}");  // by 1.0, four facets
  for (int ranks : {1, 2}) {
    const auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 3);
    expect_words(finished.err,
                 {place_of(deck, "<ParameterList name=\"indenter on slab\">") + "5: error[M51] contact > indenter on slab",
                  "25 secondary nodes penetrate", "node 1 of mesh \"indenter\" by 4 h"});
  }
}

TEST_F(OddScene, UnitsChangeNoStepAndNoIteration) {
  const auto in_metres = with(ironing, end_of_ironing, "name=\"end\" type=\"double\" value=\"1\"");
  auto in_other = in_metres;
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"{9, 4, 3}", "{9e-3, 4e-3, 3e-3}"},
                                                                                 {"{1, 1, 1}", "{1e-3, 1e-3, 1e-3}"},
                                                                                 {"{1, 1.5, 3}", "{1e-3, 1.5e-3, 3e-3}"},
                                                                                 {"value=\"1\"", "value=\"1e9\""},
                                                                                 {"value=\"1000\"", "value=\"1e12\""},
                                                                                 {"-0.7*min", "-0.7e-3*min"}})
    in_other = with(in_other, from, to);
  const auto a = history_of(in_metres), b = history_of(in_other);
  for (const std::string column : {"time", "newton_iterations", "cuts", "active"}) EXPECT_EQ(a[column], b[column]) << column;
  auto force = b["contact_force_z.indenter on slab"];
  for (double& f : force) f /= 1e9 * 1e-3 * 1e-3;
  expect_same(force, a["contact_force_z.indenter on slab"], 1e-9, "force");
}

// Forces of solved steps are at round-off: E times the area is 3.6e9.
TEST_F(OddScene, BodyThatRestsOnContactNeedsNoLoad) {
  const std::string column = "contact_force_z.upper on lower";
  for (int ranks : {1, 2}) {
    const auto at_rest = history_of(with(patch, pressing, "0"), ranks)[column];
    const auto late = history_of(with(patch, pressing, "-1e4*max(t-0.5,0)"), ranks)[column];
    ASSERT_EQ(at_rest.size(), 3u);
    ASSERT_EQ(late.size(), 3u);
    for (double force : {at_rest[1], at_rest[2], late[1]}) EXPECT_LE(std::abs(force), 1e-6);
    EXPECT_NEAR(late[2], 0.5e4 * 3600, 18);
  }
}

TEST_F(OddScene, BodyThatIsPulledOffIsNamed) {
  const std::string at_once = "1e4*t", after_pressing = "-1e4*t + 4e4*max(t-0.5,0)";  // free from t = 2/3
  for (int ranks : {1, 2})
    for (const auto& pull : {at_once, after_pressing}) {
      const auto finished = run(with(patch, pressing, pull), ranks);
      EXPECT_EQ(finished.code, 4) << pull << finished.err;
      expect_words(finished.err, {"body \"upper\" is free: translation z"});
      const auto times = times_of_results();
      ASSERT_FALSE(times.empty()) << "results.e cannot be read";
      EXPECT_EQ(times, history()["time"]) << pull;
      if (pull == at_once) {
        EXPECT_EQ(times.back(), 0);
      } else {
        EXPECT_GE(times.back(), 0.5);
        EXPECT_LE(times.back(), 2.0 / 3);
      }
    }
}

TEST_F(OddScene, RunThatEndsEarlyLeavesItsLastStepThoughNotDue) {
  auto deck = with(patch, pressing, "-1e4*t - 1e12*max(t-0.5,0)");
  deck = with(deck, "name=\"step\"   type=\"double\" value=\"0.5\"/>",
              "name=\"step\" type=\"double\" value=\"0.25\"/>" + deck_parameter("smallest step", "double", "0.2"));
  deck = with(deck, "<ParameterList name=\"output\">", "<ParameterList name=\"output\">" + deck_parameter("every", "int", "5"));
  for (int ranks : {1, 2}) {
    EXPECT_EQ(run(deck, ranks).code, 4);
    EXPECT_EQ(history()["time"], (std::vector<double>{0, 0.25, 0.5}));
    EXPECT_EQ(times_of_results(), (std::vector<double>{0, 0.5}));
  }
}

// What lies beyond the step of the terrace enters neither by what it is nor by how far the search looks, which depends on dt.
TEST_F(OddScene, ForceOnATerraceDoesNotDependOnTheStepSize) {
  write_exodus(terrace(), folder / "base.e", "terrace");
  const auto force = [&](const std::string& dt) {
    const auto deck = deck_on_base(recipe("punch", "{1.2, 0.5, 0.5}", "{5, 3, 2}", "{0.4, 0.25, 1.0}"),
                                   body("terrace", "base") + body("punch", "punch"), support("punch top", "punch/top", "-0.1*t"),
                                   contact("punch/bottom", "base/top"), dt);
    return history_of(deck)["contact_force_z.pair"].back();
  };
  const double in_ten = force("0.1"), in_two = force("0.5");
  EXPECT_GT(in_two, 1);
  EXPECT_NEAR(in_ten, in_two, 1e-9 * in_two);
}

}  // namespace
}  // namespace mortise::test
