#include "output/element_fields.hpp"

#include <algorithm>

#include "assembly/vectors.hpp"
#include "output/point_fields.hpp"

namespace mortise {
namespace {

int n_points(ElementType type) {
  return with_element(type, [](auto element) { return static_cast<int>(decltype(element)::stiffness_rule.size()); });
}

/// Points of the elements of each block, 0: it belongs to no body.
std::vector<int> points_of_blocks(const Scene& scene) {
  std::vector<char> is_of_a_body(static_cast<std::size_t>(n_elements(scene.mesh.mesh)), 0);
  for (const Body& body : scene.bodies)
    for (int e : body.elements) is_of_a_body[e] = 1;
  std::vector<int> points;
  std::size_t first = 0;
  for (const Block& block : scene.mesh.mesh.blocks) {
    const bool has_values = !block.elements.empty() && is_of_a_body[first];
    points.push_back(has_values ? n_points(block.elements.type()) : 0);
    first += block.elements.size();
  }
  return points;
}

/// What all ranks have, one after the other, on rank 0. Collective.
std::vector<double> gathered_on_root(const Comm& comm, std::vector<double> mine) {
  std::vector<int> counts(comm.getSize(), 0);
  counts[comm.getRank()] = static_cast<int>(mine.size());
  all_reduce(comm, Teuchos::REDUCE_SUM, counts);
  if (comm.getRank() != 0) {
    if (!mine.empty()) Teuchos::send(comm, counts[comm.getRank()], mine.data(), 0);
    return {};
  }
  for (int rank = 1; rank < comm.getSize(); ++rank) {
    if (counts[rank] == 0) continue;
    const std::size_t first = mine.size();
    mine.resize(first + static_cast<std::size_t>(counts[rank]));
    Teuchos::receive(comm, rank, counts[rank], mine.data() + first);
  }
  return mine;
}

}  // namespace

ElementFields::ElementFields(const Scene& scene, std::vector<Field> fields) : fields_(std::move(fields)) {
  const std::vector<int> points = points_of_blocks(scene);
  const int most = points.empty() ? 0 : *std::max_element(points.begin(), points.end());
  for (Field field : fields_) {
    counts_.push_back(suffixes(entry_of(field).shape).size());
    n_components_ += counts_.back();
  }
  for (int g = 0; g < most; ++g)
    for (Field field : fields_)
      for (const std::string& suffix : suffixes(entry_of(field).shape))
        variables_.names.push_back(entry_of(field).variable + suffix + "_" + std::to_string(g + 1));
  for (int n : points)
    for (int g = 0; g < most; ++g) variables_.in_block.insert(variables_.in_block.end(), n_components_, g < n ? 1 : 0);
}

std::vector<std::vector<double>> ElementFields::values(const StepProblem& problem, const State& state) const {
  if (fields_.empty()) return {};
  std::vector<double> mine;  // per point: its element, its number, the components of all fields
  const auto x = problem.to_overlap(*state.x);
  for (const auto& body : problem.bodies())
    body->sample(data(*x), [&](const PointSample& at) {
      mine.push_back(at.element);
      mine.push_back(at.point);
      for (std::size_t f = 0; f < fields_.size(); ++f) {
        const FieldValues values = values_at_point(fields_[f], at.state);
        mine.insert(mine.end(), values.begin(), values.begin() + static_cast<long>(counts_[f]));
      }
    });
  const std::vector<double> all = gathered_on_root(*problem.dofs().comm(), std::move(mine));
  if (problem.dofs().comm()->getRank() != 0) return {};
  const std::size_t n = static_cast<std::size_t>(n_elements(problem.scene().mesh.mesh));
  std::vector<std::vector<double>> variables(variables_.names.size(), std::vector<double>(n, 0.0));
  for (std::size_t k = 0; k < all.size(); k += 2 + n_components_) {
    const auto element = static_cast<std::size_t>(all[k]), first = static_cast<std::size_t>(all[k + 1]) * n_components_;
    for (std::size_t c = 0; c < n_components_; ++c) variables[first + c][element] = all[k + 2 + c];
  }
  return variables;
}

}  // namespace mortise
