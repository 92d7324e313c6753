#include "make_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "assembly/formulations.hpp"
#include "deck/names.hpp"
#include "errors.hpp"
#include "make_material.hpp"
#include "mesh/combine.hpp"

namespace mortise {
namespace {

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

/// Makes bodies, strings and masses; what is wrong with them is noted and left out.
class BodyMaker {
 public:
  BodyMaker(const DeckNames& names, Scene& scene, std::vector<std::string>& warnings)
      : names_(names), options_(names.deck().options()), scene_(scene), warnings_(warnings) {}

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
          names_.error("D19", {"bodies", name},
                       fmt::format("block \"{}\" belongs to body \"{}\" already - a block has one material", mesh.blocks[b].name,
                                   owner[b]));
        owner[b] = name;
        const auto elements = elements_of_block(b);
        body.elements.insert(body.elements.end(), elements.begin(), elements.end());
      }
      if (body.elements.empty()) continue;
      std::sort(body.elements.begin(), body.elements.end());
      double volume = 0;
      for (int e : body.elements) {
        const double V = element_volume(mesh, e),
                     shortest = edge_range(mesh, element_type(mesh, e), element_nodes(mesh, e)).first;
        volume += V;
        body.stiffest = std::max(body.stiffest, V / (shortest * shortest));
      }
      body.nodes = nodes_of_elements(body.elements);
      check_elements(name, body);
      check_mass(name, body);
      warn_of_locking(name, body);
      body.size = std::cbrt(volume / std::max<std::size_t>(1, body.elements.size()));
      scene_.bodies.push_back(std::move(body));
    }
    for (std::size_t b = 0; b < owner.size(); ++b)
      if (owner[b].empty() && is_solid(mesh.blocks[b].elements.type()))
        names_.error("D19", {"bodies"},
                     fmt::format("block \"{}\" belongs to no body - every block needs a material", mesh.blocks[b].name));
  }

  void make_strings() {
    const Mesh& mesh = scene_.mesh.mesh;
    std::vector<std::string> owner(mesh.blocks.size());
    for (const auto& [name, o] : options_.strings) {
      String string{name, {}, {}, o.youngs_modulus * o.area, {}, o.law, 0, initial_motion(name)};
      if (o.density) string.line_density = *o.density * o.area;
      for (int b : blocks_of("strings", name, o.mesh, o.blocks, is_bar, "bars")) {
        if (!owner[b].empty())
          names_.error("D19", {"strings", name},
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
        names_.error(
            "D19", {"strings"},
            fmt::format("block \"{}\" belongs to no string - every block of bars needs a stiffness", mesh.blocks[b].name));
  }

  void make_masses() {
    for (const auto& [name, o] : options_.masses)
      scene_.masses.push_back({name, names_.nodes_of_set_or_mesh(o.set, {"masses", name, "set"}), o.mass, initial_motion(name)});
  }

 private:
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
      if (blocks.empty())
        names_.error("D19", {list, name, "mesh"}, fmt::format("has no {}, which {} are made of", right_ones, list));
    }
    for (const auto& block : named_blocks) {
      const auto found = find_block(scene_.mesh, part, block);
      if (!found) {
        const auto names = block_names(scene_.mesh, part);
        names_.error(
            "D20", {list, name, "blocks"},
            fmt::format("mesh \"{}\" has no block \"{}\"{}; it has: {}", mesh, block, did_you_mean(block, names), join(names)));
      } else if (!is_right(all[*found].elements.type())) {
        names_.error("D19", {list, name, "blocks"},
                     fmt::format("block \"{}\" has {} elements - {} are made of {}", block,
                                 topology(all[*found].elements.type()).name, list, right_ones));
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

  std::optional<InitialOptions> initial_motion(const std::string& body) const {
    for (const auto& [name, o] : options_.initial_conditions)
      if (name == body) return o;
    return std::nullopt;
  }

  /// A pressure of their own is what elements of incompressible materials need, and what needs a material that is split.
  void check_formulation(const std::string& name, FormulationKind formulation, const Material& material) {
    std::visit(
        [&](const auto& m) {
          using M = std::decay_t<decltype(m)>;
          if (formulation != FormulationKind::mixed && is_incompressible<M>())
            names_.error("D19", {"bodies", name, "material"},
                         "the material is incompressible - elements without a pressure of their own cannot hold its volume: "
                         "\"formulation\" must be \"mixed\"");
          if (formulation == FormulationKind::mixed && !is_split<M>)
            names_.error(
                "D19", {"bodies", name, "formulation"},
                fmt::format("\"mixed\" needs a material that is split into distortion and volume, or incompressible - \"{}\" is "
                            "not",
                            m.name));
        },
        material);
    if (formulation == FormulationKind::mixed && options_.solver.linear == LinearSolverKind::iterative)
      names_.error("D19", {"bodies", name, "formulation"},
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

  void check_elements(const std::string& name, const Body& body) {
    for (int e : body.elements) {
      const ElementType type = element_type(scene_.mesh.mesh, e);
      if (with_formulation(body.formulation, type, [](auto) {})) continue;
      names_.error("D19", {"bodies", name, "formulation"},
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
      names_.error(
          "D19", {"bodies", name, "mass"},
          fmt::format("gives a singular mass for {} elements, whose stiffness takes fewer points than they have nodes ({})",
                      topology(type).name, describe_element(scene_.mesh, e)));
      return;
    }
  }

  const DeckNames& names_;
  const DeckOptions& options_;
  Scene& scene_;
  std::vector<std::string>& warnings_;
};

}  // namespace

void make_bodies(const DeckNames& names, Scene& scene, std::vector<std::string>& warnings) {
  BodyMaker maker(names, scene, warnings);
  maker.make_bodies();
  maker.make_strings();
  maker.make_masses();
}

}  // namespace mortise
