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

void declare_blocks(int id, const std::filesystem::path& file, ElementVariables& element, int n_blocks) {
  if (element.names.empty()) return;
  require_written(
      ex_put_truth_table(id, EX_ELEM_BLOCK, n_blocks, static_cast<int>(element.names.size()), element.in_block.data()), file,
      "variables of blocks");
}

bool has_variables(int id, ex_entity_type type, const std::vector<std::string>& names) {
  int n = 0;
  return ex_get_variable_param(id, type, &n) >= 0 && n == static_cast<int>(names.size());
}

bool has_blocks(int id, const ElementVariables& element, int n_blocks) {
  if (element.names.empty()) return true;
  std::vector<int> in_block(element.in_block.size());
  return ex_get_truth_table(id, EX_ELEM_BLOCK, n_blocks, static_cast<int>(element.names.size()), in_block.data()) >= 0 &&
         in_block == element.in_block;
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
                         ResultsVariables variables)
    : file_(file), n_nodes_(mortise::n_nodes(mesh)), variables_(std::move(variables)), blocks_(places(mesh)) {
  std::vector<std::string> names = variables_.nodal;
  names.insert(names.end(), variables_.global.begin(), variables_.global.end());
  names.insert(names.end(), variables_.element.names.begin(), variables_.element.names.end());
  ExodusFile exodus = create_exodus(file_, mesh, title, names);
  declare_variables(exodus.id(), file_, EX_NODAL, variables_.nodal);
  declare_variables(exodus.id(), file_, EX_GLOBAL, variables_.global);
  declare_variables(exodus.id(), file_, EX_ELEM_BLOCK, variables_.element.names);
  declare_blocks(exodus.id(), file_, variables_.element, static_cast<int>(blocks_.size()));
  require_written(ex_update(exodus.id()), file_, "geometry");
  exodus_id_ = exodus.release();
}

ResultsFile::ResultsFile(const std::filesystem::path& file, const Mesh& mesh, int n_frames, ResultsVariables variables)
    : file_(file), n_nodes_(mortise::n_nodes(mesh)), frame_(n_frames), variables_(std::move(variables)), blocks_(places(mesh)) {
  keep_frames(file, n_frames);
  // Of a file that is no netCDF at all the library would speak for itself.
  ExodusFile exodus = read_netcdf_header(file).kind == FileKind::other ? ExodusFile() : open_exodus(file, ExodusAccess::write);
  const int id = exodus.id();
  if (id < 0 || ex_inquire_int(id, EX_INQ_NODES) != n_nodes_ || ex_inquire_int(id, EX_INQ_TIME) < n_frames ||
      !has_variables(id, EX_NODAL, variables_.nodal) || !has_variables(id, EX_GLOBAL, variables_.global) ||
      !has_variables(id, EX_ELEM_BLOCK, variables_.element.names) ||
      !has_blocks(id, variables_.element, static_cast<int>(blocks_.size())))
    throw FileError(
        fmt::format("{}: error[I10] is not the results file of this run with its {} frames - move it away, and the "
                    "run goes on with a new one",
                    file.string(), n_frames));
  exodus_id_ = exodus.release();
}

ResultsFile::~ResultsFile() {
  if (exodus_id_ >= 0) ex_close(exodus_id_);  // every frame was flushed already, so a failure here loses nothing
}

std::vector<ResultsFile::BlockPlace> ResultsFile::places(const Mesh& mesh) {
  std::vector<BlockPlace> blocks;
  std::int64_t first = 0;
  for (const Block& block : mesh.blocks) {
    blocks.push_back({block.id, first, static_cast<std::int64_t>(block.elements.size())});
    first += blocks.back().count;
  }
  return blocks;
}

void ResultsFile::write(double time, const ResultsFrame& values) {
  assert(values.nodal.size() == variables_.nodal.size() && values.global.size() == variables_.global.size() &&
         values.element.size() == variables_.element.names.size());
  const int frame = frame_ + 1;
  const std::string last = frame_ == 0 ? "no complete frame" : fmt::format("last complete frame: {}", frame_);
  const auto require = [&](int status, const std::string& what) {
    require_written(status, file_, fmt::format("frame {} ({}): {}", frame, last, what));
  };
  require(ex_put_time(exodus_id_, frame, &time), "time");
  for (std::size_t v = 0; v < values.nodal.size(); ++v) {
    assert(values.nodal[v].size() == static_cast<std::size_t>(n_nodes_));
    require(ex_put_var(exodus_id_, frame, EX_NODAL, static_cast<int>(v) + 1, 1, n_nodes_, values.nodal[v].data()),
            variables_.nodal[v]);
  }
  const ElementVariables& element = variables_.element;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t v = 0; v < values.element.size(); ++v) {
      if (!element.in_block[b * element.names.size() + v]) continue;
      const BlockPlace& block = blocks_[b];
      require(ex_put_var(exodus_id_, frame, EX_ELEM_BLOCK, static_cast<int>(v) + 1, block.id, block.count,
                         values.element[v].data() + block.first),
              element.names[v]);
    }
  if (!values.global.empty())
    require(ex_put_var(exodus_id_, frame, EX_GLOBAL, 1, 1, static_cast<std::int64_t>(values.global.size()), values.global.data()),
            "global variables");
  require(ex_update(exodus_id_), "flush");
  frame_ = frame;
}

}  // namespace mortise
