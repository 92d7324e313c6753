// From XML text to the tree of lists and parameters.
#include "deck/xml_tree.hpp"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <string_view>

#include "deck/numbers.hpp"
#include "errors.hpp"
#include "utf8.hpp"

namespace mortise {

namespace {

const std::vector<std::string> parameter_types{"string", "double", "int", "bool", "Array(double)", "Array(int)", "Array(string)"};

/// Walks the document once; positions come from pugixml's offsets, which point behind the `<`.
class TreeBuilder {
 public:
  TreeBuilder(const LineTable& lines, std::vector<XmlProblem>& problems) : lines_(lines), problems_(problems) {}

  void fill(const pugi::xml_node& element, DeckList& list, int depth) {
    list.place = place(element);
    std::unordered_map<std::string, int> first_lines;
    for (const pugi::xml_node& child : element.children()) {
      if (is_ignored(child) || !is_element(child)) continue;
      const std::string kind = child.name();
      if (kind == "ParameterList") {
        add_list(child, list, depth, first_lines);
      } else if (kind == "Parameter") {
        add_parameter(child, list, first_lines);
      } else {
        const std::vector<std::string> elements{"ParameterList", "Parameter"};
        const std::string hint = did_you_mean(kind, elements);
        report("D02", child,
               "unknown element <" + kind + ">" + hint + (hint.empty() ? "; " : " ") + "allowed: " + join(elements));
      }
    }
  }

  /// Comments and processing instructions are no part of the deck.
  static bool is_ignored(const pugi::xml_node& node) {
    return node.type() == pugi::node_comment || node.type() == pugi::node_pi || node.type() == pugi::node_declaration;
  }

  /// False, with an error, for text.
  bool is_element(const pugi::xml_node& node) {
    if (node.type() == pugi::node_element) return true;
    report("D02", node, "unexpected text " + in_quotes(trimmed(node.value())) + " between elements");
    return false;
  }

  /// @return false if an attribute is missing or not allowed
  bool check_attributes(const pugi::xml_node& element, const std::vector<std::string>& allowed,
                        const std::vector<std::string>& required) {
    const std::string tag = std::string("<") + element.name() + ">";
    const std::size_t n_before = problems_.size();
    std::vector<std::string> seen;
    for (const pugi::xml_attribute& attribute : element.attributes()) {
      const std::string name = attribute.name();
      if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
        const std::string hint = did_you_mean(name, allowed);
        report("D03", element,
               "unknown attribute " + in_quotes(name) + " of " + tag + hint + (hint.empty() ? "; " : " ") +
                   "allowed: " + join(allowed));
      } else if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
        report("D03", element, "attribute " + in_quotes(name) + " of " + tag + " is given twice");
      }
      seen.push_back(name);
    }
    for (const std::string& name : required) {
      if (!element.attribute(name.c_str())) report("D03", element, "attribute \"" + name + "\" of " + tag + " is missing");
    }
    return problems_.size() == n_before;
  }

  void report(const std::string& code, const pugi::xml_node& node, const std::string& what) {
    problems_.push_back({code, place(node), what});
  }

 private:
  Place place(const pugi::xml_node& node) const {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    return lines_.place(node.type() == pugi::node_element && offset > 0 ? offset - 1 : offset);
  }

  /// @return false, with an error that names both lines, if the list has that name already
  bool is_new(const std::string& name, const pugi::xml_node& element, std::unordered_map<std::string, int>& first_lines) {
    const auto [entry, inserted] = first_lines.emplace(name, place(element).line);
    if (!inserted) {
      report("D05", element, in_quotes(name) + " is repeated; it stands in line " + std::to_string(entry->second) + " already");
    }
    return inserted;
  }

  void add_list(const pugi::xml_node& element, DeckList& parent, int depth, std::unordered_map<std::string, int>& first_lines) {
    check_attributes(element, {"name"}, {"name"});
    if (depth == DeckSource::deepest_nesting) {
      report("D04", element, "lists are nested deeper than " + std::to_string(DeckSource::deepest_nesting));
      return;
    }
    DeckList child;
    child.name = element.attribute("name").value();
    if (!element.attribute("name") || !is_new(child.name, element, first_lines)) return;
    fill(element, child, depth + 1);
    parent.list_index.emplace(child.name, parent.lists.size());
    parent.lists.push_back(std::move(child));
  }

  void add_parameter(const pugi::xml_node& element, DeckList& parent, std::unordered_map<std::string, int>& first_lines) {
    const std::vector<std::string> attributes{"name", "type", "value"};
    DeckParameter parameter;
    parameter.is_sound = check_attributes(element, attributes, attributes);
    parameter.name = element.attribute("name").value();
    parameter.type = element.attribute("type").value();
    parameter.value = element.attribute("value").value();
    parameter.place = place(element);
    if (element.attribute("type") &&
        std::find(parameter_types.begin(), parameter_types.end(), parameter.type) == parameter_types.end()) {
      const std::string hint = did_you_mean(parameter.type, parameter_types);
      report("D03", element,
             "unknown type " + in_quotes(parameter.type) + " of parameter " + in_quotes(parameter.name) + hint +
                 (hint.empty() ? "; " : " ") + "allowed: " + join(parameter_types));
      parameter.is_sound = false;
    }
    for (const pugi::xml_node& child : element.children()) {
      if (is_ignored(child) || !is_element(child)) continue;
      report("D02", child, std::string("element <") + child.name() + "> inside a <Parameter>");
    }
    if (!element.attribute("name") || !is_new(parameter.name, element, first_lines)) return;
    parent.parameter_index.emplace(parameter.name, parent.parameters.size());
    parent.parameters.push_back(std::move(parameter));
  }

  const LineTable& lines_;
  std::vector<XmlProblem>& problems_;
};

}  // namespace

/// The byte order mark of UTF-8: no editor counts it as a column.
constexpr std::string_view mark = "\xEF\xBB\xBF";

LineTable::LineTable(const std::string& text)
    : text_(text), line_starts_{text.compare(0, mark.size(), mark) == 0 ? mark.size() : 0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
}

Place LineTable::place(std::size_t offset) const {
  offset = std::clamp(offset, line_starts_.front(), text_.size());
  const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) - 1;
  const auto is_character_start = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
  const auto start = text_.begin() + static_cast<std::ptrdiff_t>(*line);
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(offset);
  return {static_cast<int>(line - line_starts_.begin()) + 1, static_cast<int>(std::count_if(start, end, is_character_start)) + 1};
}

bool build_tree(const std::string& text, DeckList& root, std::vector<XmlProblem>& problems) {
  const LineTable lines(text);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    problems.push_back({"D01", Place{}, "the file is empty"});
    return false;
  }
  if (const std::size_t bad = first_bad_byte(text); bad != std::string::npos) {
    problems.push_back({"D01", lines.place(bad), text[bad] == '\0' ? "NUL byte: not a text file" : "not UTF-8 text"});
    return false;
  }
  pugi::xml_document document;
  const unsigned options = pugi::parse_default | pugi::parse_doctype;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
  if (!parsed) {
    problems.push_back({"D01", lines.place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0))),
                        std::string("XML: ") + parsed.description()});
    return false;
  }

  TreeBuilder builder(lines, problems);
  pugi::xml_node top;
  for (const pugi::xml_node& node : document.children()) {
    if (node.type() == pugi::node_doctype) {
      builder.report("D01", node, "DOCTYPE is refused: a deck needs no document type and no entities");
      return false;
    }
    if (TreeBuilder::is_ignored(node) || !builder.is_element(node)) continue;
    if (top) {
      builder.report("D02", node, std::string("a second top element <") + node.name() + ">; a deck is one <ParameterList>");
      return false;
    }
    top = node;
  }
  if (!top || std::string(top.name()) != "ParameterList") {
    const std::string found = top ? std::string("<") + top.name() + ">" : std::string("nothing");
    problems.push_back({"D02", Place{}, "a deck is one <ParameterList>, found " + found});
    return false;
  }
  builder.check_attributes(top, {"name"}, {});
  root.name = top.attribute("name").value();
  builder.fill(top, root, 1);
  return true;
}

}  // namespace mortise
