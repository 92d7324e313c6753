// Speed of the kernels: moduli of every material, one hex8 element by every route and over a time step, one facet pair by value
// and with its complete derivative.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "assembly/stress_and_moduli.hpp"
#include "deck/names.hpp"
#include "physics/formulations/energy_momentum.hpp"
#include "support/elements.hpp"
#include "support/materials.hpp"
#include "support/random_pairs.hpp"

namespace mortise::test {
namespace {

using Brick = OneElement<Standard<Hex8>>;

/// A distorted brick in a deformed state.
struct Sample {
  Material material;
  Brick element;
  std::vector<double> x, r = std::vector<double>(24), K = std::vector<double>(576);

  explicit Sample(const Material& of)
      : material(of), element(make(MaterialLaw::whole(material, ModuliKind::automatic))), x(state(element)) {}

 private:
  static Brick make(const MaterialLaw& law) {
    Random random(1);
    return {law, distorted<Hex8>(random, 0.1)};
  }
  static std::vector<double> state(const Brick& element) {
    Random random(2);
    return element.deformed(random, 0);
  }
};

void element_residual(benchmark::State& state, const Material& material) {
  Sample one(material);
  for (auto _ : state) {
    benchmark::DoNotOptimize(one.element.block.add_force(one.x.data(), one.r.data()));
    benchmark::ClobberMemory();
  }
}

void element_tangent(benchmark::State& state, const Material& material, TangentKind kind) {
  Sample one(material);
  const auto law = MaterialLaw::whole(one.material, kind == TangentKind::analytic ? ModuliKind::analytic : ModuliKind::automatic);
  for (auto _ : state) {
    benchmark::DoNotOptimize(one.element.block.tangent(kind, best_step(kind), law, 0, one.x.data(), one.r.data(), one.K.data()));
    benchmark::ClobberMemory();
  }
}

/// The forces of energy-momentum schemes and their tangent over a step of about 1e-3 strain.
void energy_momentum_tangent(benchmark::State& state, const Material& material, TangentKind kind) {
  using Formulation = EnergyMomentum<Hex8>;
  Sample one(material);
  const auto law = MaterialLaw::whole(one.material, kind == TangentKind::analytic ? ModuliKind::analytic : ModuliKind::automatic);
  const Formulation::Since<MaterialLaw> since{law, one.x.data()};
  const auto geometry = Formulation::geometry(one.element.X);
  Random random(3);
  auto x = one.x;
  for (double& coordinate : x) coordinate += random.in(-1e-3, 1e-3);
  const std::vector<double> scale(x.size(), 1.0);
  for (auto _ : state) {
    std::fill(one.r.begin(), one.r.end(), 0.0);
    std::fill(one.K.begin(), one.K.end(), 0.0);
    benchmark::DoNotOptimize(mortise::element_tangent<Formulation>(kind, best_step(kind), since, geometry, x.data(), scale.data(),
                                                                   one.r.data(), one.K.data()));
    benchmark::ClobberMemory();
  }
}

/// One hex8 by every route, for a cheap, a usual and a dear material.
bool register_elements() {
  const std::pair<const char*, Material> materials[]{
      {"neo-hookean", sample<NeoHookean>()}, {"mooney-rivlin", sample<MooneyRivlin>()}, {"ogden", sample<Ogden>()}};
  for (const auto& [name, material] : materials) {
    benchmark::RegisterBenchmark((std::string("element_residual/") + name).c_str(), element_residual, material)
        ->Unit(benchmark::kMicrosecond);
    for (const auto& [kind_name, kind] : tangent_names)
      benchmark::RegisterBenchmark((std::string("element_tangent/") + name + "/" + kind_name).c_str(), element_tangent, material,
                                   kind)
          ->Unit(benchmark::kMicrosecond);
    for (const auto& [kind_name, kind] : tangent_names)
      benchmark::RegisterBenchmark((std::string("energy_momentum_tangent/") + name + "/" + kind_name).c_str(),
                                   energy_momentum_tangent, material, kind)
          ->Unit(benchmark::kMicrosecond);
  }
  return true;
}
[[maybe_unused]] const bool elements_are_registered = register_elements();

/// Seconds that `evaluate(F)` takes for all deformations together.
template <class Evaluate>
double seconds_of(const std::vector<Tensor3<double>>& deformations, const Evaluate& evaluate) {
  const auto start = std::chrono::steady_clock::now();
  for (const auto& F : deformations) evaluate(F);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Stress and moduli at one point: the time is that by hand; `seconds_by_ad` and `ratio_by_ad` compare automatic differentiation.
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
  state.counters["seconds_by_ad"] = by_ad / n / static_cast<double>(state.iterations());
  state.counters["ratio_by_ad"] = by_ad / by_hand;
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
template <class Evaluate>
void over_pairs(benchmark::State& state, const Evaluate& evaluate) {
  const auto& rule = triangle_rule(static_cast<int>(state.range(0)));
  const auto& all = pairs();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(evaluate(all[next], rule));
    benchmark::ClobberMemory();
    next = (next + 1) % all.size();
  }
}

PairFriction sliding(const PairInput& input) {
  PairFriction friction{input.x, 0.5, {}, 1, {}, true};
  for (auto& x : friction.before) x = x + Vec3<double>{0.01, 0.02, 0.005};
  for (auto& t : friction.traction) t = {0.3, -0.2, 0.1};
  return friction;
}

void values_of_pair(benchmark::State& state) {
  PairOutput out;
  over_pairs(state, [&](const PairInput& input, const auto& rule) { return pair_values(input, rule, out); });
}
void tangent_of_pair(benchmark::State& state) {
  PairTangent out;
  over_pairs(state, [&](const PairInput& input, const auto& rule) { return pair_tangent(input, rule, out); });
}
void values_of_frictional_pair(benchmark::State& state) {
  FrictionalOutput out;
  over_pairs(state, [&](const PairInput& input, const auto& rule) { return pair_values(input, sliding(input), rule, out); });
}
void tangent_of_frictional_pair(benchmark::State& state) {
  FrictionalTangent out;
  over_pairs(state, [&](const PairInput& input, const auto& rule) { return pair_tangent(input, sliding(input), rule, out); });
}

BENCHMARK(values_of_pair)->Name("pair_values")->Arg(5)->MinTime(0.3)->Unit(benchmark::kMicrosecond);
BENCHMARK(tangent_of_pair)->Name("pair_tangent")->Arg(4)->Arg(5)->Arg(6)->Arg(8)->MinTime(0.3)->Unit(benchmark::kMicrosecond);
BENCHMARK(values_of_frictional_pair)->Name("frictional_pair_values")->Arg(5)->MinTime(0.3)->Unit(benchmark::kMicrosecond);
BENCHMARK(tangent_of_frictional_pair)->Name("frictional_pair_tangent")->Arg(5)->MinTime(0.3)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mortise::test

BENCHMARK_MAIN();
