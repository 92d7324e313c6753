// Running a function in a child process with limits, so that whatever happens in it cannot end or hang the program.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mortise {

struct ChildLimits {
  unsigned processor_seconds;
  unsigned wall_seconds;  ///< for a child that waits instead of working
  std::uint64_t memory;   ///< address space beyond what the program has already [bytes]; not enforced under AddressSanitizer
};

struct ChildResult {
  std::string bytes;    ///< what the function returned
  std::string failure;  ///< how the child ended instead, e.g. `signal 11, Segmentation fault`; empty if it ended well
};

/// Calls `work` in a fork of this process and hands its result over through a pipe. In the child nothing can be printed, crashes
/// leave no core file, and nothing of MPI may be called: the child leaves by _exit, so the parent's MPI never hears of it.
/// @throws UserError (exit code 6) if no process can be started
ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace mortise
