#include "assembly/body_term.hpp"

namespace mortise {

MaterialLaw law_of(const Body& body, TangentKind tangent) {
  const ModuliKind kind = tangent == TangentKind::analytic ? ModuliKind::analytic : ModuliKind::automatic;
  return body.formulation == FormulationKind::mixed ? MaterialLaw::distortional(body.material, kind)
                                                    : MaterialLaw::whole(body.material, kind);
}

BodyTerm::BodyTerm(const Scene& scene, const Body& body, const Partition& partition, const DofSpace& dofs) : body_(body) {
  const Mesh& mesh = scene.mesh.mesh;
  const int rank = dofs.comm()->getRank();
  const MaterialLaw law = law_of(body, body.tangent);
  for (ElementType type : element_types)
    with_formulation(body.formulation, type, [&](auto formulation) {
      ElementBlock<decltype(formulation)> block(law, body.tangent);
      for (int e : body.elements) {
        if (partition.element_rank[e] != rank || element_type(mesh, e) != type) continue;
        const ElementNodeList nodes = element_nodes(mesh, e);
        ElementNodes<typename decltype(formulation)::Element> X;
        for (std::size_t a = 0; a < X.size(); ++a) X[a] = mesh.coordinates[nodes[a]];
        typename decltype(block)::Points points, local;
        std::copy(nodes.begin(), nodes.end(), points.begin());
        for (int m = 0; m < block.n_pressures; ++m) points[X.size() + m] = scene.pressure_point(e, m);
        for (std::size_t k = 0; k < points.size(); ++k) local[k] = dofs.local(points[k]);
        block.append(e, points, local, X);
      }
      if (block.size() > 0) blocks_.emplace_back(std::move(block));
    });
}

void BodyTerm::append_cells(std::vector<Cell>& cells) {
  for (auto& block : blocks_) std::visit([&](auto& b) { b.append_cells(cells); }, block);
}

bool BodyTerm::add_force(const double* x, double* f) const {
  for (const auto& block : blocks_)
    if (!std::visit([&](const auto& b) { return b.add_force(x, f); }, block)) return false;
  return true;
}

bool BodyTerm::add_tangent(const double* x, double factor, double* f, SystemMatrix& K) const {
  for (const auto& block : blocks_)
    if (!std::visit([&](const auto& b) { return b.add_tangent(x, factor, f, K); }, block)) return false;
  return true;
}

bool BodyTerm::add_algorithmic_force(const double* x_n, const double* x, double* f) const {
  for (const auto& block : blocks_)
    if (!std::visit([&](const auto& b) { return b.add_algorithmic_force(x_n, x, f); }, block)) return false;
  return true;
}

bool BodyTerm::add_algorithmic_tangent(const double* x_n, const double* x, double* f, SystemMatrix& K) const {
  for (const auto& block : blocks_)
    if (!std::visit([&](const auto& b) { return b.add_algorithmic_tangent(x_n, x, f, K); }, block)) return false;
  return true;
}

bool BodyTerm::has_constant_tangent() const {
  return body_.formulation == FormulationKind::standard && is_linear(body_.material);
}

double BodyTerm::strain_energy(const double* x) const {
  double energy = 0;
  for (const auto& block : blocks_) energy += std::visit([&](const auto& b) { return b.strain_energy(x); }, block);
  return energy;
}

void BodyTerm::sample(const double* x, const std::function<void(const PointSample&)>& take) const {
  for (const auto& block : blocks_) std::visit([&](const auto& b) { b.sample(x, take); }, block);
}

std::size_t BodyTerm::n_elements() const {
  std::size_t n = 0;
  for (const auto& block : blocks_) n += std::visit([](const auto& b) { return b.size(); }, block);
  return n;
}

std::size_t BodyTerm::bytes() const {
  std::size_t n = 0;
  for (const auto& block : blocks_) n += std::visit([](const auto& b) { return b.size() * b.bytes_per_element(); }, block);
  return n;
}

}  // namespace mortise
