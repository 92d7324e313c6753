// Runs that are stopped, killed and gone on with by `mortise restart`: nothing is lost, and the end is the same.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "output/checkpoint.hpp"
#include "support/frames.hpp"
#include "support/random.hpp"
#include "support/running.hpp"

namespace mortise::test {
namespace {

namespace fs = std::filesystem;

const std::string kept_after_every_step =
    "<ParameterList name=\"checkpoints\"><Parameter name=\"seconds\" type=\"double\" value=\"0\"/></ParameterList>\n";

/// The ironing on a coarse mesh until t = 8, kept after every step; some fields are written at every second step only.
std::string deck() {
  auto text = without_list(input_deck("ironing/frictionless.xml"), "expected");
  text = with(with(text, "{20, 5, 3}", "{14, 4, 3}"), "{4, 4, 4}", "{3, 3, 3}");
  text = with(text, "name=\"end\"          type=\"double\" value=\"20\"", "name=\"end\" type=\"double\" value=\"8\"");
  text = with(text, "  <ParameterList name=\"output\">",
              "  <ParameterList name=\"output\">\n    <Parameter name=\"every\" type=\"int\" value=\"2\"/>");
  return with_lists(text, kept_after_every_step +
                              "<ParameterList name=\"expected\"><ParameterList name=\"end\">"
                              "<Parameter name=\"quantity\" type=\"string\" value=\"time\"/>"
                              "<Parameter name=\"mean from\" type=\"double\" value=\"1\"/>"
                              "<Parameter name=\"value\" type=\"double\" value=\"4.7\"/>"
                              "<Parameter name=\"tolerance\" type=\"double\" value=\"0.3\"/></ParameterList></ParameterList>");
}

class Restarting : public testing::Test {
 protected:
  const ScratchFolder folder;

  void SetUp() override { folder.write("deck.xml", deck()); }

  /// The run that nothing stops, in the folder "whole".
  void run_whole(int ranks = 1) {
    const auto whole = run_mortise(folder, "run deck.xml -o whole --quiet", ranks);
    ASSERT_EQ(whole.code, 0) << whole.err;
  }

  /// Everything but seconds, and the bytes of the results.
  void expect_same_as_whole(const std::string& name) const {
    const auto a = read_history(folder / "whole" / "history.csv"), b = read_history(folder / name / "history.csv");
    ASSERT_EQ(a.n_rows(), b.n_rows());
    for (std::size_t c = 0; c < a.columns.size(); ++c)
      for (std::size_t row = 0; row < a.n_rows() && a.columns[c].rfind("seconds", 0) != 0; ++row)
        ASSERT_EQ(a.cells[row][c], b.cells[row][c]) << a.columns[c] << ", step " << row;
    EXPECT_TRUE(text_of(folder / "whole" / "results.e") == text_of(folder / name / "results.e")) << "results.e differs";
    const auto summary = [&](const std::string& run) { return nlohmann::json::parse(text_of(folder / run / "summary.json")); };
    for (const char* key : {"exit_code", "end_time", "steps", "cuts", "newton_iterations", "expected"})
      EXPECT_EQ(summary(name)[key], summary("whole")[key]) << key;
  }

  int newest_step(const std::string& name) const {
    const auto files = checkpoint_files(folder / name);
    return files.empty() ? -1 : std::stoi(files[0].extension().string().substr(1));
  }

  /// Begins a run in "out" and stops it by a signal to its last rank after step `step`.
  Finished stop(int step, int signal, int ranks = 1) {
    fs::remove_all(folder / "out");
    Running run(folder, {"run", "deck.xml", "-o", "out"}, ranks);
    EXPECT_TRUE(run.until([&] { return newest_step("out") >= step; })) << run.wait().err;
    ranks > 1 ? run.signal_child(ranks - 1, signal) : run.signal(signal);
    return run.wait();
  }

  void expect_words(const std::string& in, const std::vector<std::string>& words) const {
    for (const auto& word : words) EXPECT_GE(count_of(in, word), 1) << "\"" << word << "\" is not in: " << in;
  }
};

TEST_F(Restarting, AfterSigtermOrSigintIsTheSameToTheLastBit) {
  run_whole();
  for (const auto& [signal, code, word] : {std::tuple{SIGTERM, 143, "SIGTERM"}, std::tuple{SIGINT, 130, "SIGINT"}}) {
    const auto stopped = stop(5, signal);
    EXPECT_EQ(stopped.code, code) << stopped.err;
    expect_words(stopped.err, {std::string("stopped by ") + word + " after step", "mortise restart out"});
    const auto summary = nlohmann::json::parse(text_of(folder / "out" / "summary.json"));
    EXPECT_EQ(summary["exit_code"], code);
    EXPECT_EQ(newest_step("out"), summary["steps"]);
    EXPECT_EQ(read_frames(folder / "out" / "results.e").times.back(), summary["end_time"]) << "the last good state is not there";

    const auto restarted = run_mortise(folder, "restart out --quiet");
    EXPECT_EQ(restarted.code, 0) << restarted.err;
    expect_same_as_whole("out");
    EXPECT_EQ(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["restarted_after_step"], summary["steps"]);
    EXPECT_EQ(count_of(text_of(folder / "out" / "run.log"), "step 6, t = "), 1) << "the log of the first session is gone";
  }
}

// One rank gets the signal, all stop after the same step. (mpirun itself would pass it on to all of them, a second later.)
TEST_F(Restarting, OnTwoRanksGoesOnOnTwoAndOnOne) {
  run_whole(2);
  for (int ranks : {2, 1}) {
    EXPECT_EQ(stop(5, SIGTERM, 2).code, 143);
    EXPECT_EQ(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["exit_code"], 143);
    const auto restarted = run_mortise(folder, "restart out --quiet", ranks);
    EXPECT_EQ(restarted.code, 0) << restarted.err;
    if (ranks == 2) {
      expect_same_as_whole("out");
    } else {
      const std::string force = "contact_force_z.indenter on slab";
      const auto a = read_history(folder / "out" / "history.csv")[force],
                 b = read_history(folder / "whole" / "history.csv")[force];
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-8 * greatest_of(b)) << "step " << k;
    }
  }
}

// The program is killed wherever it happens to be, over and over, until it has got to the end: each time all files must be
// readable, no accepted step that was kept may be lost, and the end must be the same to the last bit.
TEST_F(Restarting, AfterKillsAtRandomTimesIsTheSameToTheLastBit) {
  const auto start = std::chrono::steady_clock::now();
  run_whole();
  const double whole_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const int n_kills = std::getenv("MORTISE_LONG") ? 200 : 12;
  Random random(7);
  int killed = 0, rounds = 0, lost = 0, before_any_checkpoint = 0;
  for (; killed < n_kills; ++rounds) {
    fs::remove_all(folder / "out");
    bool is_done = false;
    while (!is_done) {
      const int before = newest_step("out");
      Running run(folder, before < 0 ? std::vector<std::string>{"run", "deck.xml", "-o", "out", "--overwrite"}
                                     : std::vector<std::string>{"restart", "out"});
      // Every other time, whatever else the machine does, in mid-march: not before a further step has been kept.
      if (killed % 2 == 1) run.until([&] { return newest_step("out") >= std::max(1, before + 1); });
      const auto end = std::chrono::steady_clock::now() +
                       std::chrono::duration<double>(random.in(0, killed % 2 == 1 ? 0.1 : 0.7) * whole_seconds);
      while (!run.has_ended() && (killed >= n_kills || std::chrono::steady_clock::now() < end))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      // A program may come to its end just before the signal reaches it: its exit code says which was first.
      if (!run.has_ended()) run.signal(SIGKILL);
      const auto finished = run.wait();
      is_done = finished.code == 0;
      if (!is_done) {
        ASSERT_EQ(finished.code, 128 + SIGKILL) << finished.err;
        ++killed;
      }
      const int now = newest_step("out");
      lost += now < before;
      before_any_checkpoint += now <= 0;
      if (now < 0) continue;
      std::vector<std::string> warnings;
      const auto kept = read_newest_checkpoint(folder / "out", warnings);
      EXPECT_TRUE(warnings.empty()) << warnings[0];
      EXPECT_GE(static_cast<int>(read_history(folder / "out" / "history.csv").n_rows()), kept.done.steps + 1);
      EXPECT_GE(static_cast<int>(read_frames(folder / "out" / "results.e").times.size()), kept.frames);
    }
    expect_same_as_whole("out");
    if (HasFailure()) break;
  }
  EXPECT_EQ(lost, 0);
  EXPECT_GE(killed - before_any_checkpoint, n_kills / 2);
  std::cout << killed << " kills in " << rounds << " runs, " << before_any_checkpoint
            << " of them before the first step was kept: all runs "
            << "ended as the one without\n";
}

TEST_F(Restarting, OfAFinishedRunChangesNothing) {
  run_whole();
  fs::copy(folder / "whole", folder / "out");
  const auto restarted = run_mortise(folder, "restart out");
  EXPECT_EQ(restarted.code, 0) << restarted.err;
  expect_words(restarted.out, {"had reached its end", "\"end\"", "met"});
  expect_same_as_whole("out");
}

TEST_F(Restarting, WithAnotherDeckOrMeshIsRefused) {
  for (const std::string name : {"slab", "indenter"})
    ASSERT_EQ(run_mortise(folder, "mesh '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/ironing/" + name + "_recipe.xml' -o " +
                                      name + ".e")
                  .code,
              0);
  auto text = without_list(input_deck("ironing/frictionless_exodus.xml"), "expected");
  text = with(text, "name=\"end\"          type=\"double\" value=\"20\"", "name=\"end\" type=\"double\" value=\"3\"");
  text = with_lists(text, kept_after_every_step);
  folder.write("deck.xml", text);
  const auto stopped = stop(1, SIGTERM);
  ASSERT_EQ(stopped.code, 143) << stopped.err;

  const std::string other = with(text, "-0.7*min(t,1)", "-0.6*min(t,1)");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("-0.7*min(t,1)")), '\n');
  folder.write("deck.xml", other);
  auto refused = run_mortise(folder, "restart out");
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"deck.xml:" + std::to_string(line) + ":1: error[I10]", "-0.7*min(t,1)"});

  folder.write("deck.xml", text);
  fs::rename(folder / "slab.e", folder / "was.e");
  fs::copy_file(folder / "indenter.e", folder / "slab.e");
  refused = run_mortise(folder, "restart out", 2);
  EXPECT_NE(refused.code, 0);
  EXPECT_EQ(count_of(refused.err, "error["), 1) << refused.err;

  fs::rename(folder / "was.e", folder / "slab.e");
  fs::create_directories(folder / "moved");
  for (const std::string file : {"deck.xml", "slab.e", "indenter.e"}) fs::rename(folder / file, folder / "moved" / file);
  refused = run_mortise(folder, "restart out");
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"error[I01]", "deck.xml"});
  const auto restarted = run_mortise(folder, "restart out --deck moved/deck.xml");
  EXPECT_EQ(restarted.code, 0) << restarted.err;
}

TEST_F(Restarting, NeedsAFolderOfARun) {
  auto refused = run_mortise(folder, "restart nowhere");
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"nowhere: error[I05]", "No such file"});
  fs::create_directories(folder / "empty");
  refused = run_mortise(folder, "restart empty", 2);
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"empty", "error[I10] holds no checkpoint"});
}

TEST_F(Restarting, WithoutItsHistoryIsRefusedAndWithoutItsResultsBeginsNewOnes) {
  ASSERT_EQ(stop(5, SIGTERM).code, 143);
  fs::rename(folder / "out" / "history.csv", folder / "kept.csv");
  auto refused = run_mortise(folder, "restart out");
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"history.csv: error[I10] cannot be read"});
  const auto history = text_of(folder / "kept.csv");
  folder.write("out/history.csv", history.substr(0, history.size() / 3));
  refused = run_mortise(folder, "restart out");
  EXPECT_EQ(refused.code, 5);
  expect_words(refused.err, {"history.csv: error[I10]"});

  folder.write("out/history.csv", history);
  const auto times = read_frames(folder / "out" / "results.e").times;
  fs::rename(folder / "out" / "results.e", folder / "earlier.e");
  const auto restarted = run_mortise(folder, "restart out");
  EXPECT_EQ(restarted.code, 0) << restarted.err;
  const auto rest = read_frames(folder / "out" / "results.e").times;
  ASSERT_FALSE(rest.empty());
  EXPECT_GT(rest.front(), times[times.size() - 2]);
  EXPECT_EQ(rest.back(), 8);
}

TEST_F(Restarting, IsRefusedWhileTheRunIsStillGoing) {
  Running run(folder, {"run", "deck.xml", "-o", "out"});
  ASSERT_TRUE(run.until([&] { return newest_step("out") >= 1; }));
  run.signal(SIGSTOP);
  const auto restarted = run_mortise(folder, "restart out"), again = run_mortise(folder, "run deck.xml -o out --overwrite");
  run.signal(SIGCONT);
  for (const auto& refused : {restarted, again}) {
    EXPECT_EQ(refused.code, 5);
    expect_words(refused.err, {"error[I05] another run is writing into this folder"});
  }
  EXPECT_EQ(run.wait().code, 0);
}

}  // namespace
}  // namespace mortise::test
