// history.csv: one row per accepted step, with forces, the ledger of energies and works, momenta, probes and counts.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "output/ledger.hpp"
#include "time/march.hpp"

namespace mortise {

/// Columns and rows of a run; on rank 0 also the file. Columns: conventions, section 3; the ledger: section 7.
class History {
 public:
  /// Begins a file: writes the header on rank 0. @throws FileError
  History(const StepProblem& problem, const std::filesystem::path& file);

  /// Goes on with the file of a run after so many steps: later rows are cut off. Every rank reads it.
  /// @throws FileError if the file does not hold these steps, or other columns
  History(const StepProblem& problem, const std::filesystem::path& file, int steps, Ledger ledger);

  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<std::vector<double>>& rows() const { return rows_; }

  /// Appends the row of an accepted step. Collective; evaluates forces anew but changes nothing the march can see.
  void observe(StepProblem& problem, const State& before, const State& now, const Evaluation& at, const StepRecord& record,
               double seconds_solve, double seconds_output);

  /// Column number by name; -1 if there is none.
  int column(const std::string& name) const;

  const Ledger& ledger() const { return ledger_; }

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
  std::ofstream out_;
  std::filesystem::path file_;
  Ledger ledger_;
};

}  // namespace mortise
