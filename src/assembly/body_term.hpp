// The internal force of one body as a term of the scene, and what is derived from its state.
#pragma once

#include <vector>

#include "assembly/system_matrix.hpp"
#include "physics/elements/hex8.hpp"
#include "scene.hpp"

namespace mortise {

/// Internal force of the elements of one body that this rank owns.
class BodyTerm {
 public:
  BodyTerm(const Scene& scene, const Body& body, const Partition& partition, const DofSpace& dofs);

  /// One cell per element, appended; `add_tangent` counts from there.
  void append_cells(std::vector<Cell>& cells);

  /// Adds f_int(q) to `f` (both on the overlap). @return false if a state is inadmissible on this rank
  bool add_force(const double* q, double* f) const;

  /// The same, and K = df_int/dq into the matrix.
  bool add_tangent(const double* q, double* f, SystemMatrix& K) const;

  /// Strain energy of this rank's elements [J].
  double strain_energy(const double* q) const;

  /// Adds volume-weighted Cauchy stress (xx yy zz xy yz zx, von Mises) and volume to nodal sums, 7 and 1 per node of the mesh.
  void add_nodal_stress(const double* q, std::vector<double>& stress, std::vector<double>& volume) const;

  std::size_t n_elements() const { return geometry_.size(); }
  const Body& body() const { return body_; }

 private:
  void gather(std::size_t e, const double* q, double q_e[8][3]) const;

  const Body& body_;
  const DofSpace& dofs_;
  std::vector<std::array<int, 8>> nodes_;  // of this rank's elements
  std::vector<Hex8Geometry> geometry_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
