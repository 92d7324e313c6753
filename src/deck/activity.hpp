// When a load, a support or a spring acts.
#pragma once

#include <optional>

#include "deck/bounds.hpp"

namespace mortise {

/// From `start` to `end`: at times t with start < t <= end. Both are stops, so every step lies within or without.
struct Activity {
  std::optional<double> start, end;

  bool always() const { return !start && !end; }

  bool acts_at(double t) const { return (!start || t > *start) && (!end || t <= *end); }

  /// In the step that begins at time `t`, wherever it ends.
  bool acts_after(double t) const { return (!start || t >= *start) && (!end || t < *end); }
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
