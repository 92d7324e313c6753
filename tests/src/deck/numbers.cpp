// Numbers and arrays of the deck as texts.
#include "deck/numbers.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <locale>

#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

TEST(Numbers, AreReadToTheLastDigit) {
  double value = 0;
  for (const double expected : {0., 1., -0.1, 1. / 3, 5e-324, 1.7976931348623157e308}) {
    EXPECT_EQ(parse(shortest(expected), value), "");
    EXPECT_EQ(value, expected);
  }
  for (const auto& [text, expected] : {std::pair{" 2.5\t", 2.5}, {"+3", 3.}, {".5", 0.5}, {"1.", 1.}, {"-1E+2", -100.}}) {
    EXPECT_EQ(parse(text, value), "") << text;
    EXPECT_EQ(value, expected);
  }
}

TEST(Numbers, OfOtherKindsAreRefusedAndLeaveTheValue) {
  double value = 7;
  for (const char* text : {"", " ", "abc", "1,5", "1e", "0x10", "inf", "-inf", "nan", "1e999", "1e-999", "1 2", "1.5m", "++1",
                           "+-1", "--1", "1..2"}) {
    EXPECT_NE(parse(text, value), "") << text;
  }
  EXPECT_EQ(value, 7);
  int integer = 7;
  for (const char* text : {"", "1.0", "2147483648", "-2147483649", "18446744073709551616", "1e3", "0x1", "one"}) {
    EXPECT_NE(parse(text, integer), "") << text;
  }
  EXPECT_EQ(integer, 7);
  bool truth = true;
  EXPECT_NE(parse("1", truth), "");
  EXPECT_EQ(parse(" false ", truth), "");
  EXPECT_FALSE(truth);
}

TEST(Numbers, AtTheEndsOfIntAreRead) {
  int value = 0;
  EXPECT_EQ(parse("2147483647", value), "");
  EXPECT_EQ(value, std::numeric_limits<int>::max());
  EXPECT_EQ(parse("-2147483648", value), "");
  EXPECT_EQ(value, std::numeric_limits<int>::min());
}

TEST(Arrays, AreSplitAtCommas) {
  std::vector<std::string> entries;
  EXPECT_EQ(split_array(" {von mises, gap ,status} ", entries), "");
  EXPECT_EQ(entries, (std::vector<std::string>{"von mises", "gap", "status"}));
  EXPECT_EQ(split_array("{ }", entries), "");
  EXPECT_TRUE(entries.empty());
  for (const char* text : {"", "{", "}", "1, 2", "{1,,2}", "{1,}", "{,1}", "{{1}}", "{1} {2}", "{1} x"}) {
    EXPECT_NE(split_array(text, entries), "") << text;
  }
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Numbers, AndFormulasAreTheSameWithADecimalCommaInTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const std::string text =
      with(with(block_deck, R"(value="2.5")", R"(value="12345.5")"), R"(value="0"/>)", R"(value="1234.5*t"/>)");
  const DeckOptions o = read_text(text);
  const std::string message = errors_of(with(text, R"(value="0.5")", R"(value="1234567.5")"));
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(std::get<models::NeoHookean>(*o.materials[0].second.model).youngs_modulus, 12345.5);
  EXPECT_EQ(message.find("deck.xml:28:5: error[D08] time > \"step\" = 1234567.5 - must be at most \"end\" = 2"), 0u) << message;
}

}  // namespace
}  // namespace mortise::test
