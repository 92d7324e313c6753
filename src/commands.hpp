// The commands of the program, each a function that returns its exit code; errors leave as exceptions for main to print.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "assembly/tpetra.hpp"
#include "errors.hpp"

namespace mortise {

struct RunOptions {
  std::filesystem::path deck;
  std::optional<std::filesystem::path> output;  ///< default: the deck's name without .xml, in the current folder
  bool overwrite = false;
  bool quiet = false;
};

/// `mortise run`: marches the scene and writes the folder of the run.
ExitCode run_command(const RunOptions& options, const RCP<const Comm>& comm);

struct RestartOptions {
  std::filesystem::path folder;               ///< of a run
  std::optional<std::filesystem::path> deck;  ///< default: where it was when the run began
  bool quiet = false;
};

/// `mortise restart`: goes on from the last checkpoint in the folder of a run, as if it had not stopped.
ExitCode restart_command(const RestartOptions& options, const RCP<const Comm>& comm);

/// `mortise check`: reads a deck (and its meshes) or an Exodus file alone, checks everything, prints the manifest, runs nothing.
ExitCode check_command(const std::filesystem::path& file, const RCP<const Comm>& comm);

/// `mortise mesh`: writes the mesh of a recipe.
ExitCode mesh_command(const std::filesystem::path& recipe, const std::filesystem::path& output, const RCP<const Comm>& comm);

struct TangentsOptions {
  std::optional<std::filesystem::path> deck;    ///< none: the study of numerical differentiation (thesis Fig. D.1)
  std::optional<std::filesystem::path> output;  ///< CSV file
  bool overwrite = false;
  int most = 100;  ///< elements, or secondary facets, of a term
};

/// `mortise tangents`: differentiates every term of a scene in every way, at the initial and a deformed state, and compares.
/// @throws UserError with code 8 if one disagrees, after the tables have been printed and written
ExitCode tangents_command(const TangentsOptions& options, const RCP<const Comm>& comm);

/// `mortise describe`: prints the deck reference, or one list of it, or all of it as a schema.
ExitCode describe_command(const std::string& list, bool as_schema, const RCP<const Comm>& comm);

}  // namespace mortise
