// Makes the obstacles and rods of a scene from a deck.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `obstacles`, and counts their multipliers, in a scene whose mesh, bodies and pairs stand.
void make_obstacles(const DeckNames& names, Scene& scene);

}  // namespace mortise
