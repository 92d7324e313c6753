// Decks with every kind of load, support, spring and damping: what they must give.
#include "deck/fields.hpp"
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

/// Entries called a, b, c ...
std::string entries(const std::vector<std::string>& parameters) {
  std::string text, name = "a";
  for (const auto& one : parameters) {
    text += "<ParameterList name=\"" + name + "\">" + one + "</ParameterList>";
    ++name[0];
  }
  return text;
}
std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}
const std::string density = elastic_parameters + parameter("density", "double", "2");

TEST(Deck, TakesEveryLoadByItsName) {
  const auto of = [](const std::string& type, const std::string& rest) { return parameter("type", "string", type) + rest; };
  const std::string set = parameter("set", "string", "cube/top"), z = parameter("z", "string", "-t"),
                    mesh = parameter("mesh", "string", "cube"),
                    times = parameter("start", "double", "0.5") + parameter("end", "double", "1");
  const std::vector<std::string> all{of("traction", set + z),
                                     of("cauchy traction", set + z + times),
                                     of("pressure", set + parameter("pressure", "string", "3*t")),
                                     of("body force", parameter("body", "string", "cube") + z),
                                     of("point force", set + z),
                                     of("point force", mesh + parameter("node", "int", "3") + z),
                                     of("point force", mesh + parameter("nearest", "Array(double)", "{1, 2, 3}") + z)};
  const DeckOptions o = read_text(with(with_lists(list("loads", entries(all))), elastic_parameters, density));
  ASSERT_EQ(o.loads.size(), all.size());
  EXPECT_EQ(name_of_kind(*o.loads[0].second.kind), "traction");
  EXPECT_FALSE(o.loads[0].second.activity.start || o.loads[0].second.activity.end);
  EXPECT_EQ(std::get<loads::CauchyTraction>(*o.loads[1].second.kind).traction[2], "-t");
  EXPECT_EQ(o.loads[1].second.activity.start, 0.5);
  EXPECT_EQ(o.loads[1].second.activity.end, 1);
  EXPECT_EQ(std::get<loads::Pressure>(*o.loads[2].second.kind).pressure, "3*t");
  EXPECT_EQ(std::get<loads::BodyForce>(*o.loads[3].second.kind).body, "cube");
  EXPECT_EQ(std::get<loads::PointForce>(*o.loads[4].second.kind).set, "cube/top");
  EXPECT_EQ(std::get<loads::PointForce>(*o.loads[5].second.kind).node, 3);
  EXPECT_EQ(std::get<loads::PointForce>(*o.loads[6].second.kind).nearest, (std::array<double, 3>{1, 2, 3}));
}

TEST(Deck, TakesEverySupportAndSpringByItsName) {
  const auto of = [](const std::string& type, const std::string& rest) {
    return parameter("type", "string", type) + parameter("set", "string", "cube/top") + rest;
  };
  const std::string first = "<ParameterList name=\"supports\">";
  const std::string moved =
      entries({of("velocity", parameter("x", "string", "t")),
               of("rotation", parameter("axis", "Array(double)", "{0, 0, 2}") + parameter("angle", "string", "90*t")),
               of("symmetry", parameter("start", "double", "1"))});
  const std::string sprung = entries(
      {of("nodes", parameter("x", "double", "2") + parameter("end", "double", "1")), of("bedding", parameter("z", "int", "3"))});
  const DeckOptions o = read_text(with(with_lists(list("springs", sprung)), first, first + moved));
  ASSERT_EQ(o.supports.size(), 4U);
  EXPECT_EQ(std::get<supports::Velocity>(o.supports[0].second.kind).velocity[0], "t");
  const auto& rotation = std::get<supports::Rotation>(o.supports[1].second.kind);
  EXPECT_EQ(rotation.axis, (std::array<double, 3>{0, 0, 2}));
  EXPECT_EQ(rotation.point, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(rotation.angle, "90*t");
  EXPECT_EQ(name_of_kind(o.supports[2].second.kind), "symmetry");
  EXPECT_EQ(o.supports[2].second.activity.start, 1);
  EXPECT_EQ(name_of_kind(o.supports[3].second.kind), "displacement");
  EXPECT_EQ(std::get<springs::Nodes>(*o.springs[0].second.kind).stiffness[0], 2);
  EXPECT_EQ(o.springs[0].second.activity.end, 1);
  EXPECT_EQ(std::get<springs::Bedding>(*o.springs[1].second.kind).stiffness[2], 3);
}

TEST(Deck, TakesRayleighDampingOfABody) {
  const std::string mesh = parameter("mesh", "string", "cube") + "\n";
  const std::string of_body = parameter("rayleigh mass", "double", "2") + parameter("rayleigh stiffness", "double", "1e-3") +
                              parameter("mass", "string", "lumped");
  const auto o = read_text(with(with(block_deck, elastic_parameters, density), mesh, mesh + of_body));
  const RayleighOptions& rayleigh = o.bodies[0].second.rayleigh;
  EXPECT_EQ(rayleigh.mass, 2);
  EXPECT_EQ(rayleigh.stiffness, 1e-3);
  EXPECT_EQ(o.bodies[0].second.mass, MassKind::lumped);
  EXPECT_FALSE(read_text(block_deck).bodies[0].second.rayleigh.exists());
}

TEST(Activity, HoldsAfterItsStartAndUpToItsEnd) {
  const Activity activity{0.5, 1, {}};
  EXPECT_FALSE(activity.acts_at(0.5));
  EXPECT_TRUE(activity.acts_at(0.6));
  EXPECT_TRUE(activity.acts_at(1));
  EXPECT_FALSE(activity.acts_at(1.1));
  EXPECT_TRUE(activity.acts_after(0.5));
  EXPECT_FALSE(activity.acts_after(1));
  EXPECT_TRUE(Activity{}.acts_at(0) && Activity{}.acts_after(0));
}

}  // namespace
}  // namespace mortise::test
