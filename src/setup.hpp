// What `run`, `restart` and `check` begin with: deck, scene, partition and equations.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assembly/step_problem.hpp"
#include "deck/deck.hpp"
#include "mesh/partition.hpp"
#include "scene.hpp"

namespace mortise {

struct Setup {
  std::vector<std::string> warnings;
  Deck deck;
  Scene scene;
  Partition partition;
  StepProblem problem;

  /// @throws DeckError, MeshError, FileError; UserError with code 6 for more ranks than elements
  Setup(Deck deck, const RCP<const Comm>& comm);

  /// The state at time 0. Statics needs every rigid motion held, by supports or by contact that is closed from the start.
  /// @throws DeckError that names the free motions, or a formula without a value; MeshError for surfaces inside each other
  State first_state();
};

}  // namespace mortise
