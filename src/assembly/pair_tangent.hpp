// Seeds Sacado for contact pairs: shares of a facet pair, alone or with their complete derivative.
#pragma once

#include <optional>

#include "contact/mortar/auxiliary_plane.hpp"
#include "contact/mortar/nodal_normal.hpp"
#include "contact/mortar/pair_friction.hpp"
#include "contact/mortar/pair_residual.hpp"
#include "contact/mortar/readings.hpp"

namespace mortise {

/// What friction needs beside: motion in a step whose middle, end or other point the positions are.
struct PairFriction {
  std::array<Vec3<double>, 8> before;           ///< positions at the start of the step [m]
  double theta;                                 ///< positions of the pair = (1 - theta) before + theta after
  std::array<Vec3<double>, 4> traction_before;  ///< at the start of the step [Pa]
  double traction_theta;                        ///< what acts is (1 - traction_theta) before + traction_theta after
  std::array<Vec3<double>, 4> traction;         ///< at the end of the step [Pa]
  bool is_moment_free;
};

/// Where D and M of a pair are found, if not where it stands now.
struct FrozenPlace {
  std::array<Vec3<double>, 8> x;
  std::array<Vec3<double>, 4> normal;
};

/// Everything a pair depends on.
struct PairInput {
  std::array<Vec3<double>, 8> x;       ///< 4 secondary nodes, 4 primary nodes [m]
  std::array<Vec3<double>, 4> normal;  ///< unit nodal normals
  std::array<double, 4> pressure;      ///< nodal pressures [Pa]
  ContactForce reading = ContactForce::thesis;
  std::optional<FrozenPlace> frozen;  ///< D and M are those of this place, and do not change (thesis Remark 11)

  AuxiliaryPlane plane() const {
    return frozen ? AuxiliaryPlane::project(frozen->x, frozen->normal) : AuxiliaryPlane::project(x, normal);
  }
};

/// Shares of a pair by value. Rows in the order of `PairShares`: 24 forces, 12 normal loads, 4 weighted gaps.
struct PairOutput {
  double row[40];
  double covered_area[4];  ///< int N_I da [m^2]
};

/// Rows and their derivatives; columns: 24 positions, 12 normal components, 4 pressures.
struct PairTangent : PairOutput {
  double d[40][40];
  double d_area[4][36];  ///< derivative of the covered areas; pressures have no part in it
};

/// @return false if the facets do not overlap (all shares are zero then)
bool pair_values(const PairInput& input, const std::vector<TrianglePoint>& rule, PairOutput& out);

/// As `pair_values`, with the complete derivative: D and M by AD over 16 in-plane coordinates and pulled back in closed form,
/// then the pair's equations by AD over all 40 inputs. @see pair_residual.hpp
bool pair_tangent(const PairInput& input, const std::vector<TrianglePoint>& rule, PairTangent& out);

/// Whole projected area of a secondary facet, by node [m^2], and its derivative (columns as in `PairTangent`, without pressures);
/// the primary nodes of the input have no part in it.
void whole_area_tangent(const PairInput& input, double whole_area[4], double d[4][36]);

/// Shares of a pair with friction: those of `PairOutput`, its forces with those of friction, then 12 weighted slips.
struct FrictionalOutput {
  double row[52];
  double covered_area[4];
};

/// Rows and their derivatives; columns: 24 positions, 12 normal components, 4 pressures, 12 tractions at the end of the step.
struct FrictionalTangent : FrictionalOutput {
  double d[52][52];
  double d_area[4][36];
};

bool pair_values(const PairInput& input, const PairFriction& friction, const std::vector<TrianglePoint>& rule,
                 FrictionalOutput& out);
bool pair_tangent(const PairInput& input, const PairFriction& friction, const std::vector<TrianglePoint>& rule,
                  FrictionalTangent& out);

/// Derivative of  (dn/dx)^T b  with respect to the patch nodes, b held: a symmetric matrix, 3 m x 3 m row-major for m patch
/// nodes, added to `H`.
void add_normal_curvature(const NodePatch& patch, const std::vector<Vec3<double>>& x, const Vec3<double>& b,
                          std::vector<double>& H);

}  // namespace mortise
