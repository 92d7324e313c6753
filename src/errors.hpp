// How the program fails: exit codes, and the two exceptions that reading may throw (conventions, sections 1 and 2).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mortise {

enum class ExitCode : int {
  done = 0,
  command_line = 1,
  deck = 2,
  mesh = 3,
  no_convergence = 4,
  input_output = 5,
  resources = 6,
  expectation_missed = 7,
  tangent_disagrees = 8,
  audit_rejects = 9,
  internal = 70,
  interrupted = 130,  ///< SIGINT, after finishing the step
  terminated = 143    ///< SIGTERM, likewise
};

/// What the user must mend. `what()` holds complete lines, one per error, ready to print: at most 20, then the count of the rest.
class UserError : public std::runtime_error {
 public:
  UserError(ExitCode code, const std::vector<std::string>& messages);
  UserError(ExitCode code, const std::string& message) : UserError(code, std::vector<std::string>{message}) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// A deck that cannot be run: exit code 2.
struct DeckError : UserError {
  explicit DeckError(const std::vector<std::string>& messages) : UserError(ExitCode::deck, messages) {}
  explicit DeckError(const std::string& message) : UserError(ExitCode::deck, message) {}
};

/// A mesh that cannot be used: exit code 3.
struct MeshError : UserError {
  explicit MeshError(const std::vector<std::string>& messages) : UserError(ExitCode::mesh, messages) {}
  explicit MeshError(const std::string& message) : UserError(ExitCode::mesh, message) {}
};

/// A file or folder that cannot be read or written: exit code 5.
struct FileError : UserError {
  explicit FileError(const std::string& message) : UserError(ExitCode::input_output, message) {}
};

/// The name of `known` nearest to `name` (Damerau-Levenshtein distance at most max(1, length / 3)), or an empty string.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// `; did you mean "..."?` with the nearest known name, or an empty string; to be put behind a message about an unknown name.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& known);

/// `names` as `a, b, c`.
std::string join(const std::vector<std::string>& names);

}  // namespace mortise
