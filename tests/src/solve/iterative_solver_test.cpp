// GMRES with its block preconditioner against known solutions, on whatever number of ranks the program is run.
#include "solve/iterative_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "saddle_system.hpp"

namespace mortise {
namespace {

struct Case {
  const char* name;
  SaddleOptions options;
  int most_iterations;  ///< bound on 1, 2 and 4 ranks
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Eliminates identity rows as LinearSolver does, and solves.
LinearReport solve(SaddleSystem& s, Vector& x, const SolverOptions& options) {
  eliminate_identity_columns(*s.A, s.identity_rows, *s.b);
  IterativeSolver solver(s.map, s.n_positions, options);
  return solver.solve(*s.A, *s.b, x);
}

class KnownSolution : public testing::TestWithParam<Case> {};

TEST_P(KnownSolution, IsFoundWithinTheTolerance) {
  SaddleSystem s = saddle_system(GetParam().options);
  Vector x(s.map);
  const SolverOptions options;
  const LinearReport report = solve(s, x, options);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_LE(true_residual(*s.A, x, *s.b), options.linear_tolerance);
  EXPECT_DOUBLE_EQ(report.true_residual, true_residual(*s.A, x, *s.b));
  EXPECT_LE(relative_error(s, x), 1e-6);
  EXPECT_LE(report.iterations, GetParam().most_iterations);
  RecordProperty("iterations", report.iterations);
  if (s.map->getComm()->getRank() == 0)
    std::printf("  %s: %lld unknowns, %d closed, %d iterations, residual %.1e\n", GetParam().name,
                static_cast<long long>(s.map->getGlobalNumElements()), s.n_closed, report.iterations, report.true_residual);
}

const Case cases[] = {
    {"Plain", {}, 200},
    {"PressuresOnEveryRank", [] { SaddleOptions o; o.spread = true; return o; }(), 200},
    {"SteelInMillimetres", [] { SaddleOptions o; o.size = 10; o.youngs_modulus = 2.1e5; return o; }(), 200},
    {"SteelInMetres", [] { SaddleOptions o; o.size = 0.01; o.youngs_modulus = 2.1e11; return o; }(), 200},
    {"NoPressures", [] { SaddleOptions o; o.contact = false; return o; }(), 200},
    {"AllOpen", [] { SaddleOptions o; o.open = [](int, int) { return true; }; return o; }(), 200},
    {"AllClosed", [] { SaddleOptions o; o.open = [](int, int) { return false; }; return o; }(), 200},
    {"OneClosed", [] { SaddleOptions o; o.open = [](int i, int j) { return i != 2 || j != 2; }; return o; }(), 200},
    {"HeldByContactAlone", [] { SaddleOptions o; o.upper_held = false; return o; }(), 200},
    {"Finer", [] { SaddleOptions o; o.n = std::getenv("EXP_N") ? atoi(std::getenv("EXP_N")) : 10; o.spread = std::getenv("EXP_SPREAD"); o.upper_held = !std::getenv("EXP_HANG"); return o; }(), 400},
};

INSTANTIATE_TEST_SUITE_P(Gmres, KnownSolution, testing::ValuesIn(cases), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mortise
