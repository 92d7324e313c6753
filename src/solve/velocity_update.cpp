#include "solve/velocity_update.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/vectors.hpp"

namespace mortise {

std::string update_velocities(StepProblem& problem, LinearSolver& linear, const State& from, State& to, Evaluation& at) {
  const auto is_updated = [](const auto& contact) { return contact->nodes().closing == Closing::velocity_update; };
  const auto& contacts = problem.contacts();
  if (to.v.is_null() || at.n_closed == 0 || std::none_of(contacts.begin(), contacts.end(), is_updated)) return "";
  const auto mass = problem.mass_matrix();
  LinearReport report = linear.factor(mass, problem.identity_rows(), problem.graph_number());
  const auto& map = to.v->getMap();
  VelocityJump jump{Teuchos::rcp(new Vector(map)), Teuchos::rcp(new Vector(map)), Teuchos::rcp(new Vector(map))};
  Vector dq(*to.x, Teuchos::Copy);
  dq.update(-1.0, *from.x, 1.0);
  for (std::size_t k = 0; k < contacts.size() && report.solved; ++k) {
    if (!is_updated(contacts[k])) continue;
    const auto push = problem.push_at_end(*to.x, k);
    if (push->normInf() == 0) continue;
    Vector free_push(*push, Teuchos::Copy), answer(map);
    double* free = data(free_push);
    for (int row = 0; row < problem.dofs().n_owned(); ++row)
      if (problem.identity_rows()[row]) free[row] = 0;
    report = linear.solve(free_push, answer);
    const double work = problem.push(*to.x, k)->dot(dq), parting = push->dot(*to.v), mobility = push->dot(answer);
    if (!report.solved || !(mobility > 0)) continue;
    const double b = (std::sqrt(std::max(0.0, parting * parting - 2 * mobility * work)) - parting) / mobility;
    to.v->update(b, answer, 1.0);
    jump.change->update(b, answer, 1.0);
    jump.impulse->update(b, *push, 1.0);
    if (k >= problem.pairs().size()) jump.impulse_of_ground->update(b, *push, 1.0);
  }
  at.jump = jump;
  return report.solved ? "" : "the mass matrix: " + report.cause;
}

}  // namespace mortise
