// Fields at the quadrature points as element variables: their names, which blocks have them, and their values.
#pragma once

#include <string>
#include <vector>

#include "assembly/step_problem.hpp"
#include "deck/field_table.hpp"
#include "output/results.hpp"

namespace mortise {

/// Some fields of quadrature points of all elements of a scene.
class ElementFields {
 public:
  /// @param fields of quadrature points
  ElementFields(const Scene& scene, std::vector<Field> fields);

  /// Variables <name>_<component>_<point>, point by point, as many as the elements with most points need. A block has those of
  /// the points of its type; a block of no body has none.
  const ElementVariables& variables() const { return variables_; }

  /// Per variable one value per element of the mesh (0 where its block does not have it) on rank 0, nothing on others.
  /// Collective: one pass over the elements of each rank, which are sent as they are.
  std::vector<std::vector<double>> values(const StepProblem& problem, const State& state) const;

 private:
  std::vector<Field> fields_;
  std::vector<std::size_t> counts_;  ///< components of each field
  std::size_t n_components_ = 0;     ///< of all fields together
  ElementVariables variables_;
};

}  // namespace mortise
