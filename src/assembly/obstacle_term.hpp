// Nodes before a rigid obstacle, or on a rigid rod, as a term of the scene.
#pragma once

#include "assembly/contact_term.hpp"

namespace mortise {

/// The nodes of one obstacle that this rank owns. Each has a pressure p on its area A: the force p A grad g pushes it away.
class ObstacleTerm : public ContactTerm {
 public:
  ObstacleTerm(const Scene& scene, const Obstacle& obstacle, const DofSpace& dofs);

  bool search(const double*, double, double) override { return false; }
  void begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>& held) override;
  void append_cells(std::vector<Cell>& cells) override;
  void integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) override;
  void add_tangent(const double* a, const double* b, const double* c, double force_weight, SystemMatrix& K) const override;
  void add_force_tangent(double weight, double theta, SystemMatrix& K) const override;
  std::vector<Vec3<double>> normals(const double* x) const override;

 private:
  struct Node {
    std::size_t k;  // in secondary_nodes
    int position, pressure;
    Vec3<double> start;
    // of the last evaluation: force, its derivative by positions and by the pressure, derivative of the weighted gap
    double force_slope[3][3], push[3], gap_slope[3];
  };
  const Mesh& mesh_;
  const Obstacle& obstacle_;
  std::vector<Node> nodes_here_;
  std::size_t first_cell_ = 0;
  bool keeps_energy_ = false;  // the gradient of this step is the discrete one
};

}  // namespace mortise
