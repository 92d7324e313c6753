// The results file, read back by the Exodus library.
#include "output/results.hpp"

#include <exodusII.h>
#include <sys/resource.h>

#include <csignal>

#include "mesh/exodus.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"

namespace mortise {
namespace {

const std::vector<std::string> nodal{"displacement_x", "displacement_y", "displacement_z",
                                     "a quantity with a name of more than 32 characters"};
const std::vector<std::string> global{"kinetic_energy", "contact_force_z.indenter on slab and much further"};
const ResultsVariables variables{nodal, global, {}};

double value(int variable, int node, int frame) { return 100 * frame + 10 * variable + 0.1 * node; }

void write_frame(ResultsFile& file, const Mesh& mesh, int frame) {
  std::vector<std::vector<double>> fields(nodal.size());
  for (std::size_t v = 0; v < fields.size(); ++v)
    for (int a = 0; a < n_nodes(mesh); ++a) fields[v].push_back(value(static_cast<int>(v), a, frame));
  file.write(0.5 * frame, {fields, {1.5 * frame, -1.0 * frame}, {}});
}

/// Checks with the library's own calls that the file holds `n_frames` frames with our values.
void expect_frames(const std::filesystem::path& path, const Mesh& mesh, int n_frames) {
  int word = sizeof(double), file_word = 0;
  float version = 0;
  const int id = ex_open(path.c_str(), EX_READ, &word, &file_word, &version);
  ASSERT_GE(id, 0);
  EXPECT_EQ(ex_inquire_int(id, EX_INQ_TIME), n_frames);
  ex_set_max_name_length(id, 80);
  int n_variables = 0;
  ex_get_variable_param(id, EX_NODAL, &n_variables);
  ASSERT_EQ(n_variables, static_cast<int>(nodal.size()));
  for (int v = 0; v < n_variables; ++v) {
    char name[128] = {};
    ex_get_variable_name(id, EX_NODAL, v + 1, name);
    EXPECT_EQ(name, nodal[static_cast<std::size_t>(v)]);
    for (int frame = 1; frame <= n_frames; ++frame) {
      std::vector<double> values(mesh.coordinates.size());
      EXPECT_GE(ex_get_var(id, frame, EX_NODAL, v + 1, 1, n_nodes(mesh), values.data()), 0);
      for (int a = 0; a < n_nodes(mesh); ++a) EXPECT_EQ(values[static_cast<std::size_t>(a)], value(v, a, frame));
    }
  }
  for (int frame = 1; frame <= n_frames; ++frame) {
    double time = 0, sums[2] = {};
    ex_get_time(id, frame, &time);
    EXPECT_EQ(time, 0.5 * frame);
    ex_get_var(id, frame, EX_GLOBAL, 1, 1, 2, sums);
    EXPECT_EQ(sums[0], 1.5 * frame);
    EXPECT_EQ(sums[1], -1.0 * frame);
  }
  char name[128] = {};
  ex_get_variable_name(id, EX_GLOBAL, 2, name);
  EXPECT_EQ(name, global[1]);
  ex_close(id);
}

TEST(ResultsFile, HoldsEveryFrameAndTheMesh) {
  const ScratchFolder folder;
  const Mesh mesh = block({2, 1, 1}, {3, 2, 2});
  {
    ResultsFile file(folder / "results.e", mesh, "a run", variables);
    for (int frame = 1; frame <= 3; ++frame) write_frame(file, mesh, frame);
  }
  expect_frames(folder / "results.e", mesh, 3);
  const Mesh read = read_exodus(folder / "results.e");
  EXPECT_EQ(read.coordinates, mesh.coordinates);
  EXPECT_EQ(read.side_sets[5].name, "top");
}

TEST(ResultsFile, IsReadableWhileTheRunGoesOn) {
  const ScratchFolder folder;
  const Mesh mesh = block({2, 1, 1}, {3, 2, 2});
  ResultsFile file(folder / "results.e", mesh, "a run", variables);
  for (int frame = 1; frame <= 3; ++frame) {
    write_frame(file, mesh, frame);
    std::filesystem::copy_file(folder / "results.e", folder / "copy.e", std::filesystem::copy_options::overwrite_existing);
    expect_frames(folder / "copy.e", mesh, frame);
  }
}

TEST(ResultsFile, MayHaveNoVariables) {
  const ScratchFolder folder;
  ResultsFile file(folder / "results.e", block({1, 1, 1}, {1, 1, 1}), "", ResultsVariables{});
  EXPECT_NO_THROW(file.write(0, {}));
}

/// Two blocks, of which the first has both variables and the second has one.
const ResultsVariables of_blocks{{}, {"energy"}, {{"stress_1", "stress_2"}, {1, 1, 1, 0}}};

Mesh two_blocks() {
  Mesh mesh = block({1, 1, 1}, {2, 2, 2});
  const ElementList all = mesh.blocks[0].elements;
  mesh.blocks[0].elements = all.part(0, 5);
  mesh.blocks.push_back({7, "second", all.part(5, 8)});
  return mesh;
}

std::vector<double> values_of(int id, int frame, int variable, int block, std::size_t n) {
  std::vector<double> values(n, -1.0);
  EXPECT_EQ(ex_get_var(id, frame, EX_ELEM_BLOCK, variable, block, static_cast<std::int64_t>(n), values.data()), 0);
  return values;
}

TEST(ResultsFile, HoldsVariablesOfElementsInTheBlocksThatHaveThem) {
  const ScratchFolder folder;
  const Mesh mesh = two_blocks();
  const std::vector<double> first{0, 1, 2, 3, 4, 5, 6, 7}, second{10, 11, 12, 13, 14, 0, 0, 0}, later{5, 5, 5, 5, 5, 6, 6, 6};
  {
    ResultsFile file(folder / "results.e", mesh, "a run", of_blocks);
    for (int frame = 0; frame < 3; ++frame) file.write(frame, {{}, {1.0 * frame}, {first, second}});
  }
  {
    ResultsFile goes_on(folder / "results.e", mesh, 1, of_blocks);  // frames 2 and 3 are cut off
    goes_on.write(10, {{}, {3}, {later, second}});
  }
  int word = sizeof(double), file_word = 0;
  float version = 0;
  const int id = ex_open((folder / "results.e").c_str(), EX_READ, &word, &file_word, &version);
  ASSERT_GE(id, 0);
  EXPECT_EQ(ex_inquire_int(id, EX_INQ_TIME), 2);
  std::vector<int> in_block(4, -1);
  EXPECT_EQ(ex_get_truth_table(id, EX_ELEM_BLOCK, 2, 2, in_block.data()), 0);
  EXPECT_EQ(in_block, of_blocks.element.in_block);
  EXPECT_EQ(values_of(id, 1, 1, 1, 5), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(values_of(id, 1, 1, 7, 3), (std::vector<double>{5, 6, 7}));
  EXPECT_EQ(values_of(id, 1, 2, 1, 5), (std::vector<double>{10, 11, 12, 13, 14}));
  EXPECT_EQ(values_of(id, 2, 1, 7, 3), (std::vector<double>{6, 6, 6}));
  ex_close(id);
}

TEST(ResultsFile, WithOtherVariablesOfElementsIsNotGoneOnWith) {
  const ScratchFolder folder;
  const Mesh mesh = two_blocks();
  {
    ResultsFile(folder / "results.e", mesh, "a run", of_blocks)
        .write(0, {{}, {0}, {std::vector<double>(8), std::vector<double>(8)}});
  }
  ResultsVariables fewer = of_blocks, elsewhere = of_blocks;
  fewer.element = {{"stress_1"}, {1, 1}};
  elsewhere.element.in_block = {1, 1, 0, 1};
  for (const ResultsVariables& other : {fewer, elsewhere}) {
    std::string words = "no error";
    try {
      ResultsFile(folder / "results.e", mesh, 1, other);
    } catch (const FileError& error) {
      words = error.what();
    }
    expect_words(words, {"results.e", "I10", "is not the results file of this run"});
  }
  EXPECT_NO_THROW(ResultsFile(folder / "results.e", mesh, 1, of_blocks));
}

TEST(ResultsFile, InAFolderThatIsNotThereIsAFileError) {
  const ScratchFolder folder;
  EXPECT_THROW(ResultsFile(folder / "absent/results.e", block({1, 1, 1}, {1, 1, 1}), "", variables), FileError);
}

TEST(ResultsFile, NamesTheLastCompleteFrameWhenTheDiskIsFull) {
  const ScratchFolder folder;
  const Mesh mesh = block({1, 1, 1}, {8, 8, 8});
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  std::string words = "no error";
  {
    ResultsFile file(folder / "results.e", mesh, "a run", variables);
    write_frame(file, mesh, 1);
    rlimit full = before;
    full.rlim_cur = std::filesystem::file_size(folder / "results.e") + 1000;
    setrlimit(RLIMIT_FSIZE, &full);
    try {
      write_frame(file, mesh, 2);
    } catch (const FileError& error) {
      words = error.what();
    }
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  expect_words(words, {"results.e", "I02", "frame 2", "last complete frame: 1", "File too large"});
}

}  // namespace
}  // namespace mortise
