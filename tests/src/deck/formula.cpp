// Formulas and tables.
#include "deck/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <stdexcept>

namespace mortise::test {
namespace {

const std::array<double, 3> origin{0, 0, 0};
const Named<TableOptions> ramp{{"ramp", {{0, 1, 3}, {0, 2, 6}}}, {"hat_2", {{-1, 0, 1}, {0, 1, 0}}}};

std::string fault_of(const std::string& text) {
  try {
    Formula formula(text, ramp);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(Formula, KnowsTimeAndPlace) {
  const Formula formula("t + 10*x + 100*y + 1000*z", {});
  EXPECT_EQ(formula(4, {3, 2, 1}), 1234);
  EXPECT_EQ(formula(0, origin), 0);
  EXPECT_EQ(formula.text(), "t + 10*x + 100*y + 1000*z");
}

TEST(Formula, MayBeInOtherVariables) {
  const Formula formula("t + 10*p + ramp(v)", ramp, {"t", "p", "v"});
  EXPECT_EQ(formula.at({1, 2, 0.5}), 22);
  try {
    const Formula of_place("0.3*x", ramp, {"t", "p", "v"});
    FAIL() << "x is no variable of it";
  } catch (const std::invalid_argument& fault) {
    EXPECT_NE(std::string(fault.what()).find("\"x\""), std::string::npos) << fault.what();
  }
}

TEST(Formula, OfTheConventionsMovesTheIndenter) {
  const Formula sliding("0.15*max(t-1,0)", {}), pressing("-0.7*min(t,1)", {});
  EXPECT_EQ(sliding(0.5, origin), 0);
  EXPECT_DOUBLE_EQ(sliding(3, origin), 0.3);
  EXPECT_DOUBLE_EQ(pressing(0.5, origin), -0.35);
  EXPECT_DOUBLE_EQ(pressing(9, origin), -0.7);
}

TEST(Formula, HasFunctionsConstantsAndConditions) {
  EXPECT_DOUBLE_EQ(Formula("sin(pi/2) + cos(0) + sqrt(4) + exp(0) + log(exp(3)) + abs(-1) + 2^3", {})(0, origin), 17);
  const Formula step("t < 1 ? 5 : 6", {});
  EXPECT_EQ(step(0, origin), 5);
  EXPECT_EQ(step(1, origin), 6);
  EXPECT_EQ(Formula("t == 1 && x >= 0", {})(1, origin), 1);
}

TEST(Formula, CallsTablesThatAreStraightBetweenTheirPointsAndConstantOutside) {
  const Formula formula("ramp(t) + 100*hat_2(x)", ramp);
  EXPECT_DOUBLE_EQ(formula(0.5, {1, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(formula(1, {1, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(formula(2, {1, 0, 0}), 4);
  EXPECT_DOUBLE_EQ(formula(99, {1, 0, 0}), 6);
  EXPECT_DOUBLE_EQ(formula(-5, {0.25, 0, 0}), 75);
}

TEST(Formula, OutlivesTheTablesItWasMadeFromAndItsOriginal) {
  auto tables = std::make_unique<Named<TableOptions>>(ramp);
  auto original = std::make_unique<Formula>("ramp(t)", *tables);
  const Formula copy = *original;
  tables.reset();
  original.reset();
  EXPECT_DOUBLE_EQ(copy(2, origin), 4);
}

TEST(Formula, ReturnsInfinityAndNaNForTheCallerToRefuse) {
  EXPECT_TRUE(std::isinf(Formula("1/t", {})(0, origin)));
  EXPECT_TRUE(std::isnan(Formula("sqrt(t)", {})(-1, origin)));
  EXPECT_TRUE(std::isnan(Formula("0/0 + t", {})(0, origin)));
  EXPECT_TRUE(std::isnan(Formula("ramp(log(t))", ramp)(-1, origin)));
}

TEST(Formula, WithAFaultSaysWhich) {
  EXPECT_NE(fault_of("").find("empty"), std::string::npos);
  EXPECT_NE(fault_of("sin("), "");
  EXPECT_NE(fault_of("1 +"), "");
  EXPECT_NE(fault_of("max(t,0"), "");
  EXPECT_NE(fault_of("ramp(t, 1)"), "");
  EXPECT_NE(fault_of("w*t"), "");
  EXPECT_NE(fault_of("\"text\""), "");
  EXPECT_NE(fault_of("1e*t"), "");
  EXPECT_NE(fault_of("rmap(t)").find("did you mean \"ramp\"?"), std::string::npos) << fault_of("rmap(t)");
  EXPECT_NE(fault_of("2*sni(t)").find("did you mean \"sin\"?"), std::string::npos) << fault_of("2*sni(t)");
}

TEST(Formula, WithADecimalCommaOrAnAssignmentIsRefused) {
  EXPECT_NE(fault_of("0,15*t").find("decimal sign is a point"), std::string::npos) << fault_of("0,15*t");
  EXPECT_NE(fault_of("t = 2").find("assignment"), std::string::npos);
  EXPECT_NE(fault_of("x += 2"), "");
}

TEST(Table, AtAPointGivesItsValueExactly) {
  const TableOptions table{{0.1, 0.3, 0.7}, {1. / 3, 0.1, 1e9}};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(table_value(table, table.arguments[i]), table.values[i]);
  EXPECT_TRUE(std::isnan(table_value(table, std::numeric_limits<double>::quiet_NaN())));
}

TEST(NamesInFormula, AreFoundWithoutNumbers) {
  EXPECT_EQ(names_in_formula("2e3*ramp(t) + _a1-x"), (std::vector<std::string>{"ramp", "t", "_a1", "x"}));
}

}  // namespace
}  // namespace mortise::test
