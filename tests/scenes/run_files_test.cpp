// What a run leaves behind, and that watching it closer does not change it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/frames.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string patch_deck = "'" + std::string(MORTISE_SOURCE_DIR) + "/inputs/patch_test/contact.xml'";

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

TEST(Run, LeavesTheFilesOfTheConventions) {
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run " + patch_deck + " -o out", 2);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(count_of(run.out, "\x1b"), 0) << "control characters in a file";
  EXPECT_EQ(count_of(run.out, "step 2, t = 1"), 1);
  std::vector<std::string> found,
      expected{"checkpoint.0", "checkpoint.2", "history.csv", "manifest.txt", "mesh.e", "results.e", "run.log", "summary.json"};
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out")) found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);

  std::vector<std::string> columns{"step", "time", "dt", "newton_iterations", "cuts", "active", "stick", "slip"};
  const auto add_vector = [&](const std::string& name, const std::string& of) {
    for (const std::string axis : {"x", "y", "z"}) columns.push_back(name + "_" + axis + of);
  };
  add_vector("contact_force", ".upper on lower");
  for (const std::string support : {"lower bottom", "lower left", "lower front", "upper left", "upper front"})
    add_vector("reaction", "." + support);
  for (const std::string name : {"kinetic_energy", "strain_energy", "stick_energy", "total_energy", "external_work",
                                 "contact_work", "contact_work_closing", "contact_work_resegmentation", "friction_dissipation",
                                 "damping_dissipation", "algorithmic_dissipation", "residual_work", "ledger_mismatch"})
    columns.push_back(name);
  add_vector("linear_momentum", "");
  add_vector("angular_momentum", "");
  for (const std::string name : {"displacement_z.top", "displacement_x.side", "seconds_search", "seconds_contact",
                                 "seconds_elements", "seconds_solve", "seconds_output", "graph_rebuilds"})
    columns.push_back(name);
  const auto table = read_history(folder / "out" / "history.csv");
  ASSERT_GE(table.columns.size(), columns.size());
  EXPECT_EQ(std::vector<std::string>(table.columns.begin(), table.columns.begin() + columns.size()), columns);
  EXPECT_EQ(table["time"], (std::vector<double>{0, 0.5, 1}));

  const auto summary = nlohmann::json::parse(text_of(folder / "out" / "summary.json"));
  EXPECT_EQ(summary["exit_code"], 0);
  EXPECT_EQ(summary["steps"], 2);
  EXPECT_EQ(summary["ranks"], 2);
  EXPECT_EQ(summary["expected"].size(), 3u);
  for (const auto& e : summary["expected"]) EXPECT_TRUE(e["met"]) << e["name"];
  for (const std::string name : {"cuts", "newton_iterations", "seconds", "counts", "contact"})
    EXPECT_TRUE(summary.contains(name)) << name;

  const auto manifest = text_of(folder / "out" / "manifest.txt");
  for (const std::string words : {"sha256", "ranks 2", "internal force of \"upper\": on, neo-hookean", "inertia: off",
                                  "traction: on", "contact: on", "friction: off", "damping: off"})
    EXPECT_NE(manifest.find(words), std::string::npos) << words << " is not in\n" << manifest;
  EXPECT_EQ(count_of(text_of(folder / "out" / "run.log"), "converged in"), 2);
}

TEST(Run, WritesResultsThatTheExodusLibraryReads) {
  const ScratchFolder folder;
  const auto run = run_mortise(folder, "run " + patch_deck + " -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto frames = read_frames(folder / "out" / "results.e");
  EXPECT_EQ(frames.times, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(frames.nodal, (std::vector<std::string>{"displacement_x", "displacement_y", "displacement_z", "von_mises",
                                                    "contact_pressure", "gap", "status"}));
  EXPECT_TRUE(has(frames.global, "contact_force_z.upper on lower"));
  EXPECT_TRUE(has(frames.global, "strain_energy"));
  const auto checked = run_mortise(folder, "check out/results.e");
  EXPECT_EQ(checked.code, 0) << checked.err;
}

TEST(Run, ThatDivergesLeavesTheGoodStepsReadable) {
  const ScratchFolder folder;
  auto text = without_list(input_deck("patch_test/contact.xml"), "expected");
  text = with(text, "-1e4*t", "-1e4*t - 1e12*max(t-0.5,0)");
  folder.write(
      "deck.xml",
      with(text, "name=\"step\"   type=\"double\" value=\"0.5\"/>",
           "name=\"step\" type=\"double\" value=\"0.5\"/><Parameter name=\"smallest step\" type=\"double\" value=\"0.2\"/>"));
  for (int ranks : {1, 2}) {
    const auto run = run_mortise(folder, "run deck.xml -o out --overwrite", ranks);
    EXPECT_EQ(run.code, 4) << run.err;
    EXPECT_EQ(count_of(run.err, "no step converged at the smallest dt"), 1) << run.err;
    EXPECT_EQ(read_frames(folder / "out" / "results.e").times, (std::vector<double>{0, 0.5}));
    EXPECT_EQ(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["exit_code"], 4);
    EXPECT_GE(count_of(text_of(folder / "out" / "run.log"), "cause: "), 2);
  }
}

TEST(Run, OfEveryPatchDeckMeetsItsExpectedValues) {
  const ScratchFolder folder;
  const std::vector<std::pair<std::string, int>> runs{{"contact", 1},
                                                      {"conforming", 2},
                                                      {"shifted", 4},
                                                      {"rotated", 2},
                                                      {"inclined", 4},
                                                      {"mooney_rivlin_dead", 1},
                                                      {"mooney_rivlin_follower", 2},
                                                      {"tied", 4}};
  for (const auto& [name, ranks] : runs) {
    const auto run =
        run_mortise(folder, "run '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/patch_test/" + name + ".xml' --quiet", ranks);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_GE(count_of(run.out, ": met"), 3) << run.out;
    EXPECT_TRUE(std::filesystem::exists(folder / name / "results.e"))
        << "the folder is named after the deck where -o is left out";
  }
}

// Observers must not change anything the march can see.
TEST(Run, IsTheSameToTheLastDigitWithMoreFieldsAndProbes) {
  const ScratchFolder folder;
  const auto with_probes = input_deck("patch_test/contact.xml");
  folder.write("little.xml", with(without_list(without_list(with_probes, "expected"), "probes"),
                                  "{displacement, von mises, contact pressure, gap, status}", "{displacement}"));
  folder.write("much.xml", with(with_probes, "{displacement, von mises, contact pressure, gap, status}",
                                "{displacement, von mises, cauchy stress, reaction, contact pressure, gap, status}"));
  std::vector<Table> tables;
  for (const std::string name : {"little", "much"}) {
    const auto run = run_mortise(folder, "run " + name + ".xml");
    ASSERT_EQ(run.code, 0) << run.err;
    tables.push_back(read_history(folder / name / "history.csv"));
  }
  ASSERT_EQ(tables[0].n_rows(), tables[1].n_rows());
  int compared = 0;
  for (const auto& column : tables[0].columns) {
    if (column.rfind("seconds", 0) == 0) continue;
    EXPECT_EQ(tables[0][column], tables[1][column]) << column;
    ++compared;
  }
  EXPECT_GT(compared, 30);
  EXPECT_EQ(tables[1].columns.size(), tables[0].columns.size() + 2);
}

}  // namespace
}  // namespace mortise::test
