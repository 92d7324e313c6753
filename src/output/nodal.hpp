// Fields at the nodes of a scene, for results and probes.
#pragma once

#include <string>
#include <vector>

#include "assembly/step_problem.hpp"

namespace mortise {

/// Nodal variables by their names (deck/field_table.hpp): per name one value per node, on every rank. Collective: one pass over
/// the elements and one sum over the ranks, however many names there are.
/// A field of quadrature points is at node a the mean  sum_g w_g f_g / sum_g w_g  over the points of all elements at the node,
/// w_g = max(N_a, 0) JxW [m^3]: at corners of quadratic elements the shape functions are negative here and there, and their
/// integrals too. Principal stresses and directions are those of the mean Cauchy stress.
/// @throws std::logic_error for a name that the deck reader should not have let through
std::vector<std::vector<double>> nodal_variables(const StepProblem& problem, const State& state, const Evaluation& at,
                                                 const std::vector<std::string>& names);

}  // namespace mortise
