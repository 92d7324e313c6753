// Checkpoint files: what goes in comes out, what is damaged is refused, and something sound is always there.
#include "output/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "output/atomic_file.hpp"
#include "support/random.hpp"
#include "support/scratch_folder.hpp"
#include "support/text.hpp"

namespace mortise::test {
namespace {

Checkpoint example() {
  Checkpoint c;
  c.origin = {"1.2.3", "/a folder/deck \xC3\xBC.xml", "<ParameterList>\n", {{"slab", "abc"}, {"indenter", "def"}}};
  c.time = 0.1;
  c.dt = 1.0 / 3;
  c.pending_cuts = 2;
  c.done = {7, 3, 123456789012L, 5};
  c.frames = 8;
  c.x = {0.1, -0.0, 1e300, 5e-324, std::numeric_limits<double>::quiet_NaN(), 1 + 1e-16};
  c.v = {0.3, 0.4, -0.5};
  c.a = {1.5};
  c.search_x = {0.2, 0.3};
  c.search_reach = 0.7;
  c.search_inward = 0.9;
  c.ledger = {1, 2, 3, 4, 5, 6, 7, 10, 1e-17, 8, 9, 12, {1, 0, 1}, {0.5, -0.5, 0.25}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {1, 1, 2}};
  c.work = {11, 12, 13, 14, 0.1, 0.2, 0.3, 0.4};
  c.contact = {{21, 22, 23, 24}, {31, 32, 33, 34}};
  return c;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::string reason_against(const std::string& bytes) {
  try {
    from_bytes(bytes);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(CheckpointBytes, GiveBackEveryMemberToTheLastBit) {
  const Checkpoint c = example(), d = from_bytes(to_bytes(c));
  EXPECT_EQ(to_bytes(d), to_bytes(c));
  EXPECT_EQ(d.origin.program, c.origin.program);
  EXPECT_EQ(d.origin.deck_file, c.origin.deck_file);
  EXPECT_EQ(d.origin.deck_text, c.origin.deck_text);
  EXPECT_EQ(d.origin.meshes, c.origin.meshes);
  EXPECT_TRUE(same_bits({d.time, d.dt, d.search_reach, d.search_inward}, {c.time, c.dt, c.search_reach, c.search_inward}));
  EXPECT_TRUE(same_bits(d.x, c.x));
  EXPECT_TRUE(same_bits(d.v, c.v));
  EXPECT_TRUE(same_bits(d.a, c.a));
  EXPECT_TRUE(same_bits(d.search_x, c.search_x));
  EXPECT_TRUE(same_bits(d.ledger.angular_balance, c.ledger.angular_balance));
  EXPECT_EQ(d.pending_cuts, 2);
  EXPECT_EQ(d.done.newton_iterations, 123456789012L);
  EXPECT_EQ(d.frames, 8);
  EXPECT_EQ(d.ledger.closed, c.ledger.closed);
  EXPECT_TRUE(same_bits(d.ledger.weighted_gap, c.ledger.weighted_gap));
  EXPECT_EQ(d.ledger.damping, 7);
  EXPECT_EQ(d.ledger.mismatch, 1e-17);
  EXPECT_EQ(d.work.graphs, 14);
  ASSERT_EQ(d.contact.size(), 2u);
  EXPECT_EQ(d.contact[1].turned_away, 34);
}

TEST(CheckpointBytes, AreRefusedWithAnyBitFlippedOrAnyEndMissing) {
  const std::string good = to_bytes(example());
  for (std::size_t n = 0; n < good.size(); ++n) EXPECT_NE(reason_against(good.substr(0, n)), "") << "cut to " << n;
  EXPECT_NE(reason_against(good + '\0'), "");
  for (std::size_t k = 0; k < good.size(); ++k)
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[k] = static_cast<char>(bad[k] ^ 1 << bit);
      EXPECT_NE(reason_against(bad), "") << "byte " << k << ", bit " << bit;
    }
}

TEST(CheckpointBytes, OfAnotherFormatAreNamedAsSuch) {
  EXPECT_NE(reason_against(with(to_bytes(example()), "format 5", "format 4")).find("another version"), std::string::npos);
  EXPECT_NE(reason_against("<ParameterList/>").find("no checkpoint"), std::string::npos);
}

class CheckpointFolder : public testing::Test {
 protected:
  const ScratchFolder folder;

  void keep(int step) const {
    Checkpoint c = example();
    c.done.steps = step;
    write_checkpoint(folder / "", c);
  }
  Checkpoint newest() {
    warnings.clear();
    return read_newest_checkpoint(folder / "", warnings);
  }
  std::vector<std::string> warnings;
};

TEST_F(CheckpointFolder, KeepsTheLastTwo) {
  for (int step : {0, 9, 10, 11}) keep(step);
  folder.write("checkpoint.notes", "mine");
  std::vector<std::string> names;
  for (const auto& file : checkpoint_files(folder / "")) names.push_back(file.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"checkpoint.11", "checkpoint.10"}));
  EXPECT_EQ(newest().done.steps, 11);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(text_of(folder / "checkpoint.notes"), "mine");
}

TEST_F(CheckpointFolder, FallsBackToTheOneBeforeADamagedOne) {
  for (int step : {4, 5}) keep(step);
  std::filesystem::resize_file(folder / "checkpoint.5", 100);
  EXPECT_EQ(newest().done.steps, 4);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("checkpoint.5: error[I10]"), std::string::npos) << warnings[0];
}

TEST_F(CheckpointFolder, WithoutASoundOneIsRefusedWithTheReasons) {
  const auto message = [&] {
    try {
      newest();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message().find("error[I10] holds no checkpoint"), std::string::npos) << message();
  keep(3);
  std::filesystem::resize_file(folder / "checkpoint.3", 20);
  EXPECT_NE(message().find("checkpoint.3: error[I10]"), std::string::npos) << message();
}

TEST_F(CheckpointFolder, KeepsTheOldFileWhenTheNewOneCannotBeWritten) {
  folder.write("state", "old");
  std::filesystem::create_directories(folder / "state.tmp" / "in the way");
  EXPECT_THROW(write_atomically(folder / "state", "new"), FileError);
  EXPECT_EQ(text_of(folder / "state"), "old");
  std::filesystem::remove_all(folder / "state.tmp");
  write_atomically(folder / "state", "new");
  EXPECT_EQ(text_of(folder / "state"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "state.tmp"));
}

}  // namespace
}  // namespace mortise::test
