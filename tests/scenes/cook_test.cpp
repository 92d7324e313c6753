// Cook's membrane of inputs/cook: elements that must not lock meet the refined reference up to exact incompressibility.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mortise::test {
namespace {

/// An element of the study, and how many of it lie along each side of the panel.
struct Panel {
  std::string type, formulation;
  int n;
  std::string name() const { return type + "_" + formulation; }
};

const std::string folder_of_cook = std::string(MORTISE_SOURCE_DIR) + "/inputs/cook/";

nlohmann::json reference() { return nlohmann::json::parse(text_of(folder_of_cook + "reference.json")); }

double reference_at(const std::string& ratio) { return reference()["by Poisson's ratio"][ratio]["deflection"]; }

/// The deck of F-bar with another element and Poisson's ratio, 0.5 too.
std::string deck(const Panel& panel, const std::string& ratio) {
  const std::string elements = "{" + std::to_string(panel.n) + ", " + std::to_string(panel.n) + ", 1}\"/>";
  std::string text = without_list(input_deck("cook/f_bar.xml"), "expected");
  text = with(text, "{32, 32, 1}\"/>", elements);
  text = with(text, "value=\"hex8\"", "value=\"" + panel.type + "\"");
  text = with(text, "value=\"f-bar\"", "value=\"" + panel.formulation + "\"");
  if (ratio != "0.5") return with(text, "value=\"0.4999\"", "value=\"" + ratio + "\"");
  return with(with(text, "<Parameter name=\"poissons ratio\" type=\"double\" value=\"0.4999\"/>", ""), "isochoric-volumetric",
              "incompressible");
}

/// Displacement of the tip along y at the end.
double deflection(const std::string& deck, int ranks = 1) {
  const ScratchFolder folder;
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet", ranks);
  EXPECT_EQ(run.code, 0) << run.err;
  return run.code == 0 ? read_history(folder / "out" / "history.csv")["displacement_y.tip"].back() : std::nan("");
}

/// Relative error against the reference.
double error(const Panel& panel, const std::string& ratio) {
  const double found = deflection(deck(panel, ratio)), off = found / reference_at(ratio) - 1;
  std::cout << panel.name() << ", nu = " << ratio << ": " << found << ", error " << off << '\n';
  return off;
}

class LockingFree : public testing::TestWithParam<Panel> {};

TEST_P(LockingFree, MeetsTheReferenceNearIncompressibilityAndGetsNoWorseThere) {
  std::map<std::string, double> errors;
  for (const std::string ratio : {"0.49", "0.499", "0.4999"}) {
    errors[ratio] = std::abs(error(GetParam(), ratio));
    EXPECT_LE(errors[ratio], 0.01) << ratio;
  }
  EXPECT_LE(errors["0.4999"], 1.5 * errors["0.49"]);
  if (GetParam().formulation == "mixed") {
    EXPECT_LE(std::abs(error(GetParam(), "0.5")), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Cook, LockingFree,
                         testing::Values(Panel{"hex8", "f-bar", 32}, Panel{"hex8", "enhanced strain", 32},
                                         Panel{"hex8", "mixed", 32}, Panel{"hex27", "mixed", 8}),
                         [](const auto& info) {
                           std::string name = info.param.name();
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

// The same mesh without a cure is right in compressible rubber, and locks the more the less its volume can change.
TEST(Cook, LocksWithPlainHex8) {
  const Panel plain{"hex8", "standard", 32};
  const double compressible = error(plain, "0.3"), harder = error(plain, "0.49"), hardest = error(plain, "0.4999");
  EXPECT_LE(std::abs(compressible), 0.02);
  EXPECT_LT(harder, compressible);
  EXPECT_LT(hardest, -0.2);
}

// What the gates above compare with is found again where it is cheap, and its own last refinement changes it by far less than 1
// %.
TEST(Cook, HasAReferenceThatIsRepeatableAndConverged) {
  const auto recorded = reference();
  const int coarsest = recorded["elements along each side"][0];
  for (const std::string ratio : {"0.4999", "0.5"}) {
    const auto& values = recorded["by Poisson's ratio"][ratio];
    const double found = deflection(deck({"hex27", "mixed", coarsest}, ratio));
    EXPECT_NEAR(found, values["deflections"][0], 1e-8 * found) << ratio;
  }
  for (const auto& [ratio, values] : recorded["by Poisson's ratio"].items()) {
    EXPECT_LE(values["change"], 1e-3) << ratio;
    EXPECT_NEAR(values["deflection"].get<double>() / values["deflections"].back().get<double>(), 1, 1e-15) << ratio;
  }
}

TEST(Cook, IsTheSameOnAnyNumberOfRanks) {
  for (const Panel& panel : {Panel{"hex8", "f-bar", 8}, Panel{"hex27", "mixed", 4}}) {
    const std::string text = deck(panel, "0.4999");
    const double alone = deflection(text);
    for (int ranks : {2, 4}) EXPECT_NEAR(deflection(text, ranks), alone, 1e-8 * alone) << panel.name() << ", " << ranks;
  }
}

TEST(Run, OfEveryCookDeckMeetsItsExpectedValues) {
  const ScratchFolder folder;
  for (const std::string name : {"f_bar", "mixed", "incompressible"}) {
    const auto run = run_mortise(folder, "run '" + folder_of_cook + name + ".xml' --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(count_of(run.out, ": met"), 1) << run.out;
  }
}

}  // namespace
}  // namespace mortise::test
