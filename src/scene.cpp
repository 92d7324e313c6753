#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "assembly/formulations.hpp"
#include "errors.hpp"
#include "make_loads.hpp"
#include "make_material.hpp"
#include "make_obstacles.hpp"
#include "mesh/contact_sides.hpp"
#include "mesh/suspicions.hpp"
#include "physics/elements/geometry.hpp"
#include "physics/traction.hpp"
#include "sha256.hpp"

namespace mortise {
namespace {

using Path = std::vector<std::string>;

template <class T>
const T& named(const Named<T>& list, const std::string& name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; })->second;
}

/// Reference volume of element `e` [m^3].
double element_volume(const Mesh& mesh, int e) {
  return with_element(element_type(mesh, e), [&](auto element) {
    ElementNodes<decltype(element)> X;
    for (std::size_t a = 0; a < X.size(); ++a) X[a] = mesh.coordinates[element_nodes(mesh, e)[a]];
    return volume(reference_geometry<decltype(element)>(X));
  });
}

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
    scene_.time = options_.time;
    scene_.scheme = scheme_of(options_.time.scheme);
    scene_.solver = options_.solver;
    scene_.output = options_.output;
    scene_.checkpoints = options_.checkpoints;
    scene_.expected = options_.expected;
    warn_of_odd_materials();
    make_bodies();
    make_strings();
    make_masses();
    stop_at_errors();  // what follows needs bodies
    make_supports(names_, scene_);
    make_springs(names_, scene_);
    make_loads(names_, scene_);
    set_scales();
    make_pairs();
    make_obstacles(names_, scene_);
    add_stops(scene_);
    check_motions(names_, scene_);
    make_probes();
    check_points();
    stop_at_errors();
    return std::move(scene_);
  }

 private:
  void error(const std::string& code, const Path& path, const std::string& what) {
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

  /// The blocks of a body or string: those that it names, or all of the right kind. Faulty ones are told and left out.
  std::vector<int> blocks_of(const std::string& list, const std::string& name, const std::string& mesh,
                             const std::vector<std::string>& named_blocks, bool (*is_right)(ElementType),
                             const std::string& right_ones) {
    const MeshPart& part = *find_part(scene_.mesh, mesh);
    const auto& all = scene_.mesh.mesh.blocks;
    std::vector<int> blocks;
    if (named_blocks.empty()) {
      for (int b = part.first_block; b < part.first_block + part.n_blocks; ++b)
        if (is_right(all[b].elements.type())) blocks.push_back(b);
      if (blocks.empty()) error("D19", {list, name, "mesh"}, fmt::format("has no {}, which {} are made of", right_ones, list));
    }
    for (const auto& block : named_blocks) {
      const auto found = find_block(scene_.mesh, part, block);
      if (!found) {
        const auto names = block_names(scene_.mesh, part);
        error("D20", {list, name, "blocks"},
              fmt::format("mesh \"{}\" has no block \"{}\"{}; it has: {}", mesh, block, did_you_mean(block, names), join(names)));
      } else if (!is_right(all[*found].elements.type())) {
        error("D19", {list, name, "blocks"},
              fmt::format("block \"{}\" has {} elements - {} are made of {}", block, topology(all[*found].elements.type()).name,
                          list, right_ones));
      } else {
        blocks.push_back(*found);
      }
    }
    return blocks;
  }

  /// Elements of a block, by their numbers over all blocks.
  std::vector<int> elements_of_block(int block) const {
    int first = 0;
    for (int b = 0; b < block; ++b) first += static_cast<int>(scene_.mesh.mesh.blocks[b].elements.size());
    std::vector<int> elements(scene_.mesh.mesh.blocks[block].elements.size());
    std::iota(elements.begin(), elements.end(), first);
    return elements;
  }

  /// Nodes of some elements, ascending.
  std::vector<int> nodes_of_elements(const std::vector<int>& elements) const {
    std::vector<int> nodes;
    for (int e : elements) {
      const ElementNodeList of_element = element_nodes(scene_.mesh.mesh, e);
      nodes.insert(nodes.end(), of_element.begin(), of_element.end());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void make_bodies() {
    const Mesh& mesh = scene_.mesh.mesh;
    std::vector<std::string> owner(mesh.blocks.size());
    for (const auto& [name, o] : options_.bodies) {
      const std::vector<int> blocks = blocks_of("bodies", name, o.mesh, o.blocks, is_solid, "solid elements");
      const MaterialOptions& of_material = named(options_.materials, o.material);
      const Material material = make_material(of_material);
      check_formulation(name, o.formulation, material);
      Body body{name,
                material,
                o.formulation,
                o.tangent,
                o.kinematics,
                {},
                {},
                small_strain_moduli(material).youngs_modulus(),
                0,
                of_material.density,
                o.mass,
                o.rayleigh,
                initial_motion(name)};
      for (int b : blocks) {
        if (!owner[b].empty())
          error("D19", {"bodies", name},
                fmt::format("block \"{}\" belongs to body \"{}\" already - a block has one material", mesh.blocks[b].name,
                            owner[b]));
        owner[b] = name;
        const auto elements = elements_of_block(b);
        body.elements.insert(body.elements.end(), elements.begin(), elements.end());
      }
      if (body.elements.empty()) continue;
      std::sort(body.elements.begin(), body.elements.end());
      double volume = 0;
      for (int e : body.elements) volume += element_volume(mesh, e);
      body.nodes = nodes_of_elements(body.elements);
      check_elements(name, body);
      check_mass(name, body);
      warn_of_locking(name, body);
      body.size = std::cbrt(volume / std::max<std::size_t>(1, body.elements.size()));
      scene_.bodies.push_back(std::move(body));
    }
    for (std::size_t b = 0; b < owner.size(); ++b)
      if (owner[b].empty() && is_solid(mesh.blocks[b].elements.type()))
        error("D19", {"bodies"},
              fmt::format("block \"{}\" belongs to no body - every block needs a material", mesh.blocks[b].name));
    if (errors_.empty()) number_pressures();
  }

  /// A pressure of their own is what elements of incompressible materials need, and what needs a material that is split.
  void check_formulation(const std::string& name, FormulationKind formulation, const Material& material) {
    std::visit(
        [&](const auto& m) {
          using M = std::decay_t<decltype(m)>;
          if (formulation != FormulationKind::mixed && is_incompressible<M>())
            error("D19", {"bodies", name, "material"},
                  "the material is incompressible - elements without a pressure of their own cannot hold its volume: "
                  "\"formulation\" must be \"mixed\"");
          if (formulation == FormulationKind::mixed && !is_split<M>)
            error(
                "D19", {"bodies", name, "formulation"},
                fmt::format("\"mixed\" needs a material that is split into distortion and volume, or incompressible - \"{}\" is "
                            "not",
                            m.name));
        },
        material);
    if (formulation == FormulationKind::mixed && options_.solver.linear == LinearSolverKind::iterative)
      error("D19", {"bodies", name, "formulation"},
            "\"mixed\" needs the direct solver - solver > \"linear\" must be \"direct\" or \"auto\"");
  }

  /// Linear elements without a cure lose a twentieth of their deflection in bending at 0.49 (inputs/cook), and nearly all beyond.
  void warn_of_locking(const std::string& name, const Body& body) {
    const double ratio = small_strain_moduli(body.material).poissons_ratio();
    if (body.formulation != FormulationKind::standard || ratio <= 0.45) return;
    for (int e : body.elements) {
      const Topology& type = topology(element_type(scene_.mesh.mesh, e));
      if (type.n_nodes != type.n_corners) continue;
      warnings_.push_back(
          fmt::format("bodies > {}: Poisson's ratio is {:.5g} at small strain, where {} elements of \"formulation\" "
                      "= \"standard\" lock (too stiff) - f-bar, enhanced strain, mixed or quadratic ones do less",
                      name, ratio, type.name));
      return;
    }
  }

  std::optional<InitialOptions> initial_motion(const std::string& body) const {
    for (const auto& [name, o] : options_.initial_conditions)
      if (name == body) return o;
    return std::nullopt;
  }

  void check_elements(const std::string& name, const Body& body) {
    for (int e : body.elements) {
      const ElementType type = element_type(scene_.mesh.mesh, e);
      if (with_formulation(body.formulation, type, [](auto) {})) continue;
      error("D19", {"bodies", name, "formulation"},
            fmt::format("does not exist for {} elements ({})", topology(type).name, describe_element(scene_.mesh, e)));
      return;
    }
  }

  /// A mass matrix by fewer points than the element has nodes is singular.
  void check_mass(const std::string& name, const Body& body) {
    if (body.mass_kind != MassKind::stiffness_rule) return;
    for (int e : body.elements) {
      const ElementType type = element_type(scene_.mesh.mesh, e);
      const bool is_regular = with_element(
          type, [](auto element) { return element.stiffness_rule.size() >= static_cast<std::size_t>(element.n_nodes); });
      if (is_regular) continue;
      error("D19", {"bodies", name, "mass"},
            fmt::format("gives a singular mass for {} elements, whose stiffness takes fewer points than they have nodes ({})",
                        topology(type).name, describe_element(scene_.mesh, e)));
      return;
    }
  }

  void make_strings() {
    const Mesh& mesh = scene_.mesh.mesh;
    std::vector<std::string> owner(mesh.blocks.size());
    for (const auto& [name, o] : options_.strings) {
      String string{name, {}, {}, o.youngs_modulus * o.area, {}, o.law, 0, initial_motion(name)};
      if (o.density) string.line_density = *o.density * o.area;
      for (int b : blocks_of("strings", name, o.mesh, o.blocks, is_bar, "bars")) {
        if (!owner[b].empty())
          error("D19", {"strings", name},
                fmt::format("block \"{}\" belongs to string \"{}\" already", mesh.blocks[b].name, owner[b]));
        owner[b] = name;
        const auto elements = elements_of_block(b);
        string.elements.insert(string.elements.end(), elements.begin(), elements.end());
      }
      if (string.elements.empty()) continue;
      std::sort(string.elements.begin(), string.elements.end());
      string.nodes = nodes_of_elements(string.elements);
      string.size = 1e300;
      for (int e : string.elements) {
        const ElementNodeList nodes = element_nodes(mesh, e);
        string.size = std::min(string.size, longest_edge(mesh, element_type(mesh, e), nodes) / (nodes.size() - 1));
      }
      scene_.strings.push_back(std::move(string));
    }
    for (std::size_t b = 0; b < owner.size(); ++b)
      if (owner[b].empty() && is_bar(mesh.blocks[b].elements.type()))
        error("D19", {"strings"},
              fmt::format("block \"{}\" belongs to no string - every block of bars needs a stiffness", mesh.blocks[b].name));
  }

  void make_masses() {
    for (const auto& [name, o] : options_.masses)
      scene_.masses.push_back({name, names_.nodes_of_set_or_mesh(o.set, {"masses", name, "set"}), o.mass, initial_motion(name)});
  }

  /// A node without an equation of its own makes the matrix singular: what bodies do not hold needs inertia, or what holds it.
  void check_points() {
    const bool has_inertia = scene_.scheme.has_inertia();
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

  bool is_contact_surface(const SideSet& sides, const Path& path) {
    const auto faults = contact_surface_faults(scene_.mesh, sides);
    for (const auto& fault : faults) mesh_errors_.push_back(deck_.error(fault.code, path, fault.text));
    return faults.empty();
  }

  bool are_quadrilaterals(const SideSet& sides, const Path& path) {
    for (const Side& side : sides.sides) {
      const auto n = side_nodes(scene_.mesh.mesh, side).size();
      if (n == 4) continue;
      error("D20", path,
            fmt::format("holds a side with {} nodes ({}) - contact surfaces have sides with 4 nodes: of hex8, or the "
                        "quadrilaterals of wedge6",
                        n, describe_element(scene_.mesh, side.element)));
      return false;
    }
    return true;
  }

  std::array<int, 4> facet_nodes(const Side& side) const {
    const std::vector<int> nodes = side_nodes(scene_.mesh.mesh, side);
    return {nodes[0], nodes[1], nodes[2], nodes[3]};
  }

  void make_pairs() {
    std::map<int, std::string> secondary_of;
    for (const auto& [name, o] : options_.contact) {
      const auto* secondary = names_.sides_of(o.secondary, {"contact", name, "secondary"});
      const auto* primary = names_.sides_of(o.primary, {"contact", name, "primary"});
      if (!secondary || !primary) continue;
      const bool is_sound = is_contact_surface(*secondary, {"contact", name, "secondary"});
      if (!is_contact_surface(*primary, {"contact", name, "primary"}) || !is_sound) continue;
      const bool is_bilinear = are_quadrilaterals(*secondary, {"contact", name, "secondary"});
      if (!are_quadrilaterals(*primary, {"contact", name, "primary"}) || !is_bilinear) continue;
      ContactPair pair;
      pair.name = name;
      pair.where_penetrating = deck_.error("M51", {"contact", name}, "");
      pair.quadrature_degree = o.quadrature_degree;
      pair.closing = o.closing;
      pair.activity = o.activity;
      for (const Side& side : secondary->sides) {
        pair.secondary.facets.push_back(facet_nodes(side));
        pair.secondary_elements.push_back(side.element);
      }
      for (const Side& side : primary->sides) pair.primary.facets.push_back(facet_nodes(side));
      pair.secondary_nodes = pair.secondary.nodes();
      const auto primary_nodes = pair.primary.nodes();
      std::vector<int> shared;
      std::set_intersection(pair.secondary_nodes.begin(), pair.secondary_nodes.end(), primary_nodes.begin(), primary_nodes.end(),
                            std::back_inserter(shared));
      if (!shared.empty()) {
        error("D19", {"contact", name},
              fmt::format("secondary and primary share {} nodes (first: {}) - two surfaces without common nodes are needed",
                          shared.size(), describe_node(scene_.mesh, shared[0])));
        continue;
      }
      pair.first_multiplier = scene_.n_multipliers;
      scene_.n_multipliers += static_cast<int>(pair.secondary_nodes.size());
      for (int node : pair.secondary_nodes) {
        const auto [at, is_new] = secondary_of.insert({node, name});
        if (is_new) continue;
        error("D19", {"contact", name, "secondary"},
              fmt::format("{} is on the secondary side of \"{}\" too - swap the sides of one pair",
                          describe_node(scene_.mesh, node), at->second));
        break;
      }
      const double area = facet_areas(pair.secondary, pair.secondary_nodes, pair.tributary_area);
      pair.size = std::sqrt(area / pair.secondary.facets.size());
      std::vector<double> unused;
      pair.primary_size = std::sqrt(facet_areas(pair.primary, primary_nodes, unused) / pair.primary.facets.size());
      pair.youngs_modulus = modulus_behind(*secondary);
      pair.opposite_compliance = pair.primary_size / modulus_behind(*primary);
      if (pair.size > 3 * pair.primary_size)
        warnings_.push_back(
            fmt::format("contact > {}: the secondary side is coarser than the primary side (facets of {:.3g} and {:.3g}) - swap "
                        "them for a sharper pressure",
                        name, pair.size, pair.primary_size));
      scene_.pairs.push_back(std::move(pair));
    }
  }

  double modulus_behind(const SideSet& sides) const {
    for (const Body& body : scene_.bodies)
      if (std::binary_search(body.elements.begin(), body.elements.end(), sides.sides[0].element)) return body.youngs_modulus;
    throw std::logic_error("an element without a body");
  }

  double facet_areas(const ContactSurface& surface, const std::vector<int>& nodes, std::vector<double>& tributary) const {
    tributary.assign(nodes.size(), 0.0);
    double area = 0;
    for (const auto& facet : surface.facets) {
      std::array<Point, 4> X;
      for (int a = 0; a < 4; ++a) X[a] = scene_.mesh.mesh.coordinates[facet[a]];
      const auto w = side_weights<Quad4>(X);
      for (int a = 0; a < 4; ++a) {
        tributary[std::lower_bound(nodes.begin(), nodes.end(), facet[a]) - nodes.begin()] += w[a];
        area += w[a];
      }
    }
    return area;
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
    double stiffness = 0;
    for (const Body& body : scene_.bodies) stiffness = std::max(stiffness, stiffest_modulus(body) * size);
    for (const String& string : scene_.strings) stiffness = std::max(stiffness, string.axial_stiffness / string.size);
    for (const NodeSpring& spring : scene_.node_springs) stiffness = std::max(stiffness, spring.stiffness);
    if (scene_.bodies.empty())
      for (const Spring& spring : scene_.springs)
        stiffness = std::max(stiffness, *std::max_element(spring.stiffness.begin(), spring.stiffness.end()));
    scene_.size = size;
    scene_.extent = extent;
    scene_.force_floor = 1e-14 * stiffness * (size + extent);
  }

  const Deck& deck_;
  const DeckOptions& options_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> errors_, mesh_errors_;
  Scene scene_;
  DeckNames names_;
};

}  // namespace

std::vector<const ContactNodes*> Scene::contacts() const {
  std::vector<const ContactNodes*> all;
  for (const auto& pair : pairs) all.push_back(&pair);
  for (const auto& obstacle : obstacles) all.push_back(&obstacle);
  return all;
}

Scene make_scene(const Deck& deck, std::vector<std::string>& warnings) { return SceneMaker(deck, warnings).make(); }

}  // namespace mortise
