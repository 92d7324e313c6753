// The same run gives the same numbers: again, on more ranks, and with the other way of taking element derivatives.
#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>
#include <iostream>

#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

const std::vector<double> times{0.25, 0.5, 0.75, 1, 1.5, 2};

// Pressed 0.3 deep, then drawn along; one further iteration per step, as comparisons between rank counts need.
TestScene ironing(const RCP<const Comm>& comm, TangentKind tangent = TangentKind::quadrature_point) {
  return TestScene(with(input_deck("ironing/frictionless.xml"), "-0.7*min(t,1)", "-0.3*min(t,1)"), comm, [&](Scene& scene) {
    scene.solver.further_iterations = 1;
    for (auto& body : scene.bodies) body.tangent = tangent;
  });
}

std::vector<double> result(TestScene&& s) {
  const auto run = s.march(times);
  EXPECT_TRUE(run.converged) << run.cause;
  return s.gather(*s.state.x);
}

/// On all ranks, made once.
const std::vector<double>& on_all_ranks() {
  static const std::vector<double> all = result(ironing(world()));
  return all;
}

TEST(Agreement, PositionsAndPressuresAreTheSameOnOneRankAndOnAll) {
  const auto& all = on_all_ranks();
  std::vector<double> one(all.size());
  if (world()->getRank() == 0) one = result(ironing(alone()));
  Teuchos::broadcast(*world(), 0, static_cast<int>(one.size()), one.data());
  const std::size_t n = one.size() - 25;  // the indenter's face has 25 pressures
  const double positions = relative_difference(all, one, 0, n), pressures = relative_difference(all, one, n, one.size());
  EXPECT_LE(positions, 1e-10);
  EXPECT_LE(pressures, 1e-10);
  EXPECT_GT(*std::max_element(one.begin() + n, one.end()), 0.1) << "nothing was pressed";
  if (world()->getRank() == 0)
    std::cout << world()->getSize() << " ranks against one: positions " << positions << ", pressures " << pressures << '\n';
}

TEST(Agreement, ARerunIsEqualToTheLastBit) { EXPECT_EQ(result(ironing(world())), on_all_ranks()); }

TEST(Agreement, DerivativesOfWholeElementsGiveTheSameRun) {
  const auto& points = on_all_ranks();
  const auto elements = result(ironing(world(), TangentKind::whole_element));
  const std::size_t n = points.size() - 25;
  const double positions = relative_difference(elements, points, 0, n),
               pressures = relative_difference(elements, points, n, points.size());
  EXPECT_LE(positions, 1e-12);
  EXPECT_LE(pressures, 1e-10);
  if (world()->getRank() == 0)
    std::cout << "whole elements against quadrature points: positions " << positions << ", pressures " << pressures << '\n';
}

}  // namespace
}  // namespace mortise::test
