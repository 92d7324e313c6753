#include "make_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "errors.hpp"
#include "mesh/exodus.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;

class StartMaker {
 public:
  StartMaker(const DeckNames& names, Scene& scene) : names_(names), scene_(scene) {}

  void run() {
    for (const Body& body : scene_.bodies) carry(body.name, body.initial, body.nodes);
    for (const String& string : scene_.strings) carry(string.name, string.initial, string.nodes);
    for (const PointMasses& masses : scene_.masses) carry(masses.name, masses.initial, masses.nodes);
  }

 private:
  void carry(const std::string& name, const std::optional<InitialOptions>& initial, const std::vector<int>& nodes) {
    if (!initial || !initial->state) return;
    const DeckPath place{"initial conditions", name, "state"};
    fs::path file = names_.deck().file().parent_path() / *initial->state;
    if (fs::is_directory(file)) file /= "results.e";
    if (!fs::exists(file)) {
      names_.error("D14", place, fmt::format("there is no file \"{}\" - results of a run are needed", file.string()));
      return;
    }
    const Source& source = source_of(file);
    const MeshFrame& frame = source.frame;
    const auto displacement = vector_of(frame, "displacement", file, place), velocity = vector_of(frame, "velocity", file, place);
    if (displacement[0] == nullptr) return;
    if (velocity[0] == nullptr && is_moving(frame)) {
      names_.error(
          "D20", place,
          fmt::format("\"{}\" ends in motion, but has no velocities - run it again with \"velocity\" among the \"fields\" "
                      "of its `output`",
                      file.string()));
      return;
    }
    const std::vector<int> there = counterparts(source, file, nodes, place);
    if (there.empty()) return;
    if (!scene_.carried) {
      const std::size_t n = scene_.mesh.mesh.coordinates.size();
      scene_.carried = CarriedState{
          std::vector<char>(n, 0), std::vector<Vec3<double>>(n), std::vector<Vec3<double>>(n), std::vector<double>(n, 0.0), {}};
    }
    scene_.carried->files.emplace_back(name, file);
    const std::vector<double>* pressure = frame.at_nodes("contact_pressure");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const int node = nodes[k], other = there[k];
      scene_.carried->has[node] = 1;
      for (int i = 0; i < 3; ++i) {
        scene_.carried->displacement[node][i] = (*displacement[i])[other];
        scene_.carried->velocity[node][i] = velocity[i] ? (*velocity[i])[other] : 0;
      }
      if (pressure) scene_.carried->pressure[node] = (*pressure)[other];
    }
  }

  /// A file, and which of its nodes are those of the scene: by blocks of the same name, element by element; -1: none.
  struct Source {
    MeshFrame frame;
    std::vector<int> nodes;
  };

  const Source& source_of(const fs::path& file) {
    if (const auto known = sources_.find(file); known != sources_.end()) return known->second;
    const Mesh& mesh = scene_.mesh.mesh;
    Source source{read_last_frame(file), std::vector<int>(mesh.coordinates.size(), -1)};
    for (const Block& block : mesh.blocks)
      for (const Block& match : source.frame.mesh.blocks) {
        const auto &mine = block.elements.nodes(), &others = match.elements.nodes();
        if (match.name != block.name || match.elements.type() != block.elements.type() || others.size() != mine.size()) continue;
        for (std::size_t k = 0; k < mine.size(); ++k) source.nodes[mine[k]] = others[k];
      }
    return sources_.emplace(file, std::move(source)).first->second;
  }

  /// The components of a nodal vector; null, and an error where the vector must be there or is broken off.
  std::array<const std::vector<double>*, 3> vector_of(const MeshFrame& frame, const std::string& field, const fs::path& file,
                                                      const DeckPath& place) const {
    std::array<const std::vector<double>*, 3> components{};
    int n = 0;
    for (int i = 0; i < 3; ++i) {
      const std::string name = field + "_" + "xyz"[i];
      components[i] = frame.at_nodes(name);
      if (components[i] == nullptr) continue;
      ++n;
      for (double value : *components[i])
        if (!std::isfinite(value)) {
          names_.error("D20", place, fmt::format("\"{}\" has a value of {} that is not finite", file.string(), name));
          return {};
        }
    }
    if (n == 3 || (n == 0 && field != "displacement")) return components;
    names_.error("D20", place,
                 fmt::format("\"{}\" has no nodal variables {}_x, {}_y and {}_z", file.string(), field, field, field));
    return {};
  }

  /// Whether the run says so itself.
  static bool is_moving(const MeshFrame& frame) {
    for (const MeshVariable& variable : frame.global)
      if (variable.name == "kinetic_energy") return variable.values[0] > 0;
    return false;
  }

  /// The nodes of a file that stand for these of the scene. Empty after an error.
  std::vector<int> counterparts(const Source& source, const fs::path& file, const std::vector<int>& nodes,
                                const DeckPath& place) const {
    std::vector<int> found;
    for (int node : nodes) {
      const int there = source.nodes[node];
      const auto fail = [&](const std::string& what) {
        names_.error("D20", place, fmt::format("{} {} in \"{}\"", describe_node(scene_.mesh, node), what, file.string()));
        return std::vector<int>{};
      };
      if (there < 0) return fail("has no counterpart: no element block with the name and the elements of its own is");
      const Point &X = scene_.mesh.mesh.coordinates[node], &Y = source.frame.mesh.coordinates[there];
      const double apart = norm(vec3(X) - vec3(Y));
      if (apart > 1e-9 * scene_.extent) return fail(fmt::format("is {:.3g} away from where its reference position is", apart));
      found.push_back(there);
    }
    return found;
  }

  const DeckNames& names_;
  Scene& scene_;
  std::map<fs::path, Source> sources_;
};

}  // namespace

void make_start(const DeckNames& names, Scene& scene) { StartMaker(names, scene).run(); }

}  // namespace mortise
