// Running a function in a child process with limits.
#include "mesh/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <new>

#include "errors.hpp"

namespace mortise {

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool has_address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool has_address_sanitizer = false;
#endif

constexpr int pipe_size = 1 << 20;  // the most that Linux allows everybody [bytes]

enum ChildExit { ended_well = 0, threw = 1, out_of_memory = 2 };

template <class Resource>
void limit(Resource resource, rlim_t soft, rlim_t hard) {
  rlimit limits{};
  getrlimit(resource, &limits);
  limits.rlim_cur = std::min(soft, limits.rlim_max);
  limits.rlim_max = std::min(hard, limits.rlim_max);
  setrlimit(resource, &limits);
}

/// Address space of this process [bytes].
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Whatever the surroundings do on a crash (MPI prints a backtrace), the child just ends by it. A request to stop goes to all
/// processes at the terminal; it is the parent's to answer. A child does not outlive its parent: it would keep what that had
/// locked.
void prepare_child(const ChildLimits& limits) {
  for (int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) signal(crash, SIG_DFL);
  for (int request : {SIGINT, SIGTERM}) signal(request, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_CPU, limits.processor_seconds, limits.processor_seconds + 1);
  // AddressSanitizer maps terabytes of shadow memory, which the limit would count.
  if (!has_address_sanitizer) limit(RLIMIT_AS, address_space() + limits.memory, RLIM_INFINITY);
}

bool write_all(int pipe, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(pipe, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void be_child(const std::function<std::string()>& work, const ChildLimits& limits, int pipe) {
  int code = threw;
  try {
    prepare_child(limits);
    code = write_all(pipe, work()) ? ended_well : threw;
  } catch (const std::bad_alloc&) {
    code = out_of_memory;
  } catch (...) {  // nothing may unwind into the parent's code, which the child has a copy of
  }
  _exit(code);
}

/// Reads until the other end is closed. @return false if the deadline comes first
bool read_all(int pipe, std::string& bytes, std::chrono::steady_clock::time_point deadline) {
  std::array<char, 65536> buffer;  // left as it is: each page that is written here after the fork costs a copy
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    if (left <= 0) return false;
    pollfd wanted{pipe, POLLIN, 0};
    if (poll(&wanted, 1, static_cast<int>(std::min<long>(left, 60000))) <= 0) continue;
    const ssize_t n = read(pipe, buffer.data(), buffer.size());
    if (n == 0) return true;
    if (n > 0) bytes.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

std::string failure_of(int status, const ChildLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int cause = WTERMSIG(status);
    if (cause == SIGXCPU) return fmt::format("more than {} s of processor time", limits.processor_seconds);
    return fmt::format("signal {}, {}", cause, strsignal(cause));
  }
  const int code = WEXITSTATUS(status);
  if (code == out_of_memory) return fmt::format("more than {} MB of memory", limits.memory >> 20);
  return code == ended_well ? "" : fmt::format("exit code {}", code);
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  const auto refuse = [](int cause) {
    throw UserError(ExitCode::resources, fmt::format("error[R03] no process can be started: {}", std::strerror(cause)));
  };
  int ends[2] = {};
  if (pipe(ends) != 0) refuse(errno);
  fcntl(ends[0], F_SETPIPE_SZ, pipe_size);             // only for speed: where it is not allowed, the usual size remains
  const auto on_child_end = signal(SIGCHLD, SIG_DFL);  // where a launcher has it ignored, no end could be waited for
  const pid_t child = fork();
  if (child < 0) {
    const int cause = errno;
    signal(SIGCHLD, on_child_end);
    close(ends[0]);
    close(ends[1]);
    refuse(cause);
  }
  if (child == 0) {
    close(ends[0]);
    be_child(work, limits, ends[1]);
  }
  close(ends[1]);
  ChildResult result;
  const bool in_time =
      read_all(ends[0], result.bytes, std::chrono::steady_clock::now() + std::chrono::seconds(limits.wall_seconds));
  if (!in_time) kill(child, SIGKILL);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  signal(SIGCHLD, on_child_end);
  result.failure = in_time ? failure_of(status, limits) : fmt::format("no answer within {} s", limits.wall_seconds);
  return result;
}

}  // namespace mortise
