// Writing the geometry of a mesh to an Exodus file.
#include <exodusII.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/exodus.hpp"
#include "mesh/exodus_file.hpp"

#ifndef MORTISE_VERSION
#define MORTISE_VERSION "unknown"
#endif

namespace mortise {

namespace {

/// The strings as the library wants them: an array of pointers to writable characters, valid as long as this object.
class Names {
 public:
  explicit Names(std::vector<std::string> names) : names_(std::move(names)) {
    for (std::string& name : names_) pointers_.push_back(name.data());
  }
  char** data() { return pointers_.data(); }

 private:
  std::vector<std::string> names_;
  std::vector<char*> pointers_;
};

template <class Entity>
std::vector<std::string> names_of(const std::vector<Entity>& entities) {
  std::vector<std::string> names;
  for (const Entity& entity : entities) names.push_back(entity.name);
  return names;
}

/// Does a number or id of the mesh need more than 32 bits?
bool needs_64_bits(const Mesh& mesh) {
  const auto large = [](std::int64_t n) { return n > std::numeric_limits<std::int32_t>::max(); };
  const auto large_id = [&](const auto& entity) { return large(entity.id); };
  return std::any_of(mesh.node_numbers.begin(), mesh.node_numbers.end(), large) ||
         std::any_of(mesh.element_numbers.begin(), mesh.element_numbers.end(), large) ||
         std::any_of(mesh.blocks.begin(), mesh.blocks.end(), large_id) ||
         std::any_of(mesh.side_sets.begin(), mesh.side_sets.end(), large_id) ||
         std::any_of(mesh.node_sets.begin(), mesh.node_sets.end(), large_id);
}

int longest_name(const Mesh& mesh, const std::vector<std::string>& variables) {
  std::size_t longest = MAX_STR_LENGTH;  // readers that never ask for the length expect this one
  for (const auto& names : {names_of(mesh.blocks), names_of(mesh.side_sets), names_of(mesh.node_sets), variables})
    for (const std::string& name : names) longest = std::max(longest, name.size());
  return static_cast<int>(std::min<std::size_t>(longest, 255));  // the most that netCDF takes
}

/// Writes the parts of the geometry to one open file, each checked.
class GeometryWriter {
 public:
  GeometryWriter(int id, const std::filesystem::path& file, const Mesh& mesh) : id_(id), file_(file), mesh_(mesh) {}

  void sizes(const std::string& title) const {
    ex_init_params sizes{};
    title.copy(sizes.title, MAX_LINE_LENGTH);
    sizes.num_dim = 3;
    sizes.num_nodes = n_nodes(mesh_);
    sizes.num_elem = n_elements(mesh_);
    sizes.num_elem_blk = static_cast<std::int64_t>(mesh_.blocks.size());
    sizes.num_node_sets = static_cast<std::int64_t>(mesh_.node_sets.size());
    sizes.num_side_sets = static_cast<std::int64_t>(mesh_.side_sets.size());
    require(ex_put_init_ext(id_, &sizes), "sizes");
  }

  void origin() const {
    Names record({"mortise", MORTISE_VERSION, "", ""});  // no date: the same run gives the same bytes
    char* records[1][4] = {{record.data()[0], record.data()[1], record.data()[2], record.data()[3]}};
    require(ex_put_qa(id_, 1, records), "QA record");
  }

  void nodes() const {
    std::array<std::vector<double>, 3> x;
    for (const Point& point : mesh_.coordinates)
      for (std::size_t i = 0; i < 3; ++i) x[i].push_back(point[i]);
    require(ex_put_coord(id_, x[0].data(), x[1].data(), x[2].data()), "coordinates");
    Names axes({"x", "y", "z"});
    require(ex_put_coord_names(id_, axes.data()), "coordinate names");
    require(ex_put_id_map(id_, EX_NODE_MAP, mesh_.node_numbers.data()), "node numbers");
  }

  void blocks() const {
    for (const Block& block : mesh_.blocks) {
      const auto n = static_cast<std::int64_t>(block.elements.size());
      const Topology& of = topology(block.elements.type());
      const std::string kind = of.shape + (of.n_nodes > 1 ? std::to_string(of.n_nodes) : "");
      require(ex_put_block(id_, EX_ELEM_BLOCK, block.id, kind.c_str(), n, of.n_nodes, 0, 0, 0), "block");
      std::vector<std::int64_t> nodes;
      for (int a : block.elements.nodes()) nodes.push_back(a + 1);
      if (n > 0) require(ex_put_conn(id_, EX_ELEM_BLOCK, block.id, nodes.data(), nullptr, nullptr), "connectivity");
    }
    names(EX_ELEM_BLOCK, names_of(mesh_.blocks));
    if (n_elements(mesh_) > 0) require(ex_put_id_map(id_, EX_ELEM_MAP, mesh_.element_numbers.data()), "element numbers");
  }

  void side_sets() const {
    for (const SideSet& set : mesh_.side_sets) {
      std::vector<std::int64_t> elements, faces;
      for (const Side& side : set.sides) {
        elements.push_back(side.element + 1);
        faces.push_back(side.face + 1);
      }
      put_set(EX_SIDE_SET, set.id, elements, faces.data());
    }
    names(EX_SIDE_SET, names_of(mesh_.side_sets));
  }

  void node_sets() const {
    for (const NodeSet& set : mesh_.node_sets) {
      std::vector<std::int64_t> nodes;
      for (int a : set.nodes) nodes.push_back(a + 1);
      put_set(EX_NODE_SET, set.id, nodes, nullptr);
    }
    names(EX_NODE_SET, names_of(mesh_.node_sets));
  }

 private:
  void require(int status, const std::string& what) const { require_written(status, file_, what); }

  void put_set(ex_entity_type type, std::int64_t set, const std::vector<std::int64_t>& entries, const std::int64_t* faces) const {
    require(ex_put_set_param(id_, type, set, static_cast<std::int64_t>(entries.size()), 0), "set");
    if (!entries.empty()) require(ex_put_set(id_, type, set, entries.data(), faces), "set members");
  }

  void names(ex_entity_type type, const std::vector<std::string>& names) const {
    if (names.empty()) return;
    Names pointers(names);
    require(ex_put_names(id_, type, pointers.data()), "names");
  }

  int id_;
  const std::filesystem::path& file_;
  const Mesh& mesh_;
};

}  // namespace

ExodusFile create_exodus(const std::filesystem::path& file, const Mesh& mesh, const std::string& title,
                         const std::vector<std::string>& variables) {
  assert(mesh.node_numbers.size() == mesh.coordinates.size());
  assert(mesh.element_numbers.size() == static_cast<std::size_t>(n_elements(mesh)));
  ex_opts(EX_DEFAULT);
  const int format = needs_64_bits(mesh) ? EX_NETCDF4 | EX_ALL_INT64_DB : EX_LARGE_MODEL;
  int memory_word = sizeof(double), file_word = sizeof(double);
  ExodusFile exodus(ex_create(file.c_str(), EX_CLOBBER | format | EX_ALL_INT64_API, &memory_word, &file_word));
  require_written(exodus.id(), file, "create");
  require_written(ex_set_max_name_length(exodus.id(), longest_name(mesh, variables)), file, "length of names");
  const GeometryWriter writer(exodus.id(), file, mesh);
  writer.sizes(title);
  writer.origin();
  writer.nodes();
  writer.blocks();
  writer.side_sets();
  writer.node_sets();
  return exodus;
}

void write_exodus(const Mesh& mesh, const std::filesystem::path& file, const std::string& title) {
  ExodusFile exodus = create_exodus(file, mesh, title);
  require_written(exodus.close() ? 0 : -1, file, "close");
}

}  // namespace mortise
