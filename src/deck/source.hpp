// A ParameterList XML file as a plain tree that remembers where each list and parameter stands in the text.
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace mortise {

/// Line and column in the deck, from 1; columns count characters, not bytes.
struct Place {
  int line = 1;
  int column = 1;
};

/// `<Parameter name type value/>`, unparsed.
struct DeckParameter {
  std::string name;
  std::string type;
  std::string value;
  Place place;           ///< of the `<`
  bool is_sound = true;  ///< false: an attribute is missing or wrong, which has been reported
};

/// `<ParameterList name>` with its entries in the order of the text; names are unique.
struct DeckList {
  std::string name;
  Place place;  ///< of the `<`
  std::vector<DeckParameter> parameters;
  std::vector<DeckList> lists;
  std::unordered_map<std::string, std::size_t> parameter_index, list_index;

  /// The entry of that name, or null.
  const DeckParameter* parameter(const std::string& entry) const;
  const DeckList* list(const std::string& entry) const;
};

/// One error of a deck: the complete line to print, and the place that orders it among the others.
struct DeckProblem {
  Place place;
  std::string text;
};

/// The text of a deck, and its tree.
class DeckSource {
 public:
  static constexpr std::size_t largest_file = 16u << 20;  ///< bytes
  static constexpr int deepest_nesting = 32;

  /// @throws FileError when the file cannot be read; DeckError as the constructor below
  static DeckSource read(const std::filesystem::path& file);

  /// @param file the name used in messages
  /// @throws DeckError for text that is not well-formed XML; errors inside well-formed XML are kept in `problems()`
  DeckSource(const std::filesystem::path& file, std::string text);

  const std::string& text() const { return text_; }
  const DeckList& root() const { return root_; }

  /// Unknown elements and attributes, missing attributes, repeated names.
  const std::vector<DeckProblem>& problems() const { return problems_; }

  /// An error at a list or parameter; where the path does not exist, at its nearest ancestor.
  /// @param path names from the root, which itself is left out: {"time", "step"}
  /// @param what what is wrong and what is allowed
  /// @param unit of the value, in words ("force/length^2"); printed with the deck's labels if it has `units`
  DeckProblem problem(const std::string& code, const std::vector<std::string>& path, const std::string& what,
                      const std::string& unit = "") const;

  /// `file:line:col: error[code] what`
  DeckProblem problem(const std::string& code, Place place, const std::string& what) const;

 private:
  std::string labelled(std::string unit) const;

  std::string file_;
  std::string text_;
  DeckList root_;
  std::vector<DeckProblem> problems_;
};

/// `value` in quotes, shortened if long, control characters replaced: user text made fit for one line.
std::string in_quotes(const std::string& value);

}  // namespace mortise
