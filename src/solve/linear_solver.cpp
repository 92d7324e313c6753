#include "solve/linear_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace mortise {
namespace {

// A node is a group; its contact pressure joins it, and so do the unknowns of an element or a spring with one of its nodes.
std::vector<int> groups(const Scene& scene, const DofSpace& dofs) {
  std::vector<int> group(dofs.n_unknowns());
  for (std::size_t k = 0; k < 3 * static_cast<std::size_t>(dofs.n_nodes()); ++k) group[k] = static_cast<int>(k / 3);
  for (const ContactNodes* contact : scene.contacts())
    for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k)
      std::fill_n(&group[dofs.global(dofs.n_nodes() + contact->first_multiplier + static_cast<int>(k))], contact->n_unknowns,
                  contact->secondary_nodes[k]);
  for (int e = 0; e + 1 < static_cast<int>(scene.first_pressure.size()); ++e)
    for (int m = 0; m < scene.first_pressure[e + 1] - scene.first_pressure[e]; ++m)
      group[dofs.global(scene.pressure_point(e, m))] = element_nodes(scene.mesh.mesh, e)[0];
  for (const NodeSpring& spring : scene.node_springs)
    if (spring.augmented)
      for (int m = 0; m < 2; ++m) group[dofs.global(scene.spring_point(*spring.augmented)) + m] = spring.from;
  return group;
}

// Beyond this a factorisation costs more than GMRES with RILUK in memory and time.
constexpr long long largest_direct = 150000;

std::variant<DirectSolver, IterativeSolver> choose(const Scene& scene, const DofSpace& dofs, const SolverOptions& options) {
  const long long n = dofs.n_unknowns();
  const bool iterative =
      options.linear == LinearSolverKind::iterative || (options.linear == LinearSolverKind::automatic && n > largest_direct &&
                                                        !scene.has_internal_unknowns() && !scene.has_friction());
  if (iterative) return IterativeSolver(dofs.owned_map(), 3LL * dofs.n_nodes(), options);
  return DirectSolver(dofs.owned_map(), groups(scene, dofs));
}

}  // namespace

LinearSolver::LinearSolver(const Scene& scene, const DofSpace& dofs, const SolverOptions& options)
    : solver_(choose(scene, dofs, options)), n_positions_(3LL * dofs.n_nodes()), no_length_(1e-3 * scene.size) {
  const bool is_direct = direct() != nullptr;
  choice_ = fmt::format("{}{}", is_direct ? "direct (MUMPS, unsymmetric)" : "iterative (GMRES, RILUK blocks)",
                        options.linear == LinearSolverKind::automatic ? ", chosen by size" : "");
  accepted_residual_ = is_direct ? 1e-8 : 10 * options.linear_tolerance;
}

LinearReport LinearSolver::factor(const RCP<const Matrix>& A, const std::vector<char>& identity_rows, long graph_number) {
  original_ = A;
  reduced_ = Teuchos::rcp(new Matrix(*A, Teuchos::Copy));
  identity_rows_ = identity_rows;
  zero_known_columns(*reduced_, identity_rows);
  if (auto* direct = std::get_if<DirectSolver>(&solver_)) return direct->factor(*reduced_, graph_number);
  return std::get<IterativeSolver>(solver_).prepare(*reduced_);
}

LinearReport LinearSolver::solve(const Vector& b, Vector& x) {
  Vector right(b, Teuchos::Copy);
  move_known_columns(*original_, identity_rows_, right);
  LinearReport report = std::visit([&](auto& solver) { return solver.solve(right, x); }, solver_);
  if (!report.solved) return report;
  report.true_residual = backward_error(*reduced_, x, right, n_positions_, no_length_);
  if (!(report.true_residual <= accepted_residual_)) {
    report.solved = false;
    report.cause = fmt::format("the linear solver returned a wrong solution: backward error {:.2e}", report.true_residual);
  }
  return report;
}

}  // namespace mortise
