// Two surfaces of a deck, as contact pairs and ties need them: found, checked and measured.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills in what two side sets of the deck say: facets, secondary nodes, areas, sizes and moduli.
/// @param list, name  the entry of the deck that has them  @param mesh_errors gets messages about surfaces that cannot meet
/// @return false: something is wrong with them, and told
bool find_surfaces(const DeckNames& names, const Scene& scene, const std::string& list, const std::string& name,
                   const std::string& secondary, const std::string& primary, std::vector<std::string>& mesh_errors,
                   OppositeSurfaces& pair);

/// Numbers the multipliers of a pair's secondary nodes after those that the scene has.
void number_multipliers(Scene& scene, ContactNodes& nodes);

}  // namespace mortise
