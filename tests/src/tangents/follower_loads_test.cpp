// The check of tangents covers the loads that follow the positions, on the sides of every element type.
#include <gtest/gtest.h>

#include "support/unit_block.hpp"
#include "tangents/perturbation.hpp"
#include "tangents/tangent_check.hpp"

namespace mortise::test {
namespace {

std::string loaded_block(ElementType type) {
  const std::string on_top = word("set", "block/top");
  return list(
      "loaded block",
      list("meshes", list("block", word("recipe", "block") + deck_parameter("elements", "Array(int)", "{2, 1, 1}") +
                                       word("element type", topology(type).name))) +
          list("materials",
               list("solid", word("model", "neo-hookean") + number("youngs modulus", "1e3") + number("poissons ratio", "0.3"))) +
          list("bodies", list("block", word("mesh", "block") + word("material", "solid"))) +
          list("loads",
               list("water", word("type", "pressure") + on_top + word("pressure", "50*t*(1 + x)") + number("end", "0.5")) +
                   list("wind", word("type", "cauchy traction") + on_top + word("x", "20*t*y") + word("z", "-30*t")) +
                   list("dead", word("type", "traction") + on_top + word("z", "-t"))) +
          list("time", number("end", "1") + number("step", "0.5")));
}

class FollowerLoads : public testing::TestWithParam<ElementType> {};

TEST_P(FollowerLoads, HaveTangentsThatAgree) {
  const TestScene scene(loaded_block(GetParam()), world());
  const auto x = scene.problem.to_overlap(*perturbed(scene.problem).x);
  const auto terms = checked_terms(scene.problem, scene.partition, 10);
  int n_loads = 0;
  for (const CheckedTerm& term : terms) {
    if (term.name.rfind("load ", 0) != 0) continue;
    const StateResult result = check_tangents(term, x->getData().getRawPtr(), *scene.problem.dofs().comm());
    EXPECT_EQ(result.n_pieces, term.n_chosen) << term.name;
    for (const auto& line : disagreements(term, "deformed", result)) ADD_FAILURE() << line;
    EXPECT_GT(result.n_pieces, 0);
    ++n_loads;
  }
  EXPECT_EQ(n_loads, 2);  // a dead load has no tangent
}

INSTANTIATE_TEST_SUITE_P(Sides, FollowerLoads, testing::ValuesIn(element_types),
                         [](const auto& info) { return std::string(topology(info.param).name); });

TEST(FollowerLoadsOfAScene, AreCheckedAtTheLastTimeAtWhichTheyAct) {
  const TestScene scene(loaded_block(ElementType::hex8), world());
  const auto terms = checked_terms(scene.problem, scene.partition, 10);
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[1].name, "load \"water\" (pressure, at t = 0.5)");
  EXPECT_EQ(terms[2].name, "load \"wind\" (cauchy traction, at t = 1)");
  EXPECT_EQ(terms[1].describe(0), "side 6 of element 1 of mesh \"block\"");
}

}  // namespace
}  // namespace mortise::test
