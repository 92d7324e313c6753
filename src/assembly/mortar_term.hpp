// A mortar contact pair as a term of the scene: search, integration, shares of force, gap and slip, and their derivative.
#pragma once

#include <algorithm>
#include <vector>

#include "assembly/contact_term.hpp"
#include "assembly/held_components.hpp"
#include "assembly/pair_tangent.hpp"
#include "contact/bounding_volume.hpp"

namespace mortise {

/// Work done by a pair since the start, counted so that "absent effects cost nothing" can be checked.
struct ContactCounts {
  long searches = 0;     ///< tree queries for all facets
  long pairs = 0;        ///< facet pairs projected and clipped
  long overlaps = 0;     ///< of these, with an overlap
  long turned_away = 0;  ///< of `pairs`, not facing each other within 80 degrees
};

/// One contact pair on this rank: the secondary facets whose element the rank owns.
class MortarTerm : public ContactTerm {
 public:
  MortarTerm(const ContactPair& pair, const Partition& partition, const DofSpace& dofs);

  /// Lists for each facet the primary facets whose boxes overlap its own, stretched outward along the normal by `farthest`,
  /// inward by `inward` or as far as the secondary surface itself comes back there, and widened by `reach`. @param x positions on
  /// the overlap
  /// @return whether a list changed
  bool search(const double* x, double reach, double inward) override;

  void begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>& held) override;

  /// One cell per facet of this rank: its patch, all listed primary nodes, its pressures.
  void append_cells(std::vector<Cell>& cells) override;

  void integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) override;
  void add_tangent(const double* a, const double* b, const double* c, double force_weight, SystemMatrix& K) const override;
  void add_force_tangent(double weight, double theta, SystemMatrix& K) const override;
  void add_friction_tangent(const FrictionRows& rows, double theta, SystemMatrix& K) const override;

  const ContactPair& pair() const { return pair_; }

  /// Whether supports leave nothing to hold for exact stick at the k-th node along an axis. On all ranks alike.
  bool is_held(std::size_t k, int axis) const { return held_.count({k, axis}) > 0; }
  bool is_held(std::size_t k) const override { return held_along_normal_.count(k) > 0; }
  const ContactCounts& counts() const { return counts_; }
  void resume_counts(const ContactCounts& counts) { counts_ = counts; }

  /// Averaged unit normals of all secondary nodes.
  std::vector<Vec3<double>> normals(const double* x) const override { return normals_of(patches_, x); }

  /// Greatest relative closure error |covered - facet area| / facet area over fully covered facets in the last `integrate`, and
  /// their number.
  std::pair<double, int> closure() const { return {closure_, n_covered_}; }

 private:
  struct Facet {
    int index;                    // in pair_.secondary.facets
    std::array<int, 4> corner;    // positions of its nodes in pair_.secondary_nodes
    std::vector<int> candidates;  // primary facets
    double deepest = 0;           // what lies farther behind the facet is not inside its body but beyond it [m]
    std::vector<int> points;      // patch nodes (its own four first), primary nodes, pressures
    int n_patch = 0, n_primary = 0;
    std::vector<std::array<int, 4>> primary_at;  // per candidate: positions of its nodes among the primary nodes
    // Last tangent over the unknowns of `points`, then 4 rows each of the covered and whole areas, and 12 of weighted slips.
    std::vector<double> matrix;
    // Where friction acts, over the same columns: 12 rows of weighted slips, 4 of covered areas, 12 of nodal normals.
    std::vector<double> slip;
  };
  /// Overlaps with a greater mean gap do not count as covering: neither what lies beyond a step of the surface, nor how far the
  /// search happens to look, may enter the mean gap of a node [m].
  double farthest() const { return std::max(pair_.size, pair_.primary_size); }
  void list_points(Facet& facet);
  double thickness_behind(const BoxTree& own, const double* x, int facet, double most) const;
  Box box_of(const double* x, const std::array<int, 4>& facet) const;
  Vec3<double> normal_of(const double* x, const std::array<int, 4>& facet) const;
  void integrate_facet(Facet& facet, const double* x, bool with_tangent, double* f, NodalSums& sums);
  void chain_normals(Facet& facet, const std::vector<double>& K, int n_local) const;
  template <class Pair>
  void add_pair(Facet& facet, std::size_t candidate, const Pair& pair, bool with_tangent, double* f, NodalSums& sums,
                std::vector<double>& K);
  void store_slip(Facet& facet) const;
  PairFriction friction_of(const Facet& facet, std::size_t candidate, const double* x, const PairInput& input) const;
  int n_own() const { return 4 * pair_.n_unknowns; }  ///< unknowns of contact at the four nodes
  int n_extra() const { return pair_.friction ? 20 : 8; }
  std::size_t n_positions(const Facet& facet) const { return 3 * static_cast<std::size_t>(facet.n_patch + facet.n_primary); }
  std::size_t width(const Facet& facet) const { return n_positions(facet) + n_own(); }

  const ContactPair& pair_;
  const std::vector<TrianglePoint>& rule_;
  std::vector<NodePatch> patches_;  // per secondary node
  std::vector<Facet> facets_;
  std::vector<int> first_facet_;  // per secondary node: the facet of this rank that carries its curvature, -1: none
  std::size_t first_cell_ = 0;
  // state of the last evaluation, per secondary node used on this rank
  std::vector<Vec3<double>> normal_, load_;
  std::vector<std::array<std::vector<Vec3<double>>, 3>> normal_gradient_;  // row i: d n_i / d x of each patch node
  std::vector<std::vector<Vec3<double>>> patch_x_;
  const double* start_ = nullptr;            // positions and tractions at the start of the step, overlap; null between steps
  std::vector<Vec3<double>> start_normal_;   // nodal normals there, where D and M are those of the start
  Components held_;                          // by supports in this step, see `held_components`
  std::set<std::size_t> held_along_normal_;  // nodes
  TimeScheme scheme_;
  ContactCounts counts_;
  double closure_ = 0;
  int n_covered_ = 0;
};

}  // namespace mortise
