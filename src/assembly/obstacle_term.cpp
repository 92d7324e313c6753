#include "assembly/obstacle_term.hpp"

#include <Sacado.hpp>

namespace mortise {

ObstacleTerm::ObstacleTerm(const Scene& scene, const Obstacle& obstacle, const DofSpace& dofs)
    : ContactTerm(obstacle, dofs), mesh_(scene.mesh.mesh), obstacle_(obstacle) {
  for (std::size_t k = 0; k < obstacle.secondary_nodes.size(); ++k) {
    const int node = obstacle.secondary_nodes[k];
    if (dofs.owned(node)) nodes_here_.push_back({k, dofs.local(node), dofs.local(pressure_point(k)), {}, {}, {}, {}});
  }
}

void ObstacleTerm::begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>&) {
  keeps_energy_ = scheme.has_discrete_contact && !is_at_rest;
  if (!keeps_energy_) return;
  for (Node& node : nodes_here_) node.start = {x[node.position], x[node.position + 1], x[node.position + 2]};
}

void ObstacleTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const Node& node : nodes_here_) cells.push_back({obstacle_.secondary_nodes[node.k], pressure_point(node.k)});
}

void ObstacleTerm::integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) {
  using Fad = Sacado::Fad::SFad<double, 3>;
  double *weighted_gap = sums.weighted_gap.getDataNonConst().getRawPtr(),
         *covered = sums.covered_area.getDataNonConst().getRawPtr(), *whole = sums.whole_area.getDataNonConst().getRawPtr();
  for (Node& node : nodes_here_) {
    const double area = obstacle_.tributary_area[node.k], pressure = x[node.pressure];
    Vec3<Fad> q;
    for (int i = 0; i < 3; ++i) q[i] = Fad(3, i, x[node.position + i]);
    std::visit(
        [&](const auto& shape) {
          const Fad gap = shape.gap(q);
          const Vec3<Fad> push = keeps_energy_ ? shape.discrete_gradient(node.start, q) : shape.gradient(q);
          weighted_gap[node.pressure] += area * gap.val();
          for (int i = 0; i < 3; ++i) {
            f[node.position + i] -= area * pressure * push[i].val();
            if (!with_tangent) continue;
            node.push[i] = -area * push[i].val();
            node.gap_slope[i] = area * gap.dx(i);
            for (int j = 0; j < 3; ++j) node.force_slope[i][j] = -area * pressure * push[i].dx(j);
          }
        },
        obstacle_.shape);
    covered[node.pressure] += area;
    whole[node.pressure] += area;
  }
}

void ObstacleTerm::add_tangent(const double* a, const double*, const double*, double force_weight, SystemMatrix& matrix) const {
  for (std::size_t n = 0; n < nodes_here_.size(); ++n) {
    const Node& node = nodes_here_[n];
    double K[16] = {};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) K[4 * i + j] = force_weight * node.force_slope[i][j];
      K[4 * i + 3] = force_weight * node.push[i];
      K[12 + i] = a[node.pressure] * node.gap_slope[i];
    }
    matrix.add(first_cell_ + n, K);
  }
}

void ObstacleTerm::add_force_tangent(double weight, double theta, SystemMatrix& matrix) const {
  for (std::size_t n = 0; n < nodes_here_.size(); ++n) {
    const Node& node = nodes_here_[n];
    double K[16] = {};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) K[4 * i + j] = weight * theta * node.force_slope[i][j];
      K[4 * i + 3] = weight * node.push[i];
    }
    matrix.add(first_cell_ + n, K);
  }
}

// Every rank knows all of them: of nodes that are not here where they were at first.
std::vector<Vec3<double>> ObstacleTerm::normals(const double* x) const {
  std::vector<Vec3<double>> out;
  for (int node : obstacle_.secondary_nodes) {
    const Vec3<double> q = dofs_.local(node) >= 0 ? position(x, node) : vec3(mesh_.coordinates[node]);
    out.push_back(std::visit([&](const auto& shape) { return -1.0 * shape.gradient(q); }, obstacle_.shape));
  }
  return out;
}

}  // namespace mortise
