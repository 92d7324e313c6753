// The tangent of a whole step is the derivative of its residual: every scheme, with everything that can be in a scene.
#include <gtest/gtest.h>

#include <iostream>

#include "support/marched_scene.hpp"
#include "support/overhang.hpp"
#include "tangents/checked_step.hpp"
#include "tangents/perturbation.hpp"

namespace mortise::test {
namespace {

std::string in_one_word(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
}

const std::string plain_body = word("mesh", "upper") + word("material", "rubber");

/// Two blocks in contact, the upper one damped, pressed and held by springs, before a ball; beside them a rope.
std::string everything(const std::string& scheme, const std::string& closing = "position",
                       const std::string& upper = plain_body) {
  const std::string springs =
      list("posts", word("type", "nodes") + word("set", "upper/top") + number("x", "0.3") + number("z", "0.2")) +
      list("bed", word("type", "bedding") + word("set", "lower/left") + number("y", "0.3"));
  const std::string law = number("stiffness", "3") + word("type", "between") + word("from", "rope/start");
  const std::string between = list("direct", law + word("to", "rope/end") + word("law", "neo-hookean")) +
                              list("redundant", law + deck_parameter("anchor", "Array(double)", "{-1, 0.3, 1.5}") +
                                                    word("law", "logarithmic") + word("formulation", "augmented"));
  const std::string rope = list("rope", word("mesh", "rope") + number("area", "0.1") + number("youngs modulus", "20") +
                                            number("density", "2") + word("law", "neo-hookean"));
  const std::string rope_mesh =
      list("rope", word("recipe", "line") + deck_parameter("from", "Array(double)", "{-2, 0, 0}") +
                       deck_parameter("to", "Array(double)", "{-2, 0, 2}") + deck_parameter("elements", "int", "3"));
  const std::string loads =
      list("water", word("type", "pressure") + word("set", "upper/top") + word("pressure", "0.01*(1 + t)")) +
      list("weight", word("type", "body force") + word("z", "-0.1"));
  const std::string ball =
      list("ball", word("type", "sphere") + word("set", "upper/top") + word("closing", closing) +
                       deck_parameter("centre", "Array(double)", "{2.6, 1.3, 2.5}") + number("radius", "0.45"));
  const std::string rod = list(
      "rod", word("mesh", "rope") + deck_parameter("node", "int", "4") + deck_parameter("anchor", "Array(double)", "{-2, 1, 3}"));
  const std::string motion =
      scheme == "static"
          ? ""
          : list("initial conditions", list("upper", deck_parameter("velocity", "Array(double)", "{0.1, 0.2, -0.3}")));
  std::string deck = overhang_deck;
  deck = with(deck, "  <ParameterList name=\"meshes\">", "  <ParameterList name=\"meshes\">\n" + rope_mesh);
  deck = with(deck, "name=\"poissons ratio\" type=\"double\" value=\"0.3\"/>",
              "name=\"poissons ratio\" type=\"double\" value=\"0.3\"/>\n" + number("density", "1"));
  deck = with(deck,
              "      <Parameter name=\"mesh\"     type=\"string\" value=\"upper\"/>\n      <Parameter name=\"material\" "
              "type=\"string\" value=\"rubber\"/>\n",
              upper);
  deck = with(deck, "value=\"lower/top\"/>", "value=\"lower/top\"/>\n" + word("closing", closing));
  deck = without_list(deck, "time");
  return with_lists(deck, list("springs", springs + between) + list("strings", rope) + list("loads", loads) +
                              list("obstacles", ball) + list("rods", rod) + motion +
                              list("time", word("scheme", scheme) + number("step", "0.3") + number("end", "0.6")));
}

StepTangent checked(const std::string& deck) {
  TestScene scene(deck);
  const auto steps = check_steps(scene.problem, *perturbed(scene.problem).x);
  EXPECT_EQ(steps.size(), 1U);
  return steps[0];
}

class WholeStep : public testing::TestWithParam<const char*> {};

TEST_P(WholeStep, HasTheTangentOfItsResidual) {
  const StepTangent step = checked(everything(GetParam()));
  EXPECT_LE(step.difference, 1e-8);
  EXPECT_GT(step.n_rows, 3 * (32 - 16 + 50 + 3));
  if (world()->getRank() == 0) std::cout << step.name << ": " << step.difference << ", " << step.n_rows << " rows\n";
}

INSTANTIATE_TEST_SUITE_P(Schemes, WholeStep,
                         testing::Values("backward euler", "midpoint", "trapezoidal", "generalised alpha", "hht", "wbz",
                                         "variational midpoint", "energy momentum midpoint contact"),
                         [](const auto& info) { return in_one_word(info.param); });

class WholeStepOfClosing : public testing::TestWithParam<const char*> {};

TEST_P(WholeStepOfClosing, HasTheTangentOfItsResidual) {
  EXPECT_LE(checked(everything("midpoint", GetParam())).difference, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Closings, WholeStepOfClosing, testing::Values("modified", "persistent", "velocity update"),
                         [](const auto& info) { return in_one_word(info.param); });

std::string with_friction(const std::string& deck, const std::string& parameters,
                          const std::string& law = number("friction coefficient", "0.3")) {
  const std::string pair = "value=\"lower/top\"/>";
  return with(deck, pair, pair + "\n" + law + parameters);
}

TEST(WholeStepOfFriction, HasTheTangentOfItsResidual) {
  for (const char* scheme :
       {"static", "backward euler", "midpoint", "generalised alpha", "hht", "energy momentum midpoint contact"})
    for (const char* slip : {"thesis", "moment free"})
      for (const std::string& stick : {std::string(), number("tangential penalty", "0.5"), number("tangential penalty", "20")}) {
        const StepTangent step = checked(with_friction(everything(scheme), word("slip", slip) + stick));
        EXPECT_LE(step.difference, 1e-8) << scheme << ", " << slip << stick;
      }
}

TEST(WholeStepOfFrictionLaws, HasTheTangentOfItsResidual) {
  const std::string formula = word("friction coefficient", "0.2 + 0.1*exp(-0.5*p) + 0.2*v/(1+v) + 0.1*t"),
                    bound = word("friction bound", "0.1 + t"), creep = number("slip regularisation", "0.2");
  double worst = 0;
  for (const char* scheme : {"static", "backward euler", "midpoint", "energy momentum midpoint contact"})
    for (const std::string& law : {formula, bound, formula + creep, bound + creep, number("friction coefficient", "1.5") + creep,
                                   formula + number("tangential penalty", "0.5"), bound + number("tangential penalty", "20")}) {
      const StepTangent step = checked(with_friction(everything(scheme), "", law));
      EXPECT_LE(step.difference, 1e-8) << scheme << ", " << law;
      worst = std::max(worst, step.difference);
    }
  if (world()->getRank() == 0) std::cout << "friction laws: " << worst << '\n';
}

TEST(WholeStepOfReadings, HasTheTangentOfItsResidual) {
  const std::string pair = "value=\"lower/top\"/>";
  const std::string eps = number("normal penalty", "2");
  for (const std::string& reading : {word("contact force", "interpolated normal"), word("mortar integrals", "start of step"),
                                     word("enforcement", "penalty") + eps, word("enforcement", "augmented lagrangian") + eps,
                                     word("complementarity", "fischer burmeister"),
                                     word("contact force", "interpolated normal") + number("friction coefficient", "0.3"),
                                     word("mortar integrals", "start of step") + number("friction coefficient", "0.3")})
    for (const char* scheme : {"static", "midpoint"})
      EXPECT_LE(checked(with(everything(scheme), pair, pair + "\n" + reading)).difference, 1e-8) << scheme << reading;
}

TEST(WholeStepOfTies, HasTheTangentOfItsResidual) {
  for (const char* scheme : {"static", "midpoint", "trapezoidal", "energy momentum midpoint contact"})
    for (const char* form : {"frame invariant", "plain"}) {
      const std::string deck = without_list(everything(scheme), "contact");
      EXPECT_LE(checked(with_lists(deck, list("ties", list("glue", word("secondary", "upper/bottom") +
                                                                       word("primary", "lower/top") + word("form", form)))))
                    .difference,
                1e-8)
          << scheme << form;
    }
}

TEST(WholeStepOfFormulations, HasTheTangentOfItsResidual) {
  for (const char* formulation : {"f-bar", "enhanced strain", "mixed"})
    for (const char* scheme : {"midpoint", "generalised alpha"}) {
      const std::string deck = everything(scheme, "position", plain_body + word("formulation", formulation));
      const StepTangent step = checked(with(deck, "value=\"neo-hookean\"", "value=\"neo-hookean isochoric-volumetric\""));
      EXPECT_LE(step.difference, 1e-8) << formulation << ", " << scheme;
    }
}

TEST(WholeStepOfTheDiscreteGradient, HasTheTangentOfItsResidual) {
  const std::string deck = without_list(everything("energy momentum"), "contact");
  EXPECT_LE(checked(deck).difference, 1e-8);
}

TEST(WholeStepOfDamping, HasTheTangentOfItsResidual) {
  const std::string body = plain_body + number("rayleigh mass", "0.1") + number("rayleigh stiffness", "0.01");
  for (const char* scheme : {"backward euler", "midpoint", "trapezoidal", "hht"})
    EXPECT_LE(checked(everything(scheme, "position", body)).difference, 1e-8) << scheme;
}

/// An error of a hundred thousandth is seen.
TEST(WholeStepCheck, SeesAWrongTangent) {
  TestScene scene(everything("midpoint"));
  const auto x = perturbed(scene.problem).x;
  ASSERT_EQ(scene.problem.begin_step(scene.state, 0.3), "");
  RCP<Matrix> K;
  scene.problem.linearise(*x, K);
  Matrix wrong(*K, Teuchos::Copy);
  EXPECT_LE(tangent_difference(scene.problem, *x, wrong).difference, 1e-8);
  wrong.resumeFill();
  wrong.scale(1 + 1e-5);
  wrong.fillComplete();
  EXPECT_GT(tangent_difference(scene.problem, *x, wrong).difference, step_tangent_limit);
}

}  // namespace
}  // namespace mortise::test
