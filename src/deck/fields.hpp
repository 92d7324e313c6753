// What a description is written in: the vocabulary shared by the reader of decks and the printers of their reference and schema.
//
// A description is a template  describe(Fields& f, Options& o)  that calls, in the order of the reference,
//   f.required(name, target, bound, unit, help)      a value only the user knows
//   f.optional(name, target, bound, unit, help)      the default is what `target` holds
//   f.choice(name, target, choices, presence, help)  one of some names
//   f.words(name, target, allowed, help)             several of some names
//   f.formula(name, target, unit, help)              a formula in t, x, y, z
//   f.list(name, options, presence, help)            a list with its own description
//   f.named(name, entries, presence, help)           lists that the user names, all with the same description
//   f.exactly_one_of(names), f.at_least_one_of(names), f.only_with(...), f.rule(...)   what ties parameters together
// `unit` is in words (length, force, time, "-" for none): decks may use any consistent units.
#pragma once

#include <string>
#include <utility>
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

/// `what`, with the nearest of the known names and the list of them.
std::string not_among(const std::string& what, const std::string& name, const std::vector<std::string>& known);

/// `names` as  "a", "b".
std::string quoted_names(const std::vector<std::string>& names);

}  // namespace mortise
