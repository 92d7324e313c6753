// What a description is written in: the vocabulary shared by the reader of decks and the printers of their reference and schema.
//
// A description is a template  describe(Fields& f, Options& o)  that calls, in the order of the reference,
//   f.required(name, target, bound, unit, help)      a value only the user knows
//   f.optional(name, target, bound, unit, help)      the default is what `target` holds
//   f.choice(name, target, choices, presence, help)  one of some names
//   f.kind(name, target, presence, help)             one of several kinds, chosen by its name, with parameters of its own that
//                                                    stand beside it in the same list
//   f.words(name, target, allowed, help)             several of some names
//   f.formula(name, target, unit, help)              a formula in t, x, y, z
//   f.number_or_formula(name, target, bound, variables, unit, help)   a number, or a formula in these variables
//   f.list(name, options, presence, help)            a list with its own description
//   f.named(name, entries, presence, help)           lists that the user names, all with the same description
//   f.exactly_one_of(names), f.at_least_one_of(names), f.only_with(...), f.rule(...)   what ties parameters together
// `unit` is in words (length, force, time, "-" for none): decks may use any consistent units.
//
// The target of a kind is a std::variant, or std::optional of one, of option structs that have a `name` (the word in the deck), a
// `help` and a description of their own. A parameter that belongs to another kind only is an error: it would do nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mortise {

enum class Presence {
  required,          ///< must be there; a list must have entries
  optional,          ///< may be left out; a list may be empty
  filled_if_present  ///< a list may be left out, but not be empty
};

/// Names of a deck, and what they stand for.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value>
std::vector<std::string> names_of(const Choices<Value>& choices) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.push_back(choice.first);
  return names;
}

template <class... Kind, class Function>
void for_each_kind_of(const std::variant<Kind...>*, Function& f) {
  (f(Kind{}), ...);
}
template <class Kinds, class Function>
void for_each_kind_of(const std::optional<Kinds>*, Function& f) {
  for_each_kind_of(static_cast<const Kinds*>(nullptr), f);
}

/// Calls f(Kind{}) for each alternative of `Kinds`, a std::variant or std::optional of one, in their order.
template <class Kinds, class Function>
void for_each_kind(Function f) {
  for_each_kind_of(static_cast<const Kinds*>(nullptr), f);
}

/// The words of all kinds.
template <class Kinds>
std::vector<std::string> names_of_kinds() {
  std::vector<std::string> names;
  for_each_kind<Kinds>([&](const auto& kind) { names.emplace_back(kind.name); });
  return names;
}

/// The word of the kind that is held.
template <class... Kind>
std::string name_of_kind(const std::variant<Kind...>& kinds) {
  return std::visit([](const auto& kind) { return std::string(kind.name); }, kinds);
}

/// f(kind) for the kind that is held, if any.
template <class... Kind, class Function>
void visit_kind(std::variant<Kind...>& kinds, Function f) {
  std::visit(f, kinds);
}
template <class Kinds, class Function>
void visit_kind(std::optional<Kinds>& kinds, Function f) {
  if (kinds) std::visit(f, *kinds);
}

/// `what`, with the nearest of the known names and the list of them.
std::string not_among(const std::string& what, const std::string& name, const std::vector<std::string>& known);

/// `names` as  "a", "b".
std::string quoted_names(const std::vector<std::string>& names);

}  // namespace mortise
