// The contact condition as one semismooth equation.
#include "contact/laws/signorini.hpp"

#include <gtest/gtest.h>

#include <Sacado.hpp>

namespace mortise::test {
namespace {

constexpr double c = 40;  // complementarity constant

TEST(Complementarity, IsZeroExactlyWhereSignorinisConditionsHold) {
  EXPECT_EQ(complementarity(0.0, 0.3, c), 0);   // open
  EXPECT_EQ(complementarity(5.0, 0.0, c), 0);   // closed
  EXPECT_EQ(complementarity(0.0, 0.0, c), 0);   // touching
  EXPECT_NE(complementarity(5.0, 0.3, c), 0);   // pressure across a gap
  EXPECT_NE(complementarity(0.0, -0.3, c), 0);  // penetration
  EXPECT_NE(complementarity(-5.0, 0.0, c), 0);  // adhesion
  EXPECT_NE(complementarity(-5.0, 0.3, c), 0);
}

TEST(Complementarity, IsTheGapOnOneSideOfTheKinkAndThePressureOnTheOther) {
  EXPECT_DOUBLE_EQ(complementarity(5.0, 0.1, c), c * 0.1);  // p - c g = 1
  EXPECT_DOUBLE_EQ(complementarity(5.0, -0.1, c), -c * 0.1);
  EXPECT_DOUBLE_EQ(complementarity(5.0, 0.2, c), 5);  // p - c g = -3
  EXPECT_DOUBLE_EQ(complementarity(-5.0, 0.2, c), -5);
}

TEST(Complementarity, IsContinuousAcrossTheKink) {
  const double gap = 0.125, p = c * gap;
  EXPECT_NEAR(complementarity(p * (1 + 1e-15), gap, c), complementarity(p * (1 - 1e-15), gap, c), 1e-13);
}

TEST(Complementarity, HasTheDerivativeOfItsBranch) {
  using Fad = Sacado::Fad::SFad<double, 2>;
  for (const double gap : {-0.3, -1e-9, 0.0, 1e-9, 0.3})
    for (const double p : {-5.0, 0.0, 1e-9, 5.0, 50.0}) {
      const bool active = p - c * gap > 0;
      const Fad r = complementarity(Fad(2, 0, p), Fad(2, 1, gap), c);
      EXPECT_EQ(r.val(), complementarity(p, gap, c));
      EXPECT_EQ(r.dx(0), active ? 0 : 1) << p << " " << gap;
      EXPECT_EQ(r.dx(1), active ? c : 0) << p << " " << gap;
    }
}

TEST(FischerBurmeister, HasTheRootsOfTheMinimum) {
  for (const double gap : {-0.3, 0.0, 0.3})
    for (const double p : {-5.0, 0.0, 5.0})
      EXPECT_EQ(fischer_burmeister(p, gap, c) == 0, complementarity(p, gap, c) == 0) << p << " " << gap;
}

TEST(FischerBurmeister, HasSlopesBetweenThoseOfTheBranches) {
  using Fad = Sacado::Fad::SFad<double, 2>;
  for (const double gap : {-0.3, 0.0, 0.3})
    for (const double p : {-5.0, 0.0, 5.0}) {
      const Fad r = fischer_burmeister(Fad(2, 0, p), Fad(2, 1, gap), c);
      EXPECT_EQ(r.val(), fischer_burmeister(p, gap, c));
      if (gap == 0 && p == 0) continue;  // one of many
      const double root = std::hypot(gap, p / c);
      EXPECT_NEAR(r.dx(0), (1 - p / c / root) / c, 1e-15);
      EXPECT_NEAR(r.dx(1), 1 - gap / root, 1e-15);
    }
  const Fad both = fischer_burmeister(Fad(2, 0, 0.0), Fad(2, 1, 0.0), c);
  EXPECT_TRUE(std::isfinite(both.dx(0)) && std::isfinite(both.dx(1)));
}

}  // namespace
}  // namespace mortise::test
