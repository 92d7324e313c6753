#include "assembly/damping_term.hpp"

#include "assembly/element_mass.hpp"
#include "assembly/element_place.hpp"

namespace mortise {
DampingTerm::DampingTerm(const Scene& scene, const BodyTerm& body_term, const double* reference, const DofSpace& dofs) {
  const Mesh& mesh = scene.mesh.mesh;
  const Body& body = body_term.body();
  const auto add_block = [&](const auto& block) {
    using Block = std::decay_t<decltype(block)>;
    using Shape = typename Block::Element;
    constexpr std::size_t n = 3 * Shape::n_nodes, n_global = n + Block::n_pressures;
    for (std::size_t e = 0; e < block.size(); ++e) {
      auto place = place_of(block, e, mesh, dofs);
      Element element{std::move(place.nodes), std::move(place.local), std::vector<double>(n * n, 0.0)};
      if (body.rayleigh.stiffness > 0) {
        std::vector<double> r(n_global), K(n_global * n_global);
        constexpr TangentKind kind = TangentKind::quadrature_point;
        block.tangent(kind, best_step(kind), block.law(), e, reference, r.data(), K.data());
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t l = 0; l < n; ++l) element.C[k * n + l] = body.rayleigh.stiffness * K[k * n_global + l];
      }
      if (body.rayleigh.mass > 0) {
        const auto M = mass_over_density<Shape>(body.mass_kind, place.X);
        for (int a = 0; a < Shape::n_nodes; ++a)
          for (int b = 0; b < Shape::n_nodes; ++b)
            for (int i = 0; i < 3; ++i)
              element.C[(3 * a + i) * n + 3 * b + i] += body.rayleigh.mass * *body.density * M[a * Shape::n_nodes + b];
      }
      elements_.push_back(std::move(element));
    }
  };
  for (const auto& block : body_term.blocks()) std::visit(add_block, block);
}

void DampingTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const Element& e : elements_) cells.push_back(e.nodes);
}

void DampingTerm::add_force(const double* v, double* f) const {
  for (const Element& e : elements_) {
    const std::size_t n = 3 * e.local.size();
    for (std::size_t k = 0; k < n; ++k) {
      double force = 0;
      for (std::size_t l = 0; l < n; ++l) force += e.C[k * n + l] * v[e.local[l / 3] + l % 3];
      f[e.local[k / 3] + k % 3] += force;
    }
  }
}

void DampingTerm::add_tangent(double dv_dq, SystemMatrix& matrix) const {
  std::vector<double> K;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    K = elements_[k].C;
    for (double& entry : K) entry *= dv_dq;
    matrix.add(first_cell_ + k, K.data());
  }
}

}  // namespace mortise
