// GMRES with its block preconditioner against known solutions, on whatever number of ranks the program is run.
#include "solve/iterative_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "saddle_system.hpp"
#include "solve/schur_complement.hpp"

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

SaddleOptions with(const std::function<void(SaddleOptions&)>& change) {
  SaddleOptions o;
  change(o);
  return o;
}

const Case cases[] = {
    {"Plain", {}, 45},
    {"PressuresOnEveryRank", with([](auto& o) { o.spread = true; }), 55},
    {"SteelInMillimetres", with([](auto& o) { o.size = 10, o.youngs_modulus = 2.1e5; }), 45},
    {"SteelInMetres", with([](auto& o) { o.size = 0.01, o.youngs_modulus = 2.1e11; }), 45},
    {"NoPressures", with([](auto& o) { o.contact = false; }), 35},
    {"AllOpen", with([](auto& o) { o.open = [](int, int) { return true; }; }), 35},
    {"AllClosed", with([](auto& o) { o.open = [](int, int) { return false; }; }), 60},
    {"OneClosed", with([](auto& o) { o.open = [](int i, int j) { return i != 2 || j != 2; }; }), 40},
    {"HeldByContactAlone", with([](auto& o) { o.upper_held = false; }), 55},
    {"Finer", with([](auto& o) { o.n = 10, o.spread = true; }), 120},
};

INSTANTIATE_TEST_SUITE_P(Gmres, KnownSolution, testing::ValuesIn(cases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(IterativeSolver, ZeroRightHandSideGivesZeroWithoutIterations) {
  SaddleSystem s = saddle_system({});
  s.b->putScalar(0.0);
  Vector x(s.map);
  x.putScalar(1.0);
  const LinearReport report = solve(s, x, {});
  EXPECT_TRUE(report.solved) << report.cause;
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(x.normInf(), 0.0);
}

TEST(IterativeSolver, IdentityColumnsNeedNotBeEliminated) {
  const SaddleSystem s = saddle_system({});
  Vector x(s.map);
  const LinearReport report = IterativeSolver(s.map, s.n_positions, {}).solve(*s.A, *s.b, x);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_LE(relative_error(s, x), 1e-6);
}

// A preconditioner of old values would still converge, but in more iterations than a new one.
TEST(IterativeSolver, NewValuesAndNewGraphsAreTaken) {
  SaddleSystem s = saddle_system({});
  eliminate_identity_columns(*s.A, s.identity_rows, *s.b);
  IterativeSolver solver(s.map, s.n_positions, {});
  Vector x(s.map);
  const int first = solver.solve(*s.A, *s.b, x).iterations;

  SaddleSystem changed =
      saddle_system(with([](auto& o) { o.youngs_modulus = 50, o.open = [](int i, int j) { return (i + j) % 2 == 0; }; }));
  eliminate_identity_columns(*changed.A, changed.identity_rows, *changed.b);
  const int anew = IterativeSolver(s.map, s.n_positions, {}).solve(*changed.A, *changed.b, x).iterations;
  s.A->resumeFill();
  const auto from = changed.A->getLocalMatrixHost(), to = s.A->getLocalMatrixHost();
  ASSERT_EQ(from.values.extent(0), to.values.extent(0));
  for (std::size_t e = 0; e < from.values.extent(0); ++e) to.values(e) = from.values(e);
  s.A->fillComplete(s.map, s.map);
  const LinearReport same_graph = solver.solve(*s.A, *changed.b, x);
  ASSERT_TRUE(same_graph.solved) << same_graph.cause;
  EXPECT_EQ(same_graph.iterations, anew);
  EXPECT_LE(relative_error(changed, x), 1e-6);

  SaddleSystem other = saddle_system({});  // equal entries, a graph of its own
  eliminate_identity_columns(*other.A, other.identity_rows, *other.b);
  const LinearReport new_graph = solver.solve(*other.A, *other.b, x);
  ASSERT_TRUE(new_graph.solved) << new_graph.cause;
  EXPECT_EQ(new_graph.iterations, first);
  EXPECT_LE(relative_error(other, x), 1e-6);
}

TEST(IterativeSolver, TooFewIterationsAreReportedWithTheResidual) {
  SaddleSystem s = saddle_system({});
  Vector x(s.map);
  SolverOptions options;
  options.linear_iterations = 5;
  const LinearReport report = solve(s, x, options);
  EXPECT_FALSE(report.solved);
  EXPECT_EQ(report.iterations, 5);
  EXPECT_GT(report.true_residual, options.linear_tolerance);
  EXPECT_NE(report.cause.find("GMRES stopped after 5 iterations at |r|/|b| = "), std::string::npos) << report.cause;
}

TEST(IterativeSolver, ValuesThatAreNotFiniteAreReported) {
  SaddleSystem s = saddle_system({});
  Vector x(s.map);
  const auto local = s.A->getLocalMatrixHost();
  if (s.map->getComm()->getRank() == 0) local.values(3) = std::numeric_limits<double>::quiet_NaN();
  const LinearReport report = IterativeSolver(s.map, s.n_positions, {}).solve(*s.A, *s.b, x);
  EXPECT_FALSE(report.solved);
  EXPECT_NE(report.cause.find("not finite"), std::string::npos) << report.cause;
}

TEST(IterativeSolver, ASingularMatrixIsReported) {
  SaddleSystem s = saddle_system({});
  const auto local = s.A->getLocalMatrixHost();
  for (std::size_t e = 0; e < local.values.extent(0); ++e) local.values(e) = 0;
  Vector x(s.map);
  const LinearReport report = IterativeSolver(s.map, s.n_positions, {}).solve(*s.A, *s.b, x);
  EXPECT_FALSE(report.solved);
  EXPECT_FALSE(report.cause.empty());
}

TEST(SchurComplement, DenseAndSparseFactorsSolveWithIt) {
  const SaddleSystem s = saddle_system(with([](auto& o) { o.n = 8, o.spread = true; }));
  BlockSplit blocks(s.map, s.n_positions);
  EXPECT_TRUE(blocks.take(*s.A));
  EXPECT_FALSE(blocks.take(*s.A));
  Matrix one(blocks.map(0), 1);
  const double half = 0.5;
  for (int i = 0; i < static_cast<int>(blocks.map(0)->getNodeNumElements()); ++i) {
    const GlobalIndex row = blocks.map(0)->getGlobalElement(i);
    one.insertGlobalValues(row, 1, &half, &row);
  }
  one.fillComplete(blocks.map(0), blocks.map(0));
  Vector p(blocks.map(1)), r(blocks.map(1)), y(blocks.map(1)), u(blocks.map(0));
  p.randomize();
  blocks.B1()->apply(p, u);
  blocks.C()->apply(p, r);
  blocks.B2()->apply(u, r, Teuchos::NO_TRANS, -half, 1.0);
  for (const int largest_dense : {2000, 0}) {
    SchurComplement schur(blocks, largest_dense);
    schur.factor(one);
    schur.solve(r, y);
    y.update(-1.0, p, 1.0);
    EXPECT_LE(y.norm2() / p.norm2(), largest_dense > 0 ? 1e-10 : 0.2) << largest_dense;
  }
}

}  // namespace
}  // namespace mortise
