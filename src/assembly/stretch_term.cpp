#include "assembly/stretch_term.hpp"

#include <Sacado.hpp>

#include "assembly/bar_geometry.hpp"

namespace mortise {
namespace {

using Fad = Sacado::Fad::SFad<double, 3>;

bool is_admissible(const Vec3<double>& t) {
  const double s = dot(t, t);
  return std::isfinite(s) && s > 0;
}

Vec3<Fad> seeded(const Vec3<double>& t) { return {Fad(3, 0, t[0]), Fad(3, 1, t[1]), Fad(3, 2, t[2])}; }
Vec3<Fad> constant(const Vec3<double>& t) { return {Fad(t[0]), Fad(t[1]), Fad(t[2])}; }

}  // namespace

StretchTerm::StretchTerm(const NodeSpring& spring, const DofSpace& dofs)
    : law_(spring.law), activity_(spring.activity), is_anchored_(!spring.to) {
  if (!dofs.owned(spring.from)) return;
  Line line{nodes_of(spring), {}, {point_of(spring)}};
  for (int node : line.nodes) line.local.push_back(dofs.local(node));
  lines_.push_back(std::move(line));
}

StretchTerm::StretchTerm(const Scene& scene, const String& string, const Partition& partition, const DofSpace& dofs)
    : law_(string.law) {
  for (int e : string.elements) {
    if (partition.element_rank[e] != dofs.comm()->getRank()) continue;
    const ElementNodeList nodes = element_nodes(scene.mesh.mesh, e);
    Line line{{nodes.begin(), nodes.end()}, {}, {}};
    for (int node : nodes) line.local.push_back(dofs.local(node));
    for (const PointOfBar& at : points_of_bar(scene.mesh.mesh, nodes, static_cast<int>(nodes.size()) - 1)) {
      LinePoint point{{}, {}, string.axial_stiffness * at.length};
      for (std::size_t a = 0; a < nodes.size(); ++a) point.slopes.push_back(at.dN_dS[a]);
      line.points.push_back(std::move(point));
    }
    lines_.push_back(std::move(line));
  }
}

void StretchTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const Line& line : lines_) cells.push_back(line.nodes);
}

bool StretchTerm::add_force(const double* x_n, const double* x, double* f) const {
  return with_stretch_law(law_, [&](auto law) {
    for (const Line& line : lines_)
      for (const LinePoint& point : line.points) {
        const Vec3<double> t = point.tangent(line.local, x), t_n = x_n ? point.tangent(line.local, x_n) : t;
        if (!is_admissible(t)) return false;
        const Vec3<double> n = point.energy * tension<decltype(law)>(t_n, t);
        for (std::size_t a = 0; a < line.local.size(); ++a)
          for (int i = 0; i < 3; ++i) f[line.local[a] + i] += point.slopes[a] * n[i];
      }
    return true;
  });
}

bool StretchTerm::add_tangent(const double* x_n, const double* x, double factor, double* f, SystemMatrix& matrix) const {
  return with_stretch_law(law_, [&](auto law) {
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      const Line& line = lines_[l];
      const std::size_t size = line.local.size();
      std::vector<double> K(9 * size * size, 0.0);
      for (const LinePoint& point : line.points) {
        const Vec3<double> t = point.tangent(line.local, x);
        if (!is_admissible(t)) return false;
        const Vec3<Fad> end = seeded(t), n = tension<decltype(law)>(x_n ? constant(point.tangent(line.local, x_n)) : end, end);
        for (std::size_t a = 0; a < size; ++a)
          for (int i = 0; i < 3; ++i) {
            const double force = point.energy * point.slopes[a];
            f[line.local[a] + i] += force * n[i].val();
            for (std::size_t b = 0; b < size; ++b)
              for (int j = 0; j < 3; ++j) K[(3 * a + i) * 3 * size + 3 * b + j] += factor * force * point.slopes[b] * n[i].dx(j);
          }
      }
      matrix.add(first_cell_ + l, K.data());
    }
    return true;
  });
}

double StretchTerm::energy(const double* x) const {
  return with_stretch_law(law_, [&](auto law) {
    double energy = 0;
    for (const Line& line : lines_)
      for (const LinePoint& point : line.points) {
        const Vec3<double> t = point.tangent(line.local, x);
        energy += point.energy * law.energy(dot(t, t));
      }
    return energy;
  });
}

}  // namespace mortise
