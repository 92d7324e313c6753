// Work of rank 0 that may fail, such as writing files.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <new>
#include <string>

#include "assembly/tpetra.hpp"
#include "errors.hpp"

namespace mortise {

/// Rank 0 does the work; if it fails, every rank leaves with the same error instead of waiting for it. Collective.
template <class Work>
void on_root(const Comm& comm, const Work& work) {
  std::string message;
  int code = 0;
  if (comm.getRank() == 0) {
    try {
      work();
    } catch (const UserError& error) {
      code = static_cast<int>(error.code());
      message = error.what();
    } catch (const std::bad_alloc&) {
      code = static_cast<int>(ExitCode::resources);
      message = "error[R01] out of memory while writing";
    } catch (const std::exception& error) {
      code = static_cast<int>(ExitCode::internal);
      message = std::string("internal error, please report it: ") + error.what();
    }
  }
  Teuchos::broadcast(comm, 0, &code);
  if (code != 0) throw UserError(static_cast<ExitCode>(code), comm.getRank() == 0 ? message : std::string("another rank failed"));
}

}  // namespace mortise
