// What contact forces owe to mechanics: no net force, no net moment, the same in every frame; and that absent contact costs
// nothing.
#include <gtest/gtest.h>

#include <iostream>

#include "support/overhang.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {
namespace {

struct Sums {
  Vec3<double> force{}, moment{};
  double forces = 0, moments = 0;  // of the absolute values
};

Sums sums_of(const TestScene& s, const std::vector<double>& x, const std::vector<double>& f) {
  Sums sums;
  for (std::size_t n = 0; n < s.n_positions(); n += 3) {
    const Vec3<double> q{x[n], x[n + 1], x[n + 2]}, force{f[n], f[n + 1], f[n + 2]};
    sums.force = sums.force + force;
    sums.moment = sums.moment + cross(q, force);
    sums.forces += norm(force);
    sums.moments += norm(q) * norm(force);
  }
  return sums;
}

TEST(ContactForce, HasNoResultantAndNoMomentAtRandomStates) {
  TestScene s(overhang_deck);
  Random random(7);
  double force = 0, moment = 0;
  for (int k = 0; k < 10; ++k) {
    const auto x = s.random_state(random, 0.08, -0.5, 1);
    const auto at = s.problem.evaluate(*s.scatter(x));
    ASSERT_TRUE(at.admissible);
    const Sums sums = sums_of(s, x, s.gather(*at.contact));
    ASSERT_GT(sums.forces, 0.1);
    force = std::max(force, norm(sums.force) / sums.forces);
    moment = std::max(moment, norm(sums.moment) / sums.moments);
  }
  EXPECT_LE(force, 1e-13);
  EXPECT_LE(moment, 1e-13);
  if (world()->getRank() == 0) std::cout << "resultant " << force << ", moment " << moment << " of the sum of magnitudes\n";
}

TEST(ContactForce, OnTheSecondarySideIsThePressureTimesCoveredAreaAgainstTheNormal) {
  TestScene s(overhang_deck);
  Random random(8);
  double worst = 0;
  for (int k = 0; k < 5; ++k) {
    const auto x = s.random_state(random, 0.08, 0.2, 1);
    const auto owned = s.scatter(x);
    const auto at = s.problem.evaluate(*owned);
    const auto area = s.gather(*at.area);
    const auto overlap = s.problem.to_overlap(*owned);
    const auto normals = s.problem.pairs()[0]->normals(overlap->getData().getRawPtr());
    Vec3<double> expected{};
    double size = 0;
    for (std::size_t I = 0; I < normals.size(); ++I) {
      const double push = x[s.n_positions() + I] * area[s.n_positions() + I];
      expected = expected - push * normals[I];
      size += push;
    }
    ASSERT_GT(size, 0.1);
    worst = std::max(worst, norm(s.problem.force_on_secondary(*owned, 0) - expected) / size);
  }
  EXPECT_LE(worst, 1e-10);
  if (world()->getRank() == 0) std::cout << "difference " << worst << '\n';
}

TEST(ContactForce, TurnsWithARigidMotionOfBothBodiesAndGapsStay) {
  TestScene s(overhang_deck);
  Random random(9);
  double forces = 0, gaps = 0;
  for (int k = 0; k < 5; ++k) {
    const auto x = s.random_state(random, 0.08, 0.2, 1);
    const auto Q = random.rotation();
    const auto shift = random.vector(3);
    auto moved = x;
    const auto turn = [&](std::vector<double>& v, const Vec3<double>& by) {
      for (std::size_t n = 0; n < s.n_positions(); n += 3) {
        const auto w = rotate(Q, Vec3<double>{v[n], v[n + 1], v[n + 2]}) + by;
        for (int i = 0; i < 3; ++i) v[n + i] = w[i];
      }
    };
    turn(moved, shift);
    const auto before = s.problem.evaluate(*s.scatter(x)), after = s.problem.evaluate(*s.scatter(moved));
    auto turned = s.gather(*before.contact);
    turn(turned, {0, 0, 0});
    forces = std::max(forces, relative_difference(s.gather(*after.contact), turned, 0, s.n_positions()));
    gaps = std::max(gaps, relative_difference(s.gather(*after.gap), s.gather(*before.gap), s.n_positions(), s.n_unknowns()));
    EXPECT_EQ(before.closed, after.closed);
  }
  EXPECT_LE(forces, 1e-12);
  EXPECT_LE(gaps, 1e-11);
  if (world()->getRank() == 0) std::cout << "forces " << forces << ", gaps " << gaps << '\n';
}

TEST(AbsentContact, IsNeverEvaluated) {
  TestScene s(without_list(overhang_deck, "contact"));
  RCP<Matrix> K;
  const auto at = s.problem.linearise(*s.state.x, K);
  EXPECT_TRUE(s.problem.pairs().empty());
  EXPECT_EQ(s.n_unknowns(), s.n_positions());
  EXPECT_EQ(s.problem.counts().seconds_search, 0);
  EXPECT_EQ(at.contact->norm2(), 0);
}

TEST(DistantContact, ProjectsNothing) {
  TestScene s(with(overhang_deck, "{1.6, 0.15, 1.01}", "{1.6, 0.15, 5}"));
  RCP<Matrix> K;
  s.problem.linearise(*s.state.x, K);
  EXPECT_GT(s.problem.pairs()[0]->counts().searches, 0);
  EXPECT_EQ(s.problem.pairs()[0]->counts().pairs, 0);
  EXPECT_EQ(s.problem.counts().graphs, 1);
}

}  // namespace
}  // namespace mortise::test
