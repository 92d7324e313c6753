// The stages of a run: what a deck says in `stages`, or in `time` about the only one.
#pragma once

#include <string>
#include <vector>

#include "deck/options.hpp"
#include "deck/reader.hpp"
#include "deck/source.hpp"

namespace mortise {

/// A stage and its place in the deck.
struct DeckStage {
  std::vector<std::string> path;  ///< of its list
  std::string name;               ///< empty: the only one
  const TimeOptions* time;
  const std::vector<std::string>* without;
  double begin;  ///< end of the stage before

  std::vector<std::string> at(const std::string& parameter) const;
  /// As in messages: time > "end".
  std::string in_words(const std::string& parameter) const;
  /// time > "scheme" = "midpoint"
  std::string with_scheme() const { return in_words("scheme") + " = " + in_quotes(name_of_kind(time->scheme)); }
  TimeScheme scheme() const { return scheme_of(time->scheme); }
  bool has(const std::string& list, const std::string& entry) const;
};

/// In the order of the run; at least one. @param options must outlive what is returned
std::vector<DeckStage> stages_of(const DeckOptions& options);

/// Whether any stage has inertia.
bool has_inertia(const DeckOptions& options);

/// Stages one after the other, and what they are without. @param findings gets the problems
void check_stages(const DeckSource& source, const DeckOptions& options, Findings& findings);

/// Tells the entries that stages are without when they pause.
void set_pauses(DeckOptions& options);

}  // namespace mortise
