#include "assembly/spring_term.hpp"

#include "physics/surface_load.hpp"

namespace mortise {

SpringTerm::SpringTerm(const Scene& scene, const Spring& spring, const Partition& partition, const DofSpace& dofs)
    : mesh_(scene.mesh.mesh), spring_(spring) {
  for (const LocalSide& side : owned_sides(mesh_, spring.sides, partition, dofs))
    with_side(static_cast<int>(side.nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      const auto S = side_mass_matrix<Kind>(reference_positions<Kind>(mesh_, side));
      elements_.push_back({side.nodes, side.local, {S.begin(), S.end()}});
    });
  if (spring.sides.empty())
    for (int node : spring.nodes)
      if (dofs.owned(node)) elements_.push_back({{node}, {dofs.local(node)}, {1.0}});
}

void SpringTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const Element& e : elements_) cells.push_back(e.nodes);
}

void SpringTerm::add_force(const double* x, double* f) const {
  for (const Element& e : elements_)
    for (std::size_t a = 0; a < e.nodes.size(); ++a)
      for (std::size_t b = 0; b < e.nodes.size(); ++b)
        for (int i = 0; i < 3; ++i)
          f[e.local[a] + i] +=
              spring_.stiffness[i] * e.S[a * e.nodes.size() + b] * (x[e.local[b] + i] - mesh_.coordinates[e.nodes[b]][i]);
}

void SpringTerm::add_stiffness(double factor, SystemMatrix& matrix) const {
  std::vector<double> K;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const std::size_t n = elements_[k].nodes.size();
    K.assign(9 * n * n, 0.0);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        for (int i = 0; i < 3; ++i)
          K[(3 * a + i) * 3 * n + 3 * b + i] = factor * spring_.stiffness[i] * elements_[k].S[a * n + b];
    matrix.add(first_cell_ + k, K.data());
  }
}

double SpringTerm::energy(const double* x) const {
  double energy = 0;
  for (const Element& e : elements_)
    for (std::size_t a = 0; a < e.nodes.size(); ++a)
      for (std::size_t b = 0; b < e.nodes.size(); ++b)
        for (int i = 0; i < 3; ++i)
          energy += 0.5 * spring_.stiffness[i] * e.S[a * e.nodes.size() + b] *
                    (x[e.local[a] + i] - mesh_.coordinates[e.nodes[a]][i]) *
                    (x[e.local[b] + i] - mesh_.coordinates[e.nodes[b]][i]);
  return energy;
}

}  // namespace mortise
