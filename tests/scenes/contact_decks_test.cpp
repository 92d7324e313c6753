// Decks of contact at rest that are tests by what they expect, on 1, 2 and 4 ranks.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/program.hpp"

namespace mortise::test {
namespace {

struct ContactDeck {
  const char* name;
  bool is_long;  ///< takes more than some seconds: more ranks than one only in the long tests
};

void PrintTo(const ContactDeck& deck, std::ostream* out) { *out << deck.name; }

class StaticDeck : public testing::TestWithParam<ContactDeck> {};

TEST_P(StaticDeck, MeetsWhatItExpectsOnAnyNumberOfRanks) {
  const std::string deck = input_deck(std::string(GetParam().name) + ".xml");
  const int n_expected = count_of(deck, "\"tolerance\"");
  ASSERT_GT(n_expected, 0);
  const bool is_short = GetParam().is_long && std::getenv("MORTISE_LONG") == nullptr;
  for (int ranks : is_short ? std::vector<int>{1} : std::vector<int>{1, 2, 4}) {
    const ScratchFolder folder;
    folder.write("deck.xml", deck);
    const auto run = run_mortise(folder, "run deck.xml -o out --quiet", ranks);
    EXPECT_EQ(run.code, 0) << ranks << " ranks\n" << run.out << run.err;
    EXPECT_EQ(count_of(run.out, ": met"), n_expected) << ranks << " ranks";
  }
}

INSTANTIATE_TEST_SUITE_P(Inputs, StaticDeck,
                         testing::Values(ContactDeck{"capstan/mu03", false}, ContactDeck{"capstan/mu12", false},
                                         ContactDeck{"cattaneo/cattaneo", true}, ContactDeck{"hertz/cylinder", false},
                                         ContactDeck{"hertz/sphere", true}, ContactDeck{"rotating_blocks/frictionless", true},
                                         ContactDeck{"rotating_blocks/frictional", true}));

}  // namespace
}  // namespace mortise::test
