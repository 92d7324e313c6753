// MUMPS against known solutions, gathered on one rank and distributed, on whatever number of ranks the program is run.
#include "solve/direct_solver.hpp"

#include <gtest/gtest.h>

#include "saddle_system.hpp"

namespace mortise {
namespace {

/// Systems below this are gathered on rank 0: a great number gathers all, 0 none.
class Direct : public testing::TestWithParam<int> {
 protected:
  DirectSolver solver(const SaddleSystem& s) const { return DirectSolver(s.map, s.group, GetParam()); }
};

TEST_P(Direct, FindsTheKnownSolution) {
  for (const bool spread : {false, true}) {
    for (const double youngs_modulus : {1.0, 2.1e11}) {
      SaddleOptions o;
      o.n = 5;
      o.spread = spread;
      o.youngs_modulus = youngs_modulus;
      const SaddleSystem s = saddle_system(o);
      Vector x(s.map);
      const LinearReport report = solver(s).solve(*s.A, *s.b, x, 1);
      ASSERT_TRUE(report.solved) << report.cause;
      EXPECT_EQ(report.null_pivots, 0);
      EXPECT_LE(true_residual(*s.A, x, *s.b), 1e-9);
      EXPECT_LE(relative_error(s, x), 1e-8);
    }
  }
}

TEST_P(Direct, FindsTheKnownSolutionOfABodyHeldByContactAlone) {
  SaddleOptions o;
  o.upper_held = false;
  const SaddleSystem s = saddle_system(o);
  Vector x(s.map);
  const LinearReport report = solver(s).solve(*s.A, *s.b, x, 1);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_LE(relative_error(s, x), 1e-8);
}

TEST_P(Direct, EliminatedIdentityColumnsKeepTheSolution) {
  SaddleSystem s = saddle_system({});
  const double size = s.b->norm2();
  eliminate_identity_columns(*s.A, s.identity_rows, *s.b);
  EXPECT_GT(std::abs(s.b->norm2() - size), 1e-6 * size) << "nothing was eliminated";
  Vector x(s.map);
  const LinearReport report = solver(s).solve(*s.A, *s.b, x, 1);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_LE(relative_error(s, x), 1e-10);
}

TEST_P(Direct, ZeroRightHandSideGivesZero) {
  const SaddleSystem s = saddle_system({});
  Vector x(s.map), zero(s.map);
  x.putScalar(1.0);
  const LinearReport report = solver(s).solve(*s.A, zero, x, 1);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_EQ(x.normInf(), 0.0);
}

TEST_P(Direct, RigidMotionsAreReportedAsNullPivots) {
  for (const double youngs_modulus : {1.0, 2.1e11}) {
    SaddleOptions o;
    o.youngs_modulus = youngs_modulus;
    o.contact = false;
    o.n = 8;
    o.lower_held = false;  // six rigid motions of the lower block
    SaddleSystem s = saddle_system(o);
    Vector x(s.map);
    const LinearReport report = solver(s).solve(*s.A, *s.b, x, 1);
    EXPECT_FALSE(report.solved);
    EXPECT_EQ(report.null_pivots, 6) << report.cause;
    EXPECT_NE(report.cause.find("singular"), std::string::npos) << report.cause;
  }
}

TEST_P(Direct, AnEmptyRowIsReportedAsSingular) {
  SaddleSystem s = saddle_system({});
  s.A->resumeFill();
  if (const GlobalIndex row = s.n_positions; s.map->isNodeGlobalElement(row)) {
    const auto local = s.A->getLocalMatrixHost();
    const int i = s.map->getLocalElement(row);
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e) local.values(e) = 0;
  }
  s.A->fillComplete(s.map, s.map);
  Vector x(s.map);
  const LinearReport report = solver(s).solve(*s.A, *s.b, x, 1);
  EXPECT_FALSE(report.solved);
  EXPECT_NE(report.cause.find("singular"), std::string::npos) << report.cause;
}

TEST_P(Direct, RedundantConstraintsAreReportedAsNullPivots) {
  SaddleOptions o;
  o.open = [](int, int) { return false; };
  const SaddleSystem s = saddle_system(o);
  // The second pressure's row and column become copies of the first's; their diagonals are zero.
  const GlobalIndex first = s.n_positions;
  const auto A = Teuchos::rcp(new Matrix(s.map, 250));
  for (int i = 0; i < static_cast<int>(s.map->getNodeNumElements()); ++i) {
    const GlobalIndex row = s.map->getGlobalElement(i);
    const auto local = s.A->getLocalMatrixHost();
    for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e) {
      const GlobalIndex column = s.A->getColMap()->getGlobalElement(local.graph.entries(e));
      const double value = local.values(e);
      if (row == first + 1 || column == first + 1) continue;
      A->insertGlobalValues(row, 1, &value, &column);
      const GlobalIndex copy = first + 1;
      if (column == first && row < first) A->insertGlobalValues(row, 1, &value, &copy);
      if (row == first && s.map->isNodeGlobalElement(copy)) A->insertGlobalValues(copy, 1, &value, &column);
    }
  }
  A->fillComplete(s.map, s.map);
  Vector x(s.map);
  const LinearReport report = solver(s).solve(*A, *s.b, x, 1);
  EXPECT_FALSE(report.solved);
  EXPECT_EQ(report.null_pivots, 1) << report.cause;
}

TEST_P(Direct, ASolvableSystemFollowsASingularOne) {
  SaddleSystem s = saddle_system({});
  Matrix singular(*s.A, Teuchos::Copy);
  singular.resumeFill();
  singular.setAllToScalar(0.0);
  singular.fillComplete(s.map, s.map);
  DirectSolver direct = solver(s);
  Vector x(s.map);
  EXPECT_FALSE(direct.solve(singular, *s.b, x, 1).solved);
  const LinearReport report = direct.solve(*s.A, *s.b, x, 1);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_LE(relative_error(s, x), 1e-8);
}

TEST_P(Direct, KeepsItsAnalysisWhileTheGraphStands) {
  SaddleSystem s = saddle_system({});
  DirectSolver direct = solver(s);
  Vector x(s.map);
  EXPECT_TRUE(direct.solve(*s.A, *s.b, x, 1).solved);
  s.A->resumeFill();
  s.A->scale(2.0);
  s.A->fillComplete(s.map, s.map);
  EXPECT_TRUE(direct.solve(*s.A, *s.b, x, 1).solved);
  EXPECT_EQ(direct.analyses(), 1);
  x.scale(2.0);
  EXPECT_LE(relative_error(s, x), 1e-8);

  SaddleOptions spread;  // another graph: all entries of the pressures differ
  spread.open = [](int, int) { return false; };
  spread.contact = true;
  const SaddleSystem other = saddle_system(spread);
  EXPECT_TRUE(direct.solve(*other.A, *other.b, x, 2).solved);
  EXPECT_EQ(direct.analyses(), 2);
  EXPECT_LE(relative_error(other, x), 1e-8);
  EXPECT_GT(direct.factor_entries(), 0);
}

TEST_P(Direct, TheSmallestSystemIsSolved) {
  const auto map = Teuchos::rcp(new Map(1, 0, Tpetra::getDefaultComm()));
  Matrix A(map, 1);
  const GlobalIndex zero = 0;
  const double four = 4;
  if (map->isNodeGlobalElement(0)) A.insertGlobalValues(0, 1, &four, &zero);
  A.fillComplete(map, map);
  Vector x(map), b(map);
  b.putScalar(2.0);
  DirectSolver direct(map, {0}, GetParam());
  const LinearReport report = direct.solve(A, b, x, 1);
  ASSERT_TRUE(report.solved) << report.cause;
  EXPECT_DOUBLE_EQ(x.normInf(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Mumps, Direct, testing::Values(50000, 0),
                         [](const auto& info) { return info.param > 0 ? "OnOneRank" : "OnAllRanks"; });

}  // namespace
}  // namespace mortise
