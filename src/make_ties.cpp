#include "make_ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/bounding_volume.hpp"
#include "contact/mortar/auxiliary_plane.hpp"
#include "contact/mortar/planar.hpp"
#include "opposite_surfaces.hpp"

namespace mortise {
namespace {

/// Integrates over what lies opposite each secondary facet in the reference configuration.
class TieSegments {
 public:
  TieSegments(const Mesh& mesh, Tie& tie, double largest_gap)
      : mesh_(mesh), tie_(tie), largest_gap_(largest_gap), rule_(triangle_rule(tie.quadrature_degree)), tree_(boxes()) {
    const auto patches = tie.secondary.patches();
    for (const auto& patch : patches) {
      std::vector<Vec3<double>> positions;
      for (int node : patch.nodes) positions.push_back(position(node));
      normals_.push_back(nodal_normal(patch, positions));
    }
    tie.is_tied.assign(tie.secondary_nodes.size(), 0);
    gaps_.resize(tie.secondary_nodes.size());
    areas_.resize(tie.secondary_nodes.size());
    for (std::size_t k = 0; k < tie.secondary.facets.size(); ++k) integrate(static_cast<int>(k));
  }

  /// Whether the surfaces fit: no gap in the mean at any node, but round-off.
  bool fit() const {
    for (std::size_t k = 0; k < gaps_.size(); ++k)
      if (norm(gaps_[k]) > 1e-10 * tie_.size * areas_[k]) return false;
    return true;
  }

 private:
  Vec3<double> position(int node) const { return vec3(mesh_.coordinates[node]); }

  std::vector<Box> boxes() const {
    std::vector<Box> all(tie_.primary.facets.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      for (int node : tie_.primary.facets[k]) all[k].include(position(node));
    return all;
  }

  std::size_t place(int node) const {
    const auto& nodes = tie_.secondary_nodes;
    return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  }

  void integrate(int index) {
    const auto& nodes = tie_.secondary.facets[index];
    std::array<Vec3<double>, 8> x;
    std::array<Vec3<double>, 4> normal;
    Box box;
    for (int a = 0; a < 4; ++a) {
      x[a] = position(nodes[a]);
      normal[a] = normals_[place(nodes[a])];
      box.include(x[a]);
    }
    box.widen(largest_gap_);
    TieFacet facet{index, {}, {}, {}, {}};
    for (int candidate : tree_.query(box)) add(candidate, normal, x, facet);
    if (facet.primary_nodes.empty()) return;
    for (int a = 0; a < 4; ++a)
      if (facet.area[a] > 0) tie_.is_tied[place(nodes[a])] = 1;
    tie_.facets.push_back(std::move(facet));
  }

  void add(int candidate, const std::array<Vec3<double>, 4>& normal, std::array<Vec3<double>, 8>& x, TieFacet& facet) {
    const auto& nodes = tie_.primary.facets[candidate];
    for (int a = 0; a < 4; ++a) x[4 + a] = position(nodes[a]);
    ++tie_.n_pairs;
    const auto plane = AuxiliaryPlane::project(x, normal);
    const Vec3<double> across = cross(x[6] - x[4], x[7] - x[5]);
    if (!(dot(plane.n, across) < -least_facing * norm(across))) return;
    const auto integrals = planar_integrals(plane.y, rule_);
    double area = 0, gap = 0;
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) {
        area += integrals.D[I][J];
        gap += integrals.M[I][J] * plane.height[4 + J] - integrals.D[I][J] * plane.height[J];
      }
    if (!(area > 0) || std::abs(gap) > largest_gap_ * area) return;
    for (int I = 0; I < 4; ++I) {
      const std::size_t k = place(tie_.secondary.facets[facet.index][I]);
      for (int J = 0; J < 4; ++J) {
        facet.D[I][J] += integrals.D[I][J];
        facet.area[I] += integrals.D[I][J];
        areas_[k] += integrals.D[I][J];
        gaps_[k] = gaps_[k] + integrals.D[I][J] * (x[J] - plane.centre) - integrals.M[I][J] * (x[4 + J] - plane.centre);
      }
    }
    for (int K = 0; K < 4; ++K) {
      auto at = std::find(facet.primary_nodes.begin(), facet.primary_nodes.end(), nodes[K]);
      if (at == facet.primary_nodes.end()) {
        at = facet.primary_nodes.insert(at, nodes[K]);
        facet.M.push_back({});
      }
      for (int I = 0; I < 4; ++I) facet.M[at - facet.primary_nodes.begin()][I] += integrals.M[I][K];
    }
  }

  static constexpr double least_facing = 0.17364817766693033;  // cos 80 degrees: what is turned further away is not opposite

  const Mesh& mesh_;
  Tie& tie_;
  const double largest_gap_;
  const std::vector<TrianglePoint>& rule_;
  const BoxTree tree_;
  std::vector<Vec3<double>> normals_;  // of the secondary nodes
  std::vector<Vec3<double>> gaps_;     // weighted, of the secondary nodes [m^3]
  std::vector<double> areas_;          // covered [m^2]
};

}  // namespace

void make_ties(const DeckNames& names, Scene& scene, std::vector<std::string>& mesh_errors, std::vector<std::string>& warnings) {
  std::set<int> tied_before;
  for (const auto& [name, o] : names.deck().options().ties) {
    Tie tie;
    if (!find_surfaces(names, scene, "ties", name, o.secondary, o.primary, mesh_errors, tie)) continue;
    tie.form = o.form;
    tie.quadrature_degree = o.quadrature_degree;
    tie.activity = o.activity;
    tie.is_two_sided = true;
    tie.n_unknowns = 3;
    const double largest_gap = o.largest_gap.value_or(0.25 * std::max(tie.size, tie.primary_size));
    const TieSegments segments(scene.mesh.mesh, tie, largest_gap);
    if (tie.form == TieForm::automatic) tie.form = segments.fit() ? TieForm::plain : TieForm::frame_invariant;
    for (const Stage& stage : scene.stages)
      if (stage.scheme.has_discrete_contact && tie.form == TieForm::frame_invariant)
        names.error("D19", {"ties", name},
                    "is frame invariant, of which \"energy momentum\" has no discrete gradient yet - take \"energy momentum "
                    "midpoint contact\", or surfaces that fit");
    if (tie.facets.empty()) {
      names.error("D20", {"ties", name},
                  fmt::format("ties nothing: no two facets of these surfaces face each other within \"largest gap\" = {:.6g}",
                              largest_gap));
      continue;
    }
    const auto n_free = std::count(tie.is_tied.begin(), tie.is_tied.end(), 0);
    if (n_free > 0)
      warnings.push_back(fmt::format("ties > {}: {} of {} secondary nodes have nothing opposite within {:.3g} and stay free",
                                     name, n_free, tie.is_tied.size(), largest_gap));
    // Two equal conditions at one node would leave its tractions undetermined: the first tie keeps it (a cross point).
    int n_shared = 0;
    for (std::size_t k = 0; k < tie.is_tied.size(); ++k)
      if (tie.is_tied[k] && !tied_before.insert(tie.secondary_nodes[k]).second) {
        tie.is_tied[k] = 0;
        ++n_shared;
      }
    if (n_shared > 0)
      warnings.push_back(
          fmt::format("ties > {}: {} nodes are tied by an entry before, which alone has a traction there", name, n_shared));
    number_multipliers(scene, tie);
    scene.ties.push_back(std::move(tie));
  }
}

}  // namespace mortise
