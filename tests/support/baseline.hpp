// Counts of work in a run, and how they differ from those of the saved baseline.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mortise::test {

using Json = nlohmann::ordered_json;

/// Counts that must be the same as in the baseline.
inline const std::vector<std::string> exact_counts{"steps",    "cuts",   "newton_iterations", "evaluations",
                                                   "tangents", "graphs", "analyses",          "searches"};

/// Counts that depend on round-off where facets just touch, or on the ordering of the factors: within 2 % of the baseline.
inline const std::vector<std::string> near_counts{"pairs", "overlaps", "factor_entries"};
inline constexpr double near_share = 0.02;

/// The counts of a summary.json, all contact pairs together. The same names as in tools/bench.py.
/// @throws nlohmann::json::exception if one is missing
inline Json counts_of(const Json& summary) {
  Json counts{{"steps", summary.at("steps")},
              {"cuts", summary.at("cuts")},
              {"newton_iterations", summary.at("newton_iterations")},
              {"evaluations", summary.at("counts").at("residuals")},
              {"tangents", summary.at("counts").at("tangents")},
              {"graphs", summary.at("counts").at("graphs")},
              {"analyses", summary.at("direct_solver").at("analyses")},
              {"factor_entries", summary.at("direct_solver").at("factor_entries")}};
  for (const std::string name : {"searches", "pairs", "overlaps"}) {
    long sum = 0;
    for (const auto& pair : summary.at("contact")) sum += pair.at(name).get<long>();
    counts[name] = sum;
  }
  return counts;
}

/// What a scene's counts have against the baseline's, a line each: a count that is missing on either side, or off. None: equal.
inline std::vector<std::string> differences(const Json& baseline, const Json& found) {
  std::vector<std::string> lines;
  const auto compare = [&](const std::string& name, double share) {
    const auto number = [&name](const Json& counts) {
      return counts.is_object() && counts.contains(name) && counts[name].is_number();
    };
    if (!number(baseline)) return lines.push_back(name + ": not in the baseline");
    if (!number(found)) return lines.push_back(name + ": not in the run");
    const double expected = baseline[name], is = found[name];
    if (!(std::abs(is - expected) <= share * std::abs(expected)))
      lines.push_back(name + ": " + found[name].dump() + ", in the baseline " + baseline[name].dump());
  };
  for (const auto& name : exact_counts) compare(name, 0);
  for (const auto& name : near_counts) compare(name, near_share);
  return lines;
}

}  // namespace mortise::test
