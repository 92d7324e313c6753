// What a formulation is: how an element's unknowns make deformation gradients, and stresses make its residual.
//
// A formulation is a struct with
//   Element                        its shape functions and rules
//   n_pressures, n_local           further unknowns: of the scene (pressures), and of the element alone (condensed)
//   Geometry, geometry(X)          what it keeps of the reference configuration
//   add_residual(law, geometry, y, r)     the residual, once, over any scalar;  y = [positions, pressures, local unknowns]
//   add_tangent(law, geometry, y, r, K)   the same with K = dr/dy from stress and moduli at the quadrature points
//   strain_energy(law, geometry, y)       [J]
//   point(law, geometry, g, y)            deformation gradient, first Piola stress and energy density at a quadrature point, for
//                                         output; the energy densities add up to strain_energy
// All but `geometry` add to what is there. Residuals and tangents return false for an inadmissible state (det F <= 0).
// A law is a material, or what calls one:  strain_energy(F), first_piola(F) over any scalar, and moduli(F, P, A) with
// A[3 i + J][3 k + L] = dP_iJ/dF_kL; the mixed element also asks for volumetric_compliance().
#pragma once

#include "physics/elements/geometry.hpp"
#include "physics/internal_force.hpp"

namespace mortise {

/// Numbers of unknowns of a formulation.
template <class Formulation>
struct Count {
  static constexpr int nodes = Formulation::Element::n_nodes;
  static constexpr int positions = 3 * nodes;
  static constexpr int global = positions + Formulation::n_pressures;  ///< that the scene solves for
  static constexpr int all = global + Formulation::n_local;
};

/// What an element's quadrature point knows of itself.
struct PointState {
  Tensor3<double> F;     ///< deformation gradient that the material sees [-]
  Tensor3<double> P;     ///< first Piola-Kirchhoff stress, with the pressure of a mixed element [Pa]
  double strain_energy;  ///< per reference volume, with that of the pressure [J/m^3]
};

}  // namespace mortise
