// What carries contact pressures, as the equations of a step see it: pairs of surfaces, and nodes before obstacles.
#pragma once

#include <array>
#include <vector>

#include "assembly/system_matrix.hpp"
#include "physics/time_scheme.hpp"
#include "scene.hpp"

namespace mortise {

/// Sums round each secondary node, on the overlap at the indices of its pressure.
struct NodalSums {
  explicit NodalSums(const DofSpace& dofs)
      : weighted_gap(dofs.overlap_map()), covered_area(dofs.overlap_map()), whole_area(dofs.overlap_map()) {}
  Vector weighted_gap, covered_area, whole_area;
  /// Where the forces of friction act: covered area [m^2] and, at the unknowns of the traction, weighted slip of the step [m^3].
  /// Null: the positions are others.
  RCP<Vector> slip;
  bool with_friction = true;  ///< false: forces of the pressures alone
};

/// Rows of the tractions of friction: factors of the derivatives that make them up, at the indices of the tractions.
struct FrictionRows {
  enum { slip = 0, area = 3, traction = 4, normal = 7, pressure = 10, n = 11 };  ///< three each of slip, traction and normal
  explicit FrictionRows(const RCP<const Map>& map) {
    for (auto& factor : factors) factor = Teuchos::rcp(new Vector(map));
  }
  std::array<RCP<Vector>, n> factors;
};

/// One term with pressures on this rank.
/// Order of calls: `search`, then per evaluation `integrate` -> (nodal sums over ranks, law) -> `add_...`.
class ContactTerm {
 public:
  ContactTerm(const ContactNodes& nodes, const DofSpace& dofs) : dofs_(dofs), nodes_(nodes) {}
  virtual ~ContactTerm() = default;

  /// Where may what meet what. @param x positions on the overlap @return whether the answer changed
  virtual bool search(const double* x, double reach, double inward) = 0;

  /// A step begins. @param x positions at its start, on the overlap  @param is_at_rest between steps: nothing moves
  /// @param held what supports hold in it
  virtual void begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>& held) = 0;

  virtual void append_cells(std::vector<Cell>& cells) = 0;

  /// Evaluates at positions and pressures `x` (overlap). Adds to nodal sums on the overlap, at the pressures' indices: weighted
  /// gap [m^3], covered area and whole area (as if all of the surface were covered) [m^2]; and the contact force to the rows of
  /// the nodes in `f`. What is two-sided does so for each of its unknowns.
  virtual void integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) = 0;

  /// Adds the tangent; the row of a pressure is  a d(weighted gap) + b d(covered area) + c d(whole area).
  /// @param a, b, c factors (overlap, at the pressures' indices)  @param force_weight factor on the rows of forces
  virtual void add_tangent(const double* a, const double* b, const double* c, double force_weight, SystemMatrix& K) const = 0;

  /// Adds the rows of forces alone, for forces that act elsewhere than where gaps close.
  /// @param weight factor on them  @param theta further factor on their columns of positions: dx/dq of the time scheme
  virtual void add_force_tangent(double weight, double theta, SystemMatrix& K) const = 0;

  /// Adds the rows of the tractions, found in the last evaluation that summed slips. @param theta as above
  virtual void add_friction_tangent(const FrictionRows&, double /*theta*/, SystemMatrix&) const {}

  /// Whether supports hold the k-th node along its normal, so that its pressure has nothing to do in this step. On all ranks
  /// alike.
  virtual bool is_held(std::size_t /*k*/) const { return false; }

  /// Unit normals at all its nodes at positions `x` (overlap), out of the body.
  virtual std::vector<Vec3<double>> normals(const double* x) const = 0;

  const ContactNodes& nodes() const { return nodes_; }

  /// Point of the k-th node's pressure, and with friction of its traction.
  int pressure_point(std::size_t k) const { return dofs_.n_nodes() + nodes_.first_multiplier + static_cast<int>(k); }

 protected:
  Vec3<double> position(const double* x, int node) const {
    const double* q = x + dofs_.local(node);
    return {q[0], q[1], q[2]};
  }
  /// Averaged unit normals of nodes by their patches.
  std::vector<Vec3<double>> normals_of(const std::vector<NodePatch>& patches, const double* x) const {
    std::vector<Vec3<double>> normals;
    for (const auto& patch : patches) {
      std::vector<Vec3<double>> positions;
      for (int node : patch.nodes) positions.push_back(position(x, node));
      normals.push_back(nodal_normal(patch, positions));
    }
    return normals;
  }
  const DofSpace& dofs_;

 private:
  const ContactNodes& nodes_;
};

}  // namespace mortise
