#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assembly/formulations.hpp"
#include "deck/stages.hpp"
#include "errors.hpp"
#include "make_bodies.hpp"
#include "make_loads.hpp"
#include "make_material.hpp"
#include "make_obstacles.hpp"
#include "make_pairs.hpp"
#include "make_start.hpp"
#include "make_ties.hpp"
#include "mesh/suspicions.hpp"
#include "sha256.hpp"

namespace mortise {
namespace {

/// The modulus [Pa] that makes stress of the round-off of positions: changes of volume meet the bulk modulus, which is far above
/// Young's where a material can hardly be compressed, unless a pressure of its own takes its place.
double stiffest_modulus(const Body& body) {
  const Moduli moduli = small_strain_moduli(body.material);
  return body.formulation == FormulationKind::mixed ? moduli.youngs_modulus()
                                                    : std::max(moduli.youngs_modulus(), moduli.bulk_modulus());
}

/// Makes the scene part by part; errors are gathered so that the user sees them together.
class SceneMaker {
 public:
  SceneMaker(const Deck& deck, std::vector<std::string>& warnings)
      : deck_(deck), options_(deck.options()), warnings_(warnings), names_(deck, scene_.mesh, errors_) {}

  Scene make() {
    std::vector<std::pair<std::string, Mesh>> meshes;
    for (const auto& [name, mesh] : options_.meshes) meshes.emplace_back(name, checked_mesh(name, mesh));
    scene_.title = options_.title;
    scene_.mesh = combine(meshes);
    for (const DeckStage& stage : stages_of(options_))
      scene_.stages.push_back({stage.name, stage.begin, *stage.time, stage.scheme()});
    scene_.solver = options_.solver;
    scene_.output = options_.output;
    scene_.checkpoints = options_.checkpoints;
    scene_.expected = options_.expected;
    warn_of_odd_materials();
    make_bodies(names_, scene_, warnings_);
    stop_at_errors();  // what follows needs bodies
    number_pressures();
    make_supports(names_, scene_);
    make_springs(names_, scene_);
    make_loads(names_, scene_);
    set_scales();
    make_pairs(names_, scene_, mesh_errors_, warnings_);
    make_ties(names_, scene_, mesh_errors_, warnings_);
    make_obstacles(names_, scene_);
    add_stops(scene_);
    make_start(names_, scene_);
    check_motions(names_, scene_);
    make_probes();
    check_points();
    stop_at_errors();
    return std::move(scene_);
  }

 private:
  void error(const std::string& code, const DeckPath& path, const std::string& what) {
    errors_.push_back(deck_.error(code, path, what));
  }
  void stop_at_errors() const {
    if (!errors_.empty()) throw DeckError(errors_);
    if (!mesh_errors_.empty()) throw MeshError(mesh_errors_);
  }

  Mesh checked_mesh(const std::string& name, const MeshOptions& o) {
    const auto folder = deck_.file().parent_path();
    if (o.sha256) {
      const std::string found = sha256_of_file(folder / *o.file);
      if (found != *o.sha256)
        throw MeshError(deck_.error("M07", {"meshes", name, "sha256"},
                                    fmt::format("\"{}\" is another file than the deck means: its sha256 is {}, the deck's {}",
                                                *o.file, found, *o.sha256)));
    }
    Mesh mesh = make_mesh(o, folder);
    for (const auto& warning : mesh_warnings(mesh)) warnings_.push_back(fmt::format("meshes > {}: {}", name, warning));
    return mesh;
  }

  void warn_of_odd_materials() {
    for (const auto& [name, o] : options_.materials)
      if (const std::string what = oddity(make_material(o)); !what.empty())
        warnings_.push_back(fmt::format("materials > {}: {}", name, what));
  }

  /// A node without an equation of its own makes the matrix singular: what bodies do not hold needs inertia, or what holds it.
  void check_points() {
    const auto is_moving = [](const Stage& stage) { return stage.scheme.has_inertia(); };
    if (std::any_of(scene_.stages.begin(), scene_.stages.end(), is_moving)) check_points(true);
    if (!std::all_of(scene_.stages.begin(), scene_.stages.end(), is_moving)) check_points(false);
  }
  void check_points(bool has_inertia) {
    std::vector<std::array<char, 3>> held(scene_.mesh.mesh.coordinates.size(), {0, 0, 0});
    const auto hold = [&](int node) { held[node] = {1, 1, 1}; };
    for (const Body& body : scene_.bodies) std::for_each(body.nodes.begin(), body.nodes.end(), hold);
    for (const String& string : scene_.strings) std::for_each(string.nodes.begin(), string.nodes.end(), hold);
    if (has_inertia) {
      for (const auto& masses : scene_.masses) std::for_each(masses.nodes.begin(), masses.nodes.end(), hold);
    } else {
      for (const Spring& spring : scene_.springs)
        for (int node : spring.nodes)
          for (int i = 0; i < 3; ++i) held[node][i] |= spring.stiffness[i] > 0;
      for (const NodeSpring& spring : scene_.node_springs) {
        hold(spring.from);
        if (spring.to) hold(*spring.to);
      }
    }
    for (const PrescribedDof& p : scene_.prescribed)
      if (scene_.supports[p.support].activity.always()) held[p.node][p.axis] = 1;
    for (const MeshPart& part : scene_.mesh.parts)
      for (int node = part.first_node; node < part.first_node + part.n_nodes; ++node) {
        if (held[node] == std::array<char, 3>{1, 1, 1}) continue;
        error("D22", {"meshes", part.name},
              fmt::format("{} can move, and has no {} - give it {}, or supports in x, y and z", describe_node(scene_.mesh, node),
                          has_inertia ? "inertia" : "stiffness", has_inertia ? "a mass" : "springs"));
        break;
      }
  }

  void number_pressures() {
    std::vector<int> count(static_cast<std::size_t>(n_elements(scene_.mesh.mesh)), 0);
    int n = 0;
    for (const Body& body : scene_.bodies)
      for (int e : body.elements) n += count[e] = n_pressures(body.formulation, element_type(scene_.mesh.mesh, e));
    if (n == 0) return;
    scene_.first_pressure = {0};
    for (int c : count) scene_.first_pressure.push_back(scene_.first_pressure.back() + c);
  }

  void make_probes() {
    for (const auto& [name, o] : options_.probes) {
      if (const auto node = names_.node_of(o.mesh, o.node, o.nearest, {"probes", name}))
        scene_.probes.push_back({name, o.quantity, *node});
    }
  }

  void set_scales() {
    double extent = 0, size = 0;
    for (const Point& X : scene_.mesh.mesh.coordinates)
      for (double x : X) extent = std::max(extent, std::abs(x));
    const auto meet = [&](double h) { size = size > 0 ? std::min(size, h) : h; };
    for (const Body& body : scene_.bodies) meet(body.size);
    for (const String& string : scene_.strings) meet(string.size);
    for (const NodeSpring& spring : scene_.node_springs) meet(spring.rest_length);
    if (!(size > 0)) size = extent > 0 ? extent : 1;  // masses alone
    double stiffness = 0, greatest = 0;
    for (const Body& body : scene_.bodies) {
      stiffness = std::max(stiffness, stiffest_modulus(body) * size);
      greatest = std::max(greatest, stiffest_modulus(body) * body.stiffest);
    }
    for (const String& string : scene_.strings) stiffness = std::max(stiffness, string.axial_stiffness / string.size);
    for (const NodeSpring& spring : scene_.node_springs) stiffness = std::max(stiffness, spring.stiffness);
    if (scene_.bodies.empty())
      for (const Spring& spring : scene_.springs)
        stiffness = std::max(stiffness, *std::max_element(spring.stiffness.begin(), spring.stiffness.end()));
    scene_.size = size;
    scene_.extent = extent;
    scene_.force_floor = 1e-14 * std::max(stiffness, greatest) * (size + extent);
    scene_.pressure_floor = 1e-14 * stiffness * (size + extent) / (size * size);
  }

  const Deck& deck_;
  const DeckOptions& options_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> errors_, mesh_errors_;
  Scene scene_;
  DeckNames names_;
};

}  // namespace

bool Scene::has_inertia() const {
  return std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.scheme.has_inertia(); });
}

bool Scene::has_friction() const {
  return std::any_of(pairs.begin(), pairs.end(), [](const ContactPair& pair) { return pair.friction.has_value(); });
}

std::vector<const ContactNodes*> Scene::contacts() const {
  std::vector<const ContactNodes*> all;
  for (const auto& pair : pairs) all.push_back(&pair);
  for (const auto& tie : ties) all.push_back(&tie);
  for (const auto& obstacle : obstacles) all.push_back(&obstacle);
  return all;
}

std::vector<const ContactNodes*> Scene::contacts_with_pressures() const {
  std::vector<const ContactNodes*> all;
  for (const auto& pair : pairs) all.push_back(&pair);
  for (const auto& obstacle : obstacles) all.push_back(&obstacle);
  return all;
}

Scene make_scene(const Deck& deck, std::vector<std::string>& warnings) { return SceneMaker(deck, warnings).make(); }

}  // namespace mortise
