#include "deck/stages.hpp"

#include <algorithm>

#include "deck/entries.hpp"

namespace mortise {
namespace {

/// Of all entries that act at times: "list/name".
std::vector<std::string> acting_entries(const DeckOptions& options) {
  std::vector<std::string> names;
  for_each_acting_list(options, [&](const std::string& list, const auto& entries) {
    for (const auto& entry : entries) names.push_back(list + "/" + entry.first);
  });
  return names;
}

}  // namespace

std::vector<std::string> DeckStage::at(const std::string& parameter) const {
  std::vector<std::string> place = path;
  place.push_back(parameter);
  return place;
}

std::string DeckStage::in_words(const std::string& parameter) const {
  std::string text;
  for (const std::string& part : path) text += part + " > ";
  return text + in_quotes(parameter);
}

bool DeckStage::has(const std::string& list, const std::string& entry) const {
  return std::find(without->begin(), without->end(), list + "/" + entry) == without->end();
}

std::vector<DeckStage> stages_of(const DeckOptions& options) {
  static const std::vector<std::string> nothing;
  if (options.stages.empty()) return {{{"time"}, "", &options.time, &nothing, 0}};
  std::vector<DeckStage> stages;
  double begin = 0;
  for (const auto& [name, stage] : options.stages) {
    stages.push_back({{"stages", name}, name, &stage, &stage.without, begin});
    begin = stage.end;
  }
  return stages;
}

bool has_inertia(const DeckOptions& options) {
  const auto stages = stages_of(options);
  return std::any_of(stages.begin(), stages.end(), [](const DeckStage& stage) { return stage.scheme().has_inertia(); });
}

void check_stages(const DeckSource& source, const DeckOptions& options, Findings& findings) {
  const auto report = [&](const std::string& code, const std::vector<std::string>& path, const std::string& what) {
    findings.problems.push_back(source.problem(code, path, what));
  };
  const auto stages = stages_of(options);
  const std::vector<std::string> entries = acting_entries(options);
  for (const DeckStage& stage : stages) {
    if (!(stage.time->end > 0)) continue;  // missing or faulty, and reported
    const std::string before = "must be after " + shortest(stage.begin) + ", where the stage before ends";
    if (stage.time->end <= stage.begin) {
      report("D08", stage.at("end"), before);
    } else if (!stage.time->stops.empty() && stage.time->stops.front() <= stage.begin) {
      report("D08", stage.at("stops"), before);
    }
    for (const std::string& entry : *stage.without)
      if (std::find(entries.begin(), entries.end(), entry) == entries.end())
        report("D14", stage.at("without"), not_among("there is no entry " + in_quotes(entry), entry, entries));
  }
  for_each_acting_list(options, [&](const std::string& list, const auto& all) {
    for (const auto& entry : all) {
      const auto is_without = [&, name = entry.first](const DeckStage& stage) { return !stage.has(list, name); };
      if (std::all_of(stages.begin(), stages.end(), is_without))
        report("D15", {list, entry.first}, "acts in no stage: all are without it");
    }
  });
}

void set_pauses(DeckOptions& options) {
  const auto stages = stages_of(options);
  for_each_acting_list(options, [&](const std::string& list, auto& entries) {
    for (auto& [name, entry] : entries)
      for (const DeckStage& stage : stages)
        if (!stage.has(list, name)) entry.activity.pauses.emplace_back(stage.begin, stage.time->end);
  });
}

}  // namespace mortise
