// Reading an Exodus file into a mesh: nothing is believed before it is checked. The library works in a child process, of which
// only plain arrays come back: damaged files make it crash, hang, or write where it should not.
#include <exodusII.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <limits>
#include <optional>

#include "errors.hpp"
#include "mesh/checks.hpp"
#include "mesh/child_process.hpp"
#include "mesh/exodus.hpp"
#include "mesh/exodus_file.hpp"
#include "mesh/mesh_bytes.hpp"
#include "mesh/netcdf_header.hpp"

namespace mortise {

namespace {

/// A number counted from 1 in the file as an index from 0; what no index can hold becomes the least one, for the checks to find.
int to_index(std::int64_t number) {
  const bool fits = number > std::numeric_limits<int>::min() && number <= std::numeric_limits<int>::max();
  return fits ? static_cast<int>(number - 1) : std::numeric_limits<int>::min();
}

/// Reads the parts of one open file.
class ExodusReader {
 public:
  ExodusReader(int id, std::string source) : id_(id), errors_(source) { mesh_.source = std::move(source); }

  Mesh read() {
    sizes();
    nodes();
    blocks();
    side_sets();
    node_sets();
    errors_.throw_if_any();
    return std::move(mesh_);
  }

  MeshFrame read_last_frame() {
    MeshFrame frame;
    frame.mesh = read();
    const auto n_frames = static_cast<int>(std::max<std::int64_t>(0, ex_inquire_int(id_, EX_INQ_TIME)));
    if (n_frames == 0) errors_.add("M08", "holds no results: not one frame");
    errors_.throw_if_any();
    require(ex_get_time(id_, n_frames, &frame.time), "the time of the last frame");
    frame.nodal = variables(EX_NODAL, n_frames, frame.mesh.coordinates.size());
    frame.global = variables(EX_GLOBAL, n_frames, 1);
    return frame;
  }

 private:
  /// @param n_values of each, where there is not one array of all
  std::vector<MeshVariable> variables(ex_entity_type type, int frame, std::size_t n_values) {
    int n = 0;
    require(ex_get_variable_param(id_, type, &n), "the number of variables");
    std::vector<MeshVariable> variables(static_cast<std::size_t>(std::max(n, 0)));
    for (std::size_t v = 0; v < variables.size(); ++v) {
      std::vector<char> name(static_cast<std::size_t>(name_length_) + 1, 0);
      require(ex_get_variable_name(id_, type, static_cast<int>(v) + 1, name.data()), "the name of a variable");
      variables[v] = {name.data(), std::vector<double>(n_values)};
    }
    if (type == EX_GLOBAL) {
      std::vector<double> all(variables.size());
      if (!all.empty())
        require(ex_get_var(id_, frame, type, 1, 1, static_cast<std::int64_t>(all.size()), all.data()), "global variables");
      for (std::size_t v = 0; v < all.size(); ++v) variables[v].values[0] = all[v];
    } else {
      for (std::size_t v = 0; v < variables.size(); ++v)
        require(ex_get_var(id_, frame, type, static_cast<int>(v) + 1, 1, static_cast<std::int64_t>(n_values),
                           variables[v].values.data()),
                variables[v].name);
    }
    return variables;
  }

  /// Says that a part cannot be read, and stops: what follows would build on it.
  void require(int status, const std::string& what) {
    if (status >= 0) return;
    errors_.add("M05", fmt::format("{} cannot be read: {}", what, exodus_reason()));
    errors_.throw_if_any();
  }

  void sizes() {
    require(ex_get_init_ext(id_, &sizes_), "the sizes");
    if (sizes_.num_dim != 3) errors_.add("M02", fmt::format("the mesh has {} dimensions - must have 3", sizes_.num_dim));
    if (sizes_.num_nodes <= 0) errors_.add("M03", "no nodes");
    if (sizes_.num_elem <= 0 || sizes_.num_elem_blk <= 0) errors_.add("M03", "no elements");
    constexpr std::int64_t limit = std::numeric_limits<int>::max() / 27;
    if (sizes_.num_nodes > limit || sizes_.num_elem > limit)
      errors_.add("M06", fmt::format("{} nodes and {} elements - at most {} of each", sizes_.num_nodes, sizes_.num_elem, limit));
    errors_.throw_if_any();
    const auto length = ex_inquire_int(id_, EX_INQ_DB_MAX_USED_NAME_LENGTH);
    name_length_ = static_cast<int>(std::clamp<std::int64_t>(length, MAX_STR_LENGTH, 255));
    require(ex_set_max_name_length(id_, name_length_), "the length of names");
  }

  void nodes() {
    const auto n = static_cast<std::size_t>(sizes_.num_nodes);
    std::array<std::vector<double>, 3> x;
    for (auto& component : x) component.resize(n);
    require(ex_get_coord(id_, x[0].data(), x[1].data(), x[2].data()), "coordinates");
    mesh_.coordinates.resize(n);
    for (std::size_t a = 0; a < n; ++a) mesh_.coordinates[a] = {x[0][a], x[1][a], x[2][a]};
    mesh_.node_numbers.resize(n);
    require(ex_get_id_map(id_, EX_NODE_MAP, mesh_.node_numbers.data()), "the node number map");
  }

  void blocks() {
    std::int64_t n_found = 0;
    for (std::int64_t id : ids(EX_ELEM_BLOCK, sizes_.num_elem_blk, "blocks")) {
      Block block{id, name(EX_ELEM_BLOCK, id), ElementList()};
      ex_block stored{};
      stored.id = id;
      stored.type = EX_ELEM_BLOCK;
      require(ex_get_block_param(id_, &stored), describe(block));
      if (stored.num_entry == 0) continue;  // an empty block has no type either
      n_found += stored.num_entry;
      if (n_found > sizes_.num_elem) break;
      if (const auto type = type_of(stored, block)) {
        block.elements = ElementList(*type);
        connectivity(block, stored.num_entry);
        mesh_.blocks.push_back(std::move(block));
      }
    }
    if (n_found != sizes_.num_elem)
      errors_.add("M05", fmt::format("the blocks do not hold the {} elements that the file announces", sizes_.num_elem));
    mesh_.element_numbers.resize(static_cast<std::size_t>(sizes_.num_elem));
    require(ex_get_id_map(id_, EX_ELEM_MAP, mesh_.element_numbers.data()), "the element number map");
  }

  /// The type by name and number of nodes; files write "HEX", "hex8" and "HEXAHEDRON" for the same, and "BAR", "BEAM" or "TRUSS".
  std::optional<ElementType> type_of(const ex_block& stored, const Block& block) {
    std::string word(stored.topology, strnlen(stored.topology, MAX_STR_LENGTH));
    word.erase(std::find(word.begin(), word.end(), ' '), word.end());
    std::string upper = word;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const char* bar : {"BEAM", "TRUSS"})
      if (upper.rfind(bar, 0) == 0) upper.replace(0, std::string(bar).size(), "BAR");
    std::vector<ElementType> types(element_types.begin(), element_types.end());
    types.insert(types.end(), discrete_types.begin(), discrete_types.end());
    std::vector<std::string> names;
    for (ElementType type : types) {
      const Topology& known = topology(type);
      names.push_back(known.name);
      const std::string stem = known.shape.substr(0, 3);  // TET, TETRA; WED, WEDGE; HEX
      if (upper.rfind(stem, 0) != 0 || stored.num_nodes_per_entry != known.n_nodes) continue;
      const std::size_t digits = upper.find_first_of("0123456789");
      if (digits == std::string::npos || upper.substr(digits) == std::to_string(known.n_nodes)) return type;
    }
    errors_.add("M12", fmt::format("{}: element type {} with {} nodes is not supported - supported: {}", describe(block), word,
                                   stored.num_nodes_per_entry, join(names)));
    return std::nullopt;
  }

  void connectivity(Block& block, std::int64_t n) {
    std::vector<std::int64_t> nodes(block.elements.n_nodes() * static_cast<std::size_t>(n));
    require(ex_get_conn(id_, EX_ELEM_BLOCK, block.id, nodes.data(), nullptr, nullptr),
            fmt::format("the elements of {}", describe(block)));
    for (std::int64_t node : nodes) block.elements.nodes().push_back(to_index(node));
  }

  /// Members of a set; `faces` only for side sets.
  std::vector<std::int64_t> members(ex_entity_type type, std::int64_t set, const std::string& what,
                                    std::vector<std::int64_t>* faces) {
    std::int64_t n = 0, n_factors = 0;
    require(ex_get_set_param(id_, type, set, &n, &n_factors), what);
    if (n < 0 || n > std::numeric_limits<int>::max()) {
      errors_.add("M06", fmt::format("{} has {} members - at most {}", what, n, std::numeric_limits<int>::max()));
      errors_.throw_if_any();
    }
    std::vector<std::int64_t> entries(static_cast<std::size_t>(n));
    if (faces != nullptr) faces->resize(entries.size());
    if (n > 0) require(ex_get_set(id_, type, set, entries.data(), faces != nullptr ? faces->data() : nullptr), what);
    return entries;
  }

  void side_sets() {
    for (std::int64_t id : ids(EX_SIDE_SET, sizes_.num_side_sets, "side sets")) {
      SideSet set{id, name(EX_SIDE_SET, id), {}};
      std::vector<std::int64_t> faces;
      const std::vector<std::int64_t> elements = members(EX_SIDE_SET, id, describe(set), &faces);
      for (std::size_t i = 0; i < elements.size(); ++i) set.sides.push_back({to_index(elements[i]), to_index(faces[i])});
      mesh_.side_sets.push_back(std::move(set));
    }
  }

  void node_sets() {
    for (std::int64_t id : ids(EX_NODE_SET, sizes_.num_node_sets, "node sets")) {
      NodeSet set{id, name(EX_NODE_SET, id), {}};
      for (std::int64_t node : members(EX_NODE_SET, id, describe(set), nullptr)) set.nodes.push_back(to_index(node));
      mesh_.node_sets.push_back(std::move(set));
    }
  }

  std::vector<std::int64_t> ids(ex_entity_type type, std::int64_t n, const std::string& what) {
    if (n <= 0) return {};
    std::vector<std::int64_t> ids(static_cast<std::size_t>(n));
    require(ex_get_ids(id_, type, ids.data()), fmt::format("the ids of the {}", what));
    return ids;
  }

  std::string name(ex_entity_type type, std::int64_t entity) {
    std::vector<char> buffer(static_cast<std::size_t>(name_length_) + 2, '\0');
    require(ex_get_name(id_, type, entity, buffer.data()), fmt::format("the name of {} {}", ex_name_of_object(type), entity));
    std::string name(buffer.data());
    name.erase(name.find_last_not_of(' ') + 1);
    return name;
  }

  int id_;
  int name_length_ = MAX_STR_LENGTH;
  ex_init_params sizes_{};
  MeshErrors errors_;
  Mesh mesh_;
};

/// The header must read well and promise just the bytes that the file has.
void check_header(const NetcdfHeader& header, MeshErrors& errors) {
  if (header.kind == FileKind::other) {
    errors.add("M01", "this is not an Exodus file (neither netCDF classic nor netCDF-4)");
  } else if (!header.fault.empty()) {
    errors.add("M04", fmt::format("the netCDF header is broken or truncated: {}", header.fault));
  } else if (header.n_bytes < header.n_required) {
    errors.add("M04", fmt::format("the file has {} bytes, its header requires {}: truncated", header.n_bytes, header.n_required));
  } else if (header.n_bytes > header.n_required) {
    errors.add("M04", fmt::format("the file has {} bytes, its header describes {}: the header is damaged, or the file was being "
                                  "written",
                                  header.n_bytes, header.n_required));
  }
  errors.throw_if_any();
}

/// All that the library does, with a reader of the open file.
/// @throws MeshError
template <class Read>
auto read_by_library(const std::filesystem::path& file, Read read) {
  const ExodusFile exodus = open_exodus(file);
  MeshErrors errors(file.string());
  if (exodus.id() < 0) errors.add("M01", fmt::format("this is not an Exodus file: {}", exodus_reason()));
  errors.throw_if_any();
  return read(ExodusReader(exodus.id(), file.string()));
}

/// What reading an honest file of that size never needs; a damaged one is to be given up within 2 s.
ChildLimits limits_for(std::uint64_t n_bytes) {
  constexpr std::uint64_t slowest_disk = 10'000'000;  // bytes per second
  const auto seconds = static_cast<unsigned>(1 + n_bytes / slowest_disk);
  return {seconds, 30 * seconds, (std::uint64_t{2} << 30) + 100 * n_bytes};  // a hundredfold: netCDF-4 may be compressed
}

/// Bytes of what `read` makes of the file, in a child process: damaged files make the library crash, hang or swallow memory.
/// @throws MeshError, FileError
template <class Read>
std::string read_in_child(const std::filesystem::path& file, Read read) {
  MeshErrors errors(file.string());
  const NetcdfHeader header = read_netcdf_header(file);
  check_header(header, errors);

  constexpr char good = 'm', bad = 'e';  // at the end, where it moves nothing
  const auto work = [&] {
    std::string answer;
    try {
      answer = bytes_of(read_by_library(file, read));
      answer += good;
    } catch (const MeshError& error) {
      answer = error.what();
      answer += bad;
    }
    return answer;
  };
  ChildResult result = run_in_child(work, limits_for(header.n_bytes));
  if (!result.failure.empty())
    errors.add("M04", fmt::format("the mesh library fails on it ({}): the file is damaged", result.failure));
  errors.throw_if_any();
  const char outcome = result.bytes.at(result.bytes.size() - 1);
  result.bytes.pop_back();
  if (outcome == bad) throw MeshError(result.bytes);
  return std::move(result.bytes);
}

}  // namespace

Mesh read_exodus(const std::filesystem::path& file) {
  Mesh mesh = mesh_of(read_in_child(file, [](ExodusReader reader) { return reader.read(); }));
  check_mesh(mesh);
  return mesh;
}

MeshFrame read_last_frame(const std::filesystem::path& file) {
  MeshFrame frame = frame_of(read_in_child(file, [](ExodusReader reader) { return reader.read_last_frame(); }));
  check_mesh(frame.mesh);
  return frame;
}

const std::vector<double>* MeshFrame::at_nodes(const std::string& name) const {
  for (const MeshVariable& variable : nodal)
    if (variable.name == name) return &variable.values;
  return nullptr;
}

}  // namespace mortise
