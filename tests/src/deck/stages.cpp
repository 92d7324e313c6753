// Decks with stages: what they say, when their entries act, and what is refused.
#include "deck/stages.hpp"

#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

const std::string time_list = block_deck.substr(block_deck.find("  <ParameterList name=\"time\">"));

std::string number(const std::string& name, const std::string& value) { return parameter(name, "double", value); }
std::string stage(const std::string& name, const std::string& parameters) {
  return "<ParameterList name=\"" + name + "\">" + parameters + "</ParameterList>";
}
std::string without(const std::string& entries) { return parameter("without", "Array(string)", "{" + entries + "}"); }

/// `block_deck` with a load, and stages in place of `time`.
std::string staged(const std::string& stages, const std::string& lists = "") {
  const std::string load = stage("weight", parameter("type", "string", "body force") + parameter("z", "string", "-1"));
  return with(with(block_deck, time_list,
                   "<ParameterList name=\"loads\">" + load + "</ParameterList>" + lists + "<ParameterList name=\"stages\">" +
                       stages + "</ParameterList></ParameterList>"),
              elastic_parameters, elastic_parameters + number("density", "1"));
}
const std::string hang = stage("hang", number("end", "1") + number("step", "0.5"));
std::string swing(const std::string& more = "", const std::string& end = "3", const std::string& scheme = "midpoint") {
  return stage("swing", parameter("scheme", "string", scheme) + number("end", end) + number("step", "0.1") + more);
}

TEST(Stages, FollowEachOtherWithTheirOwnSchemes) {
  const auto options =
      read_text(staged(hang + swing(without("loads/weight")) + stage("rest", number("end", "4") + number("step", "1"))));
  const auto stages = stages_of(options);
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[1].name, "swing");
  EXPECT_EQ(stages[1].begin, 1);
  EXPECT_TRUE(stages[1].scheme().has_inertia());
  EXPECT_FALSE(stages[2].scheme().has_inertia());
  EXPECT_TRUE(has_inertia(options));
  const Activity& weight = options.loads[0].second.activity;
  EXPECT_TRUE(weight.acts_at(1));
  EXPECT_FALSE(weight.acts_after(1));
  EXPECT_FALSE(weight.acts_at(3));
  EXPECT_TRUE(weight.acts_after(3));
  EXPECT_FALSE(weight.always());
  EXPECT_EQ(weight.last_time(2), 1);
  EXPECT_EQ(weight.last_time(4), 4);
  EXPECT_TRUE(options.supports[0].second.activity.always());
}

TEST(Stages, AreOneWhereADeckSaysTime) {
  const auto options = read_text(block_deck);
  const auto stages = stages_of(options);
  ASSERT_EQ(stages.size(), 1u);
  EXPECT_EQ(stages[0].time, &options.time);
  EXPECT_FALSE(has_inertia(options));
}

struct Fault {
  std::string name, deck;
  std::vector<std::string> words;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

const std::string start = "<ParameterList name=\"initial conditions\">" +
                          stage("cube", parameter("velocity", "Array(double)", "{1, 0, 0}")) + "</ParameterList>";
const std::vector<Fault> faults{
    {"NeitherTimeNorStages",
     with(block_deck, time_list, "</ParameterList>"),
     {"error[D12]", R"(exactly one of "time", "stages" must be set, none is)"}},
    {"TimeAndStages",
     with(staged(hang), "<ParameterList name=\"stages\">",
          stage("time", number("end", "1") + number("step", "1")) + "<ParameterList name=\"stages\">"),
     {"error[D12]", "stages - exactly one of", R"(but "time" is set already)"}},
    {"NoStages", staged(""), {"error[D18]", "stages"}},
    {"EndsBeforeItBegins",
     staged(hang + swing("", "0.5")),
     {"error[D08]", "stages > swing > \"end\" = 0.5 - must be after 1, where the stage before ends"}},
    {"StopBeforeItBegins",
     staged(hang + swing(parameter("stops", "Array(double)", "{0.5, 2}"))),
     {"error[D08]", "\"stops\"", "must be after 1"}},
    {"WithoutSomethingUnknown",
     staged(hang + swing(without("loads/wieght"))),
     {"error[D14]", "stages > swing > \"without\"", "there is no entry \"loads/wieght\"; did you mean \"loads/weight\"?"}},
    {"AllWithout",
     staged(stage("hang", number("end", "1") + number("step", "0.5") + without("loads/weight")) + swing(without("loads/weight"))),
     {"error[D15]", "loads > weight", "acts in no stage"}},
    {"ExplicitWithASupport",
     staged(hang + swing("", "3", "forward euler")),
     {"error[D19]", "stages > swing > \"scheme\" = \"forward euler\" - takes no supports"}},
    {"StartWithoutMotion",
     staged(hang + stage("more", number("end", "2") + number("step", "1")), start),
     {"error[D13]", "initial conditions > cube", "no stage has inertia"}},
    {"ExpectedAtNoStop",
     staged(hang + swing(), "<ParameterList name=\"expected\">" +
                                stage("e", parameter("quantity", "string", "total_energy") + number("at time", "2") +
                                               number("value", "1") + number("tolerance", "1")) +
                                "</ParameterList>"),
     {"error[D08]", "must be one of the \"stops\" and ends of the stages: 1, 3"}},
    {"StartsAfterTheLastEnd",
     with(staged(hang + swing()), parameter("z", "string", "-1"), parameter("z", "string", "-1") + number("start", "3")),
     {"error[D08]", "loads > weight > \"start\" = 3 - must be before stages > swing > \"end\" = 3"}},
    {"WordOfAnotherKind", staged(hang + swing(number("alpha", "0.1"))), {"error[D13]", "stages > swing > \"alpha\""}},
};

class BadStages : public testing::TestWithParam<Fault> {};

TEST_P(BadStages, GiveOneErrorWithItsWords) {
  const std::string message = errors_of(GetParam().deck);
  for (const std::string& one : GetParam().words) EXPECT_NE(message.find(one), std::string::npos) << one << "\n" << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

INSTANTIATE_TEST_SUITE_P(Decks, BadStages, testing::ValuesIn(faults), [](const auto& test) { return test.param.name; });

TEST(Stages, MayTakeAnExplicitSchemeWithoutTheSupport) {
  EXPECT_EQ(errors_of(staged(hang + swing(without("supports/bottom"), "3", "forward euler"))), "");
}

}  // namespace
}  // namespace mortise::test
