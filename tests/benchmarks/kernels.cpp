// Speed of the kernels: moduli of every material, one hex8 element by every route, one facet pair by value and with its complete
// derivative.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "benchmarks/analytic_tangent.hpp"
#include "support/materials.hpp"
#include "support/random_pairs.hpp"

namespace mortise::test {
namespace {

template <class M>
struct Element {
  M material = sample<M>();
  Hex8Geometry geometry;
  double q[8][3], f[8][3] = {}, K[576] = {};

  Element() {
    Random random(1);
    std::array<std::array<double, 3>, 8> X;
    for (int k = 0; k < 24; ++k) {
      X[k / 3][k % 3] = 0.5 * Hex8::corner[k / 3][k % 3] + random.in(-0.05, 0.05);
      q[k / 3][k % 3] = 1.1 * X[k / 3][k % 3] + random.in(-0.05, 0.05);
    }
    geometry = hex8_geometry(X);
  }
};

void element_residual(benchmark::State& state) {
  Element<NeoHookean> e;
  for (auto _ : state) {
    benchmark::DoNotOptimize(add_internal_force(e.material, e.geometry, e.q, e.f));
    benchmark::ClobberMemory();
  }
}

template <auto tangent, class M = NeoHookean>
void element_tangent(benchmark::State& state) {
  Element<M> e;
  for (auto _ : state) {
    std::fill_n(e.K, 576, 0.0);
    benchmark::DoNotOptimize(tangent(e.material, e.geometry, e.q, e.f, e.K));
    benchmark::ClobberMemory();
  }
}

BENCHMARK(element_residual)->Unit(benchmark::kMicrosecond);
BENCHMARK(element_tangent<analytic_tangent<NeoHookean>>)->Name("element_tangent/by_hand")->Unit(benchmark::kMicrosecond);
BENCHMARK(element_tangent<quadrature_point_tangent<NeoHookean>>)
    ->Name("element_tangent/quadrature_points")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(element_tangent<whole_element_tangent<NeoHookean>>)
    ->Name("element_tangent/whole_element")
    ->Unit(benchmark::kMicrosecond);

BENCHMARK(element_tangent<analytic_tangent<Ogden>, Ogden>)->Name("element_tangent/by_hand/ogden")->Unit(benchmark::kMicrosecond);
BENCHMARK(element_tangent<quadrature_point_tangent<Ogden>, Ogden>)
    ->Name("element_tangent/quadrature_points/ogden")
    ->Unit(benchmark::kMicrosecond);

/// Seconds that `evaluate(F)` takes for all deformations together.
template <class Evaluate>
double seconds_of(const std::vector<Tensor3<double>>& deformations, const Evaluate& evaluate) {
  const auto start = std::chrono::steady_clock::now();
  for (const auto& F : deformations) evaluate(F);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Stress and moduli at one point: the time is that by hand; `by_ad` [s] and `ratio` compare automatic differentiation.
template <class M>
void moduli_at_a_point(benchmark::State& state) {
  const M material = sample<M>();
  const auto deformations = some_deformations();
  const auto n = static_cast<double>(deformations.size());
  Tensor3<double> P;
  double A[9][9], by_hand = 0, by_ad = 0;
  for (auto _ : state) {
    const double seconds = seconds_of(deformations, [&](const Tensor3<double>& F) {
      material.moduli(F, P, A);
      benchmark::ClobberMemory();
    });
    by_hand += seconds;
    by_ad += seconds_of(deformations, [&](const Tensor3<double>& F) {
      stress_and_moduli(material, F, P, A);
      benchmark::ClobberMemory();
    });
    state.SetIterationTime(seconds / n);
  }
  benchmark::DoNotOptimize(A);
  state.counters["by_ad"] = by_ad / n / static_cast<double>(state.iterations());
  state.counters["ratio"] = by_ad / by_hand;
}

template <class... M>
bool register_materials(const std::variant<M...>*) {
  (benchmark::RegisterBenchmark((std::string("moduli/") + M::name).c_str(), moduli_at_a_point<M>)
       ->UseManualTime()
       ->Iterations(20000)
       ->Unit(benchmark::kNanosecond),
   ...);
  return true;
}
[[maybe_unused]] const bool are_registered = register_materials(static_cast<const Material*>(nullptr));

const std::vector<PairInput>& pairs() {
  static const auto all = [] {
    Random random(1);
    std::vector<PairInput> some;
    while (some.size() < 2000) some.push_back(overlapping_pair(random, 0.0));
    return some;
  }();
  return all;
}

/// Time per pair over 2000 overlapping pairs. Argument: degree of the quadrature.
template <class Output, auto evaluate>
void pair(benchmark::State& state) {
  const auto& rule = triangle_rule(static_cast<int>(state.range(0)));
  const auto& all = pairs();
  Output out;
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(evaluate(all[next], rule, out));
    benchmark::ClobberMemory();
    next = (next + 1) % all.size();
  }
}

BENCHMARK(pair<PairOutput, pair_values>)->Name("pair_values")->Arg(5)->MinTime(0.3)->Unit(benchmark::kMicrosecond);
BENCHMARK(pair<PairTangent, pair_tangent>)
    ->Name("pair_tangent")
    ->Arg(4)
    ->Arg(5)
    ->Arg(6)
    ->Arg(8)
    ->MinTime(0.3)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mortise::test

BENCHMARK_MAIN();
