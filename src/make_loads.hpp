// Makes the supports, springs and loads of a scene from a deck.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `supports` and `prescribed` of a scene whose mesh and bodies stand: those of the deck, then those of bodies in plane
/// strain.
void make_supports(const DeckNames& names, Scene& scene);

/// Fills `springs` and `node_springs`.
void make_springs(const DeckNames& names, Scene& scene);

/// Fills `loads` of a scene whose bodies stand.
void make_loads(const DeckNames& names, Scene& scene);

/// The times at which something starts or ends become stops of the march.
void add_stops(Scene& scene);

/// Tells supports that contradict each other at the start, at a stop or at the end, so that most are told before the run; later
/// they are told at each step. What a velocity support gives depends on the march: that is told then only.
void check_motions(const DeckNames& names, const Scene& scene);

}  // namespace mortise
