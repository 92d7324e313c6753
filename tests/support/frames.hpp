// What stands in a results file, by the Exodus library itself.
#pragma once

#include <exodusII.h>

#include <filesystem>
#include <string>
#include <vector>

namespace mortise::test {

/// What the Exodus library says about a results file.
struct Frames {
  std::vector<double> times;
  std::vector<std::string> nodal, global;
};

inline std::vector<std::string> names_of_variables(int id, ex_entity_type type) {
  int n = 0;
  ex_get_variable_param(id, type, &n);
  std::vector<std::string> names;
  for (int v = 1; v <= n; ++v) {
    char name[128] = {};
    ex_get_variable_name(id, type, v, name);
    names.emplace_back(name);
  }
  return names;
}

inline Frames read_frames(const std::filesystem::path& file) {
  Frames frames;
  int word = sizeof(double), file_word = 0;
  float version = 0;
  const int id = ex_open(file.c_str(), EX_READ, &word, &file_word, &version);
  if (id < 0) return frames;
  ex_set_max_name_length(id, 80);
  frames.times.resize(static_cast<std::size_t>(ex_inquire_int(id, EX_INQ_TIME)));
  ex_get_all_times(id, frames.times.data());
  frames.nodal = names_of_variables(id, EX_NODAL);
  frames.global = names_of_variables(id, EX_GLOBAL);
  ex_close(id);
  return frames;
}

}  // namespace mortise::test
