// Makes the contact pairs of a scene from a deck.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `pairs`, and counts their multipliers, in a scene whose mesh and bodies stand.
/// @param mesh_errors gets messages about surfaces that cannot meet  @param warnings gets lines for the log
void make_pairs(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings);

}  // namespace mortise
