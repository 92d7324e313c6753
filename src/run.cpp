// `mortise run` and `mortise restart`: a march in its folder, with everything that is written on the way.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>

#include "commands.hpp"
#include "mesh/exodus.hpp"
#include "output/checkpoint_writer.hpp"
#include "output/on_root.hpp"
#include "output/run_folder.hpp"
#include "setup.hpp"
#include "sha256.hpp"
#include "stop_request.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
}

Origin origin_of(const Deck& deck) {
  Origin origin{MORTISE_VERSION, fs::absolute(deck.file()).string(), deck.text(), {}};
  for (const auto& [name, mesh] : deck.options().meshes)
    if (mesh.file) origin.meshes.emplace_back(name, sha256_of_file(deck.file().parent_path() / *mesh.file));
  return origin;
}

/// A run goes on only with what it began with.
void refuse_changes(const Origin& then, const Origin& now, const fs::path& folder) {
  const auto refuse = [&](const std::string& what) {
    throw FileError(fmt::format("{} - undo that, or begin a new run; the run in {} cannot go on with it", what, folder.string()));
  };
  std::istringstream before(then.deck_text), after(now.deck_text);
  std::string old_line, line;
  for (int k = 1; then.deck_text != now.deck_text; ++k) {
    const bool had = static_cast<bool>(std::getline(before, old_line)), has = static_cast<bool>(std::getline(after, line));
    if (had == has && old_line == line) continue;
    refuse(fmt::format("{}:{}:1: error[I10] the deck has changed since the run began: this line was `{}`", now.deck_file, k,
                       had ? old_line : "not there"));
  }
  for (std::size_t k = 0; k < then.meshes.size(); ++k)
    if (then.meshes[k] != now.meshes[k])
      refuse(fmt::format("{}: error[I10] mesh \"{}\" has changed since the run began: its sha256 was {} and is {}", now.deck_file,
                         now.meshes[k].first, then.meshes[k].second, now.meshes[k].second));
}

/// One session of a run: from where its march stands to the end, or to where it is stopped.
class Session {
 public:
  /// @param kept null: the run begins here
  Session(Setup& setup, const RCP<const Comm>& comm, const fs::path& folder, bool quiet, const Checkpoint* kept,
          Clock::time_point begin)
      : setup_(setup),
        comm_(comm),
        folder_(folder),
        is_root_(comm->getRank() == 0),
        is_quiet_(quiet),
        begin_(begin),
        newton_(setup.problem, setup.scene.solver) {
    if (kept) restarted_after_ = kept->done.steps;
    write_head();
    const bool goes_on = restarted_after_ > 0;  // before the first step there is nothing to go on from but the deck
    history_.emplace(goes_on ? History(setup.problem, folder / "history.csv", kept->done.steps, kept->ledger)
                             : History(setup.problem, folder / "history.csv"));
    results_.emplace(setup.problem, *history_, folder / "results.e", goes_on ? kept->frames : 0);
    checkpoints_.emplace(setup.problem, *history_, *results_, origin_of(setup.deck), folder);
  }

  ExitCode march_on(MarchState at) {
    RunOutcome outcome;
    try {
      const MarchSummary summary = march(setup_.problem, newton_, at, party());
      outcome.code = summary.code;
      outcome.cause = summary.cause;
    } catch (const UserError& error) {  // a full disk: what is there stays usable
      outcome.code = error.code();
      outcome.cause = error.what();
    }
    if (is_root_ && on_terminal_ && !is_quiet_) std::cout << std::endl;
    if (outcome.code != ExitCode::input_output) {
      checkpoints_->at_stop(at);
      if (outcome.code != ExitCode::done) results_->write_last(setup_.problem, *history_);
    }
    if (outcome.code == ExitCode::done) {
      outcome.expectations = check_expectations(setup_.scene, *history_);
      outcome.warnings = idle_pairs(setup_.scene, *history_, touched_);
    }
    if (is_root_)
      for (const auto& warning : outcome.warnings) warn(warning);
    for (const auto& e : outcome.expectations) {
      if (is_root_)
        (e.met ? std::cout : std::cerr) << fmt::format("expected \"{}\": {:.6g} +- {:.2g}, found {:.6g}: {}", e.name, e.expected,
                                                       e.tolerance, e.found, e.met ? "met" : "MISSED")
                                        << std::endl;
      if (!e.met) outcome.code = ExitCode::expectation_missed;
    }
    outcome.end_time = at.state.time;
    outcome.done = at.counts;
    outcome.restarted_after = restarted_after_;
    outcome.cpu_seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    outcome.wall_seconds = seconds_since(begin_);
    conclude(outcome);
    return outcome.code;
  }

 private:
  void write_head() {
    std::string text = manifest(setup_.deck, setup_.problem, newton_.linear_solver().choice());
    if (restarted_after_ >= 0) text += fmt::format("restarted after step {}\n", restarted_after_);
    const auto& meshes = setup_.deck.options().meshes;
    const bool has_recipe =
        std::any_of(meshes.begin(), meshes.end(), [](const auto& mesh) { return mesh.second.recipe.has_value(); });
    on_root(*comm_, [&] {
      write_text(folder_ / "manifest.txt", text);
      if (has_recipe && restarted_after_ <= 0) write_exodus(setup_.scene.mesh.mesh, folder_ / "mesh.e", setup_.scene.title);
      log_.open(folder_ / "run.log", restarted_after_ > 0 ? std::ios::app : std::ios::trunc);
      log_ << text << '\n';
      for (const auto& warning : setup_.warnings) warn(warning);
    });
  }

  void warn(const std::string& warning) {
    log_ << "warning: " << warning << '\n';
    std::cerr << "warning: " << warning << '\n';
  }

  void note_touching(const Evaluation& at) {
    for (std::size_t k = 0; k < touched_.size(); ++k) {
      const ContactPair& pair = setup_.scene.pairs[k];
      const auto first = at.closed.begin() + pair.first_multiplier;
      touched_[k] =
          touched_[k] || std::find(first, first + pair.secondary_nodes.size(), 1) != first + pair.secondary_nodes.size();
    }
  }

  MarchParty party() {
    MarchParty party;
    party.observers.emplace_back([this](const State& before, const State& now, const Evaluation& at, const StepRecord& record) {
      const auto start = Clock::now();
      history_->observe(setup_.problem, before, now, at, record, newton_.seconds_linear(), seconds_output_);
      results_->observe(setup_.problem, now, at, record, *history_);
      note_touching(at);
      seconds_output_ += seconds_since(start);
    });
    party.keep = [this](const MarchState& at) {
      const auto start = Clock::now();
      checkpoints_->after_step(at);
      seconds_output_ += seconds_since(start);
    };
    party.stop = [this] { return requested_stop(*comm_); };
    party.log = [this](const std::string& line) {
      if (is_root_) log_ << line << std::flush;
    };
    party.progress = [this](const std::string& line) {
      if (!is_root_ || is_quiet_) return;
      std::cout << (on_terminal_ ? "\r\x1b[K" : "") << line << (on_terminal_ ? "" : "\n") << std::flush;
    };
    return party;
  }

  void conclude(const RunOutcome& outcome) {
    try {
      on_root(*comm_, [&] { write_summary(folder_ / "summary.json", outcome, setup_.problem, newton_); });
    } catch (const FileError&) {
      if (outcome.code != ExitCode::input_output) throw;  // the same disk: told already
    }
    if (!is_root_) return;
    if (!outcome.cause.empty()) {
      std::cerr << outcome.cause << std::endl;
      const bool may_go_on = outcome.code != ExitCode::deck;  // another deck is another run
      std::cerr << fmt::format("the last good state (step {}, t = {:g}) is in {}", outcome.done.steps, outcome.end_time,
                               (folder_ / "results.e").string())
                << (may_go_on ? fmt::format("; `mortise restart {}` goes on from there", folder_.string()) : "") << std::endl;
    }
    std::cout << fmt::format("{} steps to t = {:g}, {} cuts, {} Newton iterations, {:.1f} s; results in {}", outcome.done.steps,
                             outcome.end_time, outcome.done.cuts, outcome.done.newton_iterations, outcome.wall_seconds,
                             folder_.string())
              << std::endl;
  }

  Setup& setup_;
  const RCP<const Comm> comm_;
  const fs::path folder_;
  const bool is_root_, is_quiet_;
  const Clock::time_point begin_;
  // On a terminal one line that changes, in a file a line per step.
  // (mpirun gives its ranks a terminal of their own, wherever their output goes.)
  const bool on_terminal_ = !std::getenv("OMPI_COMM_WORLD_SIZE") && !std::getenv("PMI_SIZE") && isatty(STDOUT_FILENO) != 0;
  Newton newton_;
  int restarted_after_ = -1;
  std::ofstream log_;
  std::optional<History> history_;
  std::optional<ResultsWriter> results_;
  std::optional<CheckpointWriter> checkpoints_;
  std::vector<char> touched_ = std::vector<char>(setup_.scene.pairs.size(), 0);  // of each pair, in this session
  double seconds_output_ = 0;
};

void prepare_signals() {
  catch_stop_signals();
  std::signal(SIGPIPE, SIG_IGN);  // who stops listening to the progress does not stop the run
}

}  // namespace

namespace {

/// What a run begins with must not be what it replaces.
void refuse_own_results(const Scene& scene, const fs::path& folder) {
  if (!scene.carried) return;
  for (const auto& [name, file] : scene.carried->files)
    if (std::error_code none; fs::equivalent(file, folder / "results.e", none))
      throw FileError(fmt::format("{}: error[I01] \"{}\" begins with the results in this folder - name another one with -o",
                                  folder.string(), name));
}

}  // namespace

ExitCode run_command(const RunOptions& options, const RCP<const Comm>& comm) {
  const auto begin = Clock::now();
  prepare_signals();
  Setup setup(Deck::read(options.deck), comm);
  const MarchState start = starting(setup.first_state());
  const fs::path folder = options.output.value_or(options.deck.stem());
  refuse_own_results(setup.scene, folder);
  std::optional<RunFolder> held;
  on_root(*comm, [&] { held.emplace(RunFolder::begin(folder, options.overwrite)); });
  return Session(setup, comm, folder, options.quiet, nullptr, begin).march_on(start);
}

ExitCode restart_command(const RestartOptions& options, const RCP<const Comm>& comm) {
  const auto begin = Clock::now();
  prepare_signals();
  const fs::path& folder = options.folder;
  std::optional<RunFolder> held;
  on_root(*comm, [&] { held.emplace(RunFolder::go_on(folder)); });
  std::vector<std::string> warnings;
  const Checkpoint kept = read_newest_checkpoint(folder, warnings);
  if (kept.origin.program != MORTISE_VERSION)
    warnings.push_back(
        fmt::format("the run began with mortise {}, this is {}: digits may differ", kept.origin.program, MORTISE_VERSION));
  Setup setup(Deck::read(options.deck.value_or(kept.origin.deck_file)), comm);
  refuse_changes(kept.origin, origin_of(setup.deck), folder);
  if (static_cast<int>(kept.x.size()) != setup.problem.dofs().n_unknowns() || kept.contact.size() != setup.scene.pairs.size())
    throw FileError(
        fmt::format("{}: error[I10] its checkpoint holds another number of unknowns than this deck gives", folder.string()));
  setup.warnings.insert(setup.warnings.end(), warnings.begin(), warnings.end());
  const MarchState at = resume(kept, setup.problem);
  if (comm->getRank() == 0 && at.state.time >= setup.scene.end()) std::cout << "the run had reached its end" << std::endl;
  return Session(setup, comm, folder, options.quiet, &kept, begin).march_on(at);
}

}  // namespace mortise
