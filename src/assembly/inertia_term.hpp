// The inertia of one body, a string or point masses as a term of the scene: constant mass matrices, one per element.
#pragma once

#include <vector>

#include "assembly/body_term.hpp"

namespace mortise {

/// Inertial force  f = M a  of the elements of one body that this rank owns,  M_ab = rho int N_a N_b dV  times the identity of
/// space (thesis eq. 4.13); of a string, with rho A and over its length; or of its nodes with a mass. The time scheme hands over
/// a and da/dq.
class InertiaTerm {
 public:
  /// Precondition: the body has a density (the deck reader sees to it).
  InertiaTerm(const Scene& scene, const BodyTerm& body, const DofSpace& dofs);
  InertiaTerm(const PointMasses& masses, const DofSpace& dofs);
  InertiaTerm(const Scene& scene, const String& string, const Partition& partition, const DofSpace& dofs);

  void append_cells(std::vector<Cell>& cells);

  /// Adds M a to `f`, both on the overlap. @param a at the rows of positions [m/s^2]; velocities give momenta
  void add_force(const double* a, double* f) const;

  /// Adds M da/dq into the matrix. @param da_dq of the scheme [1/s^2]
  void add_tangent(double da_dq, SystemMatrix& K) const;

  /// v . M v / 2 of this rank [J]. @param v on the overlap [m/s]
  double kinetic_energy(const double* v) const;

  /// Mass of this rank's elements [kg], and sum of mass times position [kg m]. @param x on the overlap
  std::array<double, 4> mass_and_moment(const double* x) const;

  const std::vector<int>& nodes() const { return *nodes_; }  ///< of all ranks, ascending
  const std::optional<InitialOptions>& initial() const { return *initial_; }
  double mass_of_element() const { return mass_of_element_; }  ///< of the scene's size, or of a point [kg]: for scales

 private:
  struct Element {
    std::vector<int> nodes, local;
    std::vector<double> M;  // over nodes, row-major [kg]
  };
  static void empty_contact_nodes(Element& element, const std::vector<char>& is_contact_node);
  const std::vector<int>* nodes_;
  const std::optional<InitialOptions>* initial_;
  double mass_of_element_;
  std::vector<Element> elements_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
