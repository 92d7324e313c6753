// Mesh files as strangers bring them, through the whole program: which exit code, which words, once.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "sha256.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

/// The patch test with its lower brick from the file lower.e.
class MeshFile : public testing::Test {
 protected:
  const ScratchFolder folder;
  Mesh mesh = block({60, 60, 60}, {4, 4, 2});

  static std::string deck(const std::string& more = "") {
    const std::string text = input_deck("patch_test/contact.xml"),
                      recipe = "<Parameter name=\"recipe\"   type=\"string\"        value=\"block\"/>";
    const auto begin = text.find(recipe), end = text.find("</ParameterList>", begin);
    return std::string(text).replace(begin, end - begin, "<Parameter name=\"file\" type=\"string\" value=\"lower.e\"/>\n" + more);
  }
  static std::string hash(const std::string& value) {
    return "      <Parameter name=\"sha256\" type=\"string\" value=\"" + value + "\"/>\n";
  }
  void write_mesh() const { write_exodus(mesh, folder / "lower.e", "lower"); }

  Finished run(const std::string& text, const std::string& command = "check", int ranks = 1) const {
    folder.write("deck.xml", text);
    return run_mortise(folder, command + " deck.xml", ranks);
  }
  /// The only error must have the code and the words.
  static void expect_refused(const Finished& finished, int code, const std::vector<std::string>& words) {
    EXPECT_EQ(finished.code, code) << finished.out << finished.err;
    EXPECT_EQ(count_of(finished.err, "error["), 1) << finished.err;
    for (const auto& word : words) EXPECT_EQ(count_of(finished.err, word), 1) << "\"" << word << "\" in: " << finished.err;
  }
};

TEST_F(MeshFile, RunsWithItsHash) {
  write_mesh();
  const auto finished = run(deck(hash(sha256_of_file(folder / "lower.e"))), "run");
  EXPECT_EQ(finished.code, 0) << finished.err;
}

TEST_F(MeshFile, WithAnotherHashIsRefusedWithBoth) {
  write_mesh();
  const std::string found = sha256_of_file(folder / "lower.e"), wanted(64, 'a');
  for (int ranks : {1, 2})
    expect_refused(run(deck(hash(wanted)), "check", ranks), 3,
                   {"deck.xml:7:7: error[M07] meshes > lower > \"sha256\"", "\"lower.e\"", found, wanted});
}

TEST_F(MeshFile, IsComparedWithItsHashBeforeItIsOpened) {
  folder.write("lower.e", "no mesh at all");
  expect_refused(run(deck(hash(std::string(64, 'a')))), 3, {"error[M07]", sha256("no mesh at all")});
}

TEST_F(MeshFile, DamagedIsToldOnceByAllRanks) {
  write_mesh();
  const std::string whole = text_of(folder / "lower.e");
  folder.write("damaged.e", whole.substr(0, whole.size() - 1));
  for (int ranks : {1, 2, 4})
    expect_refused(run_mortise(folder, "check damaged.e", ranks), 3, {"damaged.e: error[M04]", "truncated"});
}

// The first object of the global heap of HDF5 is said to be larger than all memory: the library believes it, and crashes.
TEST_F(MeshFile, ThatMakesTheLibraryCrashIsToldOnceByAllRanks) {
  mesh.node_numbers[3] = 5'000'000'000;  // needs 64 bits, and so netCDF-4
  write_mesh();
  const std::string whole = text_of(folder / "lower.e");
  const std::size_t heap = whole.find("GCOL");
  ASSERT_NE(heap, std::string::npos);
  folder.write("lower.e", std::string(whole).replace(heap + 28, 4, "\xff\xff\xff\xff"));
  for (int ranks : {1, 2})
    expect_refused(run(deck(), "check", ranks), 3, {"lower.e: error[M04] the mesh library fails on it (signal", "is damaged"});
}

TEST_F(MeshFile, WithASeamIsUsedWithAWarning) {
  mesh.coordinates.push_back(mesh.coordinates[0]);
  mesh.node_numbers.push_back(999);
  mesh.blocks[0].elements[0][0] = n_nodes(mesh) - 1;  // a corner of its own for the first element
  mesh.blocks[0].elements.push_back(std::vector<int>(mesh.blocks[0].elements[0].begin(), mesh.blocks[0].elements[0].end()));
  mesh.element_numbers.push_back(999);
  mesh.blocks[0].elements[mesh.blocks[0].elements.size() - 1][0] = 0;
  write_mesh();
  const auto finished = run_mortise(folder, "check lower.e");
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(count_of(finished.out, "warning: lower.e: 1 pair of nodes in one place (first: nodes 1 and 999)"), 1) << finished.out;
  EXPECT_EQ(count_of(run(deck()).out, "warning: meshes > lower: "), 1);
}

TEST_F(MeshFile, WhoseContactSideIsInsideIsRefusedAtItsPlaceInTheDeck) {
  for (Side& side : mesh.side_sets[5].sides) side = {side.element - 16, side.face};  // the top of the lower layer
  write_mesh();
  expect_refused(run(deck()), 3,
                 {"error[M52] contact > upper on lower > \"primary\" = \"lower/top\"", "16 of 16 sides", "mesh \"lower\""});
}

}  // namespace
}  // namespace mortise::test
