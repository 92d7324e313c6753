// Hostile surroundings: folders that cannot be written, disks that are full, streams that are closed, locales, odd paths, too
// many ranks. The program says what is wrong, or does not mind.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/frames.hpp"
#include "support/program.hpp"

namespace mortise::test {
namespace {

namespace fs = std::filesystem;

const std::string program = "'" + std::string(MORTISE_BINARY_DIR) + "/mortise'";

/// The ironing on a coarse mesh until t = 4, kept after every step.
std::string small_ironing() {
  auto text = without_list(input_deck("ironing/frictionless.xml"), "expected");
  text = with(with(text, "{20, 5, 3}", "{14, 4, 3}"), "{4, 4, 4}", "{3, 3, 3}");
  text = with(text, "name=\"end\"          type=\"double\" value=\"20\"", "name=\"end\" type=\"double\" value=\"4\"");
  return with_lists(text,
                    "<ParameterList name=\"checkpoints\"><Parameter name=\"seconds\" type=\"double\" value=\"0\"/>"
                    "</ParameterList>");
}

class Surroundings : public testing::Test {
 protected:
  const ScratchFolder folder;

  void SetUp() override { folder.write("deck.xml", input_deck("patch_test/contact.xml")); }

  /// A shell command in the folder; the shell's own exit code.
  Finished shell(const std::string& command) const {
    folder.write(
        "command.sh",
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1\n" + command);
    const int status = std::system(
        ("cd '" + (folder / "").string() + "' && timeout 300 bash command.sh >stdout.txt 2>stderr.txt </dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "stdout.txt"), text_of(folder / "stderr.txt")};
  }
  static void expect_words(const std::string& in, const std::vector<std::string>& words) {
    for (const auto& word : words) EXPECT_GE(count_of(in, word), 1) << "\"" << word << "\" is not in: " << in;
  }
  /// History without the columns of seconds.
  static std::vector<std::vector<std::string>> numbers_of(const Table& table) {
    std::vector<std::vector<std::string>> kept;
    for (const auto& row : table.cells) {
      kept.emplace_back();
      for (std::size_t c = 0; c < row.size(); ++c)
        if (table.columns[c].rfind("seconds", 0) != 0) kept.back().push_back(row[c]);
    }
    return kept;
  }
};

// ---- where results go -------------------------------------------------------------------------------------------------

TEST_F(Surroundings, MissingFoldersAreMade) {
  const auto run = run_mortise(folder, "run deck.xml -o some/where/deep");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(fs::exists(folder / "some" / "where" / "deep" / "results.e"));
}

TEST_F(Surroundings, FolderBelowAFileIsRefused) {
  folder.write("file", "mine");
  for (const auto& [output, words] : {std::pair<std::string, std::string>{"file", "is a file"}, {"file/out", "Not a directory"}})
    for (int ranks : {1, 2}) {
      const auto run = run_mortise(folder, "run deck.xml --overwrite -o " + output, ranks);
      EXPECT_EQ(run.code, 5);
      expect_words(run.err, {output + ": error[I05]", words});
    }
  EXPECT_EQ(text_of(folder / "file"), "mine");
}

// Root may write everywhere, so the program then runs as nobody.
TEST_F(Surroundings, FolderThatMayNotBeWrittenIsRefused) {
  const std::string as_nobody = ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  fs::create_directories(folder / "closed");
  fs::permissions(folder / "", fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  const auto run =
      shell("chmod 555 closed; export TMPDIR=/tmp HOME=/tmp\n" + as_nobody + program + " run deck.xml -o closed/out");
  EXPECT_EQ(run.code, 5) << run.out << run.err;
  expect_words(run.err, {"closed/out: error[I05]", "Permission denied"});
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

// A disk of our own in a namespace of our own: geometry and some frames fit on it, not all.
TEST_F(Surroundings, FullDiskEndsTheRunAndNothingThatWasKeptIsLost) {
  folder.write("deck.xml", small_ironing());
  const auto whole = run_mortise(folder, "run deck.xml -o whole --quiet");
  ASSERT_EQ(whole.code, 0) << whole.err;
  const std::string unshare = ::geteuid() == 0 ? "unshare -m " : "unshare -rm ";
  if (shell("mkdir -p try && " + unshare + "mount -t tmpfs none try").code != 0)
    GTEST_SKIP() << "no file system may be mounted here, not even in a namespace of its own";
  const auto kilobytes = fs::file_size(folder / "whole" / "results.e") / 1024 / 2 + 100;
  const auto run =
      shell("mkdir -p disk kept && " + unshare + "bash -c '" + "mount -t tmpfs -o size=" + std::to_string(kilobytes) +
            "k none disk && { " + "\"" + std::string(MORTISE_BINARY_DIR) +
            "/mortise\" run deck.xml -o disk/out; code=$?; cp -r disk/out kept/; exit $code; }'");
  EXPECT_EQ(run.code, 5) << run.out << run.err;
  expect_words(run.err, {"disk/out/", "error[I02]", "No space left on device", "the last good state"});
  EXPECT_EQ(count_of(run.err, "error["), 1) << run.err;

  const auto frames = read_frames(folder / "kept" / "out" / "results.e").times;
  EXPECT_GE(frames.size(), 2u) << "not in mid-run";
  EXPECT_LT(frames.size(), read_frames(folder / "whole" / "results.e").times.size());
  const auto restarted = run_mortise(folder, "restart kept/out --quiet");
  EXPECT_EQ(restarted.code, 0) << restarted.err;
  EXPECT_EQ(numbers_of(read_history(folder / "kept" / "out" / "history.csv")),
            numbers_of(read_history(folder / "whole" / "history.csv")));
  EXPECT_TRUE(text_of(folder / "kept" / "out" / "results.e") == text_of(folder / "whole" / "results.e"));
}

// ---- streams ------------------------------------------------------------------------------------------------------------

TEST_F(Surroundings, ClosedStreamsDoNotEndUpInTheFiles) {
  const auto usual = run_mortise(folder, "run deck.xml -o usual");
  ASSERT_EQ(usual.code, 0);
  for (const std::string closed : {">&-", "<&- >&- 2>&-", ">/dev/full"}) {
    const auto run = shell(program + " run deck.xml -o out --overwrite " + closed);
    EXPECT_EQ(run.code, 0) << closed << run.err;
    EXPECT_EQ(numbers_of(read_history(folder / "out" / "history.csv")),
              numbers_of(read_history(folder / "usual" / "history.csv")));
    EXPECT_TRUE(text_of(folder / "out" / "results.e") == text_of(folder / "usual" / "results.e")) << closed;
    EXPECT_EQ(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["exit_code"], 0);
  }
}

TEST_F(Surroundings, ReaderThatStopsListeningDoesNotStopTheRun) {
  const auto run = shell("set -o pipefail; " + program + " run deck.xml -o out | head -n 1");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(folder / "out" / "summary.json"))["exit_code"], 0);
  const auto list = shell(program + " describe | head -n 1");
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(list.err, "");
}

// ---- words --------------------------------------------------------------------------------------------------------------

TEST_F(Surroundings, LocaleWithADecimalCommaChangesNothing) {
  if (shell("mkdir -p locales && localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8; test -d locales/de_DE.UTF-8").code != 0)
    GTEST_SKIP() << "localedef cannot make de_DE.UTF-8 here (package locales)";
  const std::string german = "export LOCPATH=$PWD/locales LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8\n";
  ASSERT_EQ(shell(german + "bash -c 'printf %.1f 1,5'").out, "1,5") << "the locale is not in force";
  const auto usual = run_mortise(folder, "run deck.xml -o usual");
  ASSERT_EQ(usual.code, 0);
  const auto run = shell(german + program + " run deck.xml -o out");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(numbers_of(read_history(folder / "out" / "history.csv")), numbers_of(read_history(folder / "usual" / "history.csv")));
  EXPECT_EQ(shell(german + program + " restart out").code, 0);
}

TEST_F(Surroundings, PathsWithBlanksQuotesAndUtf8AreFine) {
  const std::string odd = "Körper & 'Flächen' 面";
  fs::create_directories(folder / odd);
  for (const std::string name : {"slab", "indenter"})
    ASSERT_EQ(shell(program + " mesh '" + std::string(MORTISE_SOURCE_DIR) + "/inputs/ironing/" + name + "_recipe.xml' -o \"" +
                    odd + "/" + name + " ü.e\"")
                  .code,
              0);
  auto text = without_list(input_deck("ironing/frictionless_exodus.xml"), "expected");
  text = with(text, "name=\"end\"          type=\"double\" value=\"20\"", "name=\"end\" type=\"double\" value=\"1\"");
  folder.write(odd + "/ein deck.xml", with(with(text, "slab.e", "slab ü.e"), "indenter.e", "indenter ü.e"));
  for (const std::string launch : {"", "mpirun -n 2 "}) {
    const auto run = shell(launch + program + " run \"" + odd + "/ein deck.xml\" -o \"" + odd + "/out\" --overwrite");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(shell(launch + program + " restart \"" + odd + "/out\"").code, 0);
  }
  EXPECT_EQ(read_frames(folder / odd / "out" / "results.e").times.back(), 1);
}

// ---- ranks --------------------------------------------------------------------------------------------------------------

TEST_F(Surroundings, MoreRanksThanElementsAreRefusedAndAsManyAreFine) {
  folder.write("bar.xml", R"deck(<ParameterList name="bar">
  <ParameterList name="meshes"><ParameterList name="bar">
    <Parameter name="recipe" type="string" value="block"/>
    <Parameter name="size" type="Array(double)" value="{3, 1, 1}"/>
    <Parameter name="elements" type="Array(int)" value="{3, 1, 1}"/>
  </ParameterList></ParameterList>
  <ParameterList name="materials"><ParameterList name="rubber">
    <Parameter name="model" type="string" value="neo-hookean"/>
    <Parameter name="youngs modulus" type="double" value="1"/>
    <Parameter name="poissons ratio" type="double" value="0.3"/>
  </ParameterList></ParameterList>
  <ParameterList name="bodies"><ParameterList name="bar">
    <Parameter name="mesh" type="string" value="bar"/>
    <Parameter name="material" type="string" value="rubber"/>
  </ParameterList></ParameterList>
  <ParameterList name="supports"><ParameterList name="left">
    <Parameter name="set" type="string" value="bar/left"/>
    <Parameter name="x" type="string" value="0"/>
    <Parameter name="y" type="string" value="0"/>
    <Parameter name="z" type="string" value="0"/>
  </ParameterList></ParameterList>
  <ParameterList name="loads"><ParameterList name="right">
    <Parameter name="type" type="string" value="traction"/>
    <Parameter name="set" type="string" value="bar/right"/>
    <Parameter name="x" type="string" value="0.1*t"/>
  </ParameterList></ParameterList>
  <ParameterList name="probes"><ParameterList name="end">
    <Parameter name="quantity" type="string" value="displacement_x"/>
    <Parameter name="mesh" type="string" value="bar"/>
    <Parameter name="nearest" type="Array(double)" value="{3, 0, 0}"/>
  </ParameterList></ParameterList>
  <ParameterList name="time">
    <Parameter name="end" type="double" value="1"/>
    <Parameter name="step" type="double" value="1"/>
  </ParameterList>
</ParameterList>)deck");
  std::vector<double> first;
  for (int ranks : {1, 2, 3}) {
    const auto run = run_mortise(folder, "run bar.xml -o out --overwrite", ranks);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto found = read_history(folder / "out" / "history.csv")["displacement_x.end"];
    if (first.empty()) first = found;
    EXPECT_NEAR(found.back(), first.back(), 1e-12);
  }
  EXPECT_GT(first.back(), 0.25);
  const auto refused = run_mortise(folder, "run bar.xml -o more", 4);
  EXPECT_EQ(refused.code, 6);
  EXPECT_EQ(count_of(refused.err, "error[R02] 4 ranks, but 3 elements - at most 3 ranks can be used"), 1) << refused.err;
  EXPECT_FALSE(fs::exists(folder / "more"));
}

}  // namespace
}  // namespace mortise::test
