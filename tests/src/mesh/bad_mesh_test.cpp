// Meshes that must be refused, each with its code and its words.
#include <exodusII.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>

#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

Mesh two_hexes() { return block({2, 1, 1}, {2, 1, 1}); }

/// One way to spoil a mesh, and what the message must say.
struct Fault {
  const char* name;
  std::function<void(Mesh&)> spoil;
  std::vector<std::string> words;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class BadMesh : public testing::TestWithParam<Fault> {};

TEST_P(BadMesh, IsRefusedWithItsCodeAndWords) {
  Mesh mesh = two_hexes();
  GetParam().spoil(mesh);
  expect_words(mesh_error_of([&] { check_mesh(mesh); }), GetParam().words);
}

TEST_P(BadMesh, IsRefusedInAFileToo) {
  const ScratchFolder folder;
  Mesh mesh = two_hexes();
  GetParam().spoil(mesh);
  write_exodus(mesh, folder / "tool.exo", "bad");
  std::vector<std::string> words = GetParam().words;
  words.push_back((folder / "tool.exo").string() + ": error[M");
  expect_words(mesh_error_of([&] { read_exodus(folder / "tool.exo"); }), words);
}

const Fault faults[] = {
    {"NodeOutOfRange",
     [](Mesh& m) { m.blocks[0].elements[1][2] = 99; },
     {"M13", "block 1 \"block\"", "element 2, entry 3: node 100", "1 to 12"}},
    {"NodeNegative", [](Mesh& m) { m.blocks[0].elements[0][0] = -6; }, {"M13", "element 1, entry 1: node -5"}},
    {"NodeTwiceInAnElement",
     [](Mesh& m) { m.blocks[0].elements[1][2] = m.blocks[0].elements[1][3]; },
     {"M14", "element 2", "twice"}},
    {"CoordinateNotANumber", [](Mesh& m) { m.coordinates[4][1] = std::nan(""); }, {"M16", "1 node", "node 5", "nan"}},
    {"CoordinateInfinite", [](Mesh& m) { m.coordinates[4][1] = -INFINITY; }, {"M16", "node 5", "-inf"}},
    {"CoordinateTooLarge", [](Mesh& m) { m.coordinates[4][1] = 1e300; }, {"M18", "1 node", "node 5", "1e+300", "at most 1e+100"}},
    {"OrphanNodes",
     [](Mesh& m) {
       for (int i = 0; i < 7; ++i) m.coordinates.push_back({5, 5, 5}), m.node_numbers.push_back(101 + i);
     },
     {"M17", "7 nodes without element", "101, 102, 103, 104, 105"}},
    {"InvertedElement",
     [](Mesh& m) {
       const auto e = m.blocks[0].elements[1];
       std::swap(e[0], e[4]), std::swap(e[1], e[5]), std::swap(e[2], e[6]), std::swap(e[3], e[7]);
       m.element_numbers[1] = 4711;
     },
     {"M21", "1 element inverted", "element 4711", "-0.125", "Gauss point", "check node order"}},
    {"FlatElement",
     [](Mesh& m) {
       for (auto& x : m.coordinates) x[2] = 0;
     },
     {"M21", "2 elements inverted or flat", "element 1"}},
    {"FoldedAtOneGaussPoint",
     [](Mesh& m) {
       m.coordinates[0] = {0.9, 0.9, 0.9};
     },
     {"M21", "element 1", "Gauss point 1"}},
    {"NodeNumberTwice", [](Mesh& m) { m.node_numbers[3] = m.node_numbers[8]; }, {"M24", "node number map", "9"}},
    {"NodeNumberZero", [](Mesh& m) { m.node_numbers[3] = 0; }, {"M24", "entry 4 is 0", "positive"}},
    {"ElementNumberTwice", [](Mesh& m) { m.element_numbers[1] = 1; }, {"M25", "element number map", "first: 1"}},
    {"NameTwice", [](Mesh& m) { m.side_sets[1].name = "left"; }, {"M26", "side set 2 \"left\"", "unique"}},
    {"NegativeId", [](Mesh& m) { m.side_sets[1].id = -2; }, {"M27", "side set -2 \"right\"", "negative"}},
    {"NameWithControlCharacter", [](Mesh& m) { m.node_sets[1].name = "ri\aght"; }, {"M28", "node set 2 \"ri?ght\""}},
    {"NameNotUtf8", [](Mesh& m) { m.blocks[0].name = "f\xfcr"; }, {"M28", "block 1 \"f?r\"", "UTF-8"}},
    {"EmptySideSet", [](Mesh& m) { m.side_sets[4].sides.clear(); }, {"M31", "side set 5 \"bottom\" is empty"}},
    {"EmptyNodeSet", [](Mesh& m) { m.node_sets[4].nodes.clear(); }, {"M31", "node set 5 \"bottom\" is empty"}},
    {"ElementOfASideOutOfRange",
     [](Mesh& m) { m.side_sets[5].sides[1].element = 2; },
     {"M32", "side set 6 \"top\"", "entry 2, element 3", "1 to 2"}},
    {"SideNine", [](Mesh& m) { m.side_sets[5].sides[1].face = 8; }, {"M33", "entry 2, side 9 of element 2", "1 to 6"}},
    {"SideZero", [](Mesh& m) { m.side_sets[5].sides[0].face = -1; }, {"M33", "side 0 of element 1"}},
    {"SideTwice", [](Mesh& m) { m.side_sets[5].sides.push_back(m.side_sets[5].sides[0]); }, {"M35", "entry 3", "twice"}},
    {"NodeOfASetOutOfRange",
     [](Mesh& m) { m.node_sets[0].nodes[2] = 12; },
     {"M34", "node set 1 \"left\"", "entry 3, node 13", "1 to 12"}},
};

INSTANTIATE_TEST_SUITE_P(Each, BadMesh, testing::ValuesIn(faults), [](const auto& info) { return std::string(info.param.name); });

TEST(BadMeshes, HaveAllTheirErrorsListed) {
  Mesh mesh = two_hexes();
  mesh.coordinates[4][1] = std::nan("");
  mesh.side_sets[5].sides[1].face = 8;
  mesh.node_sets[0].nodes.clear();
  expect_words(mesh_error_of([&] { check_mesh(mesh); }), {"M16", "M31", "M33"});
}

TEST(BadMeshes, AreNotReportedTwiceForOneFault) {
  Mesh mesh = two_hexes();
  mesh.blocks[0].elements[1][1] = 99;  // leaves a node without element
  EXPECT_EQ(mesh_error_of([&] { check_mesh(mesh); }).find("M17"), std::string::npos);
}

TEST(BadMeshes, WithoutNodesOrElementsAreRefused) {
  expect_words(mesh_error_of([&] { check_mesh(Mesh{}); }), {"M03", "no nodes", "no elements"});
}

/// A file made by the library itself, so that it may hold what our writer would not write.
class ForeignFile {
 public:
  ForeignFile(const std::filesystem::path& path, int n_dimensions, int n_nodes, int n_elements, int n_blocks) {
    int word = sizeof(double), file_word = sizeof(double);
    id_ = ex_create(path.c_str(), EX_CLOBBER, &word, &file_word);
    ex_put_init(id_, "foreign", n_dimensions, n_nodes, n_elements, n_blocks, 0, 0);
    const std::vector<double> x(static_cast<std::size_t>(n_nodes) + 1, 0.0);
    if (n_nodes > 0) ex_put_coord(id_, x.data(), x.data(), x.data());
  }
  ~ForeignFile() { ex_close(id_); }
  void add_block(int number, const char* type, int n_elements, int n_nodes_each, const char* name) const {
    ex_put_block(id_, EX_ELEM_BLOCK, number, type, n_elements, n_nodes_each, 0, 0, 0);
    const std::vector<int> nodes(static_cast<std::size_t>(n_elements * n_nodes_each), 1);
    if (n_elements > 0) ex_put_conn(id_, EX_ELEM_BLOCK, number, nodes.data(), nullptr, nullptr);
    ex_put_name(id_, EX_ELEM_BLOCK, number, name);
  }

 private:
  int id_;
};

TEST(ForeignFiles, WithOtherElementTypesNameEachBlock) {
  const ScratchFolder folder;
  {
    const ForeignFile file(folder / "tool.exo", 3, 27, 3, 3);
    file.add_block(1, "HEX8", 1, 8, "base");
    file.add_block(2, "PYRAMID5", 1, 5, "shaft");
    file.add_block(3, "HEX", 1, 9, "");
  }
  const std::string error = mesh_error_of([&] { read_exodus(folder / "tool.exo"); });
  const std::string supported = "is not supported - supported: hex8, hex20, hex27, tet4, tet10, wedge6, sphere, bar2, bar3, bar4";
  expect_words(error, {"tool.exo: error[M12] block 2 \"shaft\": element type PYRAMID5 with 5 nodes " + supported,
                       "block 3: element type HEX with 9 nodes " + supported});
}

TEST(ForeignFiles, OfOneOrTwoDimensionsAreRefused) {
  const ScratchFolder folder;
  for (int n : {1, 2}) {
    { const ForeignFile file(folder / "flat.e", n, 4, 1, 1); }
    expect_words(mesh_error_of([&] { read_exodus(folder / "flat.e"); }), {"M02", std::to_string(n) + " dimensions"});
  }
}

TEST(ForeignFiles, WithoutNodesOrElementsAreRefused) {
  const ScratchFolder folder;
  { const ForeignFile file(folder / "none.e", 3, 0, 0, 0); }
  expect_words(mesh_error_of([&] { read_exodus(folder / "none.e"); }), {"M03", "no nodes", "no elements"});
}

TEST(ForeignFiles, MayHaveEmptyBlocks) {
  const ScratchFolder folder;
  {
    const ForeignFile file(folder / "gap.e", 3, 8, 1, 2);
    file.add_block(1, "TET4", 0, 4, "gap");
    file.add_block(2, "HEX8", 1, 8, "rest");
  }
  expect_words(mesh_error_of([&] { read_exodus(folder / "gap.e"); }), {"M14", "block 2 \"rest\""});  // and no word about TET4
}

TEST(ForeignFiles, ThatAreNoExodusFilesAreRefused) {
  const ScratchFolder folder;
  const auto write = [&](const std::string& bytes) { std::ofstream(folder / "x.e", std::ios::binary) << bytes; };
  const auto error = [&] { return mesh_error_of([&] { read_exodus(folder / "x.e"); }); };
  write("");
  expect_words(error(), {"M01", "not an Exodus file"});
  write("\x89PNG\r\n\x1a\n and so on");
  expect_words(error(), {"M01", "not an Exodus file"});
  write(std::string("CDF\1", 4) + std::string(28, '\0'));  // netCDF without anything in it
  expect_words(error(), {"M01", "not an Exodus file"});
  write(std::string("CDF\1\0\0\0\0\0\0\0\x0a\x7f\xff\xff\xff", 16));  // two thousand million dimensions
  expect_words(error(), {"M04", "do not fit"});
  write("\x89HDF\r\n\x1a\n and so on");
  expect_words(error(), {"M04", "superblock"});
}

TEST(ForeignFiles, CutAnywhereAreRefused) {
  const ScratchFolder folder;
  write_exodus(two_hexes(), folder / "whole.e", "two hexes");
  std::ifstream in(folder / "whole.e", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  for (std::size_t n = 0; n < bytes.size(); n += n % 64 == 0 ? 1 : 7) {
    std::ofstream(folder / "cut.e", std::ios::binary) << bytes.substr(0, n);
    EXPECT_THROW(read_exodus(folder / "cut.e"), MeshError) << "cut to " << n << " of " << bytes.size() << " bytes";
  }
  std::filesystem::resize_file(folder / "whole.e", bytes.size() - 40);
  expect_words(mesh_error_of([&] { read_exodus(folder / "whole.e"); }), {"M04", "requires", "truncated"});
}

TEST(ForeignFiles, LongerThanTheirHeaderSaysAreRefused) {
  const ScratchFolder folder;
  write_exodus(two_hexes(), folder / "long.e", "two hexes");
  std::ofstream(folder / "long.e", std::ios::binary | std::ios::app) << "more";
  expect_words(mesh_error_of([&] { read_exodus(folder / "long.e"); }), {"M04", "its header describes"});
}

TEST(ForeignFiles, ThatWouldHoldTheReaderUpAreRefused) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.e").c_str(), 0600), 0);
  try {
    read_exodus(folder / "pipe.e");
    ADD_FAILURE() << "a pipe is read";
  } catch (const FileError& error) {
    expect_words(error.what(), {"I01", "no regular file"});
  }
}

}  // namespace
}  // namespace mortise
