// Makes what moves in a scene from a deck: bodies, strings and point masses.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `bodies`, `strings` and `masses` of a scene whose mesh stands. @param warnings gets lines for the log
void make_bodies(const DeckNames& names, Scene& scene, std::vector<std::string>& warnings);

}  // namespace mortise
