// A deformed state to check tangents at: the same on any number of ranks.
#pragma once

#include "assembly/step_problem.hpp"

namespace mortise {

struct Perturbation {
  RCP<Vector> x;  ///< owned unknowns
  double factor;  ///< 1, or a power of 1/2 if the full perturbation were inadmissible
};

/// Reference positions moved by  factor h (0.08 sin(2 pi (X_1 + X_2 + X_3) / (8 h) + 2 pi i / 3) + r_i),  |r_i| <= 0.02 random, h
/// the edge of the body's elements (nodes of two bodies take the lesser): a few per cent of an element. Pressures of mixed
/// elements are random within 0.05 E, contact pressures between 0.05 E and 0.15 E of the secondary body. The factor is halved
/// until det F > 0 in every element. Random numbers of a fixed seed.
/// @throws std::runtime_error if no such factor is found
Perturbation perturbed(const StepProblem& problem);

}  // namespace mortise
