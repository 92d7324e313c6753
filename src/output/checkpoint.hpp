// Checkpoints: all that a run needs to go on, as plain data that is the same on any number of ranks, and their files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "output/history.hpp"
#include "time/march.hpp"

namespace mortise {

/// What a run was made from.
struct Origin {
  std::string program;                                      ///< version
  std::string deck_file;                                    ///< absolute path
  std::string deck_text;                                    ///< as read
  std::vector<std::pair<std::string, std::string>> meshes;  ///< names and SHA-256 of those that came from files
};

/// The state of a run between two steps. Unknowns by global number: positions [m], then pressures [Pa].
struct Checkpoint {
  Origin origin;
  double time = 0;            ///< of the state
  double dt = 0;              ///< next step
  int stage = 0;              ///< see MarchState
  bool enters_stage = false;  ///< likewise
  int pending_cuts = 0;
  int n_closed = 0;  ///< nodes in contact
  MarchCounts done;
  int frames = 0;  ///< in results.e
  std::vector<double> x;
  std::vector<double> v, a;      ///< likewise, 0 for pressures; empty in statics
  std::vector<double> search_x;  ///< of the last search; empty: there was none
  double search_reach = 0, search_inward = 0;
  Ledger ledger;
  WorkCounts work;
  std::vector<ContactCounts> contact;  ///< per pair
};

/// Takes everything there is to keep. Collective; the same on every rank but for the counts of work, which are rank 0's.
Checkpoint make_checkpoint(const Origin& origin, const StepProblem& problem, const MarchState& at, const Ledger& ledger,
                           int frames);

/// Where the march stood. @param problem of the same scene, on any number of ranks
MarchState resume(const Checkpoint& checkpoint, StepProblem& problem);

/// The bytes of a file: one line of text, the length and the CRC-32 of what follows, and the data as CBOR.
std::string to_bytes(const Checkpoint& checkpoint);

/// @throws std::invalid_argument, with the reason in words, for anything that `to_bytes` did not write
Checkpoint from_bytes(std::string_view bytes);

/// Writes `folder`/checkpoint.<step> so that it is there as a whole or not at all, then removes all but it and the one before.
/// @throws FileError
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// The files checkpoint.<step> of a folder, the newest first.
std::vector<std::filesystem::path> checkpoint_files(const std::filesystem::path& folder);

/// The newest checkpoint of a folder that is sound. @param warnings a line for each that is not
/// @throws FileError if there is none
Checkpoint read_newest_checkpoint(const std::filesystem::path& folder, std::vector<std::string>& warnings);

}  // namespace mortise
