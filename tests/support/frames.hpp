// What stands in a results file, by the Exodus library itself.
#pragma once

#include <exodusII.h>

#include <algorithm>
#include <array>
#include <cstdint>
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

/// Reference positions of all nodes and a nodal variable in one frame, counted from 1; empty if the file has it not.
struct NodalFrame {
  std::vector<std::array<double, 3>> X;
  std::vector<double> values;
};

inline NodalFrame read_nodal(const std::filesystem::path& file, const std::string& name, int frame) {
  NodalFrame nodal;
  int word = sizeof(double), file_word = 0;
  float version = 0;
  const int id = ex_open(file.c_str(), EX_READ, &word, &file_word, &version);
  if (id < 0) return nodal;
  ex_set_max_name_length(id, 80);
  const auto n_nodes = static_cast<std::size_t>(ex_inquire_int(id, EX_INQ_NODES));
  const auto names = names_of_variables(id, EX_NODAL);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    std::array<std::vector<double>, 3> axes;
    for (auto& axis : axes) axis.resize(n_nodes);
    ex_get_coord(id, axes[0].data(), axes[1].data(), axes[2].data());
    for (std::size_t a = 0; a < n_nodes; ++a) nodal.X.push_back({axes[0][a], axes[1][a], axes[2][a]});
    nodal.values.resize(n_nodes);
    ex_get_var(id, frame, EX_NODAL, static_cast<int>(found - names.begin()) + 1, 1, static_cast<std::int64_t>(n_nodes),
               nodal.values.data());
  }
  ex_close(id);
  return nodal;
}

}  // namespace mortise::test
