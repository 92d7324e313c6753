// Writing result frames behind the geometry of a mesh.
#include "output/results.hpp"

#include <exodusII.h>
#include <fmt/format.h>

#include <cassert>

#include "errors.hpp"
#include "mesh/exodus_file.hpp"

namespace mortise {

namespace {

void declare_variables(int id, const std::filesystem::path& file, ex_entity_type type, std::vector<std::string>& names) {
  if (names.empty()) return;
  std::vector<char*> pointers;
  for (std::string& name : names) pointers.push_back(name.data());
  const int n = static_cast<int>(names.size());
  require_written(ex_put_variable_param(id, type, n), file, "number of variables");
  require_written(ex_put_variable_names(id, type, n, pointers.data()), file, "names of variables");
}

}  // namespace

ResultsFile::ResultsFile(const std::filesystem::path& file, const Mesh& mesh, const std::string& title,
                         std::vector<std::string> nodal, std::vector<std::string> global)
    : file_(file), n_nodes_(mortise::n_nodes(mesh)), nodal_(std::move(nodal)), global_(std::move(global)) {
  std::vector<std::string> variables = nodal_;
  variables.insert(variables.end(), global_.begin(), global_.end());
  ExodusFile exodus = create_exodus(file_, mesh, title, variables);
  declare_variables(exodus.id(), file_, EX_NODAL, nodal_);
  declare_variables(exodus.id(), file_, EX_GLOBAL, global_);
  require_written(ex_update(exodus.id()), file_, "geometry");
  exodus_id_ = exodus.release();
}

ResultsFile::~ResultsFile() {
  if (exodus_id_ >= 0) ex_close(exodus_id_);  // every frame was flushed already, so a failure here loses nothing
}

void ResultsFile::write(double time, const std::vector<std::vector<double>>& nodal, const std::vector<double>& global) {
  assert(nodal.size() == nodal_.size() && global.size() == global_.size());
  const int frame = frame_ + 1;
  const std::string last = frame_ == 0 ? "no complete frame" : fmt::format("last complete frame: {}", frame_);
  const auto require = [&](int status, const std::string& what) {
    require_written(status, file_, fmt::format("frame {} ({}): {}", frame, last, what));
  };
  require(ex_put_time(exodus_id_, frame, &time), "time");
  for (std::size_t v = 0; v < nodal.size(); ++v) {
    assert(nodal[v].size() == static_cast<std::size_t>(n_nodes_));
    require(ex_put_var(exodus_id_, frame, EX_NODAL, static_cast<int>(v) + 1, 1, n_nodes_, nodal[v].data()), nodal_[v]);
  }
  if (!global.empty())
    require(ex_put_var(exodus_id_, frame, EX_GLOBAL, 1, 1, static_cast<std::int64_t>(global.size()), global.data()),
            "global variables");
  require(ex_update(exodus_id_), "flush");
  frame_ = frame;
}

}  // namespace mortise
