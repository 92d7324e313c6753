// When a load, a support, a spring or a contact acts.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "deck/bounds.hpp"

namespace mortise {

/// The next number after a time: at it acts what does in the step to come.
inline double just_after(double t) { return std::nextafter(t, std::numeric_limits<double>::infinity()); }

/// From `start` to `end`: at times t with start < t <= end. Both are stops, so every step lies within or without.
struct Activity {
  std::optional<double> start, end;
  std::vector<std::pair<double, double>> pauses;  ///< begin and end of the stages that are without it; stops too

  bool always() const { return !start && !end && pauses.empty(); }

  bool acts_at(double t) const {
    const auto pauses_at = [t](const auto& pause) { return t > pause.first && t <= pause.second; };
    return (!start || t > *start) && (!end || t <= *end) && std::none_of(pauses.begin(), pauses.end(), pauses_at);
  }

  /// In the step that begins at time `t`, wherever it ends.
  bool acts_after(double t) const { return acts_at(just_after(t)); }

  /// The last time up to `t` at which it acts, if it does at all.
  double last_time(double t) const {
    t = std::min(t, end.value_or(t));
    for (auto pause = pauses.rbegin(); pause != pauses.rend(); ++pause)
      if (t > pause->first && t <= pause->second) t = pause->first;
    return t;
  }
};

template <class Fields>
void describe(Fields& f, Activity& o) {
  f.optional("start", o.start, at_least(0), "time",
             "acts in the steps after this time, which becomes a stop; left out: from the beginning");
  f.optional("end", o.end, positive, "time", "acts in the steps up to this time, which becomes a stop; left out: to the end");
  f.rule("D08", {"start", "end"}, !o.start || !o.end || *o.start < *o.end, "must be before \"end\"",
         o.end ? " = " + shortest(*o.end) : "");
}

}  // namespace mortise
