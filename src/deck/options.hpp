// What a deck says, as plain structs: filled once by the reader, constant afterwards, free of strings that need looking up.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assembly/tangent_kind.hpp"
#include "contact/mortar/readings.hpp"
#include "deck/damping_options.hpp"
#include "deck/discrete_options.hpp"
#include "deck/friction_options.hpp"
#include "deck/initial_options.hpp"
#include "deck/load_options.hpp"
#include "deck/material_options.hpp"
#include "deck/obstacle_options.hpp"
#include "deck/scheme_options.hpp"
#include "deck/support_options.hpp"
#include "mesh/recipes/recipes.hpp"

namespace mortise {

/// Entries that the user names, in the order of the deck.
template <class Options>
using Named = std::vector<std::pair<std::string, Options>>;

/// One mesh: a file or a recipe, and where it is placed.
struct MeshOptions {
  std::optional<std::string> file;    ///< path relative to the deck
  std::optional<std::string> sha256;  ///< of the file, in lower case; compared before the file is opened
  std::optional<Recipe> recipe;
  ElementType element_type = ElementType::hex8;  ///< of a recipe's mesh
  std::array<double, 3> origin{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 1, 0};  ///< axis x, y, z and degrees; applied before origin
};

/// Plane strain: no motion in z.
enum class Kinematics { three_dimensional, plane_strain };

/// How an element's unknowns make its deformation gradients.
enum class FormulationKind { standard, f_bar, enhanced, mixed };

/// A body: some blocks of a mesh, their material and how their elements are linearised.
struct BodyOptions {
  std::string mesh;
  std::vector<std::string> blocks;  ///< names or numbers; empty: all
  std::string material;
  FormulationKind formulation = FormulationKind::standard;
  TangentKind tangent = TangentKind::quadrature_point;
  Kinematics kinematics = Kinematics::three_dimensional;
  MassKind mass = MassKind::consistent;
  RayleighOptions rayleigh;
};

enum class ContactMethod { mortar };

/// How gaps are kept closed.
enum class Enforcement {
  multipliers,          ///< exactly, by pressures that are unknowns
  penalty,              ///< by springs: pressure = penalty x penetration
  augmented_lagrangian  ///< by springs that start from the pressure found before, again and again (Uzawa)
};

/// Which function says in one equation that gap and pressure are not negative and one of them is 0.
enum class Complementarity { minimum, fischer_burmeister };

struct ContactOptions {
  std::string secondary;
  std::string primary;
  ContactMethod method = ContactMethod::mortar;
  ContactForce force = ContactForce::thesis;
  bool has_frozen_integrals = false;
  int quadrature_degree = 5;  ///< of the rule on each triangle of a segment
  Enforcement enforcement = Enforcement::multipliers;
  std::optional<double> normal_penalty;
  std::optional<double> largest_penetration;
  Complementarity function = Complementarity::minimum;
  Closing closing = Closing::position;
  FrictionOptions friction;
  Activity activity;
};

/// What of the gap between tied surfaces stays as it was.
enum class TieForm {
  automatic,        ///< plain where the surfaces fit, so that there is no gap to turn; else frame invariant
  frame_invariant,  ///< the gap seen from the secondary facet, which turns with it (thesis eq. 4.98)
  plain             ///< the gap in space (thesis eq. 4.97)
};

/// One entry of `ties`: two surfaces that stay together.
struct TieOptions {
  std::string secondary, primary;
  TieForm form = TieForm::automatic;
  int quadrature_degree = 5;
  std::optional<double> largest_gap;  ///< default: a quarter of the greater facet size
  Activity activity;
};

/// Where Newton's method starts in a step.
enum class FirstGuess {
  old_state,
  motion,  ///< q_n + dt v_n + dt^2/2 a_n (thesis eqs. 5.65-5.67)
  linear   ///< one linear solve with the forces linearised at the old state (5.68)
};

struct TimeOptions {
  SchemeKind scheme;
  FirstGuess first_guess = FirstGuess::old_state;
  double end = 0;
  double step = 0;
  std::optional<double> largest_step;     ///< default: `step`
  std::optional<double> smallest_step;    ///< default: step / 1024
  double growth = 1.5;                    ///< factor after an easy step
  int easy_iterations = 8;                ///< a step with at most that many Newton iterations is easy
  std::optional<double> error_tolerance;  ///< of positions, local to a step; none: steps are not sized by errors
  std::optional<double> touch_step;       ///< step in which contact may close where there was none
  std::vector<double> stops;              ///< times that a step must hit
};

/// A part of a run with a scheme and steps of its own; its times are those of the run.
struct StageOptions : TimeOptions {
  std::vector<std::string> without;  ///< what does not act in it: "list/name"
};

enum class LinearSolverKind { automatic, direct, iterative };

struct SolverOptions {
  LinearSolverKind linear = LinearSolverKind::automatic;
  double tolerance = 1e-10;         ///< of the residual, relative to the force scale
  int largest_iterations = 25;      ///< Newton iterations before a step is cut
  int further_iterations = 0;       ///< Newton iterations after convergence (comparisons between rank counts use 1)
  double linear_tolerance = 1e-10;  ///< GMRES: relative residual
  int linear_iterations = 1000;     ///< GMRES: most iterations
  int fill_level = 0;               ///< RILUK level of fill of the bodies
};

struct OutputOptions {
  std::vector<std::string> fields{"displacement", "von mises"};  ///< at nodes
  std::vector<std::string> element_fields;                       ///< at quadrature points
  int every = 1;                                                 ///< Exodus frames: every n-th accepted step, and every stop
  std::vector<double> times;                                     ///< and the first step that ends at or after each of these
};

/// When a checkpoint is written; one always is where a run begins and where it stops.
struct CheckpointOptions {
  int every = 1;        ///< after every n-th accepted step; 0: never in between
  double seconds = 10;  ///< of the clock at least between two
};

/// A nodal quantity followed in history.csv.
struct ProbeOptions {
  std::string quantity;  ///< e.g. "displacement_x"
  std::string mesh;
  std::optional<int> node;                       ///< the user's number
  std::optional<std::array<double, 3>> nearest;  ///< reference position
};

/// A value that the run must meet.
struct ExpectedOptions {
  std::string quantity;  ///< a column of history.csv
  std::optional<double> at_time;
  std::optional<double> mean_from;
  double value = 0;
  double tolerance = 0;
  std::string source;
};

/// Piecewise linear function of one variable, used in formulas as name(t).
struct TableOptions {
  std::vector<double> arguments;
  std::vector<double> values;
};

struct UnitOptions {
  std::string length, force, time;  ///< labels only
};

/// Everything a deck says.
struct DeckOptions {
  std::string title;
  UnitOptions units;
  Named<MeshOptions> meshes;
  Named<MaterialOptions> materials;
  Named<BodyOptions> bodies;
  Named<MassOptions> masses;
  Named<StringOptions> strings;
  Named<TableOptions> tables;
  Named<SupportOptions> supports;
  Named<SpringOptions> springs;
  Named<LoadOptions> loads;
  Named<ContactOptions> contact;
  Named<TieOptions> ties;
  Named<ObstacleOptions> obstacles;
  Named<RodOptions> rods;
  Named<InitialOptions> initial_conditions;  ///< by body, masses or string
  TimeOptions time;                          ///< of the only stage, where there are no `stages`
  Named<StageOptions> stages;
  SolverOptions solver;
  OutputOptions output;
  CheckpointOptions checkpoints;
  Named<ProbeOptions> probes;
  Named<ExpectedOptions> expected;
};

}  // namespace mortise
