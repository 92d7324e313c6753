// A run of the program that a test stops or kills in its midst.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "support/program.hpp"

namespace mortise::test {

/// `mortise ARGUMENTS` as a child in a process group of its own, its output in files of `folder`. What still runs at the end of
/// the test is killed.
class Running {
 public:
  Running(const ScratchFolder& folder, std::vector<std::string> arguments, int ranks = 1) : folder_(folder) {
    std::vector<std::string> words{std::string(MORTISE_BINARY_DIR) + "/mortise"};
    if (ranks > 1) words = {MORTISE_MPIEXEC, "--oversubscribe", "-n", std::to_string(ranks), words[0]};
    words.insert(words.end(), arguments.begin(), arguments.end());
    process_ = ::fork();
    if (process_ == 0) start(words);
  }
  ~Running() {
    if (process_ > 0) {
      signal_all(SIGKILL);
      wait();
    }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Sends a signal to the process alone, or to all of its group.
  void signal(int number) const { ::kill(process_, number); }
  void signal_all(int number) const { ::kill(-process_, number); }

  /// Sends a signal to one of its children, the first one first: with mpirun these are the ranks.
  void signal_child(int k, int number) const {
    const std::string id = std::to_string(process_);
    std::ifstream list("/proc/" + id + "/task/" + id + "/children");
    pid_t child = 0;
    for (int skipped = -1; skipped < k; ++skipped) list >> child;
    if (list) ::kill(child, number);
  }

  /// Waits until `condition` holds. @return false if the program ends before, or after a minute
  bool until(const std::function<bool()>& condition) {
    for (int k = 0; k < 12000; ++k) {
      if (condition()) return true;
      if (has_ended()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

  bool has_ended() {
    if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
    return process_ < 0;
  }

  /// Exit code; 128 + the signal that ended it.
  Finished wait() {
    if (process_ > 0) ::waitpid(process_, &status_, 0);
    process_ = -1;
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), text_of(folder_ / "stdout.txt"),
            text_of(folder_ / "stderr.txt")};
  }

 private:
  [[noreturn]] void start(const std::vector<std::string>& words) const {
    ::setpgid(0, 0);
    if (::chdir((folder_ / "").c_str()) != 0) ::_exit(127);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
    ::dup2(::open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
    for (const auto& [name, value] :
         std::vector<std::pair<const char*, const char*>>{{"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                                                          {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                                                          {"OMPI_MCA_mpi_yield_when_idle", "1"},
                                                          {"OMPI_MCA_hwloc_base_binding_policy", "none"}})
      ::setenv(name, value, 1);
    std::vector<char*> pointers;
    for (const auto& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }

  const ScratchFolder& folder_;
  pid_t process_ = -1;
  int status_ = 0;
};

}  // namespace mortise::test
