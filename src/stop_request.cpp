#include "stop_request.hpp"

#include <csignal>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

volatile std::sig_atomic_t caught = 0;

void note(int signal) { caught = signal; }

}  // namespace

void catch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

ExitCode requested_stop(const Comm& comm) {
  const int signal = all_reduced(comm, Teuchos::REDUCE_MAX, static_cast<int>(caught));
  return signal == 0 ? ExitCode::done : static_cast<ExitCode>(128 + signal);
}

}  // namespace mortise
