// Checks between the lists of a deck that need no mesh.
#pragma once

#include <vector>

#include "deck/options.hpp"
#include "deck/reader.hpp"
#include "deck/source.hpp"

namespace mortise {

/// Names that must exist (meshes, materials, pairs, supports, probes), sets of the form mesh/set, stops of expected values,
/// formulas, and declared entries that nothing uses.
/// @param findings the formulas found by the reader; gets the problems. Unused entries are reported only in a deck without
///                 other errors, because any error may be what keeps an entry from being used
void check_across(const DeckSource& source, const DeckOptions& options, Findings& findings);

}  // namespace mortise
