#include "assembly/follower_term.hpp"

#include <Sacado.hpp>
#include <algorithm>

#include "physics/surface_load.hpp"

namespace mortise {

FollowerTerm::FollowerTerm(const Scene& scene, const Load& load, const Partition& partition, const DofSpace& dofs)
    : mesh_(scene.mesh.mesh), load_(load) {
  const auto* traction = std::get_if<forces::SideTraction>(&load.what);
  const auto& sides = traction ? traction->sides : std::get<forces::SidePressure>(load.what).sides;
  sides_ = owned_sides(mesh_, sides, partition, dofs);
}

void FollowerTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const LocalSide& side : sides_) cells.push_back(side.nodes);
}

void FollowerTerm::set_time(double t, std::string& fault) {
  values_.clear();
  first_value_.clear();
  if (!load_.activity.acts_at(t)) return;
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

template <class Kind, class T>
void FollowerTerm::add_side_force(const std::array<std::array<T, 3>, Kind::n_nodes>& x, std::size_t side, T* f) const {
  const Vec3<double>* values = &values_[first_value_[side]];
  if (std::holds_alternative<forces::SidePressure>(load_.what)) {
    AtSidePoints<Kind, double> pressure;
    for (std::size_t g = 0; g < pressure.size(); ++g) pressure[g] = values[g][0];
    add_pressure_force<Kind>(x, pressure, f);
  } else {
    AtSidePoints<Kind, Vec3<double>> traction;
    std::copy_n(values, traction.size(), traction.begin());
    add_traction_force<Kind>(x, traction, f);
  }
}

void FollowerTerm::add_force(const double* x, double* f) const {
  if (values_.empty()) return;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    with_side(static_cast<int>(sides_[s].nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      std::array<std::array<double, 3>, Kind::n_nodes> positions;
      for (std::size_t a = 0; a < positions.size(); ++a)
        for (int i = 0; i < 3; ++i) positions[a][i] = x[sides_[s].local[a] + i];
      double force[3 * Kind::n_nodes] = {};
      add_side_force<Kind>(positions, s, force);
      scatter(sides_[s].local, force, f);
    });
}

void FollowerTerm::add_tangent(const double* x, double* f, SystemMatrix& matrix) const {
  if (values_.empty()) return;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    with_side(static_cast<int>(sides_[s].nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      constexpr int n = 3 * Kind::n_nodes;
      using Fad = Sacado::Fad::SFad<double, n>;
      std::array<std::array<Fad, 3>, Kind::n_nodes> positions;
      for (int k = 0; k < n; ++k) positions[k / 3][k % 3] = Fad(n, k, x[sides_[s].local[k / 3] + k % 3]);
      Fad force_ad[n];
      for (Fad& component : force_ad) component = 0.0;
      add_side_force<Kind>(positions, s, force_ad);
      double force[n], K[n * n];
      for (int k = 0; k < n; ++k) {
        force[k] = force_ad[k].val();
        for (int l = 0; l < n; ++l) K[k * n + l] = -force_ad[k].fastAccessDx(l);
      }
      scatter(sides_[s].local, force, f);
      matrix.add(first_cell_ + s, K);
    });
}

}  // namespace mortise
