// Rayleigh damping of one body as a term of the scene: a constant matrix, held per element.
#pragma once

#include <vector>

#include "assembly/body_term.hpp"

namespace mortise {

/// Damping force  f = C v,  C = a M + b K_0,  of the elements of one body that this rank owns. M is the mass matrix of the body's
/// kind, K_0 the tangent of the internal force at the reference positions. The time scheme hands over v and dv/dq.
class DampingTerm {
 public:
  /// @param body the internal force that K_0 is the tangent of  @param reference reference positions on the overlap [m]
  /// Precondition: the body has a density if a > 0, and no pressures of elements if b > 0 (the deck reader sees to it).
  DampingTerm(const Scene& scene, const BodyTerm& body, const double* reference, const DofSpace& dofs);

  void append_cells(std::vector<Cell>& cells);

  /// Adds C v to `f`, both on the overlap. @param v velocities at the rows of positions [m/s]
  void add_force(const double* v, double* f) const;

  /// Adds C dv/dq into the matrix. @param dv_dq of the scheme, 1/dt for v = (q - q_n)/dt [1/s]
  void add_tangent(double dv_dq, SystemMatrix& K) const;

 private:
  struct Element {
    std::vector<int> nodes, local;
    std::vector<double> C;  // over the nodes' unknowns, row-major [N s/m]
  };
  std::vector<Element> elements_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
