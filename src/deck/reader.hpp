// Fills an option struct from a list of the deck by its description, collecting every error.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "deck/options.hpp"
#include "deck/parameter_names.hpp"
#include "deck/source.hpp"
#include "deck/values.hpp"

namespace mortise {

/// A formula that was read; it can be compiled once the tables of the deck are known.
struct FormulaUse {
  std::vector<std::string> path;
  std::string text;
  std::vector<std::string> variables{"t", "x", "y", "z"};
};

/// What reading a deck finds besides the options.
struct Findings {
  std::vector<DeckProblem> problems;
  std::vector<FormulaUse> formulas;
};

/// The reading kind of Fields (fields.hpp): one object reads one list.
class Reader {
 public:
  Reader(const DeckSource& source, const DeckList& list, std::vector<std::string> path, Findings& findings)
      : source_(source), list_(list), path_(std::move(path)), findings_(findings) {}

  template <class T>
  void required(const std::string& name, T& target, const Bound& bound, const std::string& unit, const std::string&) {
    if (is_given(name, Presence::required)) read(name, target, bound, unit);
  }

  template <class T>
  void optional(const std::string& name, T& target, const Bound& bound, const std::string& unit, const std::string&) {
    if (is_given(name, Presence::optional)) read(name, target, bound, unit);
  }

  template <class T, class V>
  void choice(const std::string& name, T& target, const Choices<V>& choices, Presence presence, const std::string&) {
    std::string word;
    if (!is_given(name, presence) || !read(name, word, anything, "")) return;
    for (const auto& [known, value] : choices) {
      if (word == known) {
        target = value;
        return;
      }
    }
    fail("D10", name, not_among("is not one of the names to choose from", word, names_of(choices)));
  }

  template <class Kinds>
  void kind(const std::string& name, Kinds& target, Presence presence, const std::string&) {
    std::string word;
    const bool is_read = is_given(name, presence) && read(name, word, anything, "");
    bool is_known = false;
    if (is_read) {
      for_each_kind<Kinds>([&](auto one) {
        if (word != one.name) return;
        is_known = true;
        target = one;
      });
      if (!is_known) fail("D10", name, not_among("is not one of the names to choose from", word, names_of_kinds<Kinds>()));
    }
    visit_kind(target, [this](auto& held) { describe(*this, held); });  // without a word: what `target` held, if anything
    refuse_parameters_of_other_kinds(name, parameters_of_kinds<Kinds>());
  }

  void words(const std::string& name, std::vector<std::string>& target, const std::vector<std::string>& allowed,
             const std::string&);

  void formula(const std::string& name, std::optional<std::string>& target, const std::string& unit, const std::string&);

  void number_or_formula(const std::string& name, std::optional<NumberOrFormula>& target, const Bound& bound,
                         const std::vector<std::string>& variables, const std::string& unit, const std::string&);

  template <class Options>
  void list(const std::string& name, Options& options, Presence presence, const std::string&) {
    if (const DeckList* below = find_list(name, presence)) read_list(source_, *below, below_path(name), options, findings_);
  }

  template <class Options>
  void named(const std::string& name, Named<Options>& entries, Presence presence, const std::string&) {
    const DeckList* below = find_list(name, presence);
    if (below == nullptr) return;
    check_entries(*below, name);
    for (const DeckList& entry : below->lists) {
      std::vector<std::string> path = below_path(name);
      path.push_back(entry.name);
      entries.emplace_back(entry.name, Options{});
      read_list(source_, entry, path, entries.back().second, findings_);
    }
  }

  void exactly_one_of(const std::vector<std::string>& names);
  void at_least_one_of(const std::vector<std::string>& names);

  /// Where `holds` is false, none of `names` may be set.
  void only_with(const std::vector<std::string>& names, const std::string& governor, bool holds, const std::string& text);

  /// `holds` is judged only if all of `names` were read without error; the first of them that is set gets the message.
  /// @param limit the value behind `text` in this deck, for the message only
  void rule(const std::string& code, const std::vector<std::string>& names, bool holds, const std::string& text,
            const std::string& limit = "");

  /// Reports entries that the description does not know, what is missing, and what does not go together; the last thing to do.
  void finish();

  template <class Options>
  static void read_list(const DeckSource& source, const DeckList& list, const std::vector<std::string>& path, Options& options,
                        Findings& findings) {
    Reader reader(source, list, path, findings);
    describe(reader, options);
    reader.finish();
  }

 private:
  /// Notes the name as known, and as missing if it is required and absent.
  bool is_given(const std::string& name, Presence presence);
  /// After the description of the kind that was chosen: what is set beside it and belongs to others only has no meaning. Where
  /// the word `governor` is faulty or missing, nothing is said about them.
  void refuse_parameters_of_other_kinds(const std::string& governor, const Choices<std::vector<std::string>>& kinds);
  bool has_type(const std::string& name, const std::string& wanted, const std::string& meaning);
  const DeckList* find_list(const std::string& name, Presence presence);
  void check_entries(const DeckList& list, const std::string& name);

  template <class T>
  bool read(const std::string& name, T& target, const Bound& bound, const std::string& unit) {
    if (!has_type(name, type_name(target), "")) return false;
    const DeckParameter& parameter = *list_.parameter(name);
    T value = target;
    if (const std::string reason = read_value(parameter, value); !reason.empty()) return fail("D09", name, reason);
    if (parameter.type == "string" && parameter.value.find_first_not_of(" \t\r\n") == std::string::npos) {
      return fail("D08", name, "must not be empty");
    }
    if (is_empty(value)) return fail("D18", name, "must have entries, or be left out");
    if (const auto outside = first_outside(bound, value)) {
      return fail("D08", name, *outside + "must be " + bound.text + (bound.reason.empty() ? "" : "; " + bound.reason), unit);
    }
    target = std::move(value);
    return true;
  }

  /// Notes an error at a parameter or list of this list. @return false
  bool fail(const std::string& code, const std::string& name, const std::string& what, const std::string& unit = "");
  /// Notes an error of this list as a whole.
  void fail_here(const std::string& code, const std::string& what);
  std::vector<std::string> below_path(const std::string& name) const;
  bool is_set(const std::string& name) const;

  const DeckSource& source_;
  const DeckList& list_;
  const std::vector<std::string> path_;
  Findings& findings_;
  std::vector<std::string> known_;
  std::vector<std::string> of_other_kinds_;  ///< known, but not here
  std::vector<std::string> missing_;
  std::set<std::string> failed_;               ///< reported: to be left alone by the checks
  std::vector<std::function<void()>> checks_;  ///< what ties parameters together: judged when misspelt names are known
};

}  // namespace mortise
