// Exodus files: what is written is what is read.
#include "mesh/exodus.hpp"

#include <exodusII.h>

#include <algorithm>
#include <fstream>

#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

/// A brick in two blocks with names, gaps in the numbers, and sets without a name.
Mesh sample() {
  Mesh mesh = graded_block({2, 1, 1}, {4, 2, 2}, {3, 1, 1});
  Block second{20, "shaft", ElementList()};
  auto& elements = mesh.blocks[0].elements;
  second.elements = elements.part(10, elements.size());
  elements.resize(10);
  mesh.blocks[0].name = "";
  mesh.blocks[0].id = 7;
  mesh.blocks.push_back(second);
  mesh.side_sets[2].name = "";
  mesh.node_sets[3].name = "";
  mesh.node_sets[4].name = "a name of more than thirty-two characters, as they happen to be";
  for (auto& number : mesh.node_numbers) number = 10 * number + 3;
  std::reverse(mesh.element_numbers.begin(), mesh.element_numbers.end());
  return mesh;
}

template <class Sets>
void expect_same_names(const Sets& a, const Sets& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].name, b[i].name);
  }
}

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.coordinates, b.coordinates);
  EXPECT_EQ(a.node_numbers, b.node_numbers);
  EXPECT_EQ(a.element_numbers, b.element_numbers);
  expect_same_names(a.blocks, b.blocks);
  expect_same_names(a.side_sets, b.side_sets);
  expect_same_names(a.node_sets, b.node_sets);
  for (std::size_t i = 0; i < a.blocks.size(); ++i) EXPECT_EQ(a.blocks[i].elements, b.blocks[i].elements);
  for (std::size_t i = 0; i < a.node_sets.size(); ++i) EXPECT_EQ(a.node_sets[i].nodes, b.node_sets[i].nodes);
  for (std::size_t i = 0; i < a.side_sets.size(); ++i) {
    ASSERT_EQ(a.side_sets[i].sides.size(), b.side_sets[i].sides.size());
    for (std::size_t j = 0; j < a.side_sets[i].sides.size(); ++j) {
      EXPECT_EQ(a.side_sets[i].sides[j].element, b.side_sets[i].sides[j].element);
      EXPECT_EQ(a.side_sets[i].sides[j].face, b.side_sets[i].sides[j].face);
    }
  }
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(ExodusFile, GivesBackTheMeshThatWasWritten) {
  const ScratchFolder folder;
  write_exodus(sample(), folder / "sample.e", "a brick");
  expect_same(sample(), read_exodus(folder / "sample.e"));
}

TEST(ExodusFile, IsWrittenInTheClassicFormatAndTheSameEachTime) {
  const ScratchFolder folder;
  write_exodus(sample(), folder / "one.e", std::string(200, 'x'));
  write_exodus(sample(), folder / "two.e", std::string(200, 'x'));
  EXPECT_EQ(bytes_of(folder / "one.e").substr(0, 4), std::string("CDF\2"));
  EXPECT_EQ(bytes_of(folder / "one.e"), bytes_of(folder / "two.e"));
}

TEST(ExodusFile, KeepsNumbersAndIdsThatNeed64Bits) {
  const ScratchFolder folder;
  Mesh mesh = sample();
  mesh.node_numbers[3] = 5'000'000'000;
  mesh.side_sets[1].id = 6'000'000'000;
  write_exodus(mesh, folder / "large.e", "");
  expect_same(mesh, read_exodus(folder / "large.e"));
}

TEST(ExodusFile, MayHaveBlanksAndAccentsInItsPath) {
  const ScratchFolder folder;
  write_exodus(sample(), folder / "für den Träger.e", "");
  EXPECT_EQ(n_elements(read_exodus(folder / "für den Träger.e")), 16);
}

TEST(ExodusFile, WithoutNumberMapsIsCountedFromOne) {
  const ScratchFolder folder;
  int word = sizeof(double), file_word = sizeof(float);
  const int id = ex_create((folder / "bare.e").c_str(), EX_CLOBBER, &word, &file_word);
  ex_put_init(id, "bare", 3, 8, 1, 1, 0, 0);
  const double x[] = {0, 1, 1, 0, 0, 1, 1, 0}, y[] = {0, 0, 1, 1, 0, 0, 1, 1}, z[] = {0, 0, 0, 0, 1, 1, 1, 1};
  ex_put_coord(id, x, y, z);
  ex_put_block(id, EX_ELEM_BLOCK, 1, "hex", 1, 8, 0, 0, 0);
  const int nodes[] = {1, 2, 3, 4, 5, 6, 7, 8};
  ex_put_conn(id, EX_ELEM_BLOCK, 1, nodes, nullptr, nullptr);
  ex_close(id);
  const Mesh mesh = read_exodus(folder / "bare.e");
  EXPECT_EQ(mesh.node_numbers, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(mesh.element_numbers, (std::vector<std::int64_t>{1}));
  EXPECT_EQ(volume(mesh, 0), 1);
}

TEST(ExodusFile, ThatCannotBeOpenedOrWrittenIsAFileErrorWithItsReason) {
  const ScratchFolder folder;
  const auto error_of = [](auto action) -> std::string {
    try {
      action();
    } catch (const FileError& error) {
      EXPECT_EQ(error.code(), ExitCode::input_output);
      return error.what();
    }
    return "no error";
  };
  expect_words(error_of([&] { read_exodus(folder / "absent.e"); }), {"absent.e", "I01", "No such file"});
  expect_words(error_of([&] { read_exodus(folder / ""); }), {"I01", "folder"});
  expect_words(error_of([&] { write_exodus(sample(), folder / "no/such/folder.e", ""); }), {"folder.e", "I02", "No such file"});
}

/// Files of other codes, kept beside the checkout.
class PeerMesh : public testing::Test {
 protected:
  static Mesh read(const std::string& name) { return read_exodus(path(name)); }
  static std::filesystem::path path(const std::string& name) {
    return std::filesystem::path(MORTISE_SOURCE_DIR) / "../shared/peers" / name;
  }
  static bool present(const std::string& name) { return std::filesystem::exists(path(name)); }
};

TEST_F(PeerMesh, OfMooseIsRead) {
  if (!present("nafems_cgs1_brick1.e")) GTEST_SKIP() << "the folder shared/peers is not beside the checkout";
  const Mesh mesh = read("nafems_cgs1_brick1.e");
  EXPECT_EQ(mesh.blocks.size(), 2U);
  double sum = 0;
  for (int e = 0; e < n_elements(mesh); ++e) sum += volume(mesh, e);
  EXPECT_NEAR(sum, 1.0, 1e-9);
  for (const SideSet& set : mesh.side_sets) EXPECT_FALSE(set.sides.empty());
}

TEST_F(PeerMesh, Of4CIsReadWithItsNodeNumbers) {
  if (!present("contact3D_lin_stdlagr.e")) GTEST_SKIP() << "the folder shared/peers is not beside the checkout";
  const Mesh mesh = read("contact3D_lin_stdlagr.e");
  EXPECT_NE(std::find(mesh.node_numbers.begin(), mesh.node_numbers.end(), 67), mesh.node_numbers.end());
  EXPECT_GE(mesh.blocks.size(), 2U);
  for (int e = 0; e < n_elements(mesh); ++e) EXPECT_GT(volume(mesh, e), 0);
}

}  // namespace
}  // namespace mortise
