#include "assembly/inertia_term.hpp"

#include "assembly/bar_geometry.hpp"
#include "assembly/element_mass.hpp"
#include "assembly/element_place.hpp"

namespace mortise {

InertiaTerm::InertiaTerm(const Scene& scene, const BodyTerm& body_term, const DofSpace& dofs)
    : nodes_(&body_term.body().nodes),
      initial_(&body_term.body().initial),
      mass_of_element_(*body_term.body().density * scene.size * scene.size * scene.size) {
  const Mesh& mesh = scene.mesh.mesh;
  const Body& body = body_term.body();
  std::vector<char> is_contact_node(mesh.coordinates.size(), 0);
  for (const ContactNodes* contact : scene.contacts())
    for (int node : contact->secondary_nodes) is_contact_node[node] = !contact->is_two_sided;
  const auto add_block = [&](const auto& block) {
    using Shape = typename std::decay_t<decltype(block)>::Element;
    for (std::size_t e = 0; e < block.size(); ++e) {
      auto place = place_of(block, e, mesh, dofs);
      const auto M = mass_over_density<Shape>(body.mass_kind, place.X);
      Element element{std::move(place.nodes), std::move(place.local), {}};
      for (double entry : M) element.M.push_back(*body.density * entry);
      if (body.mass_kind == MassKind::redistributed) empty_contact_nodes(element, is_contact_node);
      elements_.push_back(std::move(element));
    }
  };
  for (const auto& block : body_term.blocks()) std::visit(add_block, block);
}

// Mass redistribution (Khenous, Laborde & Renard 2008) element by element, of a diagonal matrix.
void InertiaTerm::empty_contact_nodes(Element& element, const std::vector<char>& is_contact_node) {
  const std::size_t n = element.nodes.size();
  double moved = 0;
  std::vector<std::size_t> others;
  for (std::size_t a = 0; a < n; ++a) {
    if (is_contact_node[element.nodes[a]]) {
      moved += element.M[a * n + a];
    } else {
      others.push_back(a);
    }
  }
  if (others.empty()) return;  // it must be somewhere
  for (std::size_t a = 0; a < n; ++a)
    if (is_contact_node[element.nodes[a]]) element.M[a * n + a] = 0;
  for (std::size_t a : others) element.M[a * n + a] += moved / static_cast<double>(others.size());
}

InertiaTerm::InertiaTerm(const PointMasses& masses, const DofSpace& dofs)
    : nodes_(&masses.nodes), initial_(&masses.initial), mass_of_element_(masses.mass) {
  for (int node : masses.nodes)
    if (dofs.owned(node)) elements_.push_back({{node}, {dofs.local(node)}, {masses.mass}});
}

InertiaTerm::InertiaTerm(const Scene& scene, const String& string, const Partition& partition, const DofSpace& dofs)
    : nodes_(&string.nodes), initial_(&string.initial), mass_of_element_(*string.line_density * string.size) {
  for (int e : string.elements) {
    if (partition.element_rank[e] != dofs.comm()->getRank()) continue;
    const ElementNodeList nodes = element_nodes(scene.mesh.mesh, e);
    const std::size_t n = nodes.size();
    Element element{{nodes.begin(), nodes.end()}, {}, std::vector<double>(n * n, 0.0)};
    for (int node : nodes) element.local.push_back(dofs.local(node));
    for (const PointOfBar& at : points_of_bar(scene.mesh.mesh, nodes, static_cast<int>(n)))
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b) element.M[a * n + b] += *string.line_density * at.length * at.N[a] * at.N[b];
    elements_.push_back(std::move(element));
  }
}

void InertiaTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const Element& e : elements_) cells.push_back(e.nodes);
}

void InertiaTerm::add_force(const double* a, double* f) const {
  for (const Element& e : elements_) {
    const std::size_t n = e.local.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l)
        for (int i = 0; i < 3; ++i) f[e.local[k] + i] += e.M[k * n + l] * a[e.local[l] + i];
  }
}

void InertiaTerm::add_tangent(double da_dq, SystemMatrix& matrix) const {
  std::vector<double> K;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const Element& e = elements_[k];
    const std::size_t n = e.local.size();
    K.assign(9 * n * n, 0.0);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        for (int i = 0; i < 3; ++i) K[(3 * a + i) * 3 * n + 3 * b + i] = da_dq * e.M[a * n + b];
    matrix.add(first_cell_ + k, K.data());
  }
}

double InertiaTerm::kinetic_energy(const double* v) const {
  double energy = 0;
  for (const Element& e : elements_) {
    const std::size_t n = e.local.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l)
        for (int i = 0; i < 3; ++i) energy += 0.5 * e.M[k * n + l] * v[e.local[k] + i] * v[e.local[l] + i];
  }
  return energy;
}

std::array<double, 4> InertiaTerm::mass_and_moment(const double* x) const {
  std::array<double, 4> sum{};
  for (const Element& e : elements_) {
    const std::size_t n = e.local.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) {
        sum[0] += e.M[k * n + l];
        for (int i = 0; i < 3; ++i) sum[1 + i] += e.M[k * n + l] * x[e.local[l] + i];
      }
  }
  return sum;
}

}  // namespace mortise
