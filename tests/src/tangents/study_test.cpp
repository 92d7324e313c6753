// The study of thesis Fig. D.1: orders, best steps, and the two ways that have no round-off to fear.
#include "tangents/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace mortise::test {
namespace {

/// error by the exponent of the step
std::map<double, double> errors(TangentKind kind) {
  std::map<double, double> by_exponent;
  for (const auto& point : difference_study())
    if (point.kind == kind) by_exponent[std::round(4 * std::log10(point.step)) / 4] = point.error;
  return by_exponent;
}

double best_exponent(const std::map<double, double>& errors) {
  double best = 0;
  for (const auto& [exponent, error] : errors)
    if (error < errors.at(best)) best = exponent;
  return best;
}

double order(const std::map<double, double>& errors) { return std::log10(errors.at(-2) / errors.at(-3)); }

TEST(DifferenceStudy, OneSidedDifferencesHaveOrderOneAndABestStepNearTheRootOfRoundOff) {
  for (auto kind : {TangentKind::forward_differences, TangentKind::backward_differences}) {
    EXPECT_NEAR(order(errors(kind)), 1, 0.01);
    EXPECT_NEAR(best_exponent(errors(kind)), std::log10(std::sqrt(2.2e-16)), 1.5);
    EXPECT_GT(errors(kind).at(-16), 0.9);  // x + h = x: the derivative is lost
  }
}

TEST(DifferenceStudy, CentralDifferencesHaveOrderTwoAndABestStepNearTheCubeRootOfRoundOff) {
  const auto central = errors(TangentKind::central_differences);
  EXPECT_NEAR(order(central), 2, 0.01);
  EXPECT_NEAR(best_exponent(central), std::log10(std::cbrt(2.2e-16)), 1.5);
}

TEST(DifferenceStudy, TheComplexStepHasOrderTwoAndThenNoErrorForAnySmallerStep) {
  const auto complex = errors(TangentKind::complex_step);
  EXPECT_NEAR(order(complex), 2, 0.01);
  EXPECT_EQ(complex.begin()->first, -300);
  for (const auto& [exponent, error] : complex) {
    if (exponent <= -8) {
      EXPECT_LT(error, 5e-16) << exponent;
    }
  }
}

TEST(DifferenceStudy, AutomaticDifferentiationIsExact) {
  for (const auto& [exponent, error] : errors(TangentKind::whole_element)) EXPECT_LT(error, 5e-16) << exponent;
}

}  // namespace
}  // namespace mortise::test
