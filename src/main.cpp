// The command line: starts MPI, hands over to a command, prints errors once, leaves with its exit code.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "commands.hpp"

namespace {

using namespace mortise;

// One BLAS thread per rank: MPI ranks are the parallelism, and threads on top of them only fight for cores.
void single_blas_thread() {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  if (auto* set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(1);
}

// A stream that is closed would lend its number to the next file that is opened, and messages would end up in there.
void open_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY);  // takes the lowest number
}

// Every rank has found the same errors; should one alone have failed, the others must not wait for it.
int finish(const Comm& comm, int code, const std::string& message) {
  int greatest = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, 1, &code, &greatest);
  if (comm.getRank() == 0 && !message.empty()) std::cerr << message << std::endl;
  return greatest;
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  single_blas_thread();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond the limit is a failed write, told as such
  Tpetra::ScopeGuard mpi(&argc, &argv);
  const auto comm = Tpetra::getDefaultComm();
  const bool is_root = comm->getRank() == 0;

  CLI::App app{"Mortise: deformable bodies that meet"};
  app.require_subcommand(1);
  RunOptions run;
  std::filesystem::path output, file, recipe, mesh_file;
  std::string list;
  bool as_schema = false;
  auto* run_app = app.add_subcommand("run", "march the scene of a deck");
  run_app->add_option("deck", run.deck, "the deck (XML)")->required();
  run_app->add_option("-o,--output", output, "folder for the results (default: the deck's name)");
  run_app->add_flag("--overwrite", run.overwrite, "replace results in that folder");
  run_app->add_flag("--quiet", run.quiet, "no line per step");
  RestartOptions restart;
  std::filesystem::path moved_deck;
  auto* restart_app = app.add_subcommand("restart", "go on with a run from its last checkpoint");
  restart_app->add_option("folder", restart.folder, "folder of the run")->required();
  restart_app->add_option("--deck", moved_deck, "the deck of the run, if it is not where it was");
  restart_app->add_flag("--quiet", restart.quiet, "no line per step");
  auto* check_app = app.add_subcommand("check", "check a deck with its meshes, or an Exodus file");
  check_app->add_option("file", file, "deck (.xml) or mesh")->required();
  auto* mesh_app = app.add_subcommand("mesh", "write the mesh of a recipe");
  mesh_app->add_option("recipe", recipe, "the recipe (XML)")->required();
  mesh_app->add_option("-o,--output", mesh_file, "Exodus file to write")->required();
  TangentsOptions tangents;
  std::filesystem::path tangents_deck, tangents_file;
  bool is_study = false;
  auto* tangents_app = app.add_subcommand("tangents", "compare all ways to differentiate the terms of a scene");
  auto* tangents_deck_option = tangents_app->add_option("deck", tangents_deck, "the deck (XML)");
  tangents_app->add_option("--most", tangents.most, "elements of a body, or facets of a contact pair, that are compared at most")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  tangents_app->add_flag("--study", is_study, "errors of numerical derivatives over the step size instead (thesis Fig. D.1)")
      ->excludes(tangents_deck_option);
  tangents_app->add_option("-o,--output", tangents_file, "CSV file to write");
  tangents_app->add_flag("--overwrite", tangents.overwrite, "replace that file");
  tangents_app->callback([&] {
    if (!is_study && tangents_deck.empty()) throw CLI::RequiredError("deck");
  });
  auto* describe_app = app.add_subcommand("describe", "print the deck reference");
  auto* list_option = describe_app->add_option("list", list, "one list of it, e.g. contact");
  describe_app->add_flag("--schema", as_schema, "as RELAX NG schema of whole decks, for editors")->excludes(list_option);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (!is_root) return error.get_exit_code() == 0 ? 0 : static_cast<int>(ExitCode::command_line);
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::command_line);
  }
  if (!output.empty()) run.output = output;
  if (!moved_deck.empty()) restart.deck = moved_deck;
  if (!tangents_deck.empty()) tangents.deck = tangents_deck;
  if (!tangents_file.empty()) tangents.output = tangents_file;

  try {
    ExitCode code = ExitCode::done;
    if (*run_app) code = run_command(run, comm);
    if (*restart_app) code = restart_command(restart, comm);
    if (*check_app) code = check_command(file, comm);
    if (*mesh_app) code = mesh_command(recipe, mesh_file, comm);
    if (*tangents_app) code = tangents_command(tangents, comm);
    if (*describe_app) code = describe_command(list, as_schema, comm);
    return finish(*comm, static_cast<int>(code), "");
  } catch (const UserError& error) {
    return finish(*comm, static_cast<int>(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return finish(*comm, static_cast<int>(ExitCode::resources),
                  "error[R01] out of memory: the scene is too large for this machine or rank count");
  } catch (const std::exception& error) {
    return finish(*comm, static_cast<int>(ExitCode::internal), std::string("internal error, please report it: ") + error.what());
  }
}
