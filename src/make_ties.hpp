// Makes the ties of a scene from a deck: what lies opposite what in the reference configuration, once for all.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `ties`, with their mortar integrals over the reference configuration (thesis eq. 4.96 and Remark 8), and counts their
/// multipliers, in a scene whose mesh, bodies and pairs stand.
/// @param mesh_errors gets messages about surfaces that cannot meet  @param warnings gets lines for the log
void make_ties(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings);

}  // namespace mortise
