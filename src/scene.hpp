// The scene: everything a run needs, as plain data, constant after it has been made.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "contact/surface.hpp"
#include "deck/deck.hpp"
#include "mesh/combine.hpp"
#include "mesh/mesh.hpp"
#include "physics/materials/materials.hpp"
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

/// Two surfaces that may meet.
struct ContactPair {
  std::string name;
  ContactSurface secondary, primary;
  std::string where_penetrating;        ///< start of the message about surfaces inside each other: the pair's place in the deck
  std::vector<int> secondary_elements;  ///< the element behind each secondary facet
  std::vector<int> secondary_nodes;     ///< ascending; node k carries multiplier `first_multiplier + k`
  std::vector<double> tributary_area;   ///< reference area of each secondary node [m^2]
  int first_multiplier;
  int quadrature_degree;
  double size;            ///< edge of the secondary facets [m]: square root of their mean area
  double youngs_modulus;  ///< of the secondary body [Pa]
  double primary_size;    ///< the same of the primary side
  double primary_youngs_modulus;
};

/// A nodal value followed in the history.
struct Probe {
  std::string name, quantity;
  int node;
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
  int n_multipliers = 0;
  /// Of each element, counted over all bodies: where its pressures begin among those of all elements, and at the end their
  /// number. Empty: no element has any.
  std::vector<int> first_pressure;
  std::vector<Probe> probes;
  TimeOptions time;
  TimeScheme scheme;
  SolverOptions solver;
  OutputOptions output;
  CheckpointOptions checkpoints;
  Named<ExpectedOptions> expected;
  double force_floor;  ///< round-off floor of the residual, 1e-14 E h (h + |x|) [N]; E is the bulk modulus where that is greater,
                       ///< E h the stiffness of a spring, EA/h of a string
  double size;         ///< smallest size of an element of a body or string, or length of a spring [m]
  double extent;       ///< greatest reference coordinate [m]

  int n_element_pressures() const { return first_pressure.empty() ? 0 : first_pressure.back(); }
  /// The point that carries pressure `m` of element `e` (see DofSpace).
  int pressure_point(int e, int m) const { return n_nodes(mesh.mesh) + n_multipliers + first_pressure[e] + m; }

  /// Pressure that is round-off [Pa].
  double pressure_floor() const { return force_floor / (size * size); }
};

/// Opens the meshes and resolves every name of the deck.
/// @param warnings lines for the log, e.g. about a secondary side that is coarser than the primary one
/// @throws DeckError, MeshError, FileError
Scene make_scene(const Deck& deck, std::vector<std::string>& warnings);

}  // namespace mortise
