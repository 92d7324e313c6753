// A deck that must be refused, and how it is judged.
#pragma once

#include "src/deck/decks.hpp"

namespace mortise::test {

/// A change to `block_deck`, and the one message it must give.
struct BadDeck {
  std::string name;
  std::string from, to;
  std::string place_and_code;  ///< "line:column: error[code]"
  std::vector<std::string> words;
};

/// Places in `block_deck` that are changed.
inline const std::string ratio = R"(type="double" value="0.25")", modulus = R"(type="double" value="2.5")";
inline const std::string recipe = parameter("recipe", "string", "block");
inline const std::string end = parameter("end", "double", "2");

inline void PrintTo(const BadDeck& bad, std::ostream* out) { *out << bad.name; }
inline std::string name_of(const testing::TestParamInfo<BadDeck>& test) { return test.param.name; }

inline void expect_one_error(const BadDeck& bad) {
  const std::string message = errors_of(with(block_deck, bad.from, bad.to));
  EXPECT_EQ(message.find("deck.xml:" + bad.place_and_code), 0u) << message;
  for (const std::string& word : bad.words) EXPECT_NE(message.find(word), std::string::npos) << word << "\n" << message;
  EXPECT_EQ(count_lines(message), 1u) << message;
}

}  // namespace mortise::test
