// One Newton iteration of the ironing scene at refinements 1, 2, 3: whole, by stage, and each stage alone, with counts beside.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "mesh/partition.hpp"
#include "solve/newton.hpp"

namespace {

using namespace mortise;

/// The frictionless ironing of `inputs/ironing`, n times refined.
std::string deck_text(int n) {
  std::ifstream in(MORTISE_SOURCE_DIR "/inputs/ironing/frictionless.xml");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("{20, 5, 3}", fmt::format("{{{}, {}, {}}}", 20 * n, 5 * n, 3 * n));
  replace("{4, 4, 4}", fmt::format("{{{}, {}, {}}}", 4 * n, 4 * n, 4 * n));
  return text;
}

Scene refined_ironing(int n) {
  const auto file = std::filesystem::temp_directory_path() / fmt::format("mortise_bench_{}.xml", n);
  std::ofstream(file) << deck_text(n);
  const Deck deck = Deck::read(file);
  std::filesystem::remove(file);
  std::vector<std::string> warnings;
  return make_scene(deck, warnings);
}

/// The scene pressed into contact, t = 0.1: what is measured starts from there.
struct Pressed {
  Scene scene;
  Partition partition;
  StepProblem problem;
  Newton newton;
  StepResult start;

  explicit Pressed(int n)
      : scene(refined_ironing(n)),
        partition(make_partition(scene.mesh.mesh, 1, {})),
        problem(scene, partition, Tpetra::getDefaultComm()),
        newton(problem, scene.solver),
        start(newton.solve(problem.initial_state(), 0.1)) {}
};

/// By refinement. Made once: at refinement 3 it takes longer than most of what is measured. `main` empties it while Kokkos lives.
std::map<int64_t, std::unique_ptr<Pressed>> all_pressed;

Pressed& pressed(const benchmark::State& state) {
  auto& one = all_pressed[state.range(0)];
  if (!one) one = std::make_unique<Pressed>(static_cast<int>(state.range(0)));
  return *one;
}

void count_scene(benchmark::State& state, const Pressed& scene) {
  state.counters["unknowns"] = static_cast<double>(scene.start.state.x->getGlobalLength());
  double elements = 0;
  for (const auto& body : scene.problem.bodies()) elements += static_cast<double>(body->n_elements());
  state.counters["elements"] = elements;
}

double total(const Pressed& scene, long ContactCounts::*count) {
  double sum = 0;
  for (const auto& pair : scene.problem.pairs()) sum += static_cast<double>(pair->counts().*count);
  return sum;
}

/// Steps so small that the search, the graph and the analysis of the start hold: what an iteration always takes, and nothing
/// else. Counters `seconds...` are per Newton iteration, the others of all steps.
void newton_iteration(benchmark::State& state) {
  Pressed& scene = pressed(state);
  StepProblem& problem = scene.problem;
  StepResult result = scene.start;
  const WorkCounts before = problem.counts();
  const DirectSolver& direct = *scene.newton.linear_solver().direct();
  const double factor = direct.seconds_factor(), solve = direct.seconds_solve(), pairs = total(scene, &ContactCounts::pairs),
               overlaps = total(scene, &ContactCounts::overlaps);
  double t = 0.1, iterations = 0, factorisations = 0, solves = 0;
  for (auto _ : state) {
    t += 0.02;
    result = scene.newton.solve(result.state, t);
    if (!result.converged) {
      state.SkipWithError(result.cause.c_str());
      return;
    }
    for (const auto& line : result.log) {
      factorisations += line.factorisations;
      solves += line.linear_solves;
    }
    iterations += result.iterations;
  }
  const WorkCounts& after = problem.counts();
  using benchmark::Counter;
  state.counters["seconds"] = Counter(iterations, Counter::kIsRate | Counter::kInvert);
  state.counters["seconds_elements"] = (after.seconds_elements - before.seconds_elements) / iterations;
  state.counters["seconds_contact"] = (after.seconds_contact - before.seconds_contact) / iterations;
  state.counters["seconds_assembly"] = (after.seconds_assembly - before.seconds_assembly) / iterations;
  state.counters["seconds_factor"] = (direct.seconds_factor() - factor) / iterations;
  state.counters["seconds_solve"] = (direct.seconds_solve() - solve) / iterations;
  count_scene(state, scene);
  state.counters["newton_iterations"] = iterations;
  state.counters["evaluations"] = static_cast<double>(after.evaluations - before.evaluations);
  state.counters["tangents"] = static_cast<double>(after.tangents - before.tangents);
  state.counters["factorisations"] = factorisations;
  state.counters["solves"] = solves;
  state.counters["pairs"] = total(scene, &ContactCounts::pairs) - pairs;
  state.counters["overlaps"] = total(scene, &ContactCounts::overlaps) - overlaps;
  state.counters["factor_entries"] = direct.factor_entries();
}

/// The lists of facet pairs, made anew where the last search was.
void search(benchmark::State& state) {
  Pressed& scene = pressed(state);
  const Search at = scene.start.state.search;
  const auto x = scene.problem.to_overlap(*at.x);
  const double searches = total(scene, &ContactCounts::searches);
  for (auto _ : state)
    for (const auto& pair : scene.problem.pairs())
      benchmark::DoNotOptimize(pair->search(x->getDataNonConst().getRawPtr(), at.reach, at.inward));
  state.counters["searches"] =
      benchmark::Counter(total(scene, &ContactCounts::searches) - searches, benchmark::Counter::kAvgIterations);
}

/// Counts the facet pairs of one evaluation.
void count_pairs(benchmark::State& state, const Pressed& scene, double pairs, double overlaps) {
  using benchmark::Counter;
  state.counters["pairs"] = Counter(total(scene, &ContactCounts::pairs) - pairs, Counter::kAvgIterations);
  state.counters["overlaps"] = Counter(total(scene, &ContactCounts::overlaps) - overlaps, Counter::kAvgIterations);
}

/// Elements and contact by value.
void residual(benchmark::State& state) {
  Pressed& scene = pressed(state);
  const double pairs = total(scene, &ContactCounts::pairs), overlaps = total(scene, &ContactCounts::overlaps);
  for (auto _ : state) benchmark::DoNotOptimize(scene.problem.evaluate(*scene.start.state.x).admissible);
  count_scene(state, scene);
  count_pairs(state, scene, pairs, overlaps);
}

/// Elements and contact with all derivatives, assembled into the sparse tangent.
void tangent(benchmark::State& state) {
  Pressed& scene = pressed(state);
  const double pairs = total(scene, &ContactCounts::pairs), overlaps = total(scene, &ContactCounts::overlaps);
  RCP<Matrix> K;
  for (auto _ : state) benchmark::DoNotOptimize(scene.problem.linearise(*scene.start.state.x, K).admissible);
  count_scene(state, scene);
  count_pairs(state, scene, pairs, overlaps);
  state.counters["matrix_entries"] = static_cast<double>(K->getGlobalNumEntries());
}

/// A linear solver of its own for the tangent at the start.
struct System {
  RCP<Matrix> K;
  Evaluation at;
  std::vector<char> identity_rows;
  LinearSolver solver;

  explicit System(Pressed& scene)
      : at(scene.problem.linearise(*scene.start.state.x, K)),
        identity_rows(scene.problem.identity_rows()),
        solver(scene.scene, scene.problem.dofs(), scene.scene.solver) {}

  LinearReport factor(long graph_number) { return solver.factor(K, identity_rows, graph_number); }
};

void count_factors(benchmark::State& state, const System& system) {
  state.counters["matrix_entries"] = static_cast<double>(system.K->getGlobalNumEntries());
  state.counters["factor_entries"] = system.solver.direct()->factor_entries();
}

/// Factors with the analysis of before, or with an analysis each time, as after a search that changed the lists.
template <bool with_analysis>
void factor(benchmark::State& state) {
  System system(pressed(state));
  long graph_number = 1;
  LinearReport report = system.factor(graph_number);
  for (auto _ : state) report = system.factor(with_analysis ? ++graph_number : graph_number);
  if (!report.cause.empty()) state.SkipWithError(report.cause.c_str());
  count_factors(state, system);
}

/// Solves with the factors at hand, and checks the residual.
void solve(benchmark::State& state) {
  System system(pressed(state));
  system.factor(1);
  Vector x(system.at.residual->getMap());
  LinearReport report;
  for (auto _ : state) report = system.solver.solve(*system.at.internal, x);
  if (!report.solved) state.SkipWithError(report.cause.c_str());
  count_factors(state, system);
}

void at_refinements(benchmark::internal::Benchmark* each) {
  each->DenseRange(1, 3)->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(newton_iteration)->Arg(1)->Arg(2)->Iterations(5)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(newton_iteration)->Arg(3)->Iterations(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(search)->Apply(at_refinements);
BENCHMARK(residual)->Apply(at_refinements);
BENCHMARK(tangent)->Apply(at_refinements);
BENCHMARK(factor<false>)->Name("factor")->Apply(at_refinements);
BENCHMARK(factor<true>)->Name("analysis_and_factor")->Apply(at_refinements);
BENCHMARK(solve)->Apply(at_refinements);

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard mpi(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  all_pressed.clear();
}
