// What moves, holds and pushes in a scene: supports, springs and loads as plain data.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "deck/activity.hpp"
#include "deck/formula.hpp"
#include "mesh/mesh.hpp"
#include "physics/stretch_laws.hpp"
#include "physics/tensor.hpp"

namespace mortise {

/// A formula of the deck, and the start of the message about it: its place there.
struct PlacedFormula {
  Formula formula;
  std::string where;
};

/// Components x, y, z.
using PlacedVector = std::array<std::optional<PlacedFormula>, 3>;

/// Value at a time and place; what is not finite is told in `fault`, if that holds no message yet.
double evaluate(const PlacedFormula& formula, double t, const Point& X, std::string& fault);

/// The three components; those left out are 0.
Vec3<double> evaluate(const PlacedVector& formulas, double t, const Point& X, std::string& fault);

namespace motions {

/// u(t) from the reference position [m].
struct Displacement {
  PlacedVector displacement;
};
/// v(t) [m/s], integrated over each step from where the node is.
struct Velocity {
  PlacedVector velocity;
};
/// q = c + R(angle) (X - c) + u(t).
struct Rotation {
  Vec3<double> axis;  ///< unit length
  Vec3<double> centre;
  PlacedFormula degrees;
  PlacedVector displacement;
};
/// u = 0 along one axis.
struct Symmetry {
  int axis;
};

}  // namespace motions

using Motion = std::variant<motions::Displacement, motions::Velocity, motions::Rotation, motions::Symmetry>;

struct Support {
  std::string name, kind;  ///< kind: the deck's word
  Motion motion;
  Activity activity;
  std::array<std::string, 3> where_contradicting;  ///< start of the message about another support that gives another value

  bool holds(int axis) const;
};

/// One component of one node that a support prescribes, whenever the support acts.
struct PrescribedDof {
  int node;
  int axis;
  int support;  ///< index into Scene::supports
};

/// Springs to the ground: force -k (q - X) at each node, or per reference area of sides.
struct Spring {
  std::string name;
  Activity activity;
  std::array<double, 3> stiffness;  ///< of each component [N/m] at nodes, [N/m^3] on sides
  std::vector<int> nodes;           ///< of the set, ascending
  std::vector<Side> sides;          ///< of a bedding; empty: springs at nodes
};

/// A spring from a node to another one or to a fixed point: energy c L^2 w(nu^2), nu = |q_to - q_from| / L.
struct NodeSpring {
  std::string name;
  Activity activity;
  int from = 0;
  std::optional<int> to;  ///< none: `anchor`
  Point anchor{};
  double rest_length = 0;  ///< L [m]
  double stiffness = 0;    ///< c [N/m]
  StretchLaw law = StretchLaw::saint_venant;
  /// Its number among the springs whose squared stretch is an unknown (thesis eqs. 6.37-6.43); none: it is not.
  std::optional<int> augmented;

  /// The other end where nothing has moved.
  const Point& far_end(const Mesh& mesh) const { return to ? mesh.coordinates[*to] : anchor; }
};

namespace forces {

/// Traction [Pa] of fixed direction over the reference area or the current one.
struct SideTraction {
  std::vector<Side> sides;
  PlacedVector traction;
  bool over_current_area;
};
/// Pressure [Pa] against the current normal.
struct SidePressure {
  std::vector<Side> sides;
  PlacedFormula pressure;
};
/// Force per mass [m/s^2] on bodies, point masses and strings, by their indices.
struct Acceleration {
  std::vector<int> bodies, masses, strings;
  PlacedVector acceleration;
};
/// Force [N] at each node.
struct NodalForce {
  std::vector<int> nodes;
  PlacedVector force;
};

}  // namespace forces

struct Load {
  std::string name, kind;  ///< kind: the deck's word
  std::variant<forces::SideTraction, forces::SidePressure, forces::Acceleration, forces::NodalForce> what;
  Activity activity;

  bool follows() const;  ///< it depends on the positions
  /// Of a traction or pressure.
  const std::vector<Side>& sides() const;
};

}  // namespace mortise
