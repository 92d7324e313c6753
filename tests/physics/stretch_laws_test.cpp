// Laws in the stretch of a line: their slopes are quotients of their energies, with all digits for any increment.
#include "physics/stretch_laws.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

template <class Law>
class EveryStretchLaw : public testing::Test {};
using Laws = testing::Types<stretch_laws::SaintVenant, stretch_laws::NeoHookean, stretch_laws::Logarithmic>;
TYPED_TEST_SUITE(EveryStretchLaw, Laws);

TYPED_TEST(EveryStretchLaw, HasASlopeThatIsTheQuotientOfItsEnergy) {
  using L = long double;
  for (double s : {0.3, 0.64, 1.0, 2.5})
    for (double ds : {0.9, 0.3, -0.2, 1e-1, 1e-3, -1e-5}) {
      const L quotient = (TypeParam::energy(L(s) + L(ds)) - TypeParam::energy(L(s))) / L(ds);
      EXPECT_NEAR(TypeParam::slope(s, ds), static_cast<double>(quotient), 1e-13 + 1e-18 / std::abs(ds)) << s << " " << ds;
    }
}

TYPED_TEST(EveryStretchLaw, KeepsItsDigitsAsTheIncrementVanishes) {
  for (double s : {0.5, 0.64, 2.5}) {
    const double limit = TypeParam::slope(s, 0.0), h = 1e-5;
    EXPECT_NEAR((TypeParam::energy(s + h) - TypeParam::energy(s - h)) / (2 * h), limit, 1e-8);
    for (double ds = 1e-6; ds > 1e-15; ds /= 10) EXPECT_NEAR(TypeParam::slope(s, ds), limit, 300 * ds + 1e-15) << s << " " << ds;
  }
}

TYPED_TEST(EveryStretchLaw, IsAtRestWithoutStretch) {
  EXPECT_EQ(TypeParam::energy(1.0), 0.0);
  EXPECT_EQ(TypeParam::slope(1.0, 0.0), 0.0);
}

TEST(Logarithmic, HasTheForceOfTheThesis) {  // eq. 2.10
  for (double nu : {0.5, 0.99, 1.01, 3.0}) {
    const Vec3<double> t{0, nu, 0};
    EXPECT_NEAR(tension<stretch_laws::Logarithmic>(t, t)[1], 0.5 * (nu - 1 / nu), 1e-15);
  }
}

TEST(SaintVenant, HasTheForceOfTheThesis) {  // eq. 6.11
  const Vec3<double> t{0.6, 0, 0.8 * 1.5};
  const double s = dot(t, t);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(tension<stretch_laws::SaintVenant>(t, t)[i], 0.5 * (s - 1) * t[i], 1e-15);
}

TEST(LogarithmQuotient, IsSmoothWhereItChangesItsFormula) {
  for (double x : {-0.25, 0.25, 1e-3, -1e-9, 0.1})
    for (double shift : {-1e-12, 1e-12}) {
      const long double y = static_cast<long double>(x) + shift;
      EXPECT_NEAR(stretch_laws::logarithm_quotient(x + shift), static_cast<double>(std::log1p(y) / y), 1e-15) << x;
    }
  EXPECT_EQ(stretch_laws::logarithm_quotient(0.0), 1.0);
}

}  // namespace
}  // namespace mortise
