// Stopping in order: SIGINT and SIGTERM let the step finish, so that nothing is lost.
#pragma once

#include "assembly/tpetra.hpp"
#include "errors.hpp"

namespace mortise {

/// From now on the first SIGINT or SIGTERM is noted; a second one of the same kind ends the program at once, as without this.
void catch_stop_signals();

/// The exit code (130, 143) of the signal that any rank has got, or `done`. Collective.
ExitCode requested_stop(const Comm& comm);

}  // namespace mortise
