// Reads the text of a deck, and words its errors.
#include "deck/source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "deck/numbers.hpp"
#include "deck/xml_tree.hpp"
#include "errors.hpp"

namespace mortise {

namespace {

std::string replace_all(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// A number as written, any other value in quotes.
std::string shown(const DeckParameter& parameter) {
  double number = 0;
  const bool is_number = parameter.type == "double" || parameter.type == "int";
  const bool is_plain = parameter.value.size() <= 40 && parameter.value.find_first_of(" \t\r\n") == std::string::npos;
  return is_number && is_plain && parse(parameter.value, number).empty() ? parameter.value : in_quotes(parameter.value);
}

}  // namespace

std::string in_quotes(const std::string& value) {
  constexpr std::size_t longest = 60;
  std::string text = value;
  if (text.size() > longest) {
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;  // not inside a character
    text = text.substr(0, cut) + "...";
  }
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  return '"' + text + '"';
}

const DeckParameter* DeckList::parameter(const std::string& entry) const {
  const auto found = parameter_index.find(entry);
  return found == parameter_index.end() ? nullptr : &parameters[found->second];
}

const DeckList* DeckList::list(const std::string& entry) const {
  const auto found = list_index.find(entry);
  return found == list_index.end() ? nullptr : &lists[found->second];
}

DeckSource DeckSource::read(const std::filesystem::path& file) {
  const auto unreadable = [&](const std::string& why) { return FileError(file.string() + ": error[I01] " + why); };
  std::error_code status;
  if (!std::filesystem::exists(file, status)) throw unreadable(status ? status.message() : "no such file");
  if (!std::filesystem::is_regular_file(file, status)) {
    throw unreadable(std::filesystem::is_directory(file, status) ? "is a directory, not a file" : "not a file");
  }
  const auto size = std::filesystem::file_size(file, status);
  if (!status && size > largest_file) {
    throw DeckError(file.string() + ":1:1: error[D04] the file has " + std::to_string(size) + " bytes - must be at most 16 MB");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) throw unreadable(std::string("cannot be opened: ") + std::strerror(errno));
  std::ostringstream text;
  if (size > 0) text << in.rdbuf();
  if (in.bad() || text.bad()) throw unreadable(std::string("cannot be read: ") + std::strerror(errno));
  return DeckSource(file, text.str());
}

DeckSource::DeckSource(const std::filesystem::path& file, std::string text) : file_(file.string()), text_(std::move(text)) {
  if (text_.size() > largest_file) throw DeckError(file_ + ":1:1: error[D04] the text is larger than 16 MB");
  std::vector<XmlProblem> found;
  const bool has_tree = build_tree(text_, root_, found);
  for (const XmlProblem& one : found) problems_.push_back(problem(one.code, one.place, one.what));
  if (has_tree) return;
  std::vector<std::string> messages;
  for (const DeckProblem& one : problems_) messages.push_back(one.text);
  throw DeckError(messages);
}

DeckProblem DeckSource::problem(const std::string& code, Place place, const std::string& what) const {
  return {place, file_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": error[" + code + "] " + what};
}

DeckProblem DeckSource::problem(const std::string& code, const std::vector<std::string>& path, const std::string& what,
                                const std::string& unit) const {
  const DeckList* list = &root_;
  Place place = root_.place;
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) text += " > ";
    const DeckList* below = list == nullptr ? nullptr : list->list(path[i]);
    const DeckParameter* parameter = list == nullptr || below != nullptr ? nullptr : list->parameter(path[i]);
    if (below != nullptr) {
      place = below->place;
      text += path[i];
    } else {
      text += in_quotes(path[i]);
    }
    if (parameter != nullptr) {
      place = parameter->place;
      const std::string label = labelled(unit);
      if (i + 1 == path.size()) text += " = " + shown(*parameter) + (label.empty() ? "" : " " + label);
    }
    list = below;
  }
  return problem(code, place, text + (text.empty() ? "" : " - ") + what);
}

/// The unit in the deck's labels ("N/mm^2"); empty without a dimension, or if the deck has no label for one of them.
std::string DeckSource::labelled(std::string unit) const {
  const DeckList* labels = root_.list("units");
  bool has_dimension = false;
  for (const char* dimension : {"length", "force", "time"}) {
    if (unit.find(dimension) == std::string::npos) continue;
    const DeckParameter* label = labels == nullptr ? nullptr : labels->parameter(dimension);
    if (label == nullptr || label->value.empty() || label->value.size() > 10) return "";
    unit = replace_all(unit, dimension, label->value);
    has_dimension = true;
  }
  return has_dimension ? unit : "";
}

}  // namespace mortise
