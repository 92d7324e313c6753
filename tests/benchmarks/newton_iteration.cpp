// One Newton iteration of the ironing scene by stage, at refinements 1, 2, 3: CPU seconds per iteration, with counts beside them.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <ctime>
#include <filesystem>
#include <fstream>

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

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void newton_iteration(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const auto file = std::filesystem::temp_directory_path() / fmt::format("mortise_bench_{}.xml", n);
  std::ofstream(file) << deck_text(n);
  std::vector<std::string> warnings;
  const Deck deck = Deck::read(file);
  std::filesystem::remove(file);
  const Scene scene = make_scene(deck, warnings);
  const auto comm = Tpetra::getDefaultComm();
  const Partition partition = make_partition(scene.mesh.mesh, comm->getSize(), {});
  StepProblem problem(scene, partition, comm);
  Newton newton(problem, scene.solver);
  StepResult result = newton.solve(problem.initial_state(), 0.1);  // into contact; the step measured starts from there

  long iterations = 0, factorisations = 0, solves = 0;
  const WorkCounts before = problem.counts();
  const DirectSolver& direct = *newton.linear_solver().direct();
  const double factor = direct.seconds_factor(), solve = direct.seconds_solve(), analysis = direct.seconds_analysis(),
               linear = newton.seconds_linear();
  double t = 0.1, cpu = 0;
  for (auto _ : state) {
    const double start = cpu_seconds();
    t += 0.02;
    result = newton.solve(result.state, t);
    const double taken = cpu_seconds() - start;
    if (!result.converged) {
      state.SkipWithError(result.cause.c_str());
      break;
    }
    for (const auto& line : result.log) {
      factorisations += line.factorisations;
      solves += line.linear_solves;
    }
    iterations += result.iterations;
    cpu += taken;
    state.SetIterationTime(taken / result.iterations);
  }
  const WorkCounts& after = problem.counts();
  const auto per_iteration = [&](double total) { return total / static_cast<double>(iterations); };
  state.counters["dofs"] = 3.0 * problem.dofs().n_nodes();
  state.counters["s/iteration"] = per_iteration(cpu);
  state.counters["elements"] = per_iteration(after.seconds_elements - before.seconds_elements);
  state.counters["contact"] = per_iteration(after.seconds_contact - before.seconds_contact);
  state.counters["search"] = per_iteration(after.seconds_search - before.seconds_search);
  state.counters["assembly"] = per_iteration(after.seconds_assembly - before.seconds_assembly);
  state.counters["linear"] = per_iteration(newton.seconds_linear() - linear);
  state.counters["factor"] = per_iteration(direct.seconds_factor() - factor);
  state.counters["solve"] = per_iteration(direct.seconds_solve() - solve);
  state.counters["analysis"] = per_iteration(direct.seconds_analysis() - analysis);
  state.counters["iterations"] = static_cast<double>(iterations);
  state.counters["factorisations"] = static_cast<double>(factorisations);
  state.counters["solves"] = static_cast<double>(solves);
  state.counters["factor_entries"] = direct.factor_entries();
}

BENCHMARK(newton_iteration)->DenseRange(1, 3)->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard mpi(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
