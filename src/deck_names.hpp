// Looks up in the meshes what a deck names, and compiles its formulas; what is missing is noted as an error at its place.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "mesh/combine.hpp"
#include "scene_loads.hpp"

namespace mortise {

using DeckPath = std::vector<std::string>;

/// The names of one deck in its meshes.
class DeckNames {
 public:
  /// @param errors gets the messages
  DeckNames(const Deck& deck, const CombinedMesh& mesh, std::vector<std::string>& errors)
      : deck_(deck), mesh_(mesh), errors_(errors) {}

  void error(const std::string& code, const DeckPath& path, const std::string& what) const;

  /// A message that is complete.
  void tell(const std::string& message) const { errors_.push_back(message); }

  /// Nodes of a node set, or of the sides of a side set, ascending; none if there is no such set.
  std::vector<int> nodes_of(const std::string& set, const DeckPath& path) const;

  /// The same, or all nodes of the mesh of that name.
  std::vector<int> nodes_of_set_or_mesh(const std::string& name, const DeckPath& path) const;

  /// A side set; null if there is none.
  const SideSet* sides_of(const std::string& set, const DeckPath& path) const;

  /// A node by the user's number, or the nearest to a reference position.
  std::optional<int> node_of(const std::string& mesh, std::optional<int> number,
                             const std::optional<std::array<double, 3>>& nearest, const DeckPath& entry) const;

  PlacedFormula formula(const std::string& text, const DeckPath& path,
                        const std::vector<std::string>& variables = {"t", "x", "y", "z"}) const;

  /// Formulas of the parameters x, y, z of an entry.
  PlacedVector formulas(const VectorFormula& texts, const DeckPath& entry) const;

  const Deck& deck() const { return deck_; }

 private:
  std::string known_sets(const std::string& name) const;

  const Deck& deck_;
  const CombinedMesh& mesh_;
  std::vector<std::string>& errors_;
};

}  // namespace mortise
