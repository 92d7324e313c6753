#include "assembly/follower_term.hpp"

#include "assembly/follower_side.hpp"

namespace mortise {
namespace {

template <class Kind>
std::array<double, 3 * Kind::n_nodes> positions(const LocalSide& side, const double* x) {
  std::array<double, 3 * Kind::n_nodes> y;
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = x[side.local[k / 3] + k % 3];
  return y;
}

}  // namespace

FollowerTerm::FollowerTerm(const Scene& scene, const Load& load, const Partition& partition, const DofSpace& dofs)
    : mesh_(scene.mesh.mesh), load_(load) {
  sides_ = owned_sides(mesh_, load.sides(), partition, dofs);
  for (const LocalSide& side : sides_)
    with_side(static_cast<int>(side.nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      double area = 0;
      for (double weight : side_weights<Kind>(reference_positions<Kind>(mesh_, side))) area += weight;
      sizes_.push_back(std::sqrt(area));
    });
}

void FollowerTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const LocalSide& side : sides_) cells.push_back(side.nodes);
}

void FollowerTerm::set_time(double step_end, double t, std::string& fault) {
  values_.clear();
  first_value_.clear();
  if (!load_.activity.acts_at(step_end)) return;
  const auto* traction = std::get_if<forces::SideTraction>(&load_.what);
  const auto* pressure = std::get_if<forces::SidePressure>(&load_.what);
  for (const LocalSide& side : sides_) {
    first_value_.push_back(values_.size());
    with_side(static_cast<int>(side.nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      const auto X = reference_positions<Kind>(mesh_, side);
      for (const auto& point : Kind::rule) {
        const Point at = point_of_side<Kind>(X, point.xi);
        values_.push_back(traction ? evaluate(traction->traction, t, at, fault)
                                   : Vec3<double>{evaluate(pressure->pressure, t, at, fault), 0, 0});
      }
    });
  }
}

SideLoad FollowerTerm::load_of(std::size_t side) const {
  return {std::holds_alternative<forces::SidePressure>(load_.what), &values_[first_value_[side]]};
}

void FollowerTerm::add_force(const double* x, double* f) const {
  if (values_.empty()) return;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    with_side(static_cast<int>(sides_[s].nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      const auto y = positions<Kind>(sides_[s], x);
      double r[3 * Kind::n_nodes] = {};
      FollowerSide<Kind>::add_residual(load_of(s), {}, y.data(), r);
      for (double& component : r) component = -component;
      scatter(sides_[s].local, r, f);
    });
}

void FollowerTerm::add_tangent(const double* x, double factor, double* f, SystemMatrix& matrix) const {
  if (values_.empty()) return;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    with_side(static_cast<int>(sides_[s].nodes.size()), [&](auto kind) {
      constexpr int n = 3 * decltype(kind)::n_nodes;
      double r[n], K[n * n];
      tangent(TangentKind::whole_element, 0, s, x, r, K);
      for (double& component : r) component = -component;
      scatter(sides_[s].local, r, f);
      for (double& entry : K) entry *= factor;
      matrix.add(first_cell_ + s, K);
    });
}

bool FollowerTerm::tangent(TangentKind way, double relative_step, std::size_t side, const double* x, double* r, double* K) const {
  bool is_found = true;
  with_side(static_cast<int>(sides_[side].nodes.size()), [&](auto kind) {
    using Kind = decltype(kind);
    constexpr int n = 3 * Kind::n_nodes;
    std::fill_n(r, n, 0.0);
    std::fill_n(K, n * n, 0.0);
    if (values_.empty()) return;
    double scale[n];
    std::fill_n(scale, n, size(side));
    is_found = element_tangent<FollowerSide<Kind>>(way, relative_step, load_of(side), FollowerSide<Kind>{},
                                                   positions<Kind>(sides_[side], x).data(), scale, r, K);
  });
  return is_found;
}

}  // namespace mortise
