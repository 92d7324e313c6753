// The folder of a run: made, refused or cleared before anything is computed; and the small files in it.
#pragma once

#include <filesystem>
#include <string>

#include "deck/deck.hpp"
#include "output/history.hpp"

namespace mortise {

/// Makes `folder` ready: creates it, or refuses one that holds results (unless `overwrite`: these are removed, nothing else).
/// @throws FileError
void prepare_run_folder(const std::filesystem::path& folder, bool overwrite);

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

/// summary.json. @throws FileError
void write_summary(const std::filesystem::path& file, const MarchSummary& summary, ExitCode code,
                   const std::vector<Expectation>& expectations, const StepProblem& problem, const Newton& newton,
                   double cpu_seconds, double wall_seconds);

}  // namespace mortise
