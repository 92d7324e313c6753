// Runs the program as a user does, and reads what it leaves behind.
#pragma once

#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/greatest.hpp"
#include "support/scratch_folder.hpp"
#include "support/text.hpp"

namespace mortise::test {

struct Finished {
  int code = -1;
  std::string out, err;
};

/// Runs `mortise ARGUMENTS` (already quoted for the shell) in `folder`, by mpirun if on more than one rank. A program that hangs
/// is ended after five minutes: code 124.
/// @param before shell commands without ' that each rank runs first, e.g. to set limits
inline Finished run_mortise(const ScratchFolder& folder, const std::string& arguments, int ranks = 1,
                            const std::string& before = "") {
  std::string command = "cd '" + (folder / "").string() +
                        "' && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                        "OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_hwloc_base_binding_policy=none timeout 300 ";
  if (ranks > 1) command += std::string(MORTISE_MPIEXEC) + " --oversubscribe -n " + std::to_string(ranks) + " ";
  if (!before.empty()) command += "bash -c '" + before + "; exec \"$0\" \"$@\"' ";
  command += "'" + std::string(MORTISE_BINARY_DIR) + "/mortise' " + arguments + " >stdout.txt 2>stderr.txt </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "stdout.txt"), text_of(folder / "stderr.txt")};
}

/// history.csv of a run.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> cells;  ///< as written, per row

  /// @throws std::runtime_error if there is no such column
  std::vector<double> operator[](const std::string& column) const {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c] != column) continue;
      std::vector<double> values;
      for (const auto& row : cells) values.push_back(std::stod(row.at(c)));
      return values;
    }
    throw std::runtime_error("history.csv has no column " + column);
  }
  std::size_t n_rows() const { return cells.size(); }
};

inline Table read_history(const std::filesystem::path& file) {
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::ifstream in(file);
  Table table;
  std::string line;
  if (std::getline(in, line)) table.columns = split(line);
  while (std::getline(in, line)) table.cells.push_back(split(line));
  return table;
}

/// Time-weighted mean from `from` to the end.
inline double mean_from(const Table& table, const std::string& column, double from) {
  const auto time = table["time"], dt = table["dt"], values = table[column];
  double weight = 0, sum = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double share = std::min(dt[k], time[k] - from);
    if (share <= 0) continue;
    weight += share;
    sum += share * values[k];
  }
  return sum / weight;
}

}  // namespace mortise::test
