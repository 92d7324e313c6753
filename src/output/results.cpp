// Writing result frames behind the geometry of a mesh.
#include "output/results.hpp"

#include <exodusII.h>
#include <fmt/format.h>

#include <array>
#include <cassert>
#include <fstream>

#include "errors.hpp"
#include "mesh/exodus_file.hpp"
#include "mesh/netcdf_header.hpp"

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

// Cuts off all but the first frames of a classic netCDF file: the number of records stands in bytes 4 to 7, big end first, and
// records are what is last in the file. The library has no call for it. A netCDF-4 file keeps its later frames until they are
// overwritten.
void keep_frames(const std::filesystem::path& file, int n_frames) {
  if (read_netcdf_header(file).kind != FileKind::classic) return;
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  std::array<char, 4> number{};
  bytes.seekg(4);
  bytes.read(number.data(), number.size());
  std::uint32_t found = 0;
  for (char c : number) found = found << 8 | static_cast<unsigned char>(c);
  if (!bytes || found <= static_cast<std::uint32_t>(n_frames)) return;
  for (int k = 0; k < 4; ++k) number[k] = static_cast<char>(n_frames >> (24 - 8 * k) & 0xFF);
  bytes.seekp(4);
  bytes.write(number.data(), number.size());
  bytes.close();
  std::error_code failure;
  if (const auto header = read_netcdf_header(file); bytes && header.n_required < header.n_bytes)
    std::filesystem::resize_file(file, header.n_required, failure);
  if (!bytes || failure) throw FileError(fmt::format("{}: error[I02] cannot be written", file.string()));
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

ResultsFile::ResultsFile(const std::filesystem::path& file, const Mesh& mesh, int n_frames, std::vector<std::string> nodal,
                         std::vector<std::string> global)
    : file_(file), n_nodes_(mortise::n_nodes(mesh)), frame_(n_frames), nodal_(std::move(nodal)), global_(std::move(global)) {
  keep_frames(file, n_frames);
  // Of a file that is no netCDF at all the library would speak for itself.
  ExodusFile exodus = read_netcdf_header(file).kind == FileKind::other ? ExodusFile() : open_exodus(file, ExodusAccess::write);
  const auto has = [&](ex_entity_type type, const std::vector<std::string>& names) {
    int n = 0;
    return ex_get_variable_param(exodus.id(), type, &n) >= 0 && n == static_cast<int>(names.size());
  };
  if (exodus.id() < 0 || ex_inquire_int(exodus.id(), EX_INQ_NODES) != n_nodes_ ||
      ex_inquire_int(exodus.id(), EX_INQ_TIME) < n_frames || !has(EX_NODAL, nodal_) || !has(EX_GLOBAL, global_))
    throw FileError(
        fmt::format("{}: error[I10] is not the results file of this run with its {} frames - move it away, and the "
                    "run goes on with a new one",
                    file.string(), n_frames));
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
