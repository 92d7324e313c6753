#include "assembly/body_term.hpp"

#include "assembly/element_tangent.hpp"

namespace mortise {

BodyTerm::BodyTerm(const Scene& scene, const Body& body, const Partition& partition, const DofSpace& dofs)
    : body_(body), dofs_(dofs) {
  const Mesh& mesh = scene.mesh.mesh;
  const int rank = dofs.comm()->getRank();
  for (int e : body.elements) {
    if (partition.element_rank[e] != rank) continue;
    nodes_.push_back(element_nodes(mesh, e));
    std::array<Point, 8> X;
    for (int a = 0; a < 8; ++a) X[a] = mesh.coordinates[nodes_.back()[a]];
    geometry_.push_back(hex8_geometry(X));
  }
}

void BodyTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const auto& nodes : nodes_) cells.emplace_back(nodes.begin(), nodes.end());
}

void BodyTerm::gather(std::size_t e, const double* q, double q_e[8][3]) const {
  for (int a = 0; a < 8; ++a) {
    const double* q_a = q + dofs_.local(nodes_[e][a]);
    for (int i = 0; i < 3; ++i) q_e[a][i] = q_a[i];
  }
}

bool BodyTerm::add_force(const double* q, double* f) const {
  return std::visit(
      [&](const auto& material) {
        for (std::size_t e = 0; e < nodes_.size(); ++e) {
          double q_e[8][3], f_e[8][3] = {};
          gather(e, q, q_e);
          if (!add_internal_force(material, geometry_[e], q_e, f_e)) return false;
          for (int a = 0; a < 8; ++a)
            for (int i = 0; i < 3; ++i) f[dofs_.local(nodes_[e][a]) + i] += f_e[a][i];
        }
        return true;
      },
      body_.material);
}

bool BodyTerm::add_tangent(const double* q, double* f, SystemMatrix& K) const {
  const bool whole_element = body_.tangent == TangentKind::whole_element;
  return std::visit(
      [&](const auto& material) {
        for (std::size_t e = 0; e < nodes_.size(); ++e) {
          double q_e[8][3], f_e[8][3] = {}, K_e[24 * 24] = {};
          gather(e, q, q_e);
          const bool admissible = whole_element ? whole_element_tangent(material, geometry_[e], q_e, f_e, K_e)
                                                : quadrature_point_tangent(material, geometry_[e], q_e, f_e, K_e);
          if (!admissible) return false;
          for (int a = 0; a < 8; ++a)
            for (int i = 0; i < 3; ++i) f[dofs_.local(nodes_[e][a]) + i] += f_e[a][i];
          K.add(first_cell_ + e, K_e);
        }
        return true;
      },
      body_.material);
}

double BodyTerm::strain_energy(const double* q) const {
  return std::visit(
      [&](const auto& material) {
        double energy = 0;
        for (std::size_t e = 0; e < nodes_.size(); ++e) {
          double q_e[8][3];
          gather(e, q, q_e);
          energy += mortise::strain_energy(material, geometry_[e], q_e);
        }
        return energy;
      },
      body_.material);
}

void BodyTerm::add_nodal_stress(const double* q, std::vector<double>& stress, std::vector<double>& volume) const {
  std::visit(
      [&](const auto& material) {
        for (std::size_t e = 0; e < nodes_.size(); ++e) {
          double q_e[8][3];
          gather(e, q, q_e);
          for (int g = 0; g < Hex8::n_points; ++g) {
            const Tensor3<double> s = cauchy_stress(material, geometry_[e], g, q_e);
            const double components[7] = {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0), von_mises(s)};
            for (int a = 0; a < 8; ++a) {
              const double weight = Hex8::N(a, Hex8::point(g)) * geometry_[e].JxW[g];
              for (int k = 0; k < 7; ++k) stress[7 * static_cast<std::size_t>(nodes_[e][a]) + k] += weight * components[k];
              volume[nodes_[e][a]] += weight;
            }
          }
        }
      },
      body_.material);
}

}  // namespace mortise
