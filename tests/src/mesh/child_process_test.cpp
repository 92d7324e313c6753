// Whatever happens in the child, the parent gets an answer in words.
#include "mesh/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <vector>

#include "mesh/mesh_bytes.hpp"
#include "mesh/recipes/recipes.hpp"

namespace mortise {
namespace {

constexpr ChildLimits limits{1, 20, std::uint64_t{1} << 28};

TEST(ChildProcess, HandsOverWhatItsFunctionReturns) {
  const std::string many(3'000'001, 'x');  // more than a pipe holds
  const ChildResult result = run_in_child([&] { return many + '\0' + "end"; }, limits);
  EXPECT_EQ(result.failure, "");
  EXPECT_EQ(result.bytes, many + '\0' + "end");
}

TEST(ChildProcess, ThatCrashesIsAnAnswer) {
  for (int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
    const ChildResult result = run_in_child([&]() -> std::string { return raise(signal), "survived"; }, limits);
    EXPECT_EQ(result.failure.find("signal " + std::to_string(signal) + ", "), 0U) << result.failure;
  }
}

TEST(ChildProcess, ThatThrowsOrLeavesIsAnAnswer) {
  EXPECT_EQ(run_in_child([]() -> std::string { throw 1; }, limits).failure, "exit code 1");
  EXPECT_EQ(run_in_child([]() -> std::string { _exit(9); }, limits).failure, "exit code 9");
}

TEST(ChildProcess, ThatComputesForeverIsEndedByTheProcessorLimit) {
  const auto forever = []() -> std::string {
    for (volatile unsigned i = 0;; i = i + 1) continue;
  };
  rusage before{}, after{};
  getrusage(RUSAGE_CHILDREN, &before);
  EXPECT_EQ(run_in_child(forever, limits).failure, "more than 1 s of processor time");
  getrusage(RUSAGE_CHILDREN, &after);
  EXPECT_LE(after.ru_utime.tv_sec - before.ru_utime.tv_sec, 2);
}

TEST(ChildProcess, ThatWaitsForeverIsEndedByTheClock) {
  const auto forever = []() -> std::string {
    for (;;) pause();
  };
  EXPECT_EQ(run_in_child(forever, {1, 1, limits.memory}).failure, "no answer within 1 s");
}

#ifndef __SANITIZE_ADDRESS__
TEST(ChildProcess, ThatTakesTooMuchMemoryIsAnAnswer) {
  const auto greedy = []() -> std::string { return std::string(std::size_t{1} << 29, 'x').substr(0, 1); };
  EXPECT_EQ(run_in_child(greedy, limits).failure, "more than 256 MB of memory");
}
#endif

TEST(ChildProcess, IsSeenToEndWhereEndsAreIgnored) {
  const auto before = signal(SIGCHLD, SIG_IGN);
  EXPECT_EQ(run_in_child([]() -> std::string { return raise(SIGSEGV), ""; }, limits).failure.find("signal 11"), 0U);
  EXPECT_EQ(run_in_child([] { return std::string("good"); }, limits).failure, "");
  EXPECT_EQ(signal(SIGCHLD, before), SIG_IGN) << "what the surroundings had set is back";
}

TEST(ChildProcess, LeavesRequestsToStopToItsParent) {
  const auto interrupted = []() -> std::string { return raise(SIGINT), raise(SIGTERM), "finished"; };
  EXPECT_EQ(run_in_child(interrupted, limits).bytes, "finished");
}

TEST(ChildProcess, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run_in_child(
      []() -> std::string {
        std::puts("out");
        std::fflush(stdout);
        std::fputs("err", stderr);
        return "";
      },
      limits);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

TEST(MeshBytes, GiveTheMeshBackAndNothingElse) {
  Mesh mesh = block({1, 2, 3}, {2, 1, 1});
  mesh.source = "a file";
  mesh.side_sets[2].sides.clear();
  const std::string bytes = bytes_of(mesh);
  const Mesh back = mesh_of(bytes);
  EXPECT_EQ(bytes_of(back), bytes);
  EXPECT_EQ(back.coordinates, mesh.coordinates);
  EXPECT_EQ(back.side_sets[5].name, "top");
  EXPECT_EQ(back.side_sets[5].sides[1].element, 1);
  for (std::size_t n = 0; n < bytes.size(); n += 5) EXPECT_THROW(mesh_of(bytes.substr(0, n)), std::logic_error) << n;
  EXPECT_THROW(mesh_of(bytes + "x"), std::logic_error);
  EXPECT_THROW(mesh_of(std::string(64, '\xff')), std::logic_error);
}

}  // namespace
}  // namespace mortise
