// Assembly of 100,000 elements on as many ranks as the program is started on: residual, and residual with the sparse tangent.
#include <benchmark/benchmark.h>
#include <mpi.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "setup.hpp"

namespace {

using namespace mortise;

/// The neo-Hookean block of `assembly.xml` at the start of its step, the graph made.
struct Started {
  Setup setup;
  State state;
  RCP<Matrix> K;

  Started()
      : setup(Deck::read(MORTISE_SOURCE_DIR "/tests/benchmarks/assembly.xml"), Tpetra::getDefaultComm()),
        state(setup.first_state()) {
    setup.problem.begin_step(state, 1.0);
    setup.problem.linearise(*state.x, K);
  }
};

/// Made once; `main` empties it while Kokkos lives.
std::unique_ptr<Started> started;

double all_sum(double mine) {
  double sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

/// Times `work` on all ranks together: an iteration takes as long as the slowest rank.
template <class Work>
void time_together(benchmark::State& state, const Work& work) {
  if (!started) started = std::make_unique<Started>();
  for (auto _ : state) {
    MPI_Barrier(MPI_COMM_WORLD);
    const double begin = MPI_Wtime();
    work(*started);
    double seconds = MPI_Wtime() - begin;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    state.SetIterationTime(seconds);
  }
  double elements = 0, element_bytes = 0;
  for (const auto& body : started->setup.problem.bodies()) {
    elements += static_cast<double>(body->n_elements());
    element_bytes += static_cast<double>(body->bytes());
  }
  elements = all_sum(elements);
  state.counters["elements"] = elements;
  state.counters["unknowns"] = static_cast<double>(started->state.x->getGlobalLength());
  state.counters["element_bytes"] = all_sum(element_bytes) / elements;
  state.counters["matrix_bytes"] = all_sum(static_cast<double>(started->setup.problem.matrix_bytes())) / elements;
}

void assembly_residual(benchmark::State& state) {
  time_together(state, [](Started& at) { benchmark::DoNotOptimize(at.setup.problem.evaluate(*at.state.x).admissible); });
}

void assembly_tangent(benchmark::State& state) {
  time_together(state, [](Started& at) { benchmark::DoNotOptimize(at.setup.problem.linearise(*at.state.x, at.K).admissible); });
}

// A fixed number of iterations, so that all ranks do the same.
BENCHMARK(assembly_residual)->Iterations(3)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(assembly_tangent)->Iterations(3)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Rank 0 reports for all.
class NoReport : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>&) override {}
};

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard mpi(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
  } else {
    const auto is_of_rank_0 = [](const char* word) { return std::string(word).rfind("--benchmark_out", 0) == 0; };
    argc = static_cast<int>(std::remove_if(argv + 1, argv + argc, is_of_rank_0) - argv);
    benchmark::Initialize(&argc, argv);
    NoReport silent;
    benchmark::RunSpecifiedBenchmarks(&silent);
  }
  started.reset();
}
