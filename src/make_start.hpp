// Makes the start of a scene from the results of other runs.
#pragma once

#include "deck_names.hpp"
#include "scene.hpp"

namespace mortise {

/// Fills `carried` from the files that initial conditions name, where the scene's bodies, strings and masses stand.
/// @throws MeshError, FileError for files that cannot be read
void make_start(const DeckNames& names, Scene& scene);

}  // namespace mortise
