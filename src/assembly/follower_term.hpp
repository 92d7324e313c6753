// A load over the current area of sides as a term of the scene: its force and tangent change with the positions.
#pragma once

#include <string>
#include <vector>

#include "assembly/side_list.hpp"
#include "assembly/system_matrix.hpp"
#include "assembly/tangent_kind.hpp"

namespace mortise {

struct SideLoad;

/// Pressure, or traction of fixed direction, on the sides of elements that this rank owns.
class FollowerTerm {
 public:
  /// Precondition: the load follows.
  FollowerTerm(const Scene& scene, const Load& load, const Partition& partition, const DofSpace& dofs);

  /// One cell per side, appended; `add_tangent` counts from there.
  void append_cells(std::vector<Cell>& cells);

  /// Evaluates the load at time `t` at all quadrature points; where it does not act in the step that ends at `step_end`, there is
  /// no force until the next call.
  /// @param fault gets the first message about a formula without a finite value; ranks may differ
  void set_time(double step_end, double t, std::string& fault);

  /// Adds f_ext(x) [N] to `f` (both on the overlap).
  void add_force(const double* x, double* f) const;

  /// The same, and -df_ext/dx into the matrix: the term's share of the residual is -f_ext. @param factor dx/dq of the time scheme
  void add_tangent(const double* x, double factor, double* f, SystemMatrix& K) const;

  const std::vector<LocalSide>& sides() const { return sides_; }
  double size(std::size_t side) const { return sizes_[side]; }  ///< square root of the reference area [m]

  /// -f_ext [N] of one side and its derivative by any kind; overwrites r and K. Nothing if the load does not act.
  bool tangent(TangentKind kind, double relative_step, std::size_t side, const double* x, double* r, double* K) const;

 private:
  SideLoad load_of(std::size_t side) const;

  const Mesh& mesh_;
  const Load& load_;
  std::vector<LocalSide> sides_;
  std::vector<double> sizes_;
  std::vector<Vec3<double>> values_;  // at the points of the sides, one side after the other; a pressure is the first component
  std::vector<std::size_t> first_value_;  // of each side
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
