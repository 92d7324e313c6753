#include "output/run_folder.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "deck/fields.hpp"
#include "time/march.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> run_files{"results.e", "history.csv", "manifest.txt", "summary.json", "run.log", "mesh.e"};

std::string on_off(bool on) { return on ? "on" : "off"; }

}  // namespace

void prepare_run_folder(const fs::path& folder, bool overwrite) {
  std::error_code failure;
  const auto refuse = [&](const std::string& why) { throw FileError(fmt::format("{}: error[I05] {}", folder.string(), why)); };
  const bool exists = fs::exists(folder, failure);
  if (failure && failure != std::errc::no_such_file_or_directory) refuse("cannot be looked at: " + failure.message());
  if (exists && !fs::is_directory(folder, failure)) refuse("is a file - a folder for the results is needed");
  if (exists && !fs::is_empty(folder, failure)) {
    if (failure) refuse("cannot be looked at: " + failure.message());
    const bool has_results =
        std::any_of(run_files.begin(), run_files.end(), [&](const auto& name) { return fs::exists(folder / name, failure); });
    if (!has_results) refuse("holds other files and no results - name an empty folder with -o");
    if (!overwrite) refuse("holds results already - use --overwrite, or another folder with -o");
    for (const auto& name : run_files) {
      fs::remove(folder / name, failure);
      if (failure) refuse(fmt::format("\"{}\" in it cannot be replaced: {}", name, failure.message()));
    }
  }
  fs::create_directories(folder, failure);
  if (failure) refuse("cannot be made: " + failure.message());
}

std::string sha256(const std::string& text) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  EVP_Digest(text.data(), text.size(), digest, &length, EVP_sha256(), nullptr);
  std::string hex;
  for (unsigned int k = 0; k < length; ++k) hex += fmt::format("{:02x}", digest[k]);
  return hex;
}

std::string sha256_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw FileError(fmt::format("{}: error[I01] cannot be read", file.string()));
  return sha256(text);
}

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
  const int n_q = 3 * problem.dofs().n_nodes();
  text +=
      fmt::format("ranks {}\nunknowns {} ({} positions, {} contact pressures)\nelements {}\n", problem.dofs().comm()->getSize(),
                  n_q + scene.n_multipliers, n_q, scene.n_multipliers, n_elements(scene.mesh.mesh));
  text += fmt::format(
      "copies of other ranks' unknowns on this rank: {} bytes per exchange; the mesh and the positions of all contact nodes are "
      "on every rank\n",
      problem.dofs().ghost_bytes());
  text += fmt::format("linear solver {}\neffects\n", linear_solver);
  for (const auto& body : scene.bodies)
    text += fmt::format("  internal force of \"{}\": on, {}, {} elements, tangent by AD of {}\n", body.name,
                        std::visit([](const auto& m) { return std::string(m.name); }, body.material), body.elements.size(),
                        body.tangent == TangentKind::whole_element ? "whole elements" : "quadrature points");
  text += fmt::format(
      "  inertia: off (static)\n  prescribed motion: {}\n  traction: {}\n  contact: {}\n  friction: off\n  damping: off\n",
      on_off(!scene.prescribed.empty()), on_off(!scene.tractions.empty()), on_off(!scene.pairs.empty()));
  for (const auto& pair : scene.pairs)
    text += fmt::format(
        "  contact pair \"{}\": mortar, frictionless, {} secondary and {} primary facets, quadrature of degree {}; the law "
        "yields at partly covered nodes\n",
        pair.name, pair.secondary.facets.size(), pair.primary.facets.size(), pair.quadrature_degree);
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

void write_summary(const fs::path& file, const MarchSummary& summary, ExitCode code, const std::vector<Expectation>& expectations,
                   const StepProblem& problem, const Newton& newton, double cpu_seconds, double wall_seconds) {
  using Json = nlohmann::ordered_json;
  const WorkCounts& counts = problem.counts();
  Json json{{"exit_code", static_cast<int>(code)},
            {"end_time", summary.end_time},
            {"steps", summary.steps},
            {"cuts", summary.cuts},
            {"newton_iterations", summary.newton_iterations},
            {"newton_iterations_of_rejected_steps", summary.wasted_iterations},
            {"ranks", problem.dofs().comm()->getSize()},
            {"cause", summary.cause},
            {"seconds",
             {{"cpu_of_rank_0", cpu_seconds},
              {"wall", wall_seconds},
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
  for (const auto& e : expectations)
    json["expected"].push_back(
        {{"name", e.name}, {"expected", e.expected}, {"tolerance", e.tolerance}, {"found", e.found}, {"met", e.met}});
  std::ofstream out(file);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
}

}  // namespace mortise
