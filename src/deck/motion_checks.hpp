// Checks of what a deck says about motion, between its lists.
#pragma once

#include "deck/options.hpp"
#include "deck/reader.hpp"
#include "deck/source.hpp"

namespace mortise {

/// Densities where mass counts, initial conditions and mass matrices that mean something, and a time scheme that knows the forces
/// of the scene. @param findings gets the problems
void check_motion(const DeckSource& source, const DeckOptions& options, Findings& findings);

}  // namespace mortise
