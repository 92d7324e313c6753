// Springs between nodes, and strings, as a term of the scene: lines that are stretched.
#pragma once

#include <vector>

#include "assembly/dof_space.hpp"
#include "assembly/line_point.hpp"
#include "assembly/system_matrix.hpp"

namespace mortise {

/// Force of lines with the energy  V = sum_g E_g w(t_g . t_g),  t = dq/dS = sum_a N'_a q_a  at their quadrature points, with the
/// sign of an internal force (physics/stretch_laws.hpp). A spring is a line with one point.
class StretchTerm {
 public:
  /// The rank that owns the spring's first node has it.
  StretchTerm(const NodeSpring& spring, const DofSpace& dofs);

  /// The elements of the string that this rank owns, with one point less than each has nodes.
  StretchTerm(const Scene& scene, const String& string, const Partition& partition, const DofSpace& dofs);

  void append_cells(std::vector<Cell>& cells);

  bool acts_at(double t) const { return activity_.acts_at(t); }
  bool is_anchored() const { return is_anchored_; }  ///< a spring to a fixed point

  /// Adds the force to `f`, all on the overlap: at positions `x`, or, with `x_n`, the discrete gradient of the energy in the step
  /// from there to `x` (thesis eqs. 6.31-6.36). @return false if a line has shrunk to nothing on this rank
  bool add_force(const double* x_n, const double* x, double* f) const;

  /// The same, and its derivative with respect to `x`, times `factor`, into the matrix.
  bool add_tangent(const double* x_n, const double* x, double factor, double* f, SystemMatrix& K) const;

  /// Stored on this rank [J].
  double energy(const double* x) const;

 private:
  struct Line {
    std::vector<int> nodes, local;
    std::vector<LinePoint> points;
  };

  StretchLaw law_;
  Activity activity_;
  bool is_anchored_ = false;
  std::vector<Line> lines_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
