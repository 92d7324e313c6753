#include "commands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <Teuchos_CommHelpers.hpp>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>

#include "assembly/rigid_modes.hpp"
#include "mesh/exodus.hpp"
#include "mesh/suspicions.hpp"
#include "output/on_root.hpp"
#include "output/results.hpp"
#include "output/run_folder.hpp"
#include "time/march.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;

std::vector<int> contact_elements(const Scene& scene) {
  std::vector<int> elements;
  for (const auto& pair : scene.pairs)
    elements.insert(elements.end(), pair.secondary_elements.begin(), pair.secondary_elements.end());
  return elements;
}

/// Scene, equations and initial state: all that `run` and `check` need.
struct Setup {
  std::vector<std::string> warnings;
  Deck deck;
  Scene scene;
  Partition partition;
  StepProblem problem;
  State initial;

  Setup(const fs::path& file, const RCP<const Comm>& comm)
      : deck(Deck::read(file)),
        scene(make_scene(deck, warnings)),
        partition(make_partition(scene.mesh.mesh, comm->getSize(), contact_elements(scene))),
        problem(scene, partition, comm),
        initial(problem.initial_state()) {
    problem.begin_step(initial, 0);
    refuse_free_bodies();
  }

  // Statics needs every rigid motion held, by supports or by contact that is closed from the start.
  void refuse_free_bodies() {
    std::vector<char> closed(scene.n_multipliers, 0);
    std::vector<Vec3<double>> normals;
    const Evaluation at = problem.evaluate(*initial.x);
    if (!scene.pairs.empty()) closed = at.closed;
    const auto x = problem.to_overlap(*initial.x);
    for (const auto& pair : problem.pairs())
      for (const auto& n : pair->normals(x->getData().getRawPtr())) normals.push_back(n);
    std::vector<std::string> messages;
    for (const auto& body : free_bodies(scene, closed, normals))
      messages.push_back(
          deck.error("D22", {"bodies", body.body},
                     fmt::format("{} free rigid {} in statics: {} - add supports, or let contact be closed at the start",
                                 body.modes.size(), body.modes.size() == 1 ? "mode" : "modes", fmt::join(body.modes, ", "))));
    if (!messages.empty()) throw DeckError(messages);
  }
};

/// The results file, opened on rank 0 and fed with gathered fields.
class ResultsWriter {
 public:
  ResultsWriter(const StepProblem& problem, const History& history, const fs::path& file) {
    for (const auto& field : problem.scene().output.fields)
      for (const auto& variable : variables_of_field(field)) nodal_.push_back(variable);
    for (std::size_t c = 0; c < history.columns().size(); ++c) {
      const std::string& name = history.columns()[c];
      if (name == "step" || name == "time" || name.rfind("seconds", 0) == 0) continue;
      global_.push_back(name);
      columns_.push_back(c);
    }
    on_root(*problem.dofs().comm(),
            [&] { file_.emplace(file, problem.scene().mesh.mesh, problem.scene().title, nodal_, global_); });
  }

  void observe(const StepProblem& problem, const State& now, const Evaluation& at, const StepRecord& record,
               const History& history) {
    if (record.step > 0 && !record.is_stop && record.step % problem.scene().output.every != 0) {
      left_out_ = {now, at};
      return;
    }
    write(problem, now, at, history);
  }

  /// A run that ends early leaves its last good state, whether it was due or not.
  void write_last(const StepProblem& problem, const History& history) {
    if (!left_out_) return;
    const auto [now, at] = *left_out_;
    write(problem, now, at, history);
  }

 private:
  void write(const StepProblem& problem, const State& now, const Evaluation& at, const History& history) {
    left_out_.reset();
    std::vector<std::vector<double>> fields;
    for (const auto& name : nodal_) fields.push_back(nodal_quantity(problem, now, at, name));
    std::vector<double> globals;
    for (std::size_t c : columns_) globals.push_back(history.rows().back()[c]);
    on_root(*problem.dofs().comm(), [&] { file_->write(now.time, fields, globals); });
  }

  std::vector<std::string> nodal_, global_;
  std::vector<std::size_t> columns_;
  std::optional<ResultsFile> file_;
  std::optional<std::pair<State, Evaluation>> left_out_;  // the last accepted step, while it is not in the file
};

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
}

}  // namespace

ExitCode run_command(const RunOptions& options, const RCP<const Comm>& comm) {
  const auto begin = std::chrono::steady_clock::now();
  const bool is_root = comm->getRank() == 0;
  Setup setup(options.deck, comm);
  StepProblem& problem = setup.problem;
  const Scene& scene = setup.scene;
  const fs::path folder = options.output.value_or(options.deck.stem());
  Newton newton(problem, scene.solver);
  const std::string text = manifest(setup.deck, problem, newton.linear_solver().choice());
  std::ofstream log;
  on_root(*comm, [&] {
    prepare_run_folder(folder, options.overwrite);
    write_text(folder / "manifest.txt", text);
    const auto& meshes = setup.deck.options().meshes;
    if (std::any_of(meshes.begin(), meshes.end(), [](const auto& mesh) { return mesh.second.recipe.has_value(); }))
      write_exodus(scene.mesh.mesh, folder / "mesh.e", scene.title);
    log.open(folder / "run.log");
    log << text << '\n';
    for (const auto& warning : setup.warnings) {
      log << "warning: " << warning << '\n';
      std::cerr << "warning: " << warning << '\n';
    }
  });

  History history(problem, folder / "history.csv");
  ResultsWriter results(problem, history, folder / "results.e");
  double seconds_output = 0;
  const std::vector<Observer> observers{
      [&](const State& before, const State& now, const Evaluation& at, const StepRecord& record) {
        const auto start = std::chrono::steady_clock::now();
        history.observe(problem, before, now, at, record, newton.seconds_linear(), seconds_output);
        results.observe(problem, now, at, record, history);
        seconds_output += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      }};
  const Reporter to_log = [&](const std::string& line) {
    if (is_root) log << line << std::flush;
  };
  // On a terminal one line that changes, in a file a line per step.
  // (mpirun gives its ranks a terminal of their own, wherever their output goes.)
  const bool by_mpirun = std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE");
  const bool on_terminal = !by_mpirun && isatty(STDOUT_FILENO) != 0;
  const Reporter progress = [&](const std::string& line) {
    if (!is_root || options.quiet) return;
    std::cout << (on_terminal ? "\r\x1b[K" : "") << line << (on_terminal ? "" : "\n") << std::flush;
  };
  const MarchSummary summary = march(problem, newton, setup.initial, scene.time, observers, to_log, progress);

  if (is_root && on_terminal && !options.quiet) std::cout << std::endl;
  if (summary.code != ExitCode::done) results.write_last(problem, history);
  ExitCode code = summary.code;
  const auto expectations = code == ExitCode::done ? check_expectations(scene, history) : std::vector<Expectation>{};
  for (const auto& e : expectations) {
    if (is_root)
      (e.met ? std::cout : std::cerr) << fmt::format("expected \"{}\": {:.6g} +- {:.2g}, found {:.6g}: {}", e.name, e.expected,
                                                     e.tolerance, e.found, e.met ? "met" : "MISSED")
                                      << std::endl;
    if (!e.met) code = ExitCode::expectation_missed;
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  on_root(*comm, [&] { write_summary(folder / "summary.json", summary, code, expectations, problem, newton, cpu, wall); });
  if (is_root) {
    if (!summary.cause.empty())
      std::cerr << fmt::format("{}; the last good state is in {}", summary.cause, (folder / "results.e").string()) << std::endl;
    std::cout << fmt::format("{} steps to t = {:g}, {} cuts, {} Newton iterations, {:.1f} s; results in {}", summary.steps,
                             summary.end_time, summary.cuts, summary.newton_iterations, wall, folder.string())
              << std::endl;
  }
  return code;
}

ExitCode check_command(const fs::path& file, const RCP<const Comm>& comm) {
  const bool is_root = comm->getRank() == 0;
  if (file.extension() != ".xml") {
    const Mesh mesh = read_exodus(file);
    if (!is_root) return ExitCode::done;
    std::cout << fmt::format("{}: {} nodes, {} elements\n", file.string(), n_nodes(mesh), n_elements(mesh));
    for (const auto& block : mesh.blocks)
      std::cout << fmt::format("  block {} \"{}\": {} hex8\n", block.id, block.name, block.elements.size());
    for (const auto& set : mesh.side_sets)
      std::cout << fmt::format("  side set {} \"{}\": {} sides\n", set.id, set.name, set.sides.size());
    for (const auto& set : mesh.node_sets)
      std::cout << fmt::format("  node set {} \"{}\": {} nodes\n", set.id, set.name, set.nodes.size());
    for (const auto& warning : mesh_warnings(mesh)) std::cout << "warning: " << warning << '\n';
    std::cout << "the mesh is usable\n";
    return ExitCode::done;
  }
  Setup setup(file, comm);
  const LinearSolver linear(setup.scene, setup.problem.dofs(), setup.scene.solver);
  if (is_root) {
    std::cout << manifest(setup.deck, setup.problem, linear.choice());
    for (const auto& warning : setup.warnings) std::cout << "warning: " << warning << '\n';
    std::cout << "the deck is ready to run\n";
  }
  return ExitCode::done;
}

ExitCode mesh_command(const fs::path& recipe, const fs::path& output, const RCP<const Comm>& comm) {
  if (comm->getRank() != 0) return ExitCode::done;
  const Mesh mesh = make_mesh(read_recipe(recipe), recipe.parent_path());
  write_exodus(mesh, output, recipe.stem().string());
  std::cout << fmt::format("{}: {} nodes, {} elements\n", output.string(), n_nodes(mesh), n_elements(mesh));
  return ExitCode::done;
}

ExitCode describe_command(const std::string& list, const RCP<const Comm>& comm) {
  if (comm->getRank() == 0) print_reference(std::cout, list);
  return ExitCode::done;
}

}  // namespace mortise
