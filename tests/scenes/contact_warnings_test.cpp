// What the program says about pairs of surfaces that are of no use, or the wrong way round.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace mortise::test {
namespace {

/// A block that is moved towards another one, which is half a length below it.
struct Approach {
  std::string moved = "-0.6*t", upper_modulus = "10", upper_elements = "{2, 2, 1}";

  operator std::string() const {
    const auto block = [](const std::string& z, const std::string& elements) {
      return word("recipe", "block") + deck_parameter("size", "Array(double)", "{1, 1, 1}") +
             deck_parameter("elements", "Array(int)", elements) + deck_parameter("origin", "Array(double)", "{0, 0, " + z + "}");
    };
    const auto rubber = [](const std::string& E) {
      return word("model", "neo-hookean") + number("youngs modulus", E) + number("poissons ratio", "0.3");
    };
    const auto held = [](const std::string& set, const std::string& z) {
      return word("set", set) + word("x", "0") + word("y", "0") + word("z", z);
    };
    return list("approach",
                list("meshes", list("lower", block("0", "{2, 2, 1}")) + list("upper", block("1.5", upper_elements))) +
                    list("materials", list("soft", rubber("10")) + list("of upper", rubber(upper_modulus))) +
                    list("bodies", list("lower", word("mesh", "lower") + word("material", "soft")) +
                                       list("upper", word("mesh", "upper") + word("material", "of upper"))) +
                    list("supports", list("ground", held("lower/bottom", "0")) + list("hand", held("upper/top", moved))) +
                    list("contact", list("pair", word("secondary", "upper/bottom") + word("primary", "lower/top"))) +
                    list("time", number("step", "0.5") + number("end", "1")));
  }
};

struct ContactWarnings : testing::Test {
  ScratchFolder folder;
  Finished run(const std::string& deck, int ranks = 1) {
    folder.write("deck.xml", deck);
    return run_mortise(folder, "run deck.xml --quiet --overwrite -o out", ranks);
  }
  Finished check(const std::string& deck) {
    folder.write("deck.xml", deck);
    return run_mortise(folder, "check deck.xml");
  }
};

const std::string idle = "warning: contact > pair: the two sides never touched", stiff = "is much stiffer than the primary side";

TEST_F(ContactWarnings, TellOfAPairThatNeverTouches) {
  Approach deck;
  deck.moved = "-0.4*t";
  for (int ranks : {1, 2}) {
    const auto finished = run(deck, ranks);
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_EQ(count_of(finished.err, idle), 1) << finished.err;
    EXPECT_EQ(count_of(text_of(folder / "out/run.log"), idle), 1);
    EXPECT_EQ(count_of(text_of(folder / "out/summary.json"), "the two sides never touched"), 1);
  }
}

TEST_F(ContactWarnings, DoNotTellOfAPairThatTouchesOnce) {
  for (const char* moved : {"-0.6*t", "-1.2*min(t,1-t)"}) {  // at the end, or in between
    Approach deck;
    deck.moved = moved;
    const auto finished = run(deck);
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_EQ(finished.err, "");
    EXPECT_EQ(count_of(text_of(folder / "out/summary.json"), "\"warnings\": []"), 1);
  }
}

TEST_F(ContactWarnings, TellOfASecondarySideThatIsMuchStifferUnlessItIsFiner) {
  Approach deck;
  EXPECT_EQ(count_of(check(deck).out, stiff), 0);
  deck.upper_modulus = "2000";
  const auto finished = check(deck);
  EXPECT_EQ(finished.code, 0);
  EXPECT_EQ(count_of(finished.out, "warning: contact > pair: the secondary side " + stiff), 1) << finished.out;
  EXPECT_EQ(count_of(finished.out, "(Young's moduli of 2e+03 and 10)"), 1) << finished.out;
  deck.upper_elements = "{3, 3, 1}";
  EXPECT_EQ(count_of(check(deck).out, stiff), 0);
}

TEST_F(ContactWarnings, TellOfASecondarySideThatIsCoarser) {
  Approach deck;
  deck.upper_elements = "{1, 1, 1}";
  EXPECT_EQ(count_of(check(deck).out, "coarser"), 0);  // twice as coarse is not worth a word
  EXPECT_EQ(count_of(check(with(deck, "{2, 2, 1}", "{4, 4, 1}")).out, "the secondary side is coarser than the primary side"), 1);
}

}  // namespace
}  // namespace mortise::test
