// What `mortise tangents` prints, and the same as CSV.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tangents/checked_step.hpp"
#include "tangents/tangent_check.hpp"

namespace mortise {

/// The states that terms are checked at.
inline constexpr std::array<const char*, 2> checked_states{"initial", "deformed"};

struct TermResult {
  const CheckedTerm* term;
  std::array<StateResult, 2> at;  ///< in the order of `checked_states`
};

/// The table of one term.
std::string table(const TermResult& result);

/// The tangents of whole steps.
std::string table(const std::vector<StepTangent>& steps);

/// All terms, then the steps: columns term, state, way, chosen, compared, kinks, difference, order, orders, seconds,
/// relative_time.
std::string csv(const std::vector<TermResult>& results, const std::vector<StepTangent>& steps);

}  // namespace mortise
