#include "output/checkpoint_writer.hpp"

#include <Teuchos_CommHelpers.hpp>

#include "output/atomic_file.hpp"
#include "output/on_root.hpp"

namespace mortise {

CheckpointWriter::CheckpointWriter(const StepProblem& problem, const History& history, const ResultsWriter& results,
                                   Origin origin, std::filesystem::path folder)
    : problem_(problem), history_(history), results_(results), origin_(std::move(origin)), folder_(std::move(folder)) {}

void CheckpointWriter::after_step(const MarchState& at) {
  const CheckpointOptions& options = problem_.scene().checkpoints;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count();
  // Clocks of ranks differ: rank 0 decides.
  int is_due = kept_steps_ < 0 || (options.every > 0 && at.counts.steps % options.every == 0 && seconds >= options.seconds);
  Teuchos::broadcast(*problem_.dofs().comm(), 0, &is_due);
  if (is_due) write(at);
}

void CheckpointWriter::at_stop(const MarchState& at) {
  if (at.counts.steps != kept_steps_ || at.counts.cuts != kept_cuts_) write(at);
}

void CheckpointWriter::write(const MarchState& at) {
  const Checkpoint checkpoint = make_checkpoint(origin_, problem_, at, history_.ledger(), results_.n_frames());
  on_root(*problem_.dofs().comm(), [&] {
    for (const char* file : {"history.csv", "results.e"}) sync_file(folder_ / file);
    write_checkpoint(folder_, checkpoint);
  });
  last_ = std::chrono::steady_clock::now();
  kept_steps_ = at.counts.steps;
  kept_cuts_ = at.counts.cuts;
}

}  // namespace mortise
