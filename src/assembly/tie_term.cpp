#include "assembly/tie_term.hpp"

#include <Sacado.hpp>
#include <algorithm>

#include "assembly/vectors.hpp"
#include "contact/mortar/facet_frame.hpp"

namespace mortise {
namespace {

/// Rotation of a facet with its first and second derivatives by the 12 coordinates of its nodes.
using Once = Sacado::Fad::SFad<double, 12>;
using Twice = Sacado::Fad::SFad<Once, 12>;

Tensor3<Twice> rotation_with_slopes(const std::vector<Vec3<double>>& x, const Tensor3<double>& frame) {
  std::array<Vec3<Twice>, 4> seeded;
  for (int k = 0; k < 12; ++k) seeded[k / 3][k % 3] = Twice(12, k, Once(12, k, x[k / 3][k % 3]));
  return facet_rotation(seeded, frame);
}

std::array<Vec3<double>, 4> first_four(const std::vector<Vec3<double>>& x) { return {x[0], x[1], x[2], x[3]}; }

}  // namespace

TieTerm::TieTerm(const Scene& scene, const Tie& tie, const Partition& partition, const DofSpace& dofs)
    : ContactTerm(tie, dofs), tie_(tie), patches_(tie.secondary.patches()) {
  const auto& nodes = tie.secondary_nodes;
  for (const TieFacet& of : tie.facets) {
    if (partition.element_rank[tie.secondary_elements[of.index]] != dofs.comm()->getRank()) continue;
    const auto& corners = tie.secondary.facets[of.index];
    Facet facet{&of, {}, {corners.begin(), corners.end()}, {}, {}, {}, {}};
    facet.points.insert(facet.points.end(), of.primary_nodes.begin(), of.primary_nodes.end());
    std::vector<Vec3<double>> X;
    const Vec3<double> origin = vec3(scene.mesh.mesh.coordinates[corners[0]]);
    for (int node : facet.points) X.push_back(vec3(scene.mesh.mesh.coordinates[node]) - origin);
    facet.frame = facet_frame(first_four(X));
    facet.gap = gaps(facet, X);
    for (int a = 0; a < 4; ++a) {
      facet.corner[a] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), corners[a]) - nodes.begin());
      facet.points.push_back(pressure_point(facet.corner[a]));
    }
    facets_.push_back(std::move(facet));
  }
  begin_step(nullptr, true, {}, {});
}

void TieTerm::begin_step(const double*, bool, const TimeScheme&, const std::vector<PrescribedDof>& held) {
  left_out_ = held_components(patches_, tie_.primary.nodes(), held);
  for (std::size_t k = 0; k < patches_.size(); ++k)
    for (int i = 0; i < 3 && !tie_.is_tied[k]; ++i) left_out_.insert({k, i});
  for (Facet& facet : facets_)
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i)
        facet.area[a][i] = left_out_.count({static_cast<std::size_t>(facet.corner[a]), i}) > 0 ? 0 : facet.of->area[a];
}

void TieTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const auto& facet : facets_) cells.push_back(facet.points);
}

/// Positions of a facet's nodes and of the primary ones relative to its first node: far from the origin no digits are lost.
std::vector<Vec3<double>> TieTerm::positions(const Facet& facet, const double* x) const {
  std::vector<Vec3<double>> all;
  const Vec3<double> origin = position(x, facet.points[0]);
  for (std::size_t a = 0; a + 4 < facet.points.size(); ++a) all.push_back(position(x, facet.points[a]) - origin);
  return all;
}

std::array<Vec3<double>, 4> TieTerm::gaps(const Facet& facet, const std::vector<Vec3<double>>& x) const {
  std::array<Vec3<double>, 4> g{};
  for (int I = 0; I < 4; ++I) {
    for (int J = 0; J < 4; ++J) g[I] = g[I] + facet.of->D[I][J] * x[J];
    for (std::size_t K = 0; K < facet.of->M.size(); ++K) g[I] = g[I] - facet.of->M[K][I] * x[4 + K];
  }
  return g;
}

void TieTerm::integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) {
  double *weighted_gap = data(sums.weighted_gap), *covered = data(sums.covered_area), *whole = data(sums.whole_area);
  for (Facet& facet : facets_) {
    const auto q = positions(facet, x);
    const auto g = gaps(facet, q);
    const std::size_t n = width(facet), first_traction = n_positions(facet), n_nodes = q.size();
    if (with_tangent) facet.matrix.assign(n * n, 0.0);
    Tensor3<double> R = identity<double>();
    std::array<Tensor3<double>, 12> slope{};  // of R, by each coordinate of the facet's nodes
    const auto weight = [&](std::size_t a, int I) { return a < 4 ? facet.of->D[I][a] : -facet.of->M[a - 4][I]; };
    Tensor3<double> load{};  // sum_I g_I (x) traction_I: conjugate to R
    std::array<Vec3<double>, 4> traction;
    for (int I = 0; I < 4; ++I) {
      const int at = dofs_.local(facet.points[n_nodes + I]);
      traction[I] = {x[at], x[at + 1], x[at + 2]};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) load(i, j) += g[I][i] * traction[I][j];
    }
    if (tie_.form == TieForm::frame_invariant) {
      const auto with_slopes = rotation_with_slopes(q, facet.frame);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const Twice& entry = with_slopes(i, j);
          R(i, j) = entry.val().val();
          for (int k = 0; k < 12; ++k) {
            slope[k](i, j) = entry.dx(k).val();
            for (int l = 0; l < 12 && with_tangent; ++l) facet.matrix[k * n + l] += load(i, j) * entry.dx(k).dx(l);
          }
        }
      for (int k = 0; k < 12; ++k) f[dofs_.local(facet.points[k / 3]) + k % 3] += double_dot(load, slope[k]);
    }
    for (int I = 0; I < 4; ++I) {
      const int at = dofs_.local(facet.points[n_nodes + I]);
      Vec3<double> turned{};  // R traction_I
      for (int i = 0; i < 3; ++i) turned[i] = R(i, 0) * traction[I][0] + R(i, 1) * traction[I][1] + R(i, 2) * traction[I][2];
      for (std::size_t a = 0; a < n_nodes; ++a)
        for (int i = 0; i < 3; ++i) f[dofs_.local(facet.points[a]) + i] += weight(a, I) * turned[i];
      for (int j = 0; j < 3; ++j) {
        weighted_gap[at + j] += R(0, j) * g[I][0] + R(1, j) * g[I][1] + R(2, j) * g[I][2] - facet.gap[I][j];
        covered[at + j] += facet.area[I][j];
        whole[at + j] += facet.area[I][j];
      }
      if (!with_tangent) continue;
      // All is the second derivative of one function: rows and columns are filled together.
      const auto add = [&](std::size_t row, std::size_t column, double entry) {
        facet.matrix[row * n + column] += entry;
        facet.matrix[column * n + row] += entry;
      };
      for (int j = 0; j < 3; ++j) {
        const std::size_t row = first_traction + 3 * I + j;
        for (std::size_t a = 0; a < n_nodes; ++a)
          for (int i = 0; i < 3; ++i) add(row, 3 * a + i, weight(a, I) * R(i, j));
        for (int k = 0; k < 12 && tie_.form == TieForm::frame_invariant; ++k)
          add(row, k, slope[k](0, j) * g[I][0] + slope[k](1, j) * g[I][1] + slope[k](2, j) * g[I][2]);
      }
      for (int k = 0; k < 12 && tie_.form == TieForm::frame_invariant; ++k)
        for (std::size_t a = 0; a < n_nodes; ++a)
          for (int i = 0; i < 3; ++i)
            add(k, 3 * a + i,
                weight(a, I) *
                    (slope[k](i, 0) * traction[I][0] + slope[k](i, 1) * traction[I][1] + slope[k](i, 2) * traction[I][2]));
    }
  }
}

/// The last tangent with the rows of forces times `weight`, their columns of positions times `theta` too; those of tractions 0.
void TieTerm::add_scaled(const Facet& facet, std::vector<double>& scaled, double weight, double theta) const {
  const std::size_t n = width(facet), n_positions = this->n_positions(facet);
  scaled.assign(n * n, 0.0);
  for (std::size_t r = 0; r < n_positions; ++r)
    for (std::size_t c = 0; c < n; ++c) scaled[r * n + c] = weight * (c < n_positions ? theta : 1.0) * facet.matrix[r * n + c];
}

void TieTerm::add_tangent(const double* a, const double*, const double*, double force_weight, SystemMatrix& K) const {
  std::vector<double> scaled;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const Facet& facet = facets_[k];
    const std::size_t n = width(facet), first = n_positions(facet);
    add_scaled(facet, scaled, force_weight, 1.0);
    for (int I = 0; I < 4; ++I) {
      const int at = dofs_.local(facet.points[first / 3 + I]);
      for (int j = 0; j < 3; ++j)
        for (std::size_t c = 0; c < n; ++c)
          scaled[(first + 3 * I + j) * n + c] = a[at + j] * facet.matrix[(first + 3 * I + j) * n + c];
    }
    K.add(first_cell_ + k, scaled.data());
  }
}

void TieTerm::add_force_tangent(double weight, double theta, SystemMatrix& K) const {
  std::vector<double> scaled;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    add_scaled(facets_[k], scaled, weight, theta);
    K.add(first_cell_ + k, scaled.data());
  }
}

std::vector<Vec3<double>> TieTerm::normals(const double* x) const { return normals_of(patches_, x); }

}  // namespace mortise
