// Fields in results.e as the Exodus library reads them: names, which blocks have them, values on any number of ranks, restarts.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/frames.hpp"
#include "support/running.hpp"

namespace mortise::test {
namespace {

std::string held(const std::string& name, const std::string& set, const std::string& components) {
  return list(name, word("set", set) + components);
}
std::string body(const std::string& name) { return list(name, word("mesh", name) + word("material", "rubber")); }

/// Two bodies of different elements, each sheared and pressed; some fields at nodes and at points.
const std::string fixed = word("x", "0") + word("y", "0") + word("z", "0");
const std::string deck = list(
    "two element types",
    list("meshes",
         list("lower", word("recipe", "block") + deck_parameter("size", "Array(double)", "{3, 3, 1}") +
                           deck_parameter("elements", "Array(int)", "{4, 4, 2}")) +
             list("upper", word("recipe", "block") + deck_parameter("elements", "Array(int)", "{2, 2, 2}") +
                               word("element type", "tet4") + deck_parameter("origin", "Array(double)", "{0.9, 1.1, 1.5}"))) +
        list("materials",
             list("rubber", word("model", "neo-hookean") + number("youngs modulus", "10") + number("poissons ratio", "0.3"))) +
        list("bodies", body("lower") + body("upper")) +
        list("supports", held("lower bottom", "lower/bottom", fixed) +
                             held("lower top", "lower/top", word("x", "0.2*t") + word("z", "-0.1*t*x")) +
                             held("upper bottom", "upper/bottom", fixed) +
                             held("upper top", "upper/top", word("y", "0.1*t") + word("z", "0.2*t*y"))) +
        list("time", number("end", "1") + number("step", "0.125") + number("largest step", "0.125")) +
        list("solver", deck_parameter("further iterations", "int", "1")) + list("checkpoints", number("seconds", "0")) +
        list("output",
             deck_parameter("fields", "Array(string)",
                            "{displacement, reaction, cauchy stress, principal stresses, green-lagrange strain}") +
                 deck_parameter("element fields", "Array(string)", "{cauchy stress, first piola stress, energy density}")) +
        list("probes", list("corner", word("quantity", "principal_stress_1") + word("mesh", "lower") +
                                          deck_parameter("nearest", "Array(double)", "{3, 3, 1}"))));

constexpr int last_frame = 9;  // the start and eight steps

/// Variables of nodes and elements, with their values in one frame.
struct FrameValues {
  std::vector<std::string> nodal, element;
  std::vector<int> in_block;
  std::vector<std::vector<double>> nodal_values, element_values;  ///< the latter over the blocks that have the variable

  FrameValues(const std::filesystem::path& file, int frame) {
    int word = sizeof(double), file_word = 0;
    float version = 0;
    const int id = ex_open(file.c_str(), EX_READ, &word, &file_word, &version);
    if (id < 0) return;
    ex_set_max_name_length(id, 80);
    const auto n_nodes = ex_inquire_int(id, EX_INQ_NODES);
    std::vector<int> blocks(static_cast<std::size_t>(ex_inquire_int(id, EX_INQ_ELEM_BLK)));
    ex_get_ids(id, EX_ELEM_BLOCK, blocks.data());
    nodal = names_of_variables(id, EX_NODAL);
    element = names_of_variables(id, EX_ELEM_BLOCK);
    for (std::size_t v = 0; v < nodal.size(); ++v) {
      nodal_values.emplace_back(n_nodes);
      ex_get_var(id, frame, EX_NODAL, static_cast<int>(v) + 1, 1, n_nodes, nodal_values.back().data());
    }
    in_block.resize(blocks.size() * element.size());
    ex_get_truth_table(id, EX_ELEM_BLOCK, static_cast<int>(blocks.size()), static_cast<int>(element.size()), in_block.data());
    element_values.resize(element.size());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      ex_block block{};
      block.id = blocks[b];
      block.type = EX_ELEM_BLOCK;
      ex_get_block_param(id, &block);
      for (std::size_t v = 0; v < element.size(); ++v) {
        if (!in_block[b * element.size() + v]) continue;
        std::vector<double> values(static_cast<std::size_t>(block.num_entry));
        ex_get_var(id, frame, EX_ELEM_BLOCK, static_cast<int>(v) + 1, block.id, block.num_entry, values.data());
        element_values[v].insert(element_values[v].end(), values.begin(), values.end());
      }
    }
    ex_close(id);
  }
};

void expect_close(const std::vector<std::string>& names, const std::vector<std::vector<double>>& a,
                  const std::vector<std::vector<double>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v) {
    ASSERT_EQ(a[v].size(), b[v].size());
    for (std::size_t k = 0; k < a[v].size(); ++k) EXPECT_NEAR(a[v][k], b[v][k], 1e-10 * greatest_of(b[v])) << names[v];
  }
}

TEST(Fields, AreInTheFileByTheirNamesAndOnlyInBlocksThatHaveThem) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  const FrameValues frame(folder / "out" / "results.e", last_frame);
  EXPECT_EQ(frame.nodal, (std::vector<std::string>{"displacement_x",
                                                   "displacement_y",
                                                   "displacement_z",
                                                   "reaction_x",
                                                   "reaction_y",
                                                   "reaction_z",
                                                   "stress_xx",
                                                   "stress_yy",
                                                   "stress_zz",
                                                   "stress_xy",
                                                   "stress_yz",
                                                   "stress_zx",
                                                   "principal_stress_1",
                                                   "principal_stress_2",
                                                   "principal_stress_3",
                                                   "green_lagrange_strain_xx",
                                                   "green_lagrange_strain_yy",
                                                   "green_lagrange_strain_zz",
                                                   "green_lagrange_strain_xy",
                                                   "green_lagrange_strain_yz",
                                                   "green_lagrange_strain_zx"}));
  std::vector<std::string> element;
  for (const std::string point : {"1", "2", "3", "4", "5", "6", "7", "8"}) {
    for (const std::string ij : {"xx", "yy", "zz", "xy", "yz", "zx"}) element.push_back("stress_" + ij + "_" + point);
    for (const std::string ij : {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"})
      element.push_back("first_piola_stress_" + ij + "_" + point);
    element.push_back("energy_density_" + point);
  }
  EXPECT_EQ(frame.element, element);
  std::vector<int> in_block(2 * element.size(), 1);
  std::fill(in_block.begin() + static_cast<long>(element.size()) + 16, in_block.end(), 0);  // a tet4 has one point
  EXPECT_EQ(frame.in_block, in_block);
  for (std::size_t v = 0; v < element.size(); ++v)
    EXPECT_EQ(frame.element_values[v].size(), v < 16 ? 32u + 48u : 32u) << element[v];
  const double corner = read_history(folder / "out" / "history.csv")["principal_stress_1.corner"].back();
  const auto& of_nodes = frame.nodal_values.at(12);
  EXPECT_GT(std::abs(corner), 0.01);
  EXPECT_EQ(std::count(of_nodes.begin(), of_nodes.end(), corner), 1) << "the probe is not the value of a node";
}

TEST(Fields, AreTheSameOnOneTwoAndFourRanks) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  std::vector<FrameValues> frames;
  for (int ranks : {1, 2, 4}) {
    const auto run = run_mortise(folder, "run deck.xml --quiet -o on" + std::to_string(ranks), ranks);
    ASSERT_EQ(run.code, 0) << run.err;
    frames.emplace_back(folder / ("on" + std::to_string(ranks)) / "results.e", last_frame);
  }
  ASSERT_EQ(frames[0].element.size(), 128u);
  EXPECT_GT(greatest_of(frames[0].element_values[0]), 0.1) << "nothing was stressed";
  for (std::size_t k : {1, 2}) {
    EXPECT_EQ(frames[k].in_block, frames[0].in_block);
    expect_close(frames[0].nodal, frames[k].nodal_values, frames[0].nodal_values);
    expect_close(frames[0].element, frames[k].element_values, frames[0].element_values);
  }
}

TEST(Fields, OfElementsGoOnInARestartedRunToTheLastBit) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  ASSERT_EQ(run_mortise(folder, "run deck.xml -o whole --quiet").code, 0);
  Running run(folder, {"run", "deck.xml", "-o", "out"});
  ASSERT_TRUE(run.until([&] { return std::filesystem::exists(folder / "out" / "checkpoint.3"); }));
  run.signal(SIGTERM);
  ASSERT_EQ(run.wait().code, 143) << "the run was over before it was stopped";
  const auto restarted = run_mortise(folder, "restart out --quiet");
  ASSERT_EQ(restarted.code, 0) << restarted.err;
  EXPECT_GE(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["restarted_after_step"], 3);
  EXPECT_EQ(read_frames(folder / "out" / "results.e").times, read_frames(folder / "whole" / "results.e").times);
  for (int frame = 1; frame <= last_frame; ++frame) {
    const FrameValues whole(folder / "whole" / "results.e", frame), out(folder / "out" / "results.e", frame);
    ASSERT_EQ(whole.element.size(), 128u);
    EXPECT_EQ(out.in_block, whole.in_block);
    EXPECT_EQ(out.nodal_values, whole.nodal_values) << "frame " << frame;
    EXPECT_EQ(out.element_values, whole.element_values) << "frame " << frame;
  }
}

TEST(Fields, ThatAStaticRunDoesNotHaveEndItWithTheCodeOfDecks) {
  const ScratchFolder folder;
  folder.write("deck.xml", with(deck, "{displacement, reaction", "{velocity, reaction"));
  const auto run = run_mortise(folder, "run deck.xml");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(count_of(run.err, "error[D19] output > \"fields\""), 1) << run.err;
}

}  // namespace
}  // namespace mortise::test
