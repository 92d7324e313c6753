// Point masses, springs between them, and strings on any number of ranks: tangents, balances, and the weight of all.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "support/marched_scene.hpp"

namespace mortise::test {
namespace {

/// Four masses in a ring of springs, one of them held to a point, and a string that flies beside them.
struct System {
  std::string scheme = "energy momentum", law = "saint venant", formulation = "displacement", order = "2", loads;
  std::string step = "0.05", end = "1";

  operator std::string() const {
    const std::string corners = "{1, 0, 0, 0, 1, 0.2, -1, 0, 0, 0, -1, 0.1}";
    std::string ring;
    for (int k = 1; k <= 4; ++k)
      ring += list("side " + std::to_string(k), word("type", "between") + word("from", "ring/" + std::to_string(k)) +
                                                    word("to", "ring/" + std::to_string(k % 4 + 1)) + number("stiffness", "200") +
                                                    word("law", law) + word("formulation", formulation));
    const std::string line = word("recipe", "line") + deck_parameter("from", "Array(double)", "{0, 0, 2}") +
                             deck_parameter("to", "Array(double)", "{2, 0, 2}") + deck_parameter("elements", "int", "4") +
                             deck_parameter("order", "int", order);
    const std::string rope = word("mesh", "rope") + number("area", "0.1") + number("youngs modulus", "1000") +
                             number("density", "2") + word("law", law);
    const auto motion = [](const std::string& v, const std::string& omega) {
      return deck_parameter("velocity", "Array(double)", v) + deck_parameter("angular velocity", "Array(double)", omega);
    };
    return list("discrete",
                list("meshes", list("ring", word("recipe", "points") + deck_parameter("coordinates", "Array(double)", corners)) +
                                   list("rope", line)) +
                    list("masses", list("balls", word("set", "ring") + number("mass", "0.5")) +
                                       list("hook", word("set", "rope/end") + number("mass", "0.25"))) +
                    list("strings", list("rope", rope)) + list("springs", ring) +
                    list("initial conditions",
                         list("balls", motion("{1, 0, 0.5}", "{0, 3, 4}")) + list("rope", motion("{0, 1, 0}", "{0, 0, 6}"))) +
                    loads + list("time", word("scheme", scheme) + number("step", step) + number("end", end)) +
                    list("solver", number("tolerance", "1e-13")));
  }
};

TEST(DiscreteSystem, KeepsEnergyAndMomentaForEveryLawAndOrder) {
  for (const char* law : {"saint venant", "neo-hookean", "logarithmic"})
    for (const char* order : {"1", "2", "3"}) {
      System system;
      system.law = law;
      system.order = order;
      if (*order == '3') system.formulation = "augmented";
      const MarchedScene run{system};
      ASSERT_EQ(run.summary.code, ExitCode::done) << law << order << run.summary.cause << run.log;
      const auto E = run["total_energy"], stored = run["strain_energy"];
      EXPECT_GT(*std::max_element(stored.begin(), stored.end()), 1e-3 * E.front()) << law << order;
      for (double now : E) EXPECT_NEAR(now, E.front(), 1e-11 * E.front()) << law << order;
      for (const char* momentum : {"linear_momentum_x", "linear_momentum_y", "angular_momentum_x", "angular_momentum_z"}) {
        const auto p = run[momentum];
        for (double now : p) EXPECT_NEAR(now, p.front(), 1e-10) << momentum << law << order;
      }
      // rho A l = 0.4 along y, turning about its own centre of mass; the hook has no motion of its own beyond the rope's
      EXPECT_NEAR(run["linear_momentum_x"].front(), 4 * 0.5 * 1, 1e-12);
    }
}

TEST(DiscreteSystem, IsTheSameOnEveryNumberOfRanks) {
  for (const char* formulation : {"displacement", "augmented"}) {
    System system;
    system.formulation = formulation;
    const MarchedScene shared{system}, alone_one(system, alone());
    const auto together = shared.unknowns(), one = alone_one.unknowns();
    const std::size_t n_positions = shared.scene.n_positions(), n_springs = std::string(formulation) == "augmented" ? 4 : 0;
    ASSERT_EQ(together.size(), n_positions + 2 * n_springs);
    EXPECT_LE(relative_difference(together, one, 0, n_positions), 1e-10) << formulation;
    EXPECT_LE(relative_difference(together, one, n_positions, one.size()), 1e-10) << formulation;
  }
}

TEST(DiscreteSystem, FallsByItsWeight) {
  System system;
  system.loads = list("loads", list("weight", word("type", "body force") + word("z", "-9.81")));
  const MarchedScene run{system};
  ASSERT_EQ(run.summary.code, ExitCode::done) << run.summary.cause << run.log;
  // The hook has no weight of its own in `rope`, but as a mass: 4 x 0.5 + 0.25 + 2 x 0.1 x 2
  EXPECT_NEAR(run["linear_momentum_z"].back() - run["linear_momentum_z"].front(), -9.81 * 2.65, 1e-9);
  EXPECT_LE(run.relative_mismatch(), 1e-11);
}

/// Central differences of the residual against the tangent, for forces at a point and for the discrete gradient.
TEST(DiscreteSystem, HasTheTangentOfItsForces) {
  for (const char* scheme : {"midpoint", "energy momentum", "backward euler", "trapezoidal"})
    for (const char* law : {"saint venant", "neo-hookean", "logarithmic"})
      for (const char* formulation : {"displacement", "augmented"}) {
        System system;
        system.scheme = scheme;
        system.law = law;
        system.formulation = formulation;
        TestScene scene{std::string(system)};
        scene.problem.begin_step(scene.state, 0.05);
        Random random(7);
        const auto x = scene.random_state(random, 0.05, 0.7, 1.4);  // squared stretches, and multipliers, if any
        RCP<Matrix> tangent;
        scene.problem.linearise(*scene.scatter(x), tangent);
        const auto K = scene.dense(*tangent);
        const std::size_t n = x.size();
        double greatest = 0, worst = 0;
        for (double entry : K) greatest = std::max(greatest, std::abs(entry));
        for (std::size_t c = 0; c < n; ++c) {
          const double h = 1e-5;
          auto plus = x, minus = x;
          plus[c] += h;
          minus[c] -= h;
          const auto r_plus = scene.gather(*scene.problem.evaluate(*scene.scatter(plus)).residual),
                     r_minus = scene.gather(*scene.problem.evaluate(*scene.scatter(minus)).residual);
          for (std::size_t r = 0; r < n; ++r)
            worst = std::max(worst, std::abs((r_plus[r] - r_minus[r]) / (2 * h) - K[r * n + c]));
        }
        EXPECT_LE(worst, 1e-7 * greatest) << scheme << law << formulation;
      }
}

TEST(DiscreteSystem, WithoutInertiaOrWhatHoldsItIsRefused) {
  const std::string both = with(System{}, word("set", "ring"), word("set", "ring/1"));
  try {
    scene_of(both);
    ADD_FAILURE() << "no error";
  } catch (const DeckError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("error[D22] meshes > ring - node 2 of mesh \"ring\" can move, and has no inertia"), std::string::npos)
        << message;
  }
}

/// A mass that hangs on a hinged spring finds  c L (nu^2 - 1) nu / 2 = m g  in statics.
TEST(DiscreteSystem, HangsInStaticsWhereItsSpringHoldsIt) {
  for (const char* formulation : {"displacement", "augmented"}) {
    const std::string spring = word("type", "between") + word("from", "ball/1") +
                               deck_parameter("anchor", "Array(double)", "{0, 0, 0}") + number("rest length", "1") +
                               number("stiffness", "100") + word("formulation", formulation);
    const std::string deck = list(
        "hanging",
        list("meshes", list("ball", word("recipe", "points") + deck_parameter("coordinates", "Array(double)", "{0, 0, -1.2}"))) +
            list("masses", list("ball", word("set", "ball/1") + number("mass", "2"))) + list("springs", list("spring", spring)) +
            list("loads", list("weight", word("type", "body force") + word("z", "-10"))) +
            list("time", word("scheme", "static") + number("step", "1") + number("end", "1")));
    TestScene scene(deck, alone());
    const auto run = scene.march({1.0});
    ASSERT_TRUE(run.converged) << run.cause;
    const auto x = scene.gather(*scene.state.x);
    const double nu = -x[2];
    EXPECT_NEAR(50 * (nu * nu - 1) * nu, 20, 1e-8) << formulation;
    if (x.size() == 3) continue;
    EXPECT_NEAR(x[3], nu * nu, 1e-9);              // v
    EXPECT_NEAR(x[4], -25 * (nu * nu - 1), 1e-8);  // lambda = -V'(v)
    EXPECT_NEAR(-2 * x[4] * nu, 20, 1e-8) << "force, L = 1";
  }
}

}  // namespace
}  // namespace mortise::test
