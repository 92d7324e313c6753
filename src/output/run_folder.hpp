// The folder of a run: made, refused or cleared before anything is computed; and the small files in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "output/history.hpp"

namespace mortise {

/// A folder that this run alone writes into, for as long as the object lives (a lock of the system, which a killed program
/// loses).
class RunFolder {
 public:
  /// For a new run: creates the folder, or refuses one that holds results (unless `overwrite`: these are removed, nothing else).
  /// @throws FileError
  static RunFolder begin(const std::filesystem::path& folder, bool overwrite);

  /// For a run that goes on in its folder. @throws FileError
  static RunFolder go_on(const std::filesystem::path& folder);

  ~RunFolder();
  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&&) = delete;

 private:
  explicit RunFolder(int lock) : lock_(lock) {}
  int lock_;
};

/// What the run does and does not: effects on and off, versions, ranks, hashes of deck and meshes.
std::string manifest(const Deck& deck, const StepProblem& problem, const std::string& linear_solver);

/// A value that the deck expects, and what came out.
struct Expectation {
  std::string name;
  double expected, tolerance, found;
  bool met;
};

/// Compares the history with the deck's `expected` list: forces by magnitude, means weighted with time.
std::vector<Expectation> check_expectations(const Scene& scene, const History& history);

/// How a run ended, for summary.json.
struct RunOutcome {
  ExitCode code = ExitCode::done;
  std::string cause;  ///< why early, in words
  double end_time = 0;
  MarchCounts done;          ///< since the start, over all restarts
  int restarted_after = -1;  ///< the step whose checkpoint this session went on from, -1: it began the run
  std::vector<Expectation> expectations;
  std::vector<std::string> warnings;         ///< of the run as a whole
  double cpu_seconds = 0, wall_seconds = 0;  ///< of this session
};

/// A line for each pair that never touched in all steps that the history has. @param touched whether a node of the k-th pair was
/// closed in a step of this session
std::vector<std::string> idle_pairs(const Scene& scene, const History& history, const std::vector<char>& touched);

/// summary.json. @throws FileError
void write_summary(const std::filesystem::path& file, const RunOutcome& outcome, const StepProblem& problem,
                   const Newton& newton);

}  // namespace mortise
