// Loads that do not depend on the positions: dead tractions, body forces, nodal forces.
#pragma once

#include <string>
#include <vector>

#include "assembly/side_list.hpp"

namespace mortise {

/// Those of a scene, each with what this rank integrates of it: sides and elements that it owns, nodes that it owns.
class DeadLoads {
 public:
  DeadLoads(const Scene& scene, const Partition& partition, const DofSpace& dofs);

  /// Adds the forces [N] at time `t` of the loads that act in the step that ends at `step_end`, on the overlap. Formulas are
  /// evaluated at the quadrature points.
  /// @param fault gets the first message about a formula without a finite value; ranks may differ
  void add(double step_end, double t, double* f, std::string& fault) const;

  bool empty() const { return parts_.empty(); }

 private:
  struct Part {
    const Load& load;
    std::vector<LocalSide> sides;
    std::vector<int> nodes;
  };
  void add(const Part& part, const forces::SideTraction& load, double t, double* f, std::string& fault) const;
  void add(const Part& part, const forces::Acceleration& load, double t, double* f, std::string& fault) const;
  void add(const Part& part, const forces::NodalForce& load, double t, double* f, std::string& fault) const;
  void add_weight(const String& string, const PlacedVector& acceleration, double t, double* f, std::string& fault) const;
  void add_weight(const PointMasses& masses, const PlacedVector& acceleration, double t, double* f, std::string& fault) const;
  void add(const Part&, const forces::SidePressure&, double, double*, std::string&) const {}  // is never dead

  const Scene& scene_;
  const DofSpace& dofs_;
  std::vector<char> is_mine_;  // per element
  std::vector<Part> parts_;
};

}  // namespace mortise
