#include "output/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "deck/names.hpp"
#include "output/checkpoint.hpp"
#include "sha256.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> run_files{"results.e", "history.csv", "manifest.txt", "summary.json", "run.log", "mesh.e"};

// Locks a folder; file systems that know no locks go without.
int lock(const fs::path& folder) {
  const int id = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0) throw FileError(fmt::format("{}: error[I05] cannot be opened: {}", folder.string(), std::strerror(errno)));
  if (flock(id, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(id);
    throw FileError(
        fmt::format("{}: error[I05] another run is writing into this folder - wait for it, or stop it", folder.string()));
  }
  return id;
}

std::string on_off(bool on) { return on ? "on" : "off"; }

/// When something acts, in words; nothing if always.
std::string in_words(const Activity& activity) {
  std::string text = (activity.start ? fmt::format(", after t = {}", *activity.start) : "") +
                     (activity.end ? fmt::format(", up to t = {}", *activity.end) : "");
  for (const auto& [begin, end] : activity.pauses) text += fmt::format(", not from t = {} to {}", begin, end);
  return text;
}

/// Supports, springs, loads and damping: each kind on or off, then each entry with its times.
std::string forces_and_motions(const Scene& scene) {
  const bool is_damped =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.rayleigh.exists(); });
  std::string text = fmt::format("  prescribed motion: {}\n  springs: {}\n", on_off(!scene.prescribed.empty()),
                                 on_off(!scene.springs.empty() || !scene.node_springs.empty()));
  for (const auto& kind : names_of_kinds<LoadKind>())
    text += fmt::format(
        "  {}: {}\n", kind,
        on_off(std::any_of(scene.loads.begin(), scene.loads.end(), [&](const Load& load) { return load.kind == kind; })));
  text += fmt::format("  damping: {}\n", on_off(is_damped));
  for (const auto& support : scene.supports)
    text += fmt::format("  support \"{}\": {}{}\n", support.name, support.kind, in_words(support.activity));
  for (const auto& spring : scene.springs)
    text += fmt::format("  springs \"{}\": {}{}\n", spring.name, spring.sides.empty() ? "nodes" : "bedding",
                        in_words(spring.activity));
  for (const auto& spring : scene.node_springs)
    text += fmt::format("  spring \"{}\": between, {}{}{}\n", spring.name, word_for(stretch_law_names, spring.law),
                        spring.augmented ? ", augmented" : "", in_words(spring.activity));
  for (const auto& string : scene.strings)
    text += fmt::format("  string \"{}\": {}, {} bars\n", string.name, word_for(stretch_law_names, string.law),
                        string.elements.size());
  for (const auto& masses : scene.masses)
    text += fmt::format("  masses \"{}\": {} on each of {} nodes\n", masses.name, masses.mass, masses.nodes.size());
  for (const auto& load : scene.loads)
    text += fmt::format("  load \"{}\": {}{}\n", load.name, load.kind, in_words(load.activity));
  for (const auto& body : scene.bodies)
    if (body.rayleigh.exists())
      text += fmt::format("  damping of \"{}\": Rayleigh, mass {}, stiffness {}\n", body.name, body.rayleigh.mass,
                          body.rayleigh.stiffness);
  return text;
}

std::string in_words(const std::optional<Friction>& friction) { return friction ? in_words(*friction) : "frictionless"; }

}  // namespace

RunFolder RunFolder::begin(const fs::path& folder, bool overwrite) {
  std::error_code failure;
  const auto refuse = [&](const std::string& why) { throw FileError(fmt::format("{}: error[I05] {}", folder.string(), why)); };
  const bool exists = fs::exists(folder, failure);
  if (failure && failure != std::errc::no_such_file_or_directory) refuse("cannot be looked at: " + failure.message());
  if (exists && !fs::is_directory(folder, failure)) refuse("is a file - a folder for the results is needed");
  fs::create_directories(folder, failure);
  if (failure) refuse("cannot be made: " + failure.message());
  RunFolder locked(lock(folder));
  if (fs::is_empty(folder, failure)) return locked;
  if (failure) refuse("cannot be looked at: " + failure.message());
  std::vector<fs::path> old = checkpoint_files(folder);
  for (const auto& name : run_files)
    if (fs::exists(fs::symlink_status(folder / name, failure))) old.push_back(folder / name);
  if (old.empty()) refuse("holds other files and no results - name an empty folder with -o");
  if (!overwrite) refuse("holds results already - use --overwrite, or another folder with -o");
  for (const auto& file : old) {
    fs::remove(file, failure);
    if (failure) refuse(fmt::format("\"{}\" in it cannot be replaced: {}", file.filename().string(), failure.message()));
  }
  return locked;
}

RunFolder RunFolder::go_on(const fs::path& folder) { return RunFolder(lock(folder)); }

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
}

RunFolder::RunFolder(RunFolder&& other) noexcept : lock_(std::exchange(other.lock_, -1)) {}

std::string manifest(const Deck& deck, const StepProblem& problem, const std::string& linear_solver) {
  const Scene& scene = problem.scene();
  std::string text =
      fmt::format("mortise {}\ndeck {}\n  sha256 {}\n", MORTISE_VERSION, deck.file().string(), sha256(deck.text()));
  for (const auto& [name, mesh] : deck.options().meshes) {
    if (mesh.file) {
      const fs::path file = deck.file().parent_path() / *mesh.file;
      text += fmt::format("mesh \"{}\" {}\n  sha256 {}\n", name, file.string(), sha256_of_file(file));
    } else {
      text += fmt::format("mesh \"{}\" recipe {}\n", name, name_of_kind(*mesh.recipe));
    }
  }
  if (scene.carried)
    for (const auto& [name, file] : scene.carried->files)
      text += fmt::format("state of \"{}\" {}\n  sha256 {}\n", name, file.string(), sha256_of_file(file));
  const int n_q = 3 * problem.dofs().n_nodes();
  std::size_t n_pressures = 0, n_tractions = 0;
  for (const ContactNodes* contact : scene.contacts_with_pressures()) {
    n_pressures += contact->secondary_nodes.size();
    n_tractions += (contact->n_unknowns - 1) * contact->secondary_nodes.size();
  }
  for (const Tie& tie : scene.ties) n_tractions += 3 * tie.secondary_nodes.size();
  text += fmt::format(
      "ranks {}\nunknowns {} ({} positions, {} contact pressures, {} of tractions, {} pressures of elements, {} of springs)\n"
      "elements {}\n",
      problem.dofs().comm()->getSize(), problem.dofs().n_unknowns(), n_q, n_pressures, n_tractions, scene.n_element_pressures(),
      2 * scene.n_augmented_springs, n_elements(scene.mesh.mesh));
  text += fmt::format(
      "copies of other ranks' unknowns on this rank: {} bytes per exchange; the mesh and the positions of all contact nodes are "
      "on every rank\n",
      problem.dofs().ghost_bytes());
  text += fmt::format("linear solver {}\neffects\n", linear_solver);
  for (const auto& body : scene.bodies)
    text += fmt::format("  internal force of \"{}\": on, {}, {} elements, formulation {}, tangent {}\n", body.name,
                        std::visit([](const auto& m) { return std::string(m.name); }, body.material), body.elements.size(),
                        word_for(formulation_names, body.formulation), word_for(tangent_names, body.tangent));
  const auto is_rod = [](const Obstacle& o) { return o.is_two_sided; };
  const auto n_rods = std::count_if(scene.obstacles.begin(), scene.obstacles.end(), is_rod);
  for (const Stage& stage : scene.stages)
    text += fmt::format(
        "  {}time scheme: {}\n  inertia: {}\n",
        stage.name.empty() ? "" : fmt::format("stage \"{}\", t = {} to {}\n  ", stage.name, stage.begin, stage.time.end),
        name_of_kind(stage.time.scheme), on_off(stage.scheme.has_inertia()));
  std::vector<std::pair<std::string, std::string>> massive;  // in the order of the terms of inertia
  for (const Body& body : scene.bodies) massive.emplace_back(body.name, word_for(mass_names, body.mass_kind));
  for (const String& string : scene.strings) massive.emplace_back(string.name, "consistent");
  for (const PointMasses& masses : scene.masses) massive.emplace_back(masses.name, "lumped");
  for (std::size_t k = 0; k < problem.inertias().size(); ++k)
    text += fmt::format("  mass of \"{}\": {:.10g}, matrix {}\n", massive[k].first,
                        problem.mass_and_centre(problem.inertias()[k], *problem.reference_state()).first, massive[k].second);
  text += fmt::format("  contact: {}\n  ties: {}\n  obstacles: {}\n  rods: {}\n  friction: {}\n", on_off(!scene.pairs.empty()),
                      on_off(!scene.ties.empty()), on_off(n_rods < static_cast<long>(scene.obstacles.size())), on_off(n_rods > 0),
                      on_off(scene.has_friction()));
  text += forces_and_motions(scene);
  for (const auto& pair : scene.pairs)
    text += fmt::format(
        "  contact pair \"{}\": mortar, {}, {} secondary and {} primary facets, quadrature of degree {}; the law "
        "yields at partly covered nodes\n",
        pair.name, in_words(pair.friction), pair.secondary.facets.size(), pair.primary.facets.size(), pair.quadrature_degree);
  for (const auto& tie : scene.ties)
    text += fmt::format("  tie \"{}\": {}, {} of {} secondary nodes, {} facet pairs integrated at the start, once for all\n",
                        tie.name, tie.form == TieForm::plain ? "plain" : "frame invariant",
                        std::count(tie.is_tied.begin(), tie.is_tied.end(), 1), tie.is_tied.size(), tie.n_pairs);
  return text;
}

std::vector<Expectation> check_expectations(const Scene& scene, const History& history) {
  std::vector<Expectation> results;
  const int time = history.column("time"), dt = history.column("dt");
  for (const auto& [name, e] : scene.expected) {
    const int column = history.column(e.quantity);
    Expectation result{name, e.value, e.tolerance, std::nan(""), false};
    double weight = 0, sum = 0;
    for (const auto& row : history.rows()) {
      if (e.at_time && std::abs(row[time] - *e.at_time) <= 1e-12 * std::max(1.0, std::abs(*e.at_time)))
        result.found = row[column];
      if (!e.mean_from) continue;
      const double share = std::min(row[dt], row[time] - *e.mean_from);  // of the step that lies behind `mean from`
      if (share <= 0) continue;
      weight += share;
      sum += share * row[column];
    }
    if (e.mean_from && weight > 0) result.found = sum / weight;
    const bool by_magnitude = e.quantity.rfind("contact_force", 0) == 0 || e.quantity.rfind("reaction", 0) == 0;
    const double found = by_magnitude ? std::abs(result.found) : result.found,
                 expected = by_magnitude ? std::abs(e.value) : e.value;
    result.met = std::abs(found - expected) <= e.tolerance;
    results.push_back(result);
  }
  return results;
}

std::vector<std::string> idle_pairs(const Scene& scene, const History& history, const std::vector<char>& touched) {
  std::vector<std::string> warnings;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const std::string& name = scene.pairs[k].name;
    const auto bears = [&, first = history.column("contact_force_x." + name)](const std::vector<double>& row) {
      return std::hypot(row[first], row[first + 1], row[first + 2]) > scene.force_floor;
    };
    if (touched[k] || std::any_of(history.rows().begin(), history.rows().end(), bears)) continue;
    warnings.push_back(fmt::format(
        "contact > {}: the two sides never touched - are the side sets, their places and the motion what they should be?", name));
  }
  return warnings;
}

void write_summary(const fs::path& file, const RunOutcome& outcome, const StepProblem& problem, const Newton& newton) {
  using Json = nlohmann::ordered_json;
  const WorkCounts& counts = problem.counts();
  Json json{{"exit_code", static_cast<int>(outcome.code)},
            {"end_time", outcome.end_time},
            {"steps", outcome.done.steps},
            {"cuts", outcome.done.cuts},
            {"newton_iterations", outcome.done.newton_iterations},
            {"newton_iterations_of_rejected_steps", outcome.done.wasted_iterations},
            {"ranks", problem.dofs().comm()->getSize()},
            {"cause", outcome.cause},
            {"warnings", outcome.warnings},
            {"seconds",
             {{"cpu_of_rank_0", outcome.cpu_seconds},
              {"wall", outcome.wall_seconds},
              {"search", counts.seconds_search},
              {"contact", counts.seconds_contact},
              {"elements", counts.seconds_elements},
              {"assembly", counts.seconds_assembly},
              {"linear_solve", newton.seconds_linear()}}},
            {"counts",
             {{"residuals", counts.evaluations},
              {"tangents", counts.tangents},
              {"element_tangents", counts.element_tangents},
              {"graphs", counts.graphs}}}};
  if (outcome.restarted_after >= 0) json["restarted_after_step"] = outcome.restarted_after;
  if (const auto* direct = newton.linear_solver().direct())
    json["direct_solver"] = {
        {"analyses", direct->analyses()},
        {"factor_entries", direct->factor_entries()},
        {"seconds",
         {{"analysis", direct->seconds_analysis()}, {"factor", direct->seconds_factor()}, {"solve", direct->seconds_solve()}}}};
  for (const auto& pair : problem.pairs()) {
    const ContactCounts& c = pair->counts();
    json["contact"][pair->pair().name] = {
        {"searches", c.searches}, {"pairs", c.pairs}, {"overlaps", c.overlaps}, {"turned_away", c.turned_away}};
  }
  json["expected"] = Json::array();
  for (const auto& e : outcome.expectations)
    json["expected"].push_back(
        {{"name", e.name}, {"expected", e.expected}, {"tolerance", e.tolerance}, {"found", e.found}, {"met", e.met}});
  std::ofstream out(file);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
}

}  // namespace mortise
