// Springs to the ground as a term of the scene: linear, so its matrices are made once.
#pragma once

#include <vector>

#include "assembly/side_list.hpp"
#include "assembly/system_matrix.hpp"

namespace mortise {

/// Force  f_a = k sum_b S_ab (q_b - X_b)  [N] on the nodes that hold the springs, with the sign of an internal force.
/// At nodes S is 1; a bedding has S_ab = int N_a N_b dA over each reference side.
class SpringTerm {
 public:
  SpringTerm(const Scene& scene, const Spring& spring, const Partition& partition, const DofSpace& dofs);

  void append_cells(std::vector<Cell>& cells);

  bool acts_at(double t) const { return spring_.activity.acts_at(t); }

  /// Adds the force at positions `x` to `f` (both on the overlap).
  void add_force(const double* x, double* f) const;

  /// Adds factor k S into the matrix.
  void add_stiffness(double factor, SystemMatrix& K) const;

  /// Stored on this rank [J].
  double energy(const double* x) const;

 private:
  struct Element {
    std::vector<int> nodes, local;
    std::vector<double> S;  // n x n
  };
  const Mesh& mesh_;
  const Spring& spring_;
  std::vector<Element> elements_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
