// Decks of dynamic scenes that are tests by what they expect; and output that changes nothing.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace mortise::test {
namespace {

class DynamicDeck : public testing::TestWithParam<const char*> {};

TEST_P(DynamicDeck, MeetsWhatItExpects) {
  const ScratchFolder folder;
  const std::string deck = input_deck(std::string(GetParam()) + ".xml");
  ASSERT_GT(count_of(deck, "\"tolerance\""), 0);
  folder.write("deck.xml", deck);
  const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_GT(count_of(run.out, ": met"), 0);
}

INSTANTIATE_TEST_SUITE_P(Inputs, DynamicDeck,
                         testing::Values("bar_on_wall/backward_euler", "bar_on_wall/persistent", "flat_pendulum/backward_euler",
                                         "flat_pendulum/energy_momentum", "frictional_blocks/mu02", "frictional_blocks/mu08",
                                         "incline/resting", "incline/sliding", "released_beam/energy_momentum",
                                         "mass_point/modified", "mass_point/standard", "spring_pendulum/augmented",
                                         "spring_pendulum/soft_forward_euler", "spring_pendulum/stiff_energy_momentum_coarse",
                                         "spring_pendulum/stiff_generalised_alpha"));

// F3 of the catalogue of hard cases: more fields, frames at times between the steps, a probe more, and the same digits.
TEST(Observers, ChangeNoDigitOfTheSolution) {
  const ScratchFolder folder;
  const std::string deck = input_deck("bar_on_wall/persistent.xml");
  std::string observed = with(deck, "{displacement, velocity, contact pressure, gap}",
                              "{displacement, velocity, acceleration, von mises, cauchy stress, reaction, status}");
  observed = with(observed, "<Parameter name=\"every\"  type=\"int\"           value=\"10\"/>",
                  deck_parameter("every", "int", "7") + deck_parameter("times", "Array(double)", "{0.111, 0.5, 0.77777}"));
  folder.write("plain.xml", deck);
  folder.write("observed.xml", observed);
  for (const char* name : {"plain", "observed"})
    ASSERT_EQ(run_mortise(folder, "run " + std::string(name) + ".xml -o " + name + " --quiet").code, 0);
  const Table plain = read_history(folder / "plain" / "history.csv"), other = read_history(folder / "observed" / "history.csv");
  for (const char* column : {"time", "kinetic_energy", "strain_energy", "contact_force_x.wall", "linear_momentum_x", "gap.tip"})
    EXPECT_EQ(plain[column], other[column]) << column;
}

}  // namespace
}  // namespace mortise::test
