// Prints the reference of decks from the descriptions that the reader uses, so that the two cannot differ.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "deck/codes.hpp"
#include "deck/deck.hpp"
#include "deck/descriptions.hpp"
#include "deck/formula.hpp"
#include "deck/source.hpp"
#include "deck/values.hpp"
#include "errors.hpp"

namespace mortise {

namespace {

/// `text` in lines of at most 110 characters, the first behind `head`, the others indented as far.
void print_wrapped(std::ostream& out, const std::string& head, const std::string& text) {
  constexpr std::size_t width = 110;
  std::istringstream words(text);
  std::string word, line = head;
  bool is_line_empty = true;
  while (words >> word) {
    if (!is_line_empty && line.size() + 1 + word.size() > width) {
      out << line << "\n";
      line = std::string(head.size(), ' ');
      is_line_empty = true;
    }
    line += (is_line_empty ? "" : " ") + word;
    is_line_empty = false;
  }
  out << line << "\n";
}

/// The printing kind of Fields (fields.hpp): one object prints one list.
class ReferencePrinter {
 public:
  /// @param only the one list to print among those directly below, or empty for all
  ReferencePrinter(std::ostream& out, int indent, std::string only = "")
      : out_(out), indent_(static_cast<std::size_t>(indent), ' '), only_(std::move(only)) {}

  template <class T>
  void required(const std::string& name, const T& target, const Bound& bound, const std::string& unit, const std::string& help) {
    parameter(name, {type_name(target), entry_count(target), unit_text(unit), bound.text, "required"}, help, bound.reason);
  }

  template <class T>
  void optional(const std::string& name, const T& target, const Bound& bound, const std::string& unit, const std::string& help) {
    parameter(name, {type_name(target), entry_count(target), unit_text(unit), bound.text, default_text(show(target))}, help,
              bound.reason);
  }

  template <class T, class V>
  void choice(const std::string& name, const T& target, const Choices<V>& choices, Presence presence, const std::string& help) {
    std::string chosen;
    for (const auto& [word, value] : choices) {
      if (target == value) chosen = word;
    }
    parameter(
        name,
        {"string", "one of: " + join(names_of(choices)), presence == Presence::required ? "required" : default_text(chosen)},
        help);
  }

  template <class Kinds>
  void kind(const std::string& name, Kinds& target, Presence presence, const std::string& help) {
    std::string held;
    visit_kind(target, [&](const auto& one) { held = one.name; });
    parameter(name, {"string", presence == Presence::required ? "required" : default_text(held), "one of the following kinds"},
              help);
    if (!only_.empty()) return;
    for_each_kind<Kinds>([&](auto one) {
      print_wrapped(out_, fmt::format("{}  {} = \"{}\": ", indent_, name, one.name), one.help);
      ReferencePrinter printer(out_, static_cast<int>(indent_.size()) + 4);
      describe(printer, one);
    });
  }

  void words(const std::string& name, const std::vector<std::string>& target, const std::vector<std::string>& allowed,
             const std::string& help) {
    parameter(name, {"Array(string)", "of: " + join(allowed), default_text(show(target))}, help);
  }

  void formula(const std::string& name, const std::optional<std::string>&, const std::string& unit, const std::string& help) {
    parameter(name, {"string", "formula", unit_text(unit), "optional"}, help);
  }

  void number_or_formula(const std::string& name, const std::optional<NumberOrFormula>&, const Bound& bound,
                         const std::vector<std::string>& variables, const std::string& unit, const std::string& help) {
    parameter(name, {"double, or string: a formula in " + join(variables), unit_text(unit), bound.text, "optional"}, help,
              bound.reason);
  }

  template <class Options>
  void list(const std::string& name, Options& options, Presence presence, const std::string& help) {
    below(name, "list", presence, help, options);
  }

  template <class Options>
  void named(const std::string& name, Named<Options>&, Presence presence, const std::string& help) {
    Options entry;
    below(name, "list of named lists", presence, help, entry);
  }

  void exactly_one_of(const std::vector<std::string>& names) { note("exactly one of " + quoted_names(names)); }
  void at_least_one_of(const std::vector<std::string>& names) { note("at least one of " + quoted_names(names)); }
  void only_with(const std::vector<std::string>& names, const std::string&, bool, const std::string& text) {
    note(quoted_names(names) + " only with " + text);
  }
  void rule(const std::string&, const std::vector<std::string>& names, bool, const std::string& text, const std::string& = "") {
    note(in_quotes(names.front()) + " " + text);
  }

  /// Names of the lists directly below, in the order of the reference.
  const std::vector<std::string>& lists() const { return lists_; }
  bool found() const { return found_; }

 private:
  static std::string unit_text(const std::string& unit) { return unit.empty() || unit == "-" ? "" : "[" + unit + "]"; }
  static std::string default_text(const std::string& value) { return value.empty() ? "optional" : "default " + value; }

  void parameter(const std::string& name, const std::vector<std::string>& facts, const std::string& help,
                 const std::string& reason = "") {
    if (!only_.empty()) return;
    std::vector<std::string> given;
    std::copy_if(facts.begin(), facts.end(), std::back_inserter(given), [](const std::string& fact) { return !fact.empty(); });
    print_wrapped(out_, fmt::format("{}{:<20} ", indent_, name), join(given));
    print_wrapped(out_, indent_ + "    ", help + (reason.empty() ? "" : " (bounds: " + reason + ")"));
  }

  void note(const std::string& text) {
    if (only_.empty()) print_wrapped(out_, indent_ + "Rule: ", text + ".");
  }

  template <class Options>
  void below(const std::string& name, const std::string& kind, Presence presence, const std::string& help, Options& options) {
    lists_.push_back(name);
    if (!only_.empty() && only_ != name) return;
    found_ = true;
    const char* presence_text = presence == Presence::required            ? "required"
                                : presence == Presence::filled_if_present ? "optional, but not empty"
                                                                          : "optional";
    out_ << fmt::format("\n{}{} ({}, {})\n{}  {}\n", indent_, name, kind, presence_text, indent_, help);
    ReferencePrinter printer(out_, static_cast<int>(indent_.size()) + 4);
    describe(printer, options);
  }

  std::ostream& out_;
  std::string indent_;
  std::string only_;
  std::vector<std::string> lists_;
  bool found_ = false;
};

void print_preface(std::ostream& out) {
  out << "A deck is a Teuchos ParameterList XML file:\n"
         "    <ParameterList name=\"...\">                           lists, nested\n"
         "      <Parameter name=\"...\" type=\"...\" value=\"...\"/>     type: string, double, int, bool, Array(double), "
         "Array(int), "
         "Array(string)\n"
         "Arrays are written {a, b}. An int may stand where a double is wanted. Names that you choose contain no comma, dot,\n"
         "slash or quote. Units in brackets are words: any consistent units will do. Paths are relative to the deck.\n"
         "Errors read  file:line:col: error[code] path > in > deck > \"name\" = value - what is allowed.\n";
  print_wrapped(out, "",
                "Formulas are strings. They may use " + join(formula_names()) +
                    " (t is time; x, y, z the reference position; log the natural logarithm), the deck's tables by name, "
                    "as in ramp(t), and + - * / ^ < <= > >= == != && || and a ? b : c; in XML, < is written &lt; and & &amp;.");
  out << "\n";
}

void print_codes(std::ostream& out) {
  out << "\nCodes of deck errors (exit code 2):\n";
  for (const DeckCode& one : deck_codes) out << fmt::format("    {}  {}\n", one.code, one.meaning);
}

}  // namespace

void print_reference(std::ostream& out, const std::string& list) {
  DeckOptions defaults;
  ReferencePrinter printer(out, 0, list);
  if (list.empty()) print_preface(out);
  describe(printer, defaults);
  if (!list.empty() && !printer.found()) {
    throw UserError(ExitCode::command_line, not_among("there is no list " + in_quotes(list), list, printer.lists()));
  }
  if (list.empty()) print_codes(out);
}

}  // namespace mortise
