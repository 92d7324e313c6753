// The equations of one step: residual and tangent of the whole scene at a trial state.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assembly/augmented_spring_term.hpp"
#include "assembly/damping_term.hpp"
#include "assembly/dead_loads.hpp"
#include "assembly/follower_term.hpp"
#include "assembly/inertia_term.hpp"
#include "assembly/mortar_term.hpp"
#include "assembly/obstacle_term.hpp"
#include "assembly/spring_term.hpp"
#include "assembly/stretch_term.hpp"
#include "assembly/tie_term.hpp"
#include "contact/laws/coulomb.hpp"

namespace mortise {

/// The search whose lists of facet pairs are in force: where the surfaces were, and how far around them it looked.
struct Search {
  RCP<const Vector> x;  ///< owned unknowns at the search; null: there was none
  double reach = 0;     ///< to all sides [m]
  double inward = 0;    ///< beyond that against the normal [m]
};

/// A converged state: positions, pressures and motion at a time, and the search behind it. All that the next step depends on: the
/// lists of facet pairs are part of it because they fix the graph, and with it the round-off of a direct solver.
struct State {
  double time = 0;
  RCP<Vector> x;  ///< owned unknowns: positions [m], pressures [Pa]
  Search search;
  RCP<Vector> v, a;  ///< velocities [m/s] and accelerations [m/s^2] at the rows of positions; null in statics
};

/// A jump of velocities at the end of a step and the impulses of contact behind it [N s]: on the bodies, and the part of them
/// that comes from the ground. On the owned map.
struct VelocityJump {
  RCP<Vector> change, impulse, impulse_of_ground;
};

/// What one evaluation of the equations found. Vectors live on the owned map. Norms and counts are of all ranks.
struct Evaluation {
  bool admissible = false;  ///< det F > 0 everywhere, and friction has a bound; if false nothing but `fault` is of use
  std::string fault;        ///< what a formula of friction misses; empty: nothing
  RCP<Vector>
      residual;  ///< f_inertia + f_int + f_damping + f_contact - f_ext, rows of supports q - (X + u), rows of pressures the law
  RCP<Vector> internal, contact, external;  ///< forces on the rows of nodes [N]; contact with the sign of the residual
  RCP<Vector> damping, inertia;             ///< likewise; null if no body has any
  RCP<Vector> unbalanced;                   ///< the residual before supports and law take their rows: there the reactions [N]
  /// Components that supports hold: each once, with the first support of the deck that acts on it.
  std::shared_ptr<const std::vector<PrescribedDof>> prescribed;
  RCP<Vector> closing_gap;       ///< the gap that the law closes, see `Closing` [m]
  RCP<Vector> gap;               ///< mean gap at the rows of pressures [m]; 0 where nothing is covered
  RCP<Vector> area;              ///< covered area at the rows of pressures [m^2]
  RCP<Vector> compliance;        ///< of the law at partly covered nodes [m/Pa]: closed means gap + compliance p = 0
  double force_residual = 0;     ///< |R| over free positions, and what the multipliers of springs miss as a force [N]
  double force_scale = 0;        ///< max(|f_int|, |f_ext|, |f_contact|, |f_inertia|) [N]
  double force_floor = 0;        ///< round-off of the residual [N]
  double gap_residual = 0;       ///< greatest |gap| of a closed node [m]
  double pressure_residual = 0;  ///< greatest |p| of an open node [Pa]
  double pressure_scale = 0;     ///< greatest |p| of a closed node [Pa]
  /// Greatest part of its volume by which a mixed element misses what its pressure asks for, or |Phi| of an augmented spring
  /// beyond round-off [-].
  double constraint_residual = 0;
  double support_residual = 0;           ///< greatest distance of a supported component from where it should be [m]
  std::vector<char> closed;              ///< per multiplier of the scene: the branch its law took
  std::vector<char> covered;             ///< per multiplier, on the rank that owns it: something lies opposite the node
  std::optional<VelocityJump> jump;      ///< after the step's solution, see `update_velocities`
  std::vector<FrictionStatus> friction;  ///< per multiplier; empty without friction
  int n_stick = 0, n_slip = 0;
  double friction_work = 0;  ///< of the tractions on the slips of the step [J]
  double stick_energy = 0;   ///< in penalised stick at the end of the step [J]
  int n_closed = 0;
  int n_partly_covered = 0;       ///< closed nodes that are not fully covered, where the law yields
  int first_partly_covered = -1;  ///< the first of them, -1: none
};

/// Where and how often work was done; printed with the run and compared in tests.
struct WorkCounts {
  long evaluations = 0, tangents = 0, element_tangents = 0, graphs = 0;
  double seconds_search = 0, seconds_contact = 0, seconds_elements = 0, seconds_assembly = 0;
};

/// Equations of one step,  M a* + C v* + f_int* + f_contact*(p) = f_ext*,  with supports and the contact law at its end. The time
/// scheme says what the stars stand for (physics/time_scheme.hpp); springs are among f_int, damping only in bodies that have it,
/// and inertia only in dynamics.
/// Everything is collective over the ranks of the scene's communicator.
class StepProblem {
 public:
  StepProblem(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm);

  const DofSpace& dofs() const { return dofs_; }
  const Scene& scene() const { return scene_; }

  /// Reference positions, all pressures zero, springs as they are there; owned unknowns.
  RCP<Vector> reference_state() const;

  /// Reference positions, no pressure, except where surfaces touch (|gap| <= 1e-8 h): these start closed (conventions, section
  /// 8), as does what another run left under pressure. Bodies are where, and in dynamics move, as the deck's initial conditions
  /// say; accelerations are 0, still to be found.
  /// @throws MeshError if surfaces penetrate deeper than 1e-8 h
  State initial_state();

  /// Gives augmented springs the squared stretch and the multiplier that belong to the positions in `x` (owned). Collective.
  void settle_springs(Vector& x) const;

  /// The stage in which steps are; the first one until another is entered.
  const Stage& stage() const { return scene_.stages[stage_]; }
  void set_stage(std::size_t stage) { stage_ = stage; }

  /// Makes a stage the one in which steps are, and its start of the state that the stage before has left: motion begins, with the
  /// deck's initial velocities, or stops, and what does not act any more has no pressure. Accelerations are still to be found.
  State enter_stage(std::size_t stage, const State& left);

  /// Begins a step from an accepted state to time `t`: supports, loads and formulas are evaluated there, the search is that of
  /// the state (whatever a rejected attempt or another run left), and from there on surfaces are searched as far as they move, so
  /// that nothing passes through unseen.
  /// @return an empty text; or the message of the formula that gives no finite number, or of two supports that contradict each
  ///         other: there is no such step then. The same on all ranks.
  std::string begin_step(const State& from, double t);
  double time() const { return time_; }

  /// Fills in what follows from the unknowns `to.x` that solve the step begun at `from`: velocities and accelerations.
  void finish_step(const State& from, State& to) const;

  /// Estimate of the error in position that a step made: dt^2 |a_n+1 - a_n| / 12, the greatest of all components [m]; 0 in
  /// statics. For schemes of second order and smooth motion. Collective.
  double local_error(const State& from, const State& to) const;

  /// Whether det F > 0 in all elements where a step has ended: what the residual does not see where the scheme evaluates it
  /// elsewhere. Collective.
  bool is_admissible_at_end(const Vector& x) const;

  /// The mass matrix with the identity in all rows that have no acceleration to find: of supports and pressures. As `linearise`.
  RCP<Matrix> mass_matrix();

  Evaluation evaluate(const Vector& x);

  /// Residual and tangent. The rows of all covered pressures hold the derivative of the mean gap, whichever branch the law took:
  /// the active set chooses (`find_direction`). The matrix belongs to the problem and holds until the next call.
  Evaluation linearise(const Vector& x, RCP<Matrix>& tangent);

  /// Begins the step once more with the pressures of its solution `x`, where an augmented Lagrangian has not closed the gaps far
  /// enough. Collective. @return the greatest |gap| of a closed node over what its contact allows, > 1; nothing: the step stands
  std::optional<double> augment(const Vector& x, const Evaluation& at);

  /// Unknowns whose row is the identity after an evaluation: supported components and uncovered pressures. On the owned map, 1 or
  /// 0.
  const std::vector<char>& identity_rows() const { return identity_rows_; }

  /// Number of times the graph was made; a direct solver repeats its analysis when it changes.
  long graph_number() const { return counts_.graphs; }

  const WorkCounts& counts() const { return counts_; }
  std::size_t matrix_bytes() const { return matrix_ ? matrix_->bytes() : 0; }  ///< on this rank
  /// Goes on counting where another run of the same scene stopped.
  void resume_counts(const WorkCounts& counts, const std::vector<ContactCounts>& of_pairs);
  /// The search now in force; belongs into the state that a step ends in.
  const Search& search() const { return search_; }
  const std::vector<std::unique_ptr<BodyTerm>>& bodies() const { return bodies_; }
  const std::vector<InertiaTerm>& inertias() const { return inertias_; }
  const std::vector<MortarTerm*>& pairs() const { return pairs_; }  ///< those of the contacts that are pairs of surfaces
  const std::vector<std::unique_ptr<ContactTerm>>& contacts() const { return contacts_; }

  /// Strain energy of this rank's elements and of its springs that act now [J].
  double strain_energy(const double* x) const;

  /// Whether springs come or go in the run.
  bool has_temporary_springs() const;

  /// Kinetic energy of all ranks [J] and momenta M v [kg m/s], owned. @param v owned, or null: 0
  double kinetic_energy(const RCP<Vector>& v) const;
  RCP<Vector> momenta(const Vector& v) const;

  /// Mass [kg] and centre of mass [m] of a body at positions `x`, over all ranks. @param term one of `inertias`
  std::pair<double, Vec3<double>> mass_and_centre(const InertiaTerm& term, const Vector& x) const;

  /// Positions and pressures with copies of the other ranks' values.
  RCP<Vector> to_overlap(const Vector& owned) const;

  /// A quantity of every node (3 values) or pressure (1 value) on every rank, from an owned vector: for output. Index as global
  /// unknowns.
  std::vector<double> gather(const Vector& owned) const;

  /// The owned part of a vector over all unknowns that every rank knows: `gather` undone.
  RCP<Vector> scatter(const std::vector<double>& all) const;

  /// Sum of the contact forces of one contact on its secondary surface in this step [N] (the force acts on the body).
  Vec3<double> force_on_secondary(const Vector& x, std::size_t contact);

  /// What pushes from outside through springs to the ground, anchored springs, obstacles and rods in this step; sign of the
  /// residual. Null where the scene has none.
  RCP<Vector> force_from_ground(const Vector& x);

  /// What the pressures of one contact push the bodies with in this step, friction apart [N], and would with their Jacobian at
  /// the end of the step; owned.
  RCP<Vector> push(const Vector& x, std::size_t contact);
  RCP<Vector> push_at_end(const Vector& x, std::size_t contact);

  /// Force of contact pressures in this step, friction apart, with the pressures taken from `pressures` and positions from `x`;
  /// sign of the residual.
  RCP<Vector> contact_force(const Vector& x, const Vector& pressures);

 private:
  Evaluation evaluate(const Vector& x, bool with_tangent);
  void update_search(const Vector& x, const Vector& overlap_x);
  void search_at(const Search& where);
  double greatest_motion(const Vector& from, const Vector& to) const;
  double norm_of_forces(const Vector& f) const;
  void build_graph();
  void refresh_constants();
  void place_bodies(Vector& x) const;
  void add_carried(const std::vector<Vec3<double>>& values, Vector& x) const;
  RCP<Vector> initial_velocities(const Vector& x) const;
  Vec3<double> centre_of_turning(const InertiaTerm& term, const Vector& x) const;
  void move_supports(const State& from, double t, std::string& fault);
  void add_springs(const Vector& overlap_x, Vector& internal);
  RCP<Vector> in_motion(const Combination& combination, const Vector& overlap_x) const;
  RCP<Vector> damping(const Vector& overlap_x);
  RCP<Vector> inertia(const Vector& overlap_x);
  RCP<Vector> external(const Vector& overlap_x, bool with_tangent);
  RCP<Vector> dead(double t, std::string& fault) const;
  RCP<Vector> positions_at(double theta, const RCP<Vector>& overlap_x) const;
  bool add_internal(const Vector& overlap_x, const Vector& at_theta, bool with_tangent, Vector& internal);
  bool add_of_step(const Vector& overlap_x, bool with_tangent, RCP<Vector>& of_step);
  void find_forces_before(double t_before, std::string& fault);
  void find_gaps_before(const Vector& x);
  struct ContactPass {
    double theta, weight;
  };
  std::vector<ContactPass> contact_passes() const;
  double contact_theta() const;
  void add_contact_between(const RCP<Vector>& overlap_x, bool with_tangent, std::size_t first, std::size_t end, NodalSums& sums,
                           Vector& contact);
  double contact_weight_at_end() const;
  RCP<Vector> contact_force_of(const RCP<Vector>& overlap_x, std::size_t first, std::size_t end, bool with_friction);
  double round_off_of_forces() const;
  void put_identity_rows();
  RCP<Vector> owned_sum(const Vector& shares) const;
  /// Factors of the derivatives that make up a pressure's row, on the owned map.
  struct LawRows {
    explicit LawRows(const RCP<const Map>& map) : gap(map), covered(map), whole(map) {}
    Vector gap, covered, whole;
  };
  void law(const Vector& x, const Vector& whole_area, Evaluation& out, LawRows& rows);
  void law_of_two_sided(int row, double tributary_area, double force, Evaluation& out, LawRows& rows);
  void friction_law(const Vector& x, const RCP<Vector>& overlap_x, const Vector& slips, Evaluation& out, FrictionRows& rows);
  void find_normal_stiffness();
  double gap_of_pressure_before(const ContactNodes& nodes, int at) const;
  double complementarity_constant(const ContactNodes& nodes, std::size_t k, double covered_area) const;
  bool acts(const ContactTerm& contact) const { return contact.nodes().activity.acts_at(acting_time_) || dt_ == 0; }
  std::optional<double> start_of_closing(const ContactNodes& nodes, std::size_t k, int at, double pressure) const;

  const Scene& scene_;
  DofSpace dofs_;
  std::vector<std::unique_ptr<BodyTerm>> bodies_;
  std::vector<std::unique_ptr<ContactTerm>> contacts_;
  std::vector<MortarTerm*> pairs_;
  DeadLoads dead_loads_;
  std::vector<FollowerTerm> followers_;
  std::vector<SpringTerm> springs_;
  std::vector<StretchTerm> stretches_;
  std::vector<AugmentedSpringTerm> augmented_springs_;
  std::vector<DampingTerm> dampings_;
  std::vector<InertiaTerm> inertias_;
  std::unique_ptr<SystemMatrix> matrix_;
  RCP<Matrix> tangent_;
  /// What the constant part of the matrix depends on: factors of the scheme, which know the time step, and which springs act.
  struct ConstantPart {
    double theta, damping, inertia;
    std::vector<bool> acting;
    bool operator==(const ConstantPart& other) const {
      return theta == other.theta && damping == other.damping && inertia == other.inertia && acting == other.acting;
    }
  };
  std::optional<ConstantPart> constant_;  // of the matrix; none: it has to be made
  RCP<Vector> start_x_;                   // overlap positions at the start of the step
  Search search_;
  RCP<Vector> search_x_;  // its positions on the overlap
  std::size_t stage_ = 0;
  double time_ = 0, dt_ = 0;  // dt_ 0: no step has begun, nothing moves
  double acting_time_ = 0;    // at which activities are asked: the end of the step; without a step, of the one to come
  TimeScheme scheme_;         // of the step; without a step all is evaluated where it stands
  StepKinematics kinematics_;
  RCP<Vector> start_v_, start_a_;                        // overlap, at the start of the step; null in statics
  RCP<const Vector> internal_before_, external_before_;  // of a mean of forces: those at its start, owned
  std::vector<int> overlap_pressures_;                   // local indices, with the tractions of friction
  std::shared_ptr<const std::vector<PrescribedDof>> acting_ = std::make_shared<std::vector<PrescribedDof>>();
  std::vector<std::pair<int, double>> prescribed_;  // owned local unknown, position at time_
  RCP<Vector> dead_;                                // owned: force of the dead loads at time_
  // Per multiplier, owned by this rank or 0: see complementarity_constant.
  std::vector<double> normal_stiffness_, normal_mass_;  // [N/m], [kg]
  RCP<const Vector> pressure_before_;                   // owned, what augmented Lagrangians start from; null: from nothing
  RCP<Vector> start_gap_, start_area_;  // weighted gaps [m^3] and covered areas [m^2] at the start of the step, where needed
  std::vector<char> identity_rows_;
  /// The row of a constraint that this rank owns, of an element's pressure or a spring's multiplier: what it is measured by, and
  /// what is round-off then.
  struct ConstraintRow {
    int row;
    double scale, floor;
  };
  std::vector<ConstraintRow> constraint_rows_;
  WorkCounts counts_;
};

}  // namespace mortise
