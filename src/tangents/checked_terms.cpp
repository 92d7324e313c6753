// All terms of a scene that the tangent check differentiates.
#include "tangents/checked_term.hpp"

namespace mortise {

std::vector<CheckedTerm> checked_terms(const StepProblem& problem, const Partition& partition, int most) {
  std::vector<CheckedTerm> terms;
  for (const auto& body : problem.bodies())
    for (ElementType type : element_types) {
      CheckedTerm term =
          checked_elements(problem, *body, type, most, [&body](TangentKind kind) { return law_of(body->body(), kind); });
      if (term.n_pieces > 0) terms.push_back(std::move(term));
    }
  for (const Load& load : problem.scene().loads)
    if (load.follows()) terms.push_back(checked_sides(problem, load, partition, most));
  for (const auto& pair : problem.pairs()) terms.push_back(checked_facets(problem, *pair, partition, most));
  return terms;
}

}  // namespace mortise
