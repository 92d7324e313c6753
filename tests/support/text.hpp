// Decks as text: read, changed, put together.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace mortise::test {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The text of a deck of ours, e.g. "ironing/frictionless.xml".
inline std::string input_deck(const std::string& name) { return text_of(std::string(MORTISE_SOURCE_DIR) + "/inputs/" + name); }

/// `text` with the first place of `from` replaced. @throws std::logic_error if there is no such place
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the deck has no " + from);
  return text.replace(at, from.size(), to);
}

/// `text` without the list `name` of its top level.
inline std::string without_list(std::string text, const std::string& name) {
  const std::size_t begin = text.find("  <ParameterList name=\"" + name + "\">");
  if (begin == std::string::npos) throw std::logic_error("the deck has no list " + name);
  const std::string end_line = "\n  </ParameterList>\n";
  const std::size_t end = text.find(end_line, begin);
  return text.erase(begin, end + end_line.size() - begin);
}

/// `text` with further lists before its end.
inline std::string with_lists(std::string text, const std::string& lists) {
  return text.insert(text.rfind("</ParameterList>"), lists + "\n");
}

/// How often `word` stands in `text`.
inline int count_of(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
  return n;
}

/// A parameter, or a list with its content, as a deck has them.
inline std::string deck_parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>\n";
}
inline std::string word(const std::string& name, const std::string& value) { return deck_parameter(name, "string", value); }
inline std::string number(const std::string& name, const std::string& value) { return deck_parameter(name, "double", value); }
inline std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">\n" + content + "</ParameterList>\n";
}

}  // namespace mortise::test
