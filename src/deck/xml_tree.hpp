// From XML text to the tree of lists and parameters, by pugixml: the only place that knows XML.
#pragma once

#include <string>
#include <vector>

#include "deck/source.hpp"

namespace mortise {

/// An error found in the text: code, place and words; the caller adds the name of the file.
struct XmlProblem {
  std::string code;
  Place place;
  std::string what;
};

/// Places of byte offsets in a text.
class LineTable {
 public:
  explicit LineTable(const std::string& text);
  Place place(std::size_t offset) const;

 private:
  const std::string& text_;
  std::vector<std::size_t> line_starts_;
};

/// The tree of a ParameterList text.
/// @param problems gets every error; after one that leaves no tree (`false` is returned) nothing else is worth checking
bool build_tree(const std::string& text, DeckList& root, std::vector<XmlProblem>& problems);

}  // namespace mortise
