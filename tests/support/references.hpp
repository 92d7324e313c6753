// Independent reference values, kept beside the checkout in ../shared/references.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace mortise::test {

inline std::string reference_path(const std::string& name) {
  return std::string(MORTISE_SOURCE_DIR) + "/../shared/references/" + name;
}

inline bool have_reference(const std::string& name) { return std::filesystem::exists(reference_path(name)); }

/// What a skipped test says.
inline std::string no_reference(const std::string& name) { return "no reference values: " + reference_path(name) + " is absent"; }

/// The reference file; an empty one is an error, so that no test passes by comparing nothing.
inline nlohmann::json reference(const std::string& name) {
  std::ifstream file(reference_path(name));
  auto values = nlohmann::json::parse(file);
  if (values.empty()) throw std::runtime_error(reference_path(name) + " is empty");
  return values;
}

}  // namespace mortise::test
