// The checker of derivatives is itself checked: it accepts right ones and finds wrong ones.
#include "support/gradient_check.hpp"

namespace mortise::test {
namespace {

const ManyToMany curve = [](const std::vector<double>& x) {
  return std::vector<double>{std::sin(x[0]) * x[1], std::exp(x[0] * x[1]), x[0] + 2 * x[1]};
};
const std::vector<double> at{0.4, 1.3};

std::vector<double> jacobian() {
  const double e = std::exp(at[0] * at[1]);
  return {std::cos(at[0]) * at[1], std::sin(at[0]), at[1] * e, at[0] * e, 1, 2};
}

TEST(GradientCheck, AcceptsARightJacobian) { EXPECT_TRUE(is_derivative(jacobian(), curve, at)); }

TEST(GradientCheck, AcceptsLinearAndQuadraticFunctionsThatDifferencesHitExactly) {
  const ManyToMany square = [](const std::vector<double>& x) { return std::vector<double>{x[0] * x[0], 3 * x[1]}; };
  EXPECT_TRUE(is_derivative({2 * at[0], 0, 0, 3}, square, at));
}

TEST(GradientCheck, RejectsEveryEntryThatIsWrongByOnePartInAMillion) {
  for (std::size_t k = 0; k < 6; ++k) {
    auto wrong = jacobian();
    wrong[k] *= 1 + 1e-6;
    EXPECT_FALSE(is_derivative(wrong, curve, at)) << "entry " << k;
  }
}

TEST(GradientCheck, RejectsAMissingEntryASwapAndAWrongSize) {
  auto wrong = jacobian();
  wrong[3] = 0;
  EXPECT_FALSE(is_derivative(wrong, curve, at));
  wrong = jacobian();
  std::swap(wrong[0], wrong[1]);
  EXPECT_FALSE(is_derivative(wrong, curve, at));
  wrong.pop_back();
  EXPECT_FALSE(is_derivative(wrong, curve, at));
  EXPECT_FALSE(is_derivative(std::vector<double>(6, std::nan("")), curve, at));
}

}  // namespace
}  // namespace mortise::test
