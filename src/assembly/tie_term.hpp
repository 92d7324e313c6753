// Two surfaces tied together, as a term of the scene.
#pragma once

#include "assembly/contact_term.hpp"
#include "assembly/held_components.hpp"

namespace mortise {

/// One tie on this rank: the secondary facets whose element the rank owns. With weighted gaps g_I = D_IJ x_J - M_IK x_K and the
/// rotation R of the facet since the reference configuration (the identity in the plain form) it adds the stationary point of
///   sum_I traction_I . (R^T g_I - g_I(X))
/// over positions and tractions (thesis eqs. 4.95, 4.97, 4.98): momenta are kept by invariance.
class TieTerm : public ContactTerm {
 public:
  TieTerm(const Scene& scene, const Tie& tie, const Partition& partition, const DofSpace& dofs);

  bool search(const double*, double, double) override { return false; }
  void begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>& held) override;
  void append_cells(std::vector<Cell>& cells) override;
  void integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) override;
  void add_tangent(const double* a, const double* b, const double* c, double force_weight, SystemMatrix& K) const override;
  void add_force_tangent(double weight, double theta, SystemMatrix& K) const override;
  std::vector<Vec3<double>> normals(const double* x) const override;

  const Tie& tie() const { return tie_; }

  /// Number of components of tractions that the step leaves out because supports hold their nodes, on all ranks alike.
  int n_left_out() const { return static_cast<int>(left_out_.size()); }

 private:
  struct Facet {
    const TieFacet* of;
    std::array<int, 4> corner;                  // positions of its nodes in tie_.secondary_nodes
    std::vector<int> points;                    // its nodes, primary nodes, tractions
    Tensor3<double> frame;                      // in the reference configuration
    std::array<Vec3<double>, 4> gap;            // weighted, likewise [m^3]
    std::vector<double> matrix;                 // last tangent over the unknowns of `points`
    std::array<std::array<double, 3>, 4> area;  // at components that are left out 0 [m^2]
  };
  std::array<Vec3<double>, 4> gaps(const Facet& facet, const std::vector<Vec3<double>>& x) const;
  std::vector<Vec3<double>> positions(const Facet& facet, const double* x) const;
  std::size_t n_positions(const Facet& facet) const { return 3 * (facet.points.size() - 4); }
  std::size_t width(const Facet& facet) const { return n_positions(facet) + 12; }
  void add_scaled(const Facet& facet, std::vector<double>& scaled, double weight, double theta) const;

  const Tie& tie_;
  std::vector<NodePatch> patches_;
  std::vector<Facet> facets_;
  Components left_out_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
