// Decks of dynamics: schemes with their numbers, starts, obstacles and rods; and what is refused, with its code and words.
#include "deck/scheme_options.hpp"
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

const std::string density = elastic_parameters + parameter("density", "double", "2");
const std::string time_list = R"(<ParameterList name="time">)", supports_list = R"(<ParameterList name="supports">)";

std::string dynamic(const std::string& scheme, const std::string& parameters = "") {
  return with(with(block_deck, elastic_parameters, density), time_list,
              time_list + parameter("scheme", "string", scheme) + parameters);
}

std::string before_time(const std::string& deck, const std::string& list, const std::string& name,
                        const std::string& parameters) {
  return with(deck, time_list,
              "<ParameterList name=\"" + list + "\"><ParameterList name=\"" + name + "\">" + parameters +
                  "</ParameterList></ParameterList>" + time_list);
}

std::string numbers(const std::string& name, const std::string& value) { return parameter(name, "Array(double)", value); }

TEST(DynamicDeck, KnowsEverySchemeByItsName) {
  for (const std::string& name : names_of_kinds<SchemeKind>()) {
    if (name == "forward euler") continue;  // takes no supports
    const auto options = read_text(name == "static" ? block_deck : dynamic(name));
    EXPECT_EQ(name_of_kind(options.time.scheme), name);
    EXPECT_EQ(scheme_of(options.time.scheme).has_inertia(), name != "static");
  }
}

TEST(DynamicDeck, HasTheNumbersOfTheAlphaSchemes) {
  const auto numbers_of = [](const std::string& scheme, const std::string& parameters) {
    return *scheme_of(read_text(dynamic(scheme, parameters)).time.scheme).alpha;
  };
  const AlphaNumbers a = numbers_of("generalised alpha", parameter("spectral radius", "double", "0.5"));
  EXPECT_NEAR(a.alpha_m, 0, 1e-15);
  EXPECT_NEAR(a.alpha_f, 1.0 / 3, 1e-15);
  EXPECT_NEAR(a.beta, 4.0 / 9, 1e-15);
  EXPECT_NEAR(a.gamma, 5.0 / 6, 1e-15);
  const AlphaNumbers hht = numbers_of("hht", parameter("alpha", "double", "0.1"));
  EXPECT_NEAR(hht.beta, 0.25 * 1.1 * 1.1, 1e-15);
  EXPECT_NEAR(hht.gamma, 0.6, 1e-15);
  const AlphaNumbers wbz = numbers_of("wbz", parameter("alpha", "double", "0.1"));
  EXPECT_EQ(wbz.alpha_m, -0.1);
  EXPECT_NEAR(wbz.beta, hht.beta, 1e-15);
  const AlphaNumbers own =
      numbers_of("generalised alpha", parameter("alpha m", "double", "0.1") + parameter("alpha f", "double", "0.2") +
                                          parameter("beta", "double", "0.4") + parameter("gamma", "double", "0.6"));
  EXPECT_EQ(own.beta, 0.4);
}

TEST(DynamicDeck, TakesStartsObstaclesAndRods) {
  std::string deck = before_time(dynamic("energy momentum"), "initial conditions", "cube", numbers("velocity", "{1, 2, 3}"));
  deck = before_time(deck, "obstacles", "floor",
                     parameter("type", "string", "plane") + parameter("set", "string", "cube/top") +
                         parameter("closing", "string", "persistent"));
  deck = before_time(deck, "rods", "rod",
                     parameter("mesh", "string", "cube") + parameter("node", "int", "1") + numbers("anchor", "{0, 0, -3}"));
  const auto options = read_text(deck);
  EXPECT_EQ(options.initial_conditions[0].second.velocity, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(options.obstacles[0].second.closing, Closing::persistent);
  EXPECT_EQ(name_of_kind(*options.obstacles[0].second.kind), "plane");
  EXPECT_EQ(options.rods[0].second.anchor[2], -3);
}

struct Refused {
  std::string name, deck, code, words;
};
void PrintTo(const Refused& r, std::ostream* out) { *out << r.name; }

class BadDynamics : public testing::TestWithParam<Refused> {};

TEST_P(BadDynamics, AreRefusedWithCodeAndWords) {
  const std::string message = errors_of(GetParam().deck);
  EXPECT_NE(message.find("error[" + GetParam().code + "]"), std::string::npos) << message;
  EXPECT_NE(message.find(GetParam().words), std::string::npos) << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

const std::string plane = parameter("type", "string", "plane") + parameter("set", "string", "cube/top");

const std::vector<Refused> refused{
    {"NoDensity", with(block_deck, time_list, time_list + parameter("scheme", "string", "midpoint")), "D07",
     R"(required "density" is missing: time > "scheme" = "midpoint" needs it)"},
    {"UnknownScheme", dynamic("midpiont"), "D10", "did you mean"},
    {"ParameterOfAnotherScheme", dynamic("midpoint", parameter("spectral radius", "double", "0.5")), "D13", "generalised alpha"},
    {"SomeOfTheAlphaNumbers", dynamic("generalised alpha", parameter("beta", "double", "0.3")), "D07", "\"alpha m\""},
    {"RadiusAndNumbers",
     dynamic("generalised alpha", parameter("spectral radius", "double", "0.5") + parameter("alpha m", "double", "0.1") +
                                      parameter("alpha f", "double", "0.2") + parameter("beta", "double", "0.4") +
                                      parameter("gamma", "double", "0.6")),
     "D19", "cannot stand beside"},
    {"UnstableNumbers", dynamic("newmark", parameter("beta", "double", "0.1")), "D19", "allow unstable"},
    {"AverageAccelerationWithContact", before_time(dynamic("newmark"), "obstacles", "floor", plane), "D19", "3 to 23 times"},
    {"AverageAccelerationOfMassesWithContact",
     before_time(before_time(with(dynamic("newmark"), parameter("mesh", "string", "cube") + "\n",
                                  parameter("mesh", "string", "cube") + parameter("mass", "string", "lumped off contact") + "\n"),
                             "obstacles", "floor", plane),
                 "masses", "lead", parameter("set", "string", "cube/top") + parameter("mass", "double", "2")),
     "D19", "3 to 23 times"},
    {"VelocityUpdateOfASchemeWithAccelerations",
     before_time(dynamic("hht"), "obstacles", "floor", plane + parameter("closing", "string", "velocity update")), "D19",
     "carries accelerations on"},
    {"ExplicitWithSupports", dynamic("forward euler"), "D19", "it is explicit"},
    {"EnergyMomentumOfFBar",
     with(dynamic("energy momentum"), parameter("mesh", "string", "cube") + "\n",
          parameter("mesh", "string", "cube") + parameter("formulation", "string", "f-bar") + "\n"),
     "D19", "must be \"standard\""},
    {"StartOfNoBody", before_time(dynamic("midpoint"), "initial conditions", "cub", numbers("velocity", "{1, 0, 0}")), "D14",
     "there is no body"},
    {"StartInStatics", before_time(block_deck, "initial conditions", "cube", numbers("velocity", "{1, 0, 0}")), "D13",
     "only in dynamics"},
    {"ErrorToleranceInStatics", with(block_deck, time_list, time_list + parameter("error tolerance", "double", "1e-3")), "D13",
     "inertia"},
    {"CentreWithoutSpin", before_time(dynamic("midpoint"), "initial conditions", "cube", numbers("centre", "{1, 0, 0}")), "D13",
     "angular velocity"},
    {"ObstacleWithoutShape", before_time(dynamic("midpoint"), "obstacles", "floor", parameter("set", "string", "cube/top")),
     "D07", "\"type\" is missing"},
    {"SphereWithoutRadius",
     before_time(dynamic("midpoint"), "obstacles", "ball",
                 parameter("type", "string", "sphere") + parameter("set", "string", "cube/top")),
     "D07", "\"radius\""},
    {"RodWithoutNode", before_time(dynamic("midpoint"), "rods", "rod", parameter("mesh", "string", "cube")), "D12", "\"node\""},
    {"NameTakenTwice",
     before_time(before_time(dynamic("midpoint"), "obstacles", "a", plane), "rods", "a",
                 parameter("mesh", "string", "cube") + parameter("node", "int", "1")),
     "D11", "is taken"},
};
INSTANTIATE_TEST_SUITE_P(Wrong, BadDynamics, testing::ValuesIn(refused),
                         [](const testing::TestParamInfo<Refused>& test) { return test.param.name; });

}  // namespace
}  // namespace mortise::test
