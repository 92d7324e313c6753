// Springs between nodes in the redundant formulation, as a term of the scene.
#pragma once

#include <vector>

#include "assembly/dof_space.hpp"
#include "assembly/line_point.hpp"
#include "assembly/system_matrix.hpp"
#include "physics/time_scheme.hpp"

namespace mortise {

/// A spring with the energy V(v) = c L^2 w(v), whose squared stretch v [-] and the multiplier lambda [J] of
///   Phi = v - |q_to - q_from|^2 / L^2 = 0
/// are the two unknowns of a point of its own (thesis eqs. 6.37-6.43; physics/augmented_stretch.hpp). Rows of nodes get
/// -(2 / L^2) lambda q_theta, that of v grad_v V + lambda [J], that of lambda Phi [-].
class AugmentedSpringTerm {
 public:
  /// The rank that owns the spring's first node has it. Precondition: the spring is augmented.
  AugmentedSpringTerm(const Scene& scene, const NodeSpring& spring, const DofSpace& dofs);

  void append_cells(std::vector<Cell>& cells);

  bool acts_at(double t) const { return activity_.acts_at(t); }
  bool is_anchored() const { return is_anchored_; }  ///< to a fixed point
  bool is_here() const { return !local_.empty(); }   ///< on this rank; all else is for this case

  /// Local index of v; lambda is the next one.
  int unknowns() const { return unknowns_; }
  double rest_length() const { return rest_length_; }  ///< [m]

  /// Adds the force of a step from `x_n` to `x` as a whole, whatever the scheme's reading, to `f`; all on the overlap.
  /// @return false if the squared stretch is not one on this rank
  bool add_force(const TimeScheme& scheme, const double* x_n, const double* x, double* f) const;

  /// The same, and its derivative with respect to `x` into the matrix.
  bool add_tangent(const TimeScheme& scheme, const double* x_n, const double* x, double* f, SystemMatrix& K) const;

  /// Writes v and lambda of the spring at rest at positions `x` (overlap) into `y` (owned).
  void settle(const double* x, double* y) const;

  /// Stored on this rank at the positions in `x` [J].
  double energy(const double* x) const;

 private:
  bool is_admissible(double v) const;

  StretchLaw law_;
  Activity activity_;
  bool is_anchored_;
  double rest_length_;  // [m]
  LinePoint line_;
  std::vector<int> points_, local_;  // of the nodes, then its own; empty: on another rank
  int unknowns_ = -1;
  std::size_t cell_ = 0;
};

}  // namespace mortise
