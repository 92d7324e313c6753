// The sides under a follower load, as the tangent check sees them.
#include <fmt/format.h>

#include "errors.hpp"
#include "tangents/checked_term.hpp"

namespace mortise {

CheckedTerm checked_sides(const StepProblem& problem, const Load& load, const Partition& partition, int most) {
  const Scene& scene = problem.scene();
  const auto term = std::make_shared<FollowerTerm>(scene, load, partition, problem.dofs());
  const double last = load.activity.last_time(scene.end());
  std::string fault;
  term->set_time(last, last, fault);
  if (!fault.empty()) throw DeckError(fault);
  const std::vector<Side>& sides = load.sides();
  const int n = static_cast<int>(sides.size()), stride = stride_for(n, most);

  CheckedTerm checked;
  checked.name = fmt::format("load \"{}\" ({}, at t = {:g})", load.name, load.kind, last);
  checked.pieces_name = "sides";
  checked.ways = {{TangentKind::whole_element, "AD"},
                  {TangentKind::complex_step, "complex step"},
                  {TangentKind::central_differences, "central differences"},
                  {TangentKind::forward_differences, "forward differences"},
                  {TangentKind::backward_differences, "backward differences"}};
  checked.reference = TangentKind::complex_step;
  checked.time_unit = TangentKind::whole_element;
  checked.has_kinks = false;
  checked.n_pieces = n;
  checked.n_chosen = (n + stride - 1) / stride;
  checked.describe = [&scene, &sides](long long key) {
    return fmt::format("side {} of {}", sides[key].face + 1, describe_element(scene.mesh, sides[key].element));
  };
  checked.pieces = [term, stride](const double* x) {
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < term->sides().size(); ++s) {
      const LocalSide& side = term->sides()[s];
      if (side.number % stride != 0) continue;
      const double size = term->size(s);
      Piece piece{static_cast<long long>(side.number), std::vector<double>(3 * side.nodes.size(), size), 0, {}};
      for (int k : side.local)
        for (int i = 0; i < 3; ++i) piece.magnitude = std::max(piece.magnitude, std::abs(x[k + i]) / size);
      piece.tangent = [term, s, x](TangentKind kind, double relative_step, double* K) {
        std::vector<double> r(term->sides()[s].nodes.size() * 3);
        return term->tangent(kind, relative_step, s, x, r.data(), K);
      };
      pieces.push_back(std::move(piece));
    }
    return pieces;
  };
  return checked;
}

}  // namespace mortise
