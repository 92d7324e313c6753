#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "errors.hpp"
#include "make_material.hpp"
#include "mesh/contact_sides.hpp"
#include "mesh/suspicions.hpp"
#include "physics/elements/hex8.hpp"
#include "physics/traction.hpp"
#include "sha256.hpp"

namespace mortise {
namespace {

using Path = std::vector<std::string>;

template <class T>
const T& named(const Named<T>& list, const std::string& name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; })->second;
}

/// Makes the scene part by part; errors are gathered so that the user sees them together.
class SceneMaker {
 public:
  SceneMaker(const Deck& deck, std::vector<std::string>& warnings) : deck_(deck), options_(deck.options()), warnings_(warnings) {}

  Scene make() {
    std::vector<std::pair<std::string, Mesh>> meshes;
    for (const auto& [name, mesh] : options_.meshes) meshes.emplace_back(name, checked_mesh(name, mesh));
    scene_.title = options_.title;
    scene_.mesh = combine(meshes);
    scene_.time = options_.time;
    scene_.solver = options_.solver;
    scene_.output = options_.output;
    scene_.checkpoints = options_.checkpoints;
    scene_.expected = options_.expected;
    warn_of_odd_materials();
    make_bodies();
    stop_at_errors();  // what follows needs bodies
    make_supports();
    make_tractions();
    make_pairs();
    make_probes();
    stop_at_errors();
    set_scales();
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

  std::string known_sets(const std::string& name) const {
    const auto names = set_names(scene_.mesh);
    return fmt::format("no such set{}; the meshes have: {}", did_you_mean(name, names), join(names));
  }

  void warn_of_odd_materials() {
    for (const auto& [name, o] : options_.materials)
      if (const std::string what = oddity(make_material(o)); !what.empty())
        warnings_.push_back(fmt::format("materials > {}: {}", name, what));
  }

  void make_bodies() {
    const Mesh& mesh = scene_.mesh.mesh;
    std::vector<int> first_of_block{0};
    for (const auto& block : mesh.blocks)
      first_of_block.push_back(first_of_block.back() + static_cast<int>(block.elements.size()));
    std::vector<std::string> owner(mesh.blocks.size());
    for (const auto& [name, o] : options_.bodies) {
      const MeshPart& part = *find_part(scene_.mesh, o.mesh);
      std::vector<int> blocks;
      if (o.blocks.empty())
        for (int b = 0; b < part.n_blocks; ++b) blocks.push_back(part.first_block + b);
      for (const auto& block : o.blocks) {
        if (const auto found = find_block(scene_.mesh, part, block)) {
          blocks.push_back(*found);
        } else {
          const auto names = block_names(scene_.mesh, part);
          error("D20", {"bodies", name, "blocks"},
                fmt::format("mesh \"{}\" has no block \"{}\"{}; it has: {}", o.mesh, block, did_you_mean(block, names),
                            join(names)));
        }
      }
      const MaterialOptions& of_material = named(options_.materials, o.material);
      const Material material = make_material(of_material);
      if (std::visit([](const auto& one) { return is_incompressible<std::decay_t<decltype(one)>>(); }, material))
        error("D19", {"bodies", name, "material"},
              "the material is incompressible: elements without a pressure of their own cannot hold its volume");
      Body body{name, material, o.tangent, {}, {}, small_strain_moduli(material).youngs_modulus(), 0, of_material.density};
      for (int b : blocks) {
        if (!owner[b].empty())
          error("D19", {"bodies", name},
                fmt::format("block \"{}\" belongs to body \"{}\" already - a block has one material", mesh.blocks[b].name,
                            owner[b]));
        owner[b] = name;
        for (int e = first_of_block[b]; e < first_of_block[b + 1]; ++e) body.elements.push_back(e);
      }
      std::sort(body.elements.begin(), body.elements.end());
      double volume = 0;
      for (int e : body.elements) {
        std::array<Point, 8> X;
        for (int a = 0; a < 8; ++a) X[a] = mesh.coordinates[element_nodes(mesh, e)[a]];
        for (double w : hex8_geometry(X).JxW) volume += w;
        body.nodes.insert(body.nodes.end(), element_nodes(mesh, e).begin(), element_nodes(mesh, e).end());
      }
      std::sort(body.nodes.begin(), body.nodes.end());
      body.nodes.erase(std::unique(body.nodes.begin(), body.nodes.end()), body.nodes.end());
      body.size = std::cbrt(volume / std::max<std::size_t>(1, body.elements.size()));
      scene_.bodies.push_back(std::move(body));
    }
    for (std::size_t b = 0; b < owner.size(); ++b)
      if (owner[b].empty())
        error("D19", {"bodies"},
              fmt::format("block \"{}\" belongs to no body - every block needs a material", mesh.blocks[b].name));
  }

  std::vector<int> nodes_of(const std::string& name, const Path& path) {
    if (const auto* sides = find_side_set(scene_.mesh, name)) {
      std::vector<int> nodes;
      for (const Side& side : sides->sides)
        for (int n : side_nodes(scene_.mesh.mesh, side)) nodes.push_back(n);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return nodes;
    }
    if (const auto* set = find_node_set(scene_.mesh, name)) return set->nodes;
    error("D20", path, known_sets(name));
    return {};
  }

  const SideSet* sides_of(const std::string& name, const Path& path) {
    const auto* sides = find_side_set(scene_.mesh, name);
    if (!sides)
      error("D20", path, find_node_set(scene_.mesh, name) ? "a node set has no sides - a side set is needed" : known_sets(name));
    return sides;
  }

  std::array<std::optional<Formula>, 3> formulas(const std::array<std::optional<std::string>, 3>& texts) const {
    std::array<std::optional<Formula>, 3> compiled;
    for (int i = 0; i < 3; ++i)
      if (texts[i]) compiled[i].emplace(*texts[i], options_.tables);
    return compiled;
  }

  std::array<std::string, 3> places(const std::string& code, const std::string& list, const std::string& name,
                                    const std::array<std::optional<std::string>, 3>& texts) const {
    std::array<std::string, 3> where;
    for (int i = 0; i < 3; ++i)
      if (texts[i]) where[i] = deck_.error(code, {list, name, std::string(1, "xyz"[i])}, "");
    return where;
  }

  // Judged here at the start, at the stops and at the end, so that most contradictions are told before the run; later at each
  // step.
  bool agree(const DoublyPrescribed& twice) {
    std::vector<double> times{0.0, options_.time.end};
    times.insert(times.end(), options_.time.stops.begin(), options_.time.stops.end());
    for (double t : times) {
      const std::string message = contradiction(scene_, twice, t);
      if (message.empty()) continue;
      errors_.push_back(message);
      return false;
    }
    return true;
  }

  void make_supports() {
    std::map<std::pair<int, int>, int> taken;
    for (const auto& [name, o] : options_.supports) {
      Support support{name, formulas(o.displacement), places("D23", "supports", name, o.displacement),
                      places("D21", "supports", name, o.displacement)};
      const int index = static_cast<int>(scene_.supports.size());
      scene_.supports.push_back(support);
      bool told = false;
      for (int node : nodes_of(o.set, {"supports", name, "set"}))
        for (int i = 0; i < 3; ++i) {
          if (!support.displacement[i]) continue;
          const auto [at, is_new] = taken.insert({{node, i}, index});
          if (is_new) continue;
          const DoublyPrescribed twice{node, i, at->second, index};
          scene_.doubly_prescribed.push_back(twice);
          if (!told) told = !agree(twice);  // the first node is enough
        }
    }
    for (const auto& [dof, support] : taken) scene_.prescribed.push_back({dof.first, dof.second, support});
  }

  void make_tractions() {
    for (const auto& [name, o] : options_.loads) {
      Traction traction{name, {}, formulas(o.traction), places("D23", "loads", name, o.traction)};
      std::map<int, double> weights;
      if (const auto* sides = sides_of(o.set, {"loads", name, "set"}))
        for (const Side& side : sides->sides) {
          const auto nodes = side_nodes(scene_.mesh.mesh, side);
          std::array<Point, 4> X;
          for (int a = 0; a < 4; ++a) X[a] = scene_.mesh.mesh.coordinates[nodes[a]];
          const auto w = side_weights(X);
          for (int a = 0; a < 4; ++a) weights[nodes[a]] += w[a];
        }
      traction.weights.assign(weights.begin(), weights.end());
      scene_.tractions.push_back(std::move(traction));
    }
  }

  bool is_contact_surface(const SideSet& sides, const Path& path) {
    const auto faults = contact_surface_faults(scene_.mesh, sides);
    for (const auto& fault : faults) mesh_errors_.push_back(deck_.error(fault.code, path, fault.text));
    return faults.empty();
  }

  void make_pairs() {
    const Mesh& mesh = scene_.mesh.mesh;
    std::map<int, std::string> secondary_of;
    for (const auto& [name, o] : options_.contact) {
      const auto* secondary = sides_of(o.secondary, {"contact", name, "secondary"});
      const auto* primary = sides_of(o.primary, {"contact", name, "primary"});
      if (!secondary || !primary) continue;
      const bool is_sound = is_contact_surface(*secondary, {"contact", name, "secondary"});
      if (!is_contact_surface(*primary, {"contact", name, "primary"}) || !is_sound) continue;
      ContactPair pair;
      pair.name = name;
      pair.where_penetrating = deck_.error("M51", {"contact", name}, "");
      pair.quadrature_degree = o.quadrature_degree;
      for (const Side& side : secondary->sides) {
        pair.secondary.facets.push_back(side_nodes(mesh, side));
        pair.secondary_elements.push_back(side.element);
      }
      for (const Side& side : primary->sides) pair.primary.facets.push_back(side_nodes(mesh, side));
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
      pair.primary_youngs_modulus = modulus_behind(*primary);
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
      const auto w = side_weights(X);
      for (int a = 0; a < 4; ++a) {
        tributary[std::lower_bound(nodes.begin(), nodes.end(), facet[a]) - nodes.begin()] += w[a];
        area += w[a];
      }
    }
    return area;
  }

  void make_probes() {
    for (const auto& [name, o] : options_.probes) {
      const MeshPart* part = find_part(scene_.mesh, o.mesh);
      if (!part) {
        error("D20", {"probes", name, "mesh"}, "no such mesh");
        continue;
      }
      int node = -1;
      if (o.node) {
        if (const auto found = find_node(scene_.mesh, *part, *o.node)) {
          node = *found;
        } else {
          error("D20", {"probes", name, "node"}, fmt::format("mesh \"{}\" has no node with that number", o.mesh));
          continue;
        }
      } else {
        double nearest = 1e300;
        for (int n = part->first_node; n < part->first_node + part->n_nodes; ++n) {
          const Point& X = scene_.mesh.mesh.coordinates[n];
          const double d = std::hypot(X[0] - (*o.nearest)[0], X[1] - (*o.nearest)[1], X[2] - (*o.nearest)[2]);
          if (d < nearest) {
            nearest = d;
            node = n;
          }
        }
      }
      scene_.probes.push_back({name, o.quantity, node});
    }
  }

  void set_scales() {
    double modulus = 0, size = 1e300, extent = 0;
    for (const Body& body : scene_.bodies) {
      modulus = std::max(modulus, body.youngs_modulus);
      size = std::min(size, body.size);
    }
    for (const Point& X : scene_.mesh.mesh.coordinates)
      for (double x : X) extent = std::max(extent, std::abs(x));
    scene_.size = size;
    scene_.force_floor = 1e-14 * modulus * size * (size + extent);
  }

  const Deck& deck_;
  const DeckOptions& options_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> errors_, mesh_errors_;
  Scene scene_;
};

}  // namespace

std::string contradiction(const Scene& scene, const DoublyPrescribed& twice, double t) {
  const Support &first = scene.supports[twice.first], &second = scene.supports[twice.second];
  const Point& X = scene.mesh.mesh.coordinates[twice.node];
  const double a = (*first.displacement[twice.axis])(t, X), b = (*second.displacement[twice.axis])(t, X);
  if (!std::isfinite(a) || !std::isfinite(b) || std::abs(a - b) <= 1e-12 * (1 + std::abs(a))) return "";
  return fmt::format("{}{}, component {}, is moved by {} here and by {} in \"{}\" at t = {} - one value is needed",
                     second.where_contradicting[twice.axis], describe_node(scene.mesh, twice.node), "xyz"[twice.axis], b, a,
                     first.name, t);
}

Scene make_scene(const Deck& deck, std::vector<std::string>& warnings) { return SceneMaker(deck, warnings).make(); }

}  // namespace mortise
