// Mistakes of the user: which exit code, which words, and nothing lost.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string patch = input_deck("patch_test/contact.xml");
const std::string ironing = input_deck("ironing/frictionless.xml");

class Mistake : public testing::Test {
 protected:
  const ScratchFolder folder;

  /// The run must end with `code` and say all `words` once, in stderr.
  void expect(int code, const std::string& arguments, const std::vector<std::string>& words, int ranks = 1) {
    const auto run = run_mortise(folder, arguments, ranks);
    EXPECT_EQ(run.code, code) << run.out << run.err;
    for (const auto& word : words) EXPECT_GE(count_of(run.err, word), 1) << "\"" << word << "\" is not in: " << run.err;
    EXPECT_LE(count_of(run.err, words.empty() ? "error[" : words.front()), 1) << run.err;
  }
  void expect_deck(int code, const std::string& text, const std::vector<std::string>& words, int ranks = 1) {
    folder.write("deck.xml", text);
    expect(code, "run deck.xml -o out --overwrite", words, ranks);
  }
  static int line_of(const std::string& text, const std::string& word) {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + text.find(word), '\n'));
  }
};

TEST_F(Mistake, CommandLine) {
  expect(1, "", {});
  expect(1, "walk deck.xml", {});
  expect(1, "run deck.xml --fast", {"--fast"});
  expect(1, "describe contat", {"did you mean \"contact\""});
  expect(1, "describe contact --schema", {"list excludes --schema"});
}

TEST_F(Mistake, IsAvoidedWithTheSchemaForEditors) {
  const auto run = run_mortise(folder, "describe --schema");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("<?xml version=\"1.0\"?>\n<grammar", 0), 0u) << run.out.substr(0, 200);
}

TEST_F(Mistake, MissingDeck) { expect(5, "run nothing.xml", {"nothing.xml", "no such file"}); }

TEST_F(Mistake, MisspeltParameterIsNamedWithItsLine) {
  const auto text = with(patch, "youngs modulus", "youngs moduls");
  for (int ranks : {1, 2})
    expect_deck(
        2, text,
        {"error[D06]", "deck.xml:" + std::to_string(line_of(text, "youngs moduls")) + ":", "did you mean \"youngs modulus\""},
        ranks);
}

TEST_F(Mistake, UnknownSetIsAnsweredWithTheNearestName) {
  const auto text = with(patch, "lower/bottom", "lower/botom");
  expect_deck(2, text,
              {"error[D20]", "deck.xml:" + std::to_string(line_of(text, "lower/botom")) + ":", "did you mean \"lower/bottom\""});
}

TEST_F(Mistake, MeshThatIsNone) {
  folder.write("slab.e", "no mesh");
  ASSERT_EQ(
      run_mortise(folder, "mesh '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/ironing/indenter_recipe.xml' -o indenter.e").code,
      0);
  expect_deck(3, input_deck("ironing/frictionless_exodus.xml"), {"error[M01]", "slab.e"});
  expect(3, "check slab.e", {"error[M01]"});
}

TEST_F(Mistake, TruncatedMesh) {
  for (const std::string name : {"slab", "indenter"})
    ASSERT_EQ(run_mortise(folder, "mesh '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/ironing/" + name + "_recipe.xml' -o " +
                                      name + ".e")
                  .code,
              0);
  std::filesystem::resize_file(folder / "slab.e", std::filesystem::file_size(folder / "slab.e") / 2);
  expect_deck(3, input_deck("ironing/frictionless_exodus.xml"), {"error[M04]", "slab.e", "truncated"});
}

TEST_F(Mistake, MissingMesh) { expect_deck(5, input_deck("ironing/frictionless_exodus.xml"), {"error[I01]", "slab.e"}); }

TEST_F(Mistake, MissedExpectationFailsTheRun) {
  expect_deck(7, with(patch, "value=\"36000000\"", "value=\"36000400\""), {"\"contact force\"", "MISSED"});
  EXPECT_EQ(count_of(text_of(folder / "out" / "summary.json"), "\"exit_code\": 7"), 1);
}

TEST_F(Mistake, EmptyExpectationsAreRefused) {
  expect_deck(2, with_lists(without_list(patch, "expected"), "  <ParameterList name=\"expected\"/>"), {"error[D18]", "expected"});
}

TEST_F(Mistake, ResultsAreNotOverwrittenUnasked) {
  folder.write("deck.xml", patch);
  expect(0, "run deck.xml -o out", {});
  const auto history = text_of(folder / "out" / "history.csv");
  for (int ranks : {1, 2}) expect(5, "run deck.xml -o out", {"error[I05]", "--overwrite"}, ranks);
  EXPECT_EQ(text_of(folder / "out" / "history.csv"), history);
  folder.write("out/notes.txt", "mine");
  expect(0, "run deck.xml -o out --overwrite", {});
  EXPECT_EQ(text_of(folder / "out/notes.txt"), "mine");
  std::filesystem::create_directories(folder / "other");
  folder.write("other/notes.txt", "mine");
  expect(5, "run deck.xml -o other --overwrite", {"error[I05]"});
  EXPECT_EQ(text_of(folder / "other/notes.txt"), "mine");
}

// Rank 0 writes; when it cannot, the others must not wait for it.
TEST_F(Mistake, FileThatCannotBeWrittenEndsAllRanks) {
  for (const std::string name : {"results.e", "history.csv", "mesh.e"}) {
    const std::string out = "out_" + name.substr(0, 4);
    std::filesystem::create_directories(folder / out / name / "a folder in the way");
    folder.write("deck.xml", patch);
    expect(5, "run deck.xml --overwrite -o " + out, {"error[I05]", name}, 2);
  }
}

TEST_F(Mistake, FreeRigidMotionIsNamed) {
  const auto text = with(patch,
                         "<ParameterList name=\"upper left\">\n      <Parameter name=\"set\" type=\"string\" "
                         "value=\"upper/left\"/>\n      <Parameter name=\"x\" ",
                         "<ParameterList name=\"upper left\">\n      <Parameter name=\"set\" type=\"string\" "
                         "value=\"upper/left\"/>\n      <Parameter name=\"y\" ");
  for (int ranks : {1, 2})
    expect_deck(2, with(text, "upper/left", "upper/front"), {"error[D22]", "bodies > upper", "translation x"}, ranks);
}

TEST_F(Mistake, BodyThatHangsOnOpenContactIsFree) {
  expect_deck(2, with(patch, "{0, 0, 60}", "{0, 0, 61}"), {"error[D22]", "bodies > upper", "translation z"});
}

TEST_F(Mistake, PenetrationAtTheStartIsNamed) {
  for (int ranks : {1, 2})
    expect_deck(3, with(patch, "{0, 0, 60}", "{0, 0, 59}"),
                {"16 secondary nodes penetrate", "node 1 of mesh \"upper\" by 0.05 h", "contact > upper on lower"}, ranks);
}

TEST_F(Mistake, FormulaThatGivesNoNumberIsNamed) {
  const auto in_time = with(patch, "-1e4*t", "-1e4*t/max(0.7-t,0)");
  for (int ranks : {1, 2}) expect_deck(2, in_time, {"error[D23]", "loads > pressing", "t = 1"}, ranks);
  expect_deck(2, with(ironing, "-0.7*min(t,1)", "log(t)"), {"error[D23]", "supports > indenter top", "t = 0"});
}

TEST_F(Mistake, TheFirstTwentyErrorsAreListed) {
  auto text = patch;
  for (int k = 0; k < 30; ++k)
    text = with(text, "name=\"title\"",
                "name=\"x" + std::to_string(k) + "\" type=\"string\" value=\"a\"/><Parameter name=\"title\"");
  const auto run = (folder.write("deck.xml", text), run_mortise(folder, "check deck.xml"));
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(count_of(run.err, "error[D06]"), 20) << run.err;
  EXPECT_EQ(count_of(run.err, "10 "), 1 + count_of(run.err, ":10 ")) << run.err;
}

}  // namespace
}  // namespace mortise::test
