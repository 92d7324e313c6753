#include "assembly/dof_space.hpp"

#include <algorithm>

namespace mortise {

DofSpace::DofSpace(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm) {
  const Mesh& mesh = scene.mesh.mesh;
  n_nodes_ = mortise::n_nodes(mesh);
  const int rank = comm->getRank();
  const int n_points = n_nodes_ + scene.n_multipliers + scene.n_element_pressures() + scene.n_augmented_springs;
  std::vector<int> sizes(n_points, 1);
  std::fill_n(sizes.begin(), n_nodes_, 3);
  for (const ContactNodes* contact : scene.contacts())
    std::fill_n(sizes.begin() + n_nodes_ + contact->first_multiplier, contact->secondary_nodes.size(), contact->n_unknowns);
  std::fill(sizes.begin() + scene.spring_point(0), sizes.end(), 2);
  first_.assign(1, 0);
  for (int size : sizes) first_.push_back(first_.back() + size);
  std::vector<char> needed(n_points, 0), mine(n_points, 0);
  for (int n = 0; n < n_nodes_; ++n) mine[n] = partition.node_rank[n] == rank;
  for (int e = 0; e < n_elements(mesh); ++e)
    if (partition.element_rank[e] == rank)
      for (int n : element_nodes(mesh, e)) needed[n] = 1;
  for (const ContactNodes* contact : scene.contacts())
    for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k)
      mine[n_nodes_ + contact->first_multiplier + k] = mine[contact->secondary_nodes[k]];
  for (const auto& spring : scene.node_springs)
    if (spring.to && mine[spring.from]) needed[*spring.to] = 1;
  const auto need = [&](const OppositeSurfaces& pair) {
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k)
      needed[pair.secondary_nodes[k]] = needed[n_nodes_ + pair.first_multiplier + k] = 1;
    for (int node : pair.primary.nodes()) needed[node] = 1;
  };
  std::for_each(scene.pairs.begin(), scene.pairs.end(), need);
  std::for_each(scene.ties.begin(), scene.ties.end(), need);

  if (!scene.first_pressure.empty())
    for (int e = 0; e < n_elements(mesh); ++e)
      for (int m = 0; m < scene.first_pressure[e + 1] - scene.first_pressure[e]; ++m)
        mine[scene.pressure_point(e, m)] = partition.element_rank[e] == rank;

  for (const auto& spring : scene.node_springs)
    if (spring.augmented) mine[scene.spring_point(*spring.augmented)] = mine[spring.from];

  local_.assign(n_points, -1);
  std::vector<GlobalIndex> dofs;
  const auto append = [&](int point) {
    local_[point] = static_cast<int>(dofs.size());
    overlap_points_.push_back(point);
    for (int i = 0; i < size(point); ++i) dofs.push_back(global(point) + i);
  };
  for (int p = 0; p < n_points; ++p) {
    if (mine[p]) append(p);
    if (p < n_nodes_) n_owned_positions_ = static_cast<int>(dofs.size());
  }
  n_owned_ = static_cast<int>(dofs.size());
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  owned_map_ = Teuchos::rcp(new Map(invalid, Teuchos::ArrayView<const GlobalIndex>(dofs.data(), n_owned_), 0, comm));
  for (int p = 0; p < n_points; ++p)
    if (needed[p] && !mine[p]) append(p);
  overlap_map_ = Teuchos::rcp(new Map(invalid, Teuchos::ArrayView<const GlobalIndex>(dofs.data(), dofs.size()), 0, comm));
  importer_ = Teuchos::rcp(new Import(owned_map_, overlap_map_));
}

std::size_t DofSpace::ghost_bytes() const { return sizeof(double) * (overlap_map_->getNodeNumElements() - n_owned_); }

}  // namespace mortise
