// Prints the RELAX NG schema of decks from the descriptions that the reader uses, for editors and validators.
#include <pugixml.hpp>

#include "deck/deck.hpp"
#include "deck/descriptions.hpp"
#include "deck/values.hpp"

namespace mortise {

namespace {

// Patterns of XML Schema part 2, appendix F; \s is blank, tab or line end.
const std::string number_pattern = R"([+\-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+\-]?[0-9]+)?)", integer_pattern = R"([+\-]?[0-9]+)",
                  entry_pattern = R"([^,{}\s]([^,{}]*[^,{}\s])?)",  // of an Array(string)
    not_blank_pattern = R"((.|\s)*\S(.|\s)*)", chosen_name_pattern = R"([^,./"'\s]([^,./"'\t\n\r]*[^,./"'\s])?)";

/// The entries an array must have; 0: any number but none.
template <class T>
std::size_t fixed_count(const T&) {
  return 0;
}
template <class T, std::size_t N>
std::size_t fixed_count(const std::array<T, N>&) {
  return N;
}
template <class T>
std::size_t fixed_count(const std::optional<T>&) {
  return fixed_count(T{});
}

std::string spaced(const std::string& pattern) { return R"(\s*)" + pattern + R"(\s*)"; }

/// `{a, b}` with `count` entries; 0: one or more.
std::string array_pattern(const std::string& entry, std::size_t count) {
  const std::string further = count == 0 ? "*" : "{" + std::to_string(count - 1) + "}";
  return spaced(R"(\{)" + spaced(entry) + "(," + spaced(entry) + ")" + further + R"(\})");
}

/// What a value of that type looks like.
std::string pattern_of(const std::string& type, std::size_t count) {
  if (type == "double") return spaced(number_pattern);
  if (type == "bool") return spaced("(true|false)");
  if (type == "Array(double)") return array_pattern(number_pattern, count);
  if (type == "Array(int)") return array_pattern(integer_pattern, count);
  if (type == "Array(string)") return array_pattern(entry_pattern, count);
  return not_blank_pattern;
}

pugi::xml_node add_element(pugi::xml_node parent, const char* name) {
  pugi::xml_node element = parent.append_child("element");
  element.append_attribute("name") = name;
  return element;
}

pugi::xml_node add_attribute(pugi::xml_node parent, const char* name) {
  pugi::xml_node attribute = parent.append_child("attribute");
  attribute.append_attribute("name") = name;
  return attribute;
}

/// Exactly this text.
void add_value(pugi::xml_node parent, const std::string& text) {
  pugi::xml_node value = parent.append_child("value");
  value.append_attribute("type") = "string";
  value.text() = text.c_str();
}

void add_pattern(pugi::xml_node parent, const std::string& pattern) {
  pugi::xml_node data = parent.append_child("data");
  data.append_attribute("type") = "string";
  pugi::xml_node param = data.append_child("param");
  param.append_attribute("name") = "pattern";
  param.text() = pattern.c_str();
}

/// The entries of a list, in any order: the node to which they are added.
pugi::xml_node add_entries(pugi::xml_node list) { return list.append_child("zeroOrMore").append_child("choice"); }

/// The schema's kind of Fields (fields.hpp): one object adds the entries of one list. What ties parameters together, their
/// bounds, and which of them are required or repeated, is left to `mortise check`.
class SchemaPrinter {
 public:
  explicit SchemaPrinter(pugi::xml_node entries) : entries_(entries) {}

  template <class T>
  void required(const std::string& name, const T& target, const Bound&, const std::string&, const std::string& help) {
    typed(name, type_name(target), fixed_count(target), help);
  }

  template <class T>
  void optional(const std::string& name, const T& target, const Bound&, const std::string&, const std::string& help) {
    typed(name, type_name(target), fixed_count(target), help);
  }

  template <class T, class V>
  void choice(const std::string& name, const T&, const Choices<V>& choices, Presence, const std::string& help) {
    pugi::xml_node words = typed_value(parameter(name, help), "string").append_child("choice");
    for (const std::string& word : names_of(choices)) add_value(words, word);
  }

  /// The parameters of all kinds are allowed side by side: which belong together is left to `mortise check` too.
  template <class Kinds>
  void kind(const std::string& name, Kinds&, Presence, const std::string& help) {
    pugi::xml_node words = typed_value(parameter(name, help), "string").append_child("choice");
    for (const std::string& word : names_of_kinds<Kinds>()) add_value(words, word);
    for_each_kind<Kinds>([&](auto kind) { describe(*this, kind); });
  }

  void words(const std::string& name, const std::vector<std::string>&, const std::vector<std::string>& allowed,
             const std::string& help) {
    std::string any;  // of letters and blanks, which mean themselves in a pattern
    for (const std::string& word : allowed) any += (any.empty() ? "" : "|") + word;
    const std::string some = array_pattern("(" + any + ")", 0), none = spaced(R"(\{\s*\})");
    add_pattern(typed_value(parameter(name, help), "Array(string)"), some + "|" + none);
  }

  void formula(const std::string& name, const std::optional<std::string>&, const std::string&, const std::string& help) {
    typed(name, "string", 0, help);
  }

  void number_or_formula(const std::string& name, const std::optional<NumberOrFormula>&, const Bound&,
                         const std::vector<std::string>&, const std::string&, const std::string& help) {
    pugi::xml_node alternatives = parameter(name, help);
    add_typed(alternatives, "double", 0);
    add_typed(alternatives, "string", 0);
  }

  template <class Options>
  void list(const std::string& name, Options& options, Presence, const std::string& help) {
    SchemaPrinter below(add_entries(known_list(name, help)));
    describe(below, options);
  }

  template <class Options>
  void named(const std::string& name, Named<Options>&, Presence, const std::string& help) {
    pugi::xml_node entry = add_element(known_list(name, help).append_child("zeroOrMore"), "ParameterList");
    add_pattern(add_attribute(entry, "name"), chosen_name_pattern);
    Options options;
    SchemaPrinter below(add_entries(entry));
    describe(below, options);
  }

  void exactly_one_of(const std::vector<std::string>&) {}
  void at_least_one_of(const std::vector<std::string>&) {}
  void only_with(const std::vector<std::string>&, const std::string&, bool, const std::string&) {}
  void rule(const std::string&, const std::vector<std::string>&, bool, const std::string&, const std::string& = "") {}

 private:
  /// An entry with that name, and its help.
  pugi::xml_node known(const char* element, const std::string& name, const std::string& help) {
    pugi::xml_node entry = add_element(entries_, element);
    entry.append_child("a:documentation").text() = help.c_str();
    add_value(add_attribute(entry, "name"), name);
    return entry;
  }
  pugi::xml_node known_list(const std::string& name, const std::string& help) { return known("ParameterList", name, help); }

  /// @return where its types and values are to be added, one of which a deck must have
  pugi::xml_node parameter(const std::string& name, const std::string& help) {
    return known("Parameter", name, help).append_child("choice");
  }

  /// One type, and the attribute for its values.
  static pugi::xml_node typed_value(pugi::xml_node alternatives, const std::string& type) {
    pugi::xml_node group = alternatives.append_child("group");
    add_value(add_attribute(group, "type"), type);
    return add_attribute(group, "value");
  }

  /// A parameter that is not a choice of names: integers may stand where doubles are wanted.
  void typed(const std::string& name, const std::string& type, std::size_t count, const std::string& help) {
    add_typed(parameter(name, help), type, count);
  }
  static void add_typed(pugi::xml_node alternatives, const std::string& type, std::size_t count) {
    for (const std::string allowed : {"double", "int", "bool", "string", "Array(double)", "Array(int)", "Array(string)"}) {
      if (!is_type_allowed(allowed, type)) continue;
      pugi::xml_node value = typed_value(alternatives, allowed);
      if (allowed == "int") {
        value.append_child("data").append_attribute("type") = "int";  // in the range of 32 bits
      } else {
        add_pattern(value, pattern_of(allowed, count));
      }
    }
  }

  pugi::xml_node entries_;
};

/// The top element of a file, whose name may be any.
pugi::xml_node add_top(pugi::xml_node start, const char* help) {
  pugi::xml_node top = add_element(start, "ParameterList");
  top.append_child("a:documentation").text() = help;
  add_attribute(top.append_child("optional"), "name");
  return top;
}

}  // namespace

void print_schema(std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node grammar = document.append_child("grammar");
  grammar.append_attribute("xmlns") = "http://relaxng.org/ns/structure/1.0";
  grammar.append_attribute("xmlns:a") = "http://relaxng.org/ns/compatibility/annotations/1.0";
  grammar.append_attribute("datatypeLibrary") = "http://www.w3.org/2001/XMLSchema-datatypes";
  pugi::xml_node start = grammar.append_child("start").append_child("choice");

  SchemaPrinter deck(add_entries(add_top(start, "a deck, for mortise run")));
  DeckOptions deck_options;
  describe(deck, deck_options);

  SchemaPrinter recipe(add_entries(add_top(start, "a recipe, for mortise mesh")));
  MeshOptions mesh_options;
  describe_recipe(recipe, mesh_options, Presence::required);

  document.save(out, "  ");
}

}  // namespace mortise
