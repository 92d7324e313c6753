#include "deck_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "errors.hpp"

namespace mortise {
namespace {

DeckPath below(DeckPath entry, const std::string& name) {
  entry.push_back(name);
  return entry;
}

}  // namespace

void DeckNames::error(const std::string& code, const DeckPath& path, const std::string& what) const {
  errors_.push_back(deck_.error(code, path, what));
}

std::string DeckNames::known_sets(const std::string& name) const {
  const auto names = set_names(mesh_);
  return fmt::format("no such set{}; the meshes have: {}", did_you_mean(name, names), join(names));
}

std::vector<int> DeckNames::nodes_of_set_or_mesh(const std::string& name, const DeckPath& path) const {
  const MeshPart* part = find_part(mesh_, name);
  if (!part) return nodes_of(name, path);
  std::vector<int> nodes(static_cast<std::size_t>(part->n_nodes));
  std::iota(nodes.begin(), nodes.end(), part->first_node);
  return nodes;
}

std::vector<int> DeckNames::nodes_of(const std::string& set, const DeckPath& path) const {
  if (const auto* sides = find_side_set(mesh_, set)) {
    std::vector<int> nodes;
    for (const Side& side : sides->sides)
      for (int n : side_nodes(mesh_.mesh, side)) nodes.push_back(n);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }
  if (const auto* found = find_node_set(mesh_, set)) return found->nodes;
  error("D20", path, known_sets(set));
  return {};
}

const SideSet* DeckNames::sides_of(const std::string& set, const DeckPath& path) const {
  const auto* sides = find_side_set(mesh_, set);
  if (!sides) error("D20", path, find_node_set(mesh_, set) ? "a node set has no sides - a side set is needed" : known_sets(set));
  return sides;
}

std::optional<int> DeckNames::node_of(const std::string& mesh, std::optional<int> number,
                                      const std::optional<std::array<double, 3>>& nearest, const DeckPath& entry) const {
  const MeshPart* part = find_part(mesh_, mesh);
  if (!part) {
    error("D20", below(entry, "mesh"), "no such mesh");
    return std::nullopt;
  }
  if (number) {
    const auto node = find_node(mesh_, *part, *number);
    if (!node) error("D20", below(entry, "node"), fmt::format("mesh \"{}\" has no node with that number", mesh));
    return node;
  }
  int node = part->first_node;
  double least = 1e300;
  for (int n = part->first_node; n < part->first_node + part->n_nodes; ++n) {
    const Point& X = mesh_.mesh.coordinates[n];
    const double d = std::hypot(X[0] - (*nearest)[0], X[1] - (*nearest)[1], X[2] - (*nearest)[2]);
    if (d < least) {
      least = d;
      node = n;
    }
  }
  return node;
}

PlacedFormula DeckNames::formula(const std::string& text, const DeckPath& path, const std::vector<std::string>& variables) const {
  return {Formula(text, deck_.options().tables, variables), deck_.error("D23", path, "")};
}

PlacedVector DeckNames::formulas(const VectorFormula& texts, const DeckPath& entry) const {
  PlacedVector formulas;
  for (int i = 0; i < 3; ++i)
    if (texts[i]) formulas[i] = formula(*texts[i], below(entry, std::string(1, "xyz"[i])));
  return formulas;
}

}  // namespace mortise
