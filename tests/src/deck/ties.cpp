// Decks of ties and of ways to enforce contact: good ones are read, bad ones give their place and words.
#include "src/deck/decks.hpp"

namespace mortise::test {
namespace {

std::string errors_of_lists(const std::string& lists) { return errors_of(with_lists(lists)); }

std::string with_entry(const std::string& list, const std::string& parameters) {
  return "<ParameterList name=\"" + list + "\"><ParameterList name=\"pair\">\n" + parameter("secondary", "string", "cube/top") +
         "\n" + parameter("primary", "string", "cube/bottom") + "\n" + parameters + "</ParameterList></ParameterList>";
}

TEST(Ties, AreReadWithTheirDefaults) {
  const Deck deck = Deck::from_text("deck.xml", with_lists(with_entry("ties", "")));
  const TieOptions& tie = deck.options().ties[0].second;
  EXPECT_EQ(tie.secondary, "cube/top");
  EXPECT_EQ(tie.form, TieForm::automatic);
  EXPECT_FALSE(tie.largest_gap);
  EXPECT_EQ(tie.quadrature_degree, 5);
}

TEST(Ties, ThatAreWrongAreRefusedWithTheReason) {
  std::string message = errors_of_lists(with_entry("ties", parameter("form", "string", "frame invariance")));
  EXPECT_NE(message.find("did you mean \"frame invariant\"? allowed: automatic, frame invariant, plain"), std::string::npos)
      << message;
  message = errors_of_lists(with_entry("ties", parameter("largest gap", "double", "0")));
  EXPECT_NE(message.find("error[D08] ties > pair > \"largest gap\" = 0 - must be > 0"), std::string::npos) << message;
  message = errors_of_lists(with_entry("contact", "") + with_entry("ties", ""));
  EXPECT_NE(message.find("error[D11] ties > pair - this name is taken by an entry of `contact`, `ties`"), std::string::npos)
      << message;
  message = errors_of_lists("<ParameterList name=\"ties\"><ParameterList name=\"pair\">" +
                            parameter("secondary", "string", "cube/top") + parameter("primary", "string", "cube/top") +
                            "</ParameterList></ParameterList>");
  EXPECT_NE(message.find("error[D19] ties > pair > \"primary\" = \"cube/top\" - is the secondary surface too"), std::string::npos)
      << message;
  message = errors_of_lists("<ParameterList name=\"output\">" + parameter("fields", "Array(string)", "{tie traction}") +
                            "</ParameterList>");
  EXPECT_NE(message.find("there is no \"tie traction\": the deck has no ties"), std::string::npos) << message;
  message = errors_of_lists(with_entry("ties", "") + "<ParameterList name=\"output\">" +
                            parameter("fields", "Array(string)", "{contact pressure}") + "</ParameterList>");
  EXPECT_NE(message.find("there is no \"contact pressure\": the deck has no contact"), std::string::npos) << message;
}

TEST(Enforcement, AsksForWhatItNeedsAndForNothingElse) {
  std::string message = errors_of_lists(with_entry("contact", parameter("enforcement", "string", "penalty")));
  EXPECT_NE(message.find("error[D07] contact > pair > \"enforcement\""), std::string::npos) << message;
  EXPECT_NE(message.find("needs \"normal penalty\""), std::string::npos) << message;
  message = errors_of_lists(with_entry("contact", parameter("normal penalty", "double", "1")));
  EXPECT_NE(message.find("error[D13] contact > pair > \"normal penalty\""), std::string::npos) << message;
  message = errors_of_lists(with_entry("contact", parameter("enforcement", "string", "penalty") +
                                                      parameter("normal penalty", "double", "1") +
                                                      parameter("largest penetration", "double", "1")));
  EXPECT_NE(message.find("error[D13] contact > pair > \"largest penetration\""), std::string::npos) << message;
  message = errors_of_lists(with_entry("contact", parameter("complementarity", "string", "fischer burmeister") +
                                                      parameter("friction coefficient", "double", "0.1")));
  EXPECT_NE(message.find("error[D19] contact > pair > \"complementarity\""), std::string::npos) << message;
}

}  // namespace
}  // namespace mortise::test
