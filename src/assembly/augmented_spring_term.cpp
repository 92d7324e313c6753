#include "assembly/augmented_spring_term.hpp"

#include <Sacado.hpp>

#include "physics/augmented_stretch.hpp"

namespace mortise {
namespace {

using Fad = Sacado::Fad::SFad<double, 5>;  // t, v, lambda

}  // namespace

AugmentedSpringTerm::AugmentedSpringTerm(const Scene& scene, const NodeSpring& spring, const DofSpace& dofs)
    : law_(spring.law),
      activity_(spring.activity),
      is_anchored_(!spring.to),
      rest_length_(spring.rest_length),
      line_(point_of(spring)) {
  if (!dofs.owned(spring.from)) return;
  points_ = nodes_of(spring);
  points_.push_back(scene.spring_point(*spring.augmented));
  for (int point : points_) local_.push_back(dofs.local(point));
  unknowns_ = local_.back();
}

void AugmentedSpringTerm::append_cells(std::vector<Cell>& cells) {
  cell_ = cells.size();
  if (is_here()) cells.push_back(points_);
}

bool AugmentedSpringTerm::is_admissible(double v) const {
  return std::isfinite(v) && (v > 0 || law_ == StretchLaw::saint_venant);
}

bool AugmentedSpringTerm::add_force(const TimeScheme& scheme, const double* x_n, const double* x, double* f) const {
  if (!is_here()) return true;
  const double v = x[unknowns_], lambda = x[unknowns_ + 1];
  if (!is_admissible(v)) return false;
  const auto r = with_stretch_law(law_, [&](auto law) {
    return augmented_stretch<decltype(law)>(scheme, line_.energy, line_.tangent(local_, x_n), line_.tangent(local_, x), v,
                                            lambda);
  });
  for (std::size_t a = 0; a < line_.slopes.size(); ++a)
    for (int i = 0; i < 3; ++i) f[local_[a] + i] += line_.slopes[a] * r.force[i];
  f[unknowns_] += r.balance;
  f[unknowns_ + 1] += r.constraint;
  return true;
}

bool AugmentedSpringTerm::add_tangent(const TimeScheme& scheme, const double* x_n, const double* x, double* f,
                                      SystemMatrix& matrix) const {
  if (!is_here()) return true;
  if (!is_admissible(x[unknowns_])) return false;
  const Vec3<double> start = line_.tangent(local_, x_n), end = line_.tangent(local_, x);
  Vec3<Fad> t_n, t;
  for (int i = 0; i < 3; ++i) {
    t_n[i] = start[i];
    t[i] = Fad(5, i, end[i]);
  }
  const Fad v(5, 3, x[unknowns_]), lambda(5, 4, x[unknowns_ + 1]);
  const auto r =
      with_stretch_law(law_, [&](auto law) { return augmented_stretch<decltype(law)>(scheme, line_.energy, t_n, t, v, lambda); });

  // Rows and columns: positions of the nodes, v, lambda.
  const std::size_t n_positions = 3 * line_.slopes.size(), width = n_positions + 2;
  std::vector<double> K(width * width);
  const auto add_row = [&](std::size_t row, int to, double factor, const Fad& value) {
    f[to] += factor * value.val();
    for (std::size_t b = 0; b < line_.slopes.size(); ++b)
      for (int j = 0; j < 3; ++j) K[row * width + 3 * b + j] = factor * line_.slopes[b] * value.fastAccessDx(j);
    for (int m = 0; m < 2; ++m) K[row * width + n_positions + m] = factor * value.fastAccessDx(3 + m);
  };
  for (std::size_t a = 0; a < line_.slopes.size(); ++a)
    for (int i = 0; i < 3; ++i) add_row(3 * a + i, local_[a] + i, line_.slopes[a], r.force[i]);
  add_row(n_positions, unknowns_, 1, r.balance);
  add_row(n_positions + 1, unknowns_ + 1, 1, r.constraint);
  matrix.add(cell_, K.data());
  return true;
}

void AugmentedSpringTerm::settle(const double* x, double* y) const {
  if (!is_here()) return;
  const Vec3<double> t = line_.tangent(local_, x);
  const double v = dot(t, t);
  y[unknowns_] = v;
  y[unknowns_ + 1] = -line_.energy * with_stretch_law(law_, [&](auto law) { return law.slope(v, 0.0); });
}

double AugmentedSpringTerm::energy(const double* x) const {
  if (!is_here()) return 0;
  const Vec3<double> t = line_.tangent(local_, x);
  return line_.energy * with_stretch_law(law_, [&](auto law) { return law.energy(dot(t, t)); });
}

}  // namespace mortise
