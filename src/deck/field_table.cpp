#include "deck/field_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace mortise {
namespace {

template <class Predicate>
std::vector<std::string> names_where(Predicate is_wanted) {
  std::vector<std::string> names;
  for (const FieldEntry& entry : field_table)
    if (is_wanted(entry)) names.emplace_back(entry.name);
  return names;
}

std::vector<std::string> variables_of(const FieldEntry& entry) {
  std::vector<std::string> variables;
  for (const std::string& suffix : suffixes(entry.shape)) variables.push_back(entry.variable + suffix);
  return variables;
}

/// When a field is there, for the reference.
std::string condition(FieldNeed need) {
  switch (need) {
    case FieldNeed::nothing:
      return "";
    case FieldNeed::inertia:
      return " (not in statics)";
    case FieldNeed::supports:
      return " (with supports)";
    case FieldNeed::contact:
      return " (with contact)";
    case FieldNeed::ties:
      return " (with ties)";
  }
  return "";
}

}  // namespace

const FieldEntry& entry_of(Field field) {
  return *std::find_if(field_table.begin(), field_table.end(), [&](const FieldEntry& entry) { return entry.field == field; });
}

Field field_named(const std::string& name) {
  for (const FieldEntry& entry : field_table)
    if (entry.name == name) return entry.field;
  throw std::logic_error("no field \"" + name + "\"");
}

std::vector<std::string> suffixes(FieldShape shape) {
  switch (shape) {
    case FieldShape::scalar:
      return {""};
    case FieldShape::vector:
      return {"_x", "_y", "_z"};
    case FieldShape::symmetric_tensor:
      return {"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
    case FieldShape::tensor:
      return {"_xx", "_xy", "_xz", "_yx", "_yy", "_yz", "_zx", "_zy", "_zz"};
    case FieldShape::three_values:
      return {"_1", "_2", "_3"};
    case FieldShape::three_vectors:
      return {"_1_x", "_1_y", "_1_z", "_2_x", "_2_y", "_2_z", "_3_x", "_3_y", "_3_z"};
  }
  throw std::logic_error("no such shape of a field");
}

std::vector<std::string> variables_of_field(const std::string& name) { return variables_of(entry_of(field_named(name))); }

FieldComponent component_named(const std::string& variable) {
  for (const FieldEntry& entry : field_table) {
    const auto variables = variables_of(entry);
    const auto found = std::find(variables.begin(), variables.end(), variable);
    if (found != variables.end()) return {entry.field, static_cast<std::size_t>(found - variables.begin())};
  }
  throw std::logic_error("no nodal variable \"" + variable + "\"");
}

std::vector<std::string> all_field_names() {
  return names_where([](const FieldEntry&) { return true; });
}

std::vector<std::string> point_field_names() {
  return names_where([](const FieldEntry& entry) { return entry.place == FieldPlace::point; });
}

std::vector<std::string> all_nodal_variables() {
  std::vector<std::string> all;
  for (const FieldEntry& entry : field_table)
    for (std::string& variable : variables_of(entry)) all.push_back(std::move(variable));
  return all;
}

std::string help_on_fields() {
  std::string text;
  for (const FieldEntry& entry : field_table) {
    const std::string unit = entry.unit[0] == '-' ? "" : fmt::format(" [{}]", entry.unit),
                      help = entry.help[0] == '\0' ? "" : fmt::format(": {}", entry.help);
    text += fmt::format("{}{}{}{}{}", text.empty() ? "" : "; ", entry.name, unit, condition(entry.need), help);
  }
  return text;
}

}  // namespace mortise
