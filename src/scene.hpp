// The scene: everything a run needs, as plain data, constant after it has been made.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "contact/obstacle.hpp"
#include "contact/surface.hpp"
#include "deck/deck.hpp"
#include "mesh/combine.hpp"
#include "mesh/mesh.hpp"
#include "physics/materials/materials.hpp"
#include "scene_friction.hpp"
#include "scene_loads.hpp"

namespace mortise {

/// A deformable body: elements of one material.
struct Body {
  std::string name;
  Material material;
  FormulationKind formulation;
  TangentKind tangent;
  Kinematics kinematics;
  std::vector<int> elements;      ///< numbers over all blocks, ascending
  std::vector<int> nodes;         ///< ascending
  double youngs_modulus;          ///< at small strain [Pa], for scales
  double size;                    ///< edge of a cube with the mean element volume [m]
  std::optional<double> density;  ///< mass per reference volume [kg/m^3]
  MassKind mass_kind;
  RayleighOptions rayleigh;
  std::optional<InitialOptions> initial;  ///< none: at rest, in its reference position
  double stiffest = 0;  ///< greatest volume over squared shortest edge of an element: its stiffness over the modulus [m]
};

/// The same mass on each of some nodes.
struct PointMasses {
  std::string name;
  std::vector<int> nodes;  ///< ascending
  double mass;             ///< of each [kg]
  std::optional<InitialOptions> initial;
};

/// A string: bars of one section, without stiffness against bending.
struct String {
  std::string name;
  std::vector<int> elements;           ///< numbers over all blocks, ascending
  std::vector<int> nodes;              ///< ascending
  double axial_stiffness;              ///< EA [N]
  std::optional<double> line_density;  ///< rho A [kg/m]
  StretchLaw law;
  double size;  ///< shortest distance of an element's ends over its order [m]
  std::optional<InitialOptions> initial;
};

/// Nodes that something keeps where they may be: each has a pressure, or a traction.
struct ContactNodes {
  std::string name;
  std::string where_penetrating;  ///< start of the message about nodes inside: the entry's place in the deck
  Activity activity;
  Closing closing = Closing::position;
  Enforcement enforcement = Enforcement::multipliers;
  double penalty = 0;              ///< of the gap, where enforcement has one [Pa/m]
  double largest_penetration = 0;  ///< with which an augmented Lagrangian is content [m]
  Complementarity function = Complementarity::minimum;
  bool is_two_sided = false;           ///< held in both directions: never open
  std::vector<int> secondary_nodes;    ///< ascending; node k carries multiplier `first_multiplier + k`
  std::vector<double> tributary_area;  ///< reference area of each of them [m^2]
  int first_multiplier = 0;
  int n_unknowns = 1;              ///< of each of them: the pressure; 4 with friction: and the tangential traction; 3: a traction
  double size = 0;                 ///< edge of the facets round the nodes [m]
  double youngs_modulus = 0;       ///< of the body behind them [Pa]
  double opposite_compliance = 0;  ///< size / Young's modulus of the other side, 0 if that is rigid [m/Pa]
};

/// Two surfaces opposite each other. The size is the square root of the mean area of the secondary facets.
struct OppositeSurfaces : ContactNodes {
  ContactSurface secondary, primary;
  std::vector<int> secondary_elements;  ///< the element behind each secondary facet
  int quadrature_degree = 0;
  double primary_size = 0;  ///< as `size`, of the primary side
};

/// Two surfaces that may meet.
struct ContactPair : OppositeSurfaces {
  ContactForce force = ContactForce::thesis;
  bool has_frozen_integrals = false;  ///< D and M are those of the start of a step
  std::optional<Friction> friction;   ///< none: nothing tangential exists
};

/// What ties one secondary facet to what lies opposite it: integrals over the reference configuration, which no step changes.
struct TieFacet {
  int index;                               ///< in `secondary.facets`
  std::vector<int> primary_nodes;          ///< in the order of their first facet
  std::array<std::array<double, 4>, 4> D;  ///< int N_I N_J dA [m^2]
  std::vector<std::array<double, 4>> M;    ///< int N_I N_K dA, per primary node K [m^2]
  std::array<double, 4> area;              ///< int N_I dA over the overlap [m^2]
};

/// Two surfaces that stay together as they lie in the reference configuration: three unknowns per node, a traction (thesis
/// section 4.2.1).
struct Tie : OppositeSurfaces {
  TieForm form;
  std::vector<TieFacet> facets;  ///< those that something lies opposite
  std::vector<char> is_tied;     ///< per secondary node: it lies in one of them
  int n_pairs = 0;               ///< pairs of facets that were projected and clipped, once for all
};

/// A rigid thing that nodes may touch, or (two-sided) stay on.
struct Obstacle : ContactNodes {
  ObstacleShape shape;
};

/// A nodal value followed in the history.
struct Probe {
  std::string name, quantity;
  int node;
};

/// What another run left, by nodes of the scene.
struct CarriedState {
  std::vector<char> has;                   ///< whether something is known of a node; the rest is for those
  std::vector<Vec3<double>> displacement;  ///< [m]
  std::vector<Vec3<double>> velocity;      ///< [m/s]
  std::vector<double> pressure;            ///< contact pressure [Pa]
  Named<std::filesystem::path> files;      ///< by body, masses or string
};

/// A part of a run: a scheme, and how its steps go to its end.
struct Stage {
  std::string name;  ///< empty: the only one
  double begin = 0;
  TimeOptions time;
  TimeScheme scheme;
};

/// What a deck describes. Terms exist only where the deck calls for them: an empty list is an absent effect.
struct Scene {
  std::string title;
  CombinedMesh mesh;
  std::vector<Body> bodies;
  std::vector<PointMasses> masses;
  std::vector<String> strings;
  std::vector<Support> supports;
  std::vector<PrescribedDof> prescribed;  ///< sorted by node, axis, support, whether or not the support acts
  std::vector<Spring> springs;
  std::vector<NodeSpring> node_springs;
  std::vector<Load> loads;
  std::vector<ContactPair> pairs;
  std::vector<Tie> ties;
  std::vector<Obstacle> obstacles;
  int n_multipliers = 0;
  /// Of each element, counted over all bodies: where its pressures begin among those of all elements, and at the end their
  /// number. Empty: no element has any.
  std::vector<int> first_pressure;
  int n_augmented_springs = 0;
  std::optional<CarriedState> carried;
  std::vector<Probe> probes;
  std::vector<Stage> stages;  ///< one after the other; at least one
  SolverOptions solver;
  OutputOptions output;
  CheckpointOptions checkpoints;
  Named<ExpectedOptions> expected;
  double force_floor;  ///< round-off floor of the residual, 1e-14 E V/h^2 (h + |x|) [N] with the volume and the shortest edge of
                       ///< the stiffest element; E is the bulk modulus where that is greater, or EV/h^2 the stiffness of a
                       ///< spring, EA/h of a string
  double pressure_floor;  ///< pressure that is round-off, 1e-14 E (1 + |x|/h) [Pa]
  double size;            ///< smallest size of an element of a body or string, or length of a spring [m]
  double extent;          ///< greatest reference coordinate [m]

  double end() const { return stages.back().time.end; }
  bool has_inertia() const;  ///< in any stage

  /// Pairs, ties, obstacles: all that has multipliers, in the order of terms.
  std::vector<const ContactNodes*> contacts() const;

  /// Of these what has pressures: pairs and obstacles.
  std::vector<const ContactNodes*> contacts_with_pressures() const;

  int n_element_pressures() const { return first_pressure.empty() ? 0 : first_pressure.back(); }
  /// The point that carries pressure `m` of element `e` (see DofSpace).
  int pressure_point(int e, int m) const { return n_nodes(mesh.mesh) + n_multipliers + first_pressure[e] + m; }

  /// The point that carries the unknowns of augmented spring `k`: squared stretch and multiplier.
  int spring_point(int k) const { return n_nodes(mesh.mesh) + n_multipliers + n_element_pressures() + k; }
  bool has_friction() const;

  /// Elements or springs have unknowns of their own, so that the tangent is indefinite.
  bool has_internal_unknowns() const { return n_element_pressures() + n_augmented_springs > 0; }
};

/// Opens the meshes and resolves every name of the deck.
/// @param warnings lines for the log, e.g. about a secondary side that is coarser than the primary one
/// @throws DeckError, MeshError, FileError
Scene make_scene(const Deck& deck, std::vector<std::string>& warnings);

}  // namespace mortise
