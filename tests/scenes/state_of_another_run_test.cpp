// A run that begins with the last state of another one.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/text.hpp"

namespace mortise::test {
namespace {

const std::string toss = deck_parameter("velocity", "Array(double)", "{1, 2, -0.5}") +
                         deck_parameter("angular velocity", "Array(double)", "{3, 0.2, 8}");

/// A bar in free flight.
struct FlyingBar {
  std::string start = toss, fields = "{displacement, velocity}", elements = "{4, 2, 1}", origin = "{0, 0, 0}", end = "0.2";

  operator std::string() const {
    const std::string mesh = word("recipe", "block") + deck_parameter("size", "Array(double)", "{1, 0.3, 0.2}") +
                             deck_parameter("elements", "Array(int)", elements) +
                             deck_parameter("origin", "Array(double)", origin);
    const std::string material = word("model", "neo-hookean") + number("youngs modulus", "1000") +
                                 number("poissons ratio", "0.3") + number("density", "1.2");
    return list("bar", list("meshes", list("bar", mesh)) + list("materials", list("rubber", material)) +
                           list("bodies", list("bar", word("mesh", "bar") + word("material", "rubber"))) +
                           list("initial conditions", list("bar", start)) +
                           list("output", deck_parameter("fields", "Array(string)", fields)) +
                           list("time", word("scheme", "midpoint") + number("step", "0.02") + number("end", end)) +
                           list("solver", deck_parameter("further iterations", "int", "1")));
  }
};

FlyingBar going_on() {
  FlyingBar bar;
  bar.start = word("state", "first");
  return bar;
}

class StateOfAnotherRun : public testing::Test {
 protected:
  const ScratchFolder folder;

  void run(const std::string& name, const std::string& deck, int ranks = 1) {
    folder.write(name + ".xml", deck);
    const auto run = run_mortise(folder, "run " + name + ".xml --quiet", ranks);
    ASSERT_EQ(run.code, 0) << run.err;
  }
  /// Ends with this code and words about it.
  void expect_refused(const std::string& deck, int code, const std::string& words) {
    folder.write("refused.xml", deck);
    const auto run = run_mortise(folder, "run refused.xml --quiet");
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
};

TEST_F(StateOfAnotherRun, GoesOnAsOneRun) {
  FlyingBar longer;
  longer.end = "0.4";
  run("whole", longer);
  run("first", FlyingBar{});
  for (int ranks : {1, 2}) {
    run("second" + std::to_string(ranks), going_on(), ranks);
    const auto whole = read_history(folder / "whole" / "history.csv"), first = read_history(folder / "first" / "history.csv"),
               second = read_history(folder / ("second" + std::to_string(ranks)) / "history.csv");
    for (const char* column : {"kinetic_energy", "strain_energy", "linear_momentum_x", "angular_momentum_z"}) {
      const double size = std::abs(whole[column].back());
      EXPECT_NEAR(second[column].front(), first[column].back(), 1e-12 * size) << column;
      EXPECT_NEAR(second[column].back(), whole[column].back(), 1e-9 * size) << column;
    }
    EXPECT_EQ(second["external_work"].back(), 0);
  }
}

// What the deck gives beside the state is added to it.
TEST_F(StateOfAnotherRun, TakesAFurtherToss) {
  run("first", FlyingBar{});
  FlyingBar bar = going_on();
  bar.start += deck_parameter("velocity", "Array(double)", "{0, 0, 5}");
  run("second", bar);
  const auto first = read_history(folder / "first" / "history.csv"), second = read_history(folder / "second" / "history.csv");
  EXPECT_NEAR(second["linear_momentum_z"].front(), first["linear_momentum_z"].back() + 5 * 1.2 * 0.06, 1e-12);
}

TEST_F(StateOfAnotherRun, IsRefusedWhereItDoesNotFit) {
  run("first", FlyingBar{});
  FlyingBar finer = going_on(), moved = going_on(), lost = going_on(), turned = going_on(), text = going_on();
  finer.elements = "{5, 2, 1}";
  expect_refused(finer, 2, "initial conditions > bar > \"state\" = \"first\" - node 1 of mesh \"bar\" has no counterpart");
  moved.origin = "{0, 0.5, 0}";
  expect_refused(moved, 2, "node 1 of mesh \"bar\" is 0.5 away from where its reference position is in");
  lost.start = word("state", "frist");
  expect_refused(lost, 2, "error[D14]");
  turned.start += deck_parameter("rotation", "Array(double)", "{0, 0, 1, 90}");
  expect_refused(turned, 2, "cannot stand beside \"state\"");
  text.start = word("state", "first.xml");
  expect_refused(text, 3, "error[M01]");
}

TEST_F(StateOfAnotherRun, IsNotOverwrittenByTheRunThatBeginsWithIt) {
  run("first", FlyingBar{});
  const std::string before = text_of(folder / "first" / "results.e");
  folder.write("second.xml", going_on());
  const auto run = run_mortise(folder, "run second.xml -o first --overwrite --quiet");
  EXPECT_EQ(run.code, 5) << run.err;
  EXPECT_NE(run.err.find("begins with the results in this folder - name another one with -o"), std::string::npos) << run.err;
  EXPECT_TRUE(text_of(folder / "first" / "results.e") == before);
}

TEST_F(StateOfAnotherRun, IsRefusedIfItMovesWithoutVelocities) {
  FlyingBar first;
  first.fields = "{displacement}";
  run("first", first);
  expect_refused(going_on(), 2, "ends in motion, but has no velocities");
  folder.write("mesh.xml", "<ParameterList name=\"m\">" + word("recipe", "block") + "</ParameterList>");
  ASSERT_EQ(run_mortise(folder, "mesh mesh.xml -o first.e").code, 0);
  FlyingBar bare = going_on();
  bare.start = word("state", "first.e");
  expect_refused(bare, 3, "error[M08] holds no results");
}

// Pressed in one run, held in another: the pressures are there from the start.
TEST_F(StateOfAnotherRun, KeepsContact) {
  auto deck = without_list(input_deck("ironing/frictionless.xml"), "expected");
  deck = with(with(deck, "{20, 5, 3}", "{9, 3, 2}"), "{4, 4, 4}", "{2, 2, 2}");
  deck = with(with(deck, "-0.7*min(t,1)", "-0.3*min(t,1)"), "name=\"end\"          type=\"double\" value=\"20\"",
              "name=\"end\" type=\"double\" value=\"1\"");
  run("first", deck);
  const std::string start =
      list("initial conditions", list("slab", word("state", "first")) + list("indenter", word("state", "first")));
  run("second", with_lists(with(deck, "-0.3*min(t,1)", "-0.3"), start));
  const auto first = read_history(folder / "first" / "history.csv"), second = read_history(folder / "second" / "history.csv");
  const char* force = "contact_force_z.indenter on slab";
  EXPECT_GT(std::abs(first[force].back()), 0.1);
  EXPECT_NEAR(second[force].front(), first[force].back(), 1e-9);
  EXPECT_NEAR(second[force].back(), first[force].back(), 1e-9);
  EXPECT_LE(second["newton_iterations"][1], 1);
}

}  // namespace
}  // namespace mortise::test
