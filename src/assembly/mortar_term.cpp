#include "assembly/mortar_term.hpp"

#include <algorithm>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

int position_of(std::vector<int>& list, int first, int entry) {
  const auto found = std::find(list.begin() + first, list.end(), entry);
  if (found != list.end()) return static_cast<int>(found - list.begin()) - first;
  list.push_back(entry);
  return static_cast<int>(list.size()) - 1 - first;
}

}  // namespace

MortarTerm::MortarTerm(const ContactPair& pair, const Partition& partition, const DofSpace& dofs)
    : ContactTerm(pair, dofs), pair_(pair), rule_(triangle_rule(pair.quadrature_degree)), patches_(pair.secondary.patches()) {
  const auto& nodes = pair.secondary_nodes;
  first_facet_.assign(nodes.size(), -1);
  for (std::size_t k = 0; k < pair.secondary.facets.size(); ++k) {
    if (partition.element_rank[pair.secondary_elements[k]] != dofs.comm()->getRank()) continue;
    Facet facet;
    facet.index = static_cast<int>(k);
    for (int a = 0; a < 4; ++a) {
      facet.corner[a] =
          static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), pair.secondary.facets[k][a]) - nodes.begin());
      if (first_facet_[facet.corner[a]] < 0) first_facet_[facet.corner[a]] = static_cast<int>(facets_.size());
    }
    list_points(facet);
    facets_.push_back(std::move(facet));
  }
  normal_.resize(nodes.size());
  load_.resize(nodes.size());
  normal_gradient_.resize(nodes.size());
  patch_x_.resize(nodes.size());
}

void MortarTerm::list_points(Facet& facet) {
  facet.points.assign(pair_.secondary.facets[facet.index].begin(), pair_.secondary.facets[facet.index].end());
  for (int corner : facet.corner)
    for (int node : patches_[corner].nodes) position_of(facet.points, 0, node);
  facet.n_patch = static_cast<int>(facet.points.size());
  facet.primary_at.clear();
  for (int candidate : facet.candidates) {
    std::array<int, 4> at;
    for (int a = 0; a < 4; ++a) at[a] = position_of(facet.points, facet.n_patch, pair_.primary.facets[candidate][a]);
    facet.primary_at.push_back(at);
  }
  facet.n_primary = static_cast<int>(facet.points.size()) - facet.n_patch;
  for (int corner : facet.corner) facet.points.push_back(pressure_point(corner));
}

void MortarTerm::append_cells(std::vector<Cell>& cells) {
  first_cell_ = cells.size();
  for (const auto& facet : facets_) cells.push_back(facet.points);
}

void MortarTerm::integrate(const double* x, bool with_tangent, double* f, NodalSums& sums) {
  closure_ = 0;
  n_covered_ = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    if (first_facet_[k] < 0) continue;
    auto& positions = patch_x_[k];
    positions.clear();
    for (int node : patches_[k].nodes) positions.push_back(position(x, node));
    normal_[k] = nodal_normal(patches_[k], positions);
    load_[k] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      Vec3<double> axis{};
      axis[i] = 1;
      normal_pull_back(patches_[k], positions, axis, normal_gradient_[k][i]);
    }
  }
  for (auto& facet : facets_) integrate_facet(facet, x, with_tangent, f, sums);

  // The normals turn with the surface: (dn/dx)^T (p g) acts on the patch, and its change with x is the curvature term.
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    if (first_facet_[k] < 0) continue;
    const auto& nodes = patches_[k].nodes;
    for (std::size_t b = 0; b < nodes.size(); ++b)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) f[dofs_.local(nodes[b]) + j] += normal_gradient_[k][i][b][j] * load_[k][i];
    Facet& facet = facets_[first_facet_[k]];
    if (!with_tangent || dot(load_[k], load_[k]) == 0) continue;
    const int n = 3 * static_cast<int>(nodes.size());
    if (facet.matrix.empty()) facet.matrix.assign((width(facet) + n_extra()) * width(facet), 0.0);
    std::vector<double> H(static_cast<std::size_t>(n) * n, 0.0);
    add_normal_curvature(patches_[k], patch_x_[k], load_[k], H);
    std::vector<int> at;
    for (int node : nodes) at.push_back(position_of(facet.points, 0, node));
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c)
        facet.matrix[(3 * at[r / 3] + r % 3) * width(facet) + 3 * at[c / 3] + c % 3] += H[static_cast<std::size_t>(r) * n + c];
  }
}

void MortarTerm::begin_step(const double* x, bool is_at_rest, const TimeScheme& scheme, const std::vector<PrescribedDof>& held) {
  start_ = is_at_rest ? nullptr : x;
  scheme_ = scheme;
  if (start_ && pair_.has_frozen_integrals) start_normal_ = normals(x);
  held_ = held_components(patches_, pair_.primary.nodes(), held);
  held_along_normal_.clear();
  if (held_.empty()) return;
  const auto n = normals(x);
  for (std::size_t k = 0; k < n.size(); ++k) {
    double held_part = 0;  // of the normal, squared
    for (int i = 0; i < 3; ++i) held_part += is_held(k, i) ? n[k][i] * n[k][i] : 0;
    if (held_part > 0.9) held_along_normal_.insert(k);
  }
}

PairFriction MortarTerm::friction_of(const Facet& facet, std::size_t candidate, const double* x, const PairInput& input) const {
  PairFriction friction;
  const auto& secondary = pair_.secondary.facets[facet.index];
  const auto& primary = pair_.primary.facets[facet.candidates[candidate]];
  friction.before = input.x;
  for (int a = 0; a < 4; ++a) {
    if (start_) {
      friction.before[a] = position(start_, secondary[a]);
      friction.before[4 + a] = position(start_, primary[a]);
    }
    const int traction = dofs_.local(pressure_point(facet.corner[a])) + 1;
    const double* before = start_ ? start_ : x;
    friction.traction[a] = {x[traction], x[traction + 1], x[traction + 2]};
    friction.traction_before[a] = {before[traction], before[traction + 1], before[traction + 2]};
  }
  friction.theta = start_ ? scheme_.constraint_theta : 1;
  friction.traction_theta = start_ ? pair_.friction->theta_of(scheme_) : 1;
  friction.is_moment_free = pair_.friction->is_moment_free(scheme_);
  return friction;
}

void MortarTerm::integrate_facet(Facet& facet, const double* x, bool with_tangent, double* f, NodalSums& sums) {
  const auto& nodes = pair_.secondary.facets[facet.index];
  PairInput input;
  for (int a = 0; a < 4; ++a) {
    input.x[a] = position(x, nodes[a]);
    input.normal[a] = normal_[facet.corner[a]];
    input.pressure[a] = x[dofs_.local(pressure_point(facet.corner[a]))];
  }
  input.reading = pair_.force;
  if (pair_.has_frozen_integrals && start_) {
    input.frozen.emplace();
    for (int a = 0; a < 4; ++a) {
      input.frozen->x[a] = position(start_, nodes[a]);
      input.frozen->normal[a] = start_normal_[facet.corner[a]];
    }
  }

  // Columns and rows of the local system: 4 nodes, 4 normals, the contact unknowns of 4 nodes, primary nodes; below, 4 rows each
  // of covered and whole areas, and 12 of weighted slips.
  const int n_local = 24 + n_own() + 3 * facet.n_primary;
  std::vector<double> K;
  facet.matrix.clear();
  if (!sums.slip.is_null()) facet.slip.clear();
  double covered = 0;
  PairTangent frictionless;  // neither is filled before it is used
  FrictionalTangent frictional;
  for (std::size_t k = 0; k < facet.candidates.size(); ++k) {
    for (int a = 0; a < 4; ++a) {
      const int node = pair_.primary.facets[facet.candidates[k]][a];
      input.x[4 + a] = position(x, node);
      if (input.frozen) input.frozen->x[4 + a] = position(start_, node);
    }
    ++counts_.pairs;
    const PairWeight facing = facing_weight(input);
    if (facing.value == 0) {
      ++counts_.turned_away;
      continue;
    }
    const auto add = [&](auto& pair, const auto&... friction) {
      if (!pair_values(input, friction..., rule_, pair)) return;
      ++counts_.overlaps;
      const double* c = pair.covered_area;
      for (int a = 0; a < 4; ++a) covered += c[a];  // whatever of it counts
      const double* g = &pair.row[36];
      const double gap = (g[0] + g[1] + g[2] + g[3]) / (c[0] + c[1] + c[2] + c[3]);
      if (gap > farthest() || gap < -facet.deepest) return;  // too far apart to matter, or on the body's other side
      if (with_tangent) pair_tangent(input, friction..., rule_, pair);
      PairWeight weight = facing;
      add_nearness(pair, farthest(), with_tangent, weight);
      weigh(weight, with_tangent, pair);
      if (with_tangent && K.empty()) K.assign(static_cast<std::size_t>(n_local + n_extra()) * n_local, 0.0);
      add_pair(facet, k, pair, with_tangent, f, sums, K);
    };
    if (pair_.friction && sums.with_friction) {
      add(frictional, friction_of(facet, k, x, input));
    } else {
      add(frictionless);
    }
  }
  double whole_by_node[4], d_whole[4][36];
  whole_area_tangent(input, whole_by_node, d_whole);
  double* whole_area = data(sums.whole_area);
  for (int I = 0; I < 4; ++I) whole_area[dofs_.local(pressure_point(facet.corner[I]))] += whole_by_node[I];
  if (with_tangent && K.empty()) K.assign(static_cast<std::size_t>(n_local + n_extra()) * n_local, 0.0);
  if (!K.empty()) {
    for (int I = 0; I < 4; ++I)
      for (int c = 0; c < 12; ++c) {
        K[static_cast<std::size_t>(n_local + 4 + I) * n_local + c] = d_whole[I][c];
        K[static_cast<std::size_t>(n_local + 4 + I) * n_local + 12 + c] = d_whole[I][24 + c];
      }
    chain_normals(facet, K, n_local);
    if (pair_.friction && !sums.slip.is_null()) store_slip(facet);
  }

  const double whole = whole_by_node[0] + whole_by_node[1] + whole_by_node[2] + whole_by_node[3],
               error = std::abs(covered - whole) / whole;
  if (error < 1e-6) {  // nearer than any true partial cover of a mesh that is not made to deceive
    closure_ = std::max(closure_, error);
    ++n_covered_;
  }
}

template <class Pair>
void MortarTerm::add_pair(Facet& facet, std::size_t k, const Pair& pair, bool with_tangent, double* f, NodalSums& sums,
                          std::vector<double>& K) {
  constexpr int n = sizeof(pair.row) / sizeof(double);  // 40, and with friction 12 slips
  double *weighted_gap = data(sums.weighted_gap), *area = data(sums.covered_area);
  const auto& nodes = pair_.secondary.facets[facet.index];
  const auto& primary_nodes = pair_.primary.facets[facet.candidates[k]];
  for (int a = 0; a < 4; ++a) {
    const int pressure = dofs_.local(pressure_point(facet.corner[a]));
    weighted_gap[pressure] += pair.row[36 + a];
    area[pressure] += pair.covered_area[a];
    const int secondary = dofs_.local(nodes[a]), primary = dofs_.local(primary_nodes[a]);
    for (int i = 0; i < 3; ++i) {
      f[secondary + i] += pair.row[3 * a + i];
      f[primary + i] += pair.row[12 + 3 * a + i];
      load_[facet.corner[a]][i] += pair.row[24 + 3 * a + i];
    }
    if constexpr (n > 40)
      if (!sums.slip.is_null()) {
        double* slip = data(*sums.slip) + pressure;
        slip[0] += pair.covered_area[a];
        for (int i = 0; i < 3; ++i) slip[1 + i] += pair.row[40 + 3 * a + i];
      }
  }
  if (!with_tangent) return;
  const int n_local = 24 + n_own() + 3 * facet.n_primary, m = pair_.n_unknowns;
  int at[n];
  for (int c = 0; c < 12; ++c) {
    at[c] = c;
    at[12 + c] = 24 + n_own() + 3 * facet.primary_at[k][c / 3] + c % 3;
    at[24 + c] = 12 + c;
  }
  for (int I = 0; I < 4; ++I) at[36 + I] = 24 + m * I;
  for (int c = 40; c < n; ++c) at[c] = 24 + m * ((c - 40) / 3) + 1 + (c - 40) % 3;
  for (int r = 0; r < n; ++r) {
    double* row = &K[static_cast<std::size_t>(r < 40 ? at[r] : n_local + 8 + r - 40) * n_local];
    for (int c = 0; c < n; ++c) row[at[c]] += pair.d[r][c];
  }
  for (int I = 0; I < 4; ++I)
    for (int c = 0; c < 36; ++c) K[static_cast<std::size_t>(n_local + I) * n_local + at[c]] += pair.d_area[I][c];
}

void MortarTerm::chain_normals(Facet& facet, const std::vector<double>& K, int n_local) const {
  const int n_patch = facet.n_patch, width = static_cast<int>(this->width(facet)), end_own = 24 + n_own();
  const auto column = [&](int z) {  // of every local column that is not a normal
    if (z < 12) return z;
    if (z < end_own) return static_cast<int>(n_positions(facet)) + z - 24;
    return 3 * n_patch + z - end_own;
  };
  std::array<std::vector<int>, 4> patch_at;
  for (int I = 0; I < 4; ++I)
    for (int node : patches_[facet.corner[I]].nodes) patch_at[I].push_back(position_of(facet.points, 0, node));

  std::vector<double> half(static_cast<std::size_t>(n_local + n_extra()) * width, 0.0);
  for (int r = 0; r < n_local + n_extra(); ++r) {
    const double* from = &K[static_cast<std::size_t>(r) * n_local];
    double* to = &half[static_cast<std::size_t>(r) * width];
    for (int z = 0; z < n_local; ++z)
      if (z < 12 || z >= 24) to[column(z)] += from[z];
    for (int I = 0; I < 4; ++I)
      for (int i = 0; i < 3; ++i) {
        const double factor = from[12 + 3 * I + i];
        const auto& gradient = normal_gradient_[facet.corner[I]][i];
        for (std::size_t b = 0; b < gradient.size(); ++b)
          for (int j = 0; j < 3; ++j) to[3 * patch_at[I][b] + j] += factor * gradient[b][j];
      }
  }
  facet.matrix.assign(static_cast<std::size_t>(width + n_extra()) * width, 0.0);
  const auto add_row = [&](int to_row, double factor, int from_row) {
    double* to = &facet.matrix[static_cast<std::size_t>(to_row) * width];
    const double* from = &half[static_cast<std::size_t>(from_row) * width];
    for (int c = 0; c < width; ++c) to[c] += factor * from[c];
  };
  for (int z = 0; z < n_local; ++z)
    if (z < 12 || z >= 24) add_row(column(z), 1.0, z);
  for (int I = 0; I < n_extra(); ++I) add_row(width + I, 1.0, n_local + I);
  for (int I = 0; I < 4; ++I)
    for (int i = 0; i < 3; ++i) {
      const auto& gradient = normal_gradient_[facet.corner[I]][i];
      for (std::size_t b = 0; b < gradient.size(); ++b)
        for (int j = 0; j < 3; ++j) add_row(3 * patch_at[I][b] + j, gradient[b][j], 12 + 3 * I + i);
    }
}

void MortarTerm::store_slip(Facet& facet) const {
  const std::size_t n = width(facet);
  facet.slip.assign(28 * n, 0.0);
  std::copy_n(&facet.matrix[(n + 8) * n], 12 * n, &facet.slip[0]);
  std::copy_n(&facet.matrix[n * n], 4 * n, &facet.slip[12 * n]);
  for (int I = 0; I < 4; ++I)
    for (std::size_t b = 0; b < patches_[facet.corner[I]].nodes.size(); ++b) {
      const int at = 3 * position_of(facet.points, 0, patches_[facet.corner[I]].nodes[b]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) facet.slip[(16 + 3 * I + i) * n + at + j] = normal_gradient_[facet.corner[I]][i][b][j];
    }
}

void MortarTerm::add_friction_tangent(const FrictionRows& rows, double theta, SystemMatrix& K) const {
  std::vector<double> shares;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const Facet& facet = facets_[k];
    if (facet.slip.empty()) continue;
    const std::size_t n = width(facet), n_positions = this->n_positions(facet);
    shares.assign(n * n, 0.0);
    for (int I = 0; I < 4; ++I) {
      const double part = 1.0 / static_cast<double>(patches_[facet.corner[I]].corners.size());  // of what facets share
      const int pressure = dofs_.local(pressure_point(facet.corner[I]));
      const std::size_t own = n_positions + pair_.n_unknowns * I;
      for (int i = 0; i < 3; ++i) {
        const auto factor = [&](int which) { return data(static_cast<const Vector&>(*rows.factors[which]))[pressure + 1 + i]; };
        double* row = &shares[(own + 1 + i) * n];
        const auto add = [&](double by, std::size_t from_row) {
          const double* from = &facet.slip[from_row * n];
          for (std::size_t c = 0; c < n; ++c) row[c] += by * (c < n_positions ? theta : 1) * from[c];
        };
        for (int j = 0; j < 3; ++j) {
          add(factor(FrictionRows::slip + j), 3 * I + j);
          add(part * factor(FrictionRows::normal + j), 16 + 3 * I + j);
          row[own + 1 + j] += part * factor(FrictionRows::traction + j);
        }
        add(factor(FrictionRows::area), 12 + I);
        row[own] += part * factor(FrictionRows::pressure);
      }
    }
    K.add(first_cell_ + k, shares.data());
  }
}

void MortarTerm::add_tangent(const double* a, const double* b, const double* c, double force_weight, SystemMatrix& K) const {
  std::vector<double> scaled;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const Facet& facet = facets_[k];
    if (facet.matrix.empty()) continue;
    const std::size_t n = width(facet);
    scaled.assign(facet.matrix.begin(), facet.matrix.begin() + n * n);
    if (force_weight != 1)
      for (std::size_t j = 0; j < n_positions(facet) * n; ++j) scaled[j] *= force_weight;
    for (int I = 0; I < 4; ++I) {
      const int pressure = dofs_.local(pressure_point(facet.corner[I]));
      double* row = &scaled[(n_positions(facet) + pair_.n_unknowns * I) * n];
      const double *covered = &facet.matrix[(n + I) * n], *whole = &facet.matrix[(n + 4 + I) * n];
      for (std::size_t j = 0; j < n; ++j) row[j] = a[pressure] * row[j] + b[pressure] * covered[j] + c[pressure] * whole[j];
    }
    K.add(first_cell_ + k, scaled.data());
  }
}

void MortarTerm::add_force_tangent(double weight, double theta, SystemMatrix& K) const {
  std::vector<double> scaled;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const Facet& facet = facets_[k];
    if (facet.matrix.empty()) continue;
    const std::size_t n = width(facet), n_positions = this->n_positions(facet);
    scaled.assign(n * n, 0.0);
    for (std::size_t r = 0; r < n_positions; ++r)
      for (std::size_t j = 0; j < n; ++j) scaled[r * n + j] = weight * (j < n_positions ? theta : 1.0) * facet.matrix[r * n + j];
    K.add(first_cell_ + k, scaled.data());
  }
}

}  // namespace mortise
