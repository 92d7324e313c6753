// Materials against independent values: energy, stress and moduli from 80-digit differences of the energy alone.
#include <gtest/gtest.h>

#include "support/materials.hpp"
#include "support/references.hpp"

namespace mortise::test {
namespace {

/// At the 16 deformation gradients of the references. @param make the material from the parameters there
template <class Make>
void expect_reference_values(const std::string& name, const Make& make) {
  if (!have_reference("materials.json")) GTEST_SKIP() << no_reference("materials.json");
  const auto values = reference("materials.json");
  const auto material = make(values["parameters"]);
  int n_compared = 0;
  for (const auto& [label, rows] : values["F"].items()) {
    const auto& expected = values["results"][name + "|" + label];
    std::vector<double> F, A;
    for (const auto& row : rows)
      for (const auto& entry : row) F.push_back(entry);
    for (const auto& row : expected["A"])
      for (const auto& entry : row) A.push_back(entry);
    const std::vector<double> P = expected["P"];
    ASSERT_EQ(A.size(), 81U);
    const double tolerance = 1e-12 * largest(A) * largest(F);
    EXPECT_NEAR(material.strain_energy(tensor(F)), double(expected["W"]), tolerance) << label;
    const auto stress = entries(material.first_piola(tensor(F))), tangent = moduli_by_hand(material, tensor(F));
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(stress[k], P[k], tolerance) << label;
    for (int k = 0; k < 81; ++k) EXPECT_NEAR(tangent[k], A[k], 1e-12 * largest(A)) << label;
    ++n_compared;
  }
  EXPECT_EQ(n_compared, 16);
}

template <class M>
M from_lame(const nlohmann::json& parameters) {
  return M::from({parameters["E"], parameters["nu"]});
}

Ogden ogden(const nlohmann::json& parameters) {
  Ogden material{{}, parameters["kappa"], parameters["beta"]};
  for (std::size_t p = 0; p < parameters["mu"].size(); ++p)
    material.isochoric.terms.push_back({parameters["mu"][p], parameters["alpha"][p]});
  return material;
}

TEST(ReferenceValues, OfLinearElasticity) { expect_reference_values("linear_elastic", from_lame<LinearElastic>); }

TEST(ReferenceValues, OfSaintVenantAndKirchhoff) { expect_reference_values("svk", from_lame<SaintVenantKirchhoff>); }

TEST(ReferenceValues, OfNeoHooke) { expect_reference_values("neo_hooke", from_lame<NeoHookean>); }

TEST(ReferenceValues, OfMooneyAndRivlin) {
  expect_reference_values("mooney_rivlin", [](const nlohmann::json& parameters) {
    const auto& mr = parameters["mr"];
    const MooneyRivlin material{mr["c1"], mr["c2"], mr["c"]};
    EXPECT_DOUBLE_EQ(material.d(), mr["d"].get<double>());
    return material;
  });
}

TEST(ReferenceValues, OfOgdenWithTheFirstTable) {
  expect_reference_values("ogden_tab61", [](const nlohmann::json& parameters) { return ogden(parameters["ogden_tab61"]); });
}

TEST(ReferenceValues, OfOgdenWithTheSecondTable) {
  expect_reference_values("ogden_tab63", [](const nlohmann::json& parameters) { return ogden(parameters["ogden_tab63"]); });
}

}  // namespace
}  // namespace mortise::test
