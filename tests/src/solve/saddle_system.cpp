#include "saddle_system.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>

namespace mortise {

CubeStiffness cube_stiffness(double edge, double youngs_modulus, double poissons_ratio) {
  const double shear = youngs_modulus / (2 * (1 + poissons_ratio));
  const double lambda = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
  const double g = 1 / std::sqrt(3.0), JxW = edge * edge * edge / 8;
  CubeStiffness K{};
  for (int q = 0; q < 8; ++q) {
    const double xi[3] = {q & 1 ? g : -g, q & 2 ? g : -g, q & 4 ? g : -g};
    double dN[8][3];
    for (int a = 0; a < 8; ++a) {
      const double s[3] = {a & 1 ? 1.0 : -1.0, a & 2 ? 1.0 : -1.0, a & 4 ? 1.0 : -1.0};
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        dN[a][i] = 0.125 * s[i] * (1 + s[j] * xi[j]) * (1 + s[k] * xi[k]) * 2 / edge;
      }
    }
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) {
        const double dot = dN[a][0] * dN[b][0] + dN[a][1] * dN[b][1] + dN[a][2] * dN[b][2];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            K[3 * a + i][3 * b + j] +=
                JxW * (lambda * dN[a][i] * dN[b][j] + shear * dN[a][j] * dN[b][i] + (i == j ? shear * dot : 0));
      }
  }
  return K;
}

SaddleSystem saddle_system(const SaddleOptions& o) {
  const auto comm = Tpetra::getDefaultComm();
  const int rank = comm->getRank(), n_ranks = comm->getSize(), m = o.n + 1;  // m nodes per edge
  const int per_block = m * m * m, n_nodes = 2 * per_block, n_pressures = o.contact ? m * m : 0;
  const auto node = [&](int block, int i, int j, int k) { return block * per_block + i + m * (j + m * k); };
  const auto height = [&](int n) { return n / per_block * m + n % per_block / (m * m); };  // layer of nodes from below
  const auto owner = [&](int n) { return o.spread ? n % m * n_ranks / m : height(n) * n_ranks / (2 * m); };
  const auto first = 3LL * n_nodes;
  const auto is_open = [&](int k) { return o.open(k % m, k / m); };
  const auto held = [&](long long unknown) {
    const int n = static_cast<int>(unknown / 3), component = static_cast<int>(unknown % 3);
    if (height(n) == 0) return o.lower_held;
    if (height(n) == 2 * m - 1) return o.upper_held || (o.lower_held && component < 2);
    return false;
  };

  SaddleSystem s;
  s.n_positions = first;
  std::vector<GlobalIndex> mine;
  for (int n = 0; n < n_nodes; ++n)
    for (int i = 0; i < 3; ++i) {
      s.group.push_back(n);
      if (owner(n) == rank) mine.push_back(3LL * n + i);
    }
  for (int k = 0; k < n_pressures; ++k) {
    const int secondary = node(1, k % m, k / m, 0);
    s.group.push_back(secondary);
    if (owner(secondary) == rank) mine.push_back(first + k);
  }
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  s.map = Teuchos::rcp(new Map(invalid, Teuchos::ArrayView<const GlobalIndex>(mine.data(), mine.size()), 0, comm));
  s.A = Teuchos::rcp(new Matrix(s.map, 160));
  const auto add = [&](GlobalIndex row, GlobalIndex column, double value) {
    if (s.map->isNodeGlobalElement(row)) s.A->insertGlobalValues(row, 1, &value, &column);
  };

  const double edge = o.size / o.n;
  const CubeStiffness K = cube_stiffness(edge, o.youngs_modulus, 0.3);
  for (int e = 0; e < 2 * o.n * o.n * o.n; ++e) {
    const int block = e / (o.n * o.n * o.n), i = e % o.n, j = e / o.n % o.n, k = e / (o.n * o.n) % o.n;
    GlobalIndex unknown[24];
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d) unknown[3 * a + d] = 3LL * node(block, i + (a & 1), j + (a >> 1 & 1), k + (a >> 2 & 1)) + d;
    for (int a = 0; a < 24; ++a)
      for (int b = 0; b < 24; ++b)
        if (!held(unknown[a])) add(unknown[a], unknown[b], K[a][b]);
  }
  for (GlobalIndex row : mine)
    if (row < first && held(row)) add(row, row, 1.0);

  // Matching surfaces with a mortar's mass matrix; normals slightly inclined so that all components take part. Gaps are per unit
  // area, forces are not, so that rows and columns of pressures differ.
  for (int k = 0; k < n_pressures; ++k) {
    const int i = k % m, j = k / m;
    const bool open = is_open(k);
    if (!open) ++s.n_closed;
    const double normal[3] = {0.1 * std::sin(i), 0.1 * std::cos(j), 1.0};
    for (int p = std::max(0, i - 1); p <= std::min(o.n, i + 1); ++p)
      for (int q = std::max(0, j - 1); q <= std::min(o.n, j + 1); ++q) {
        const double weight = open ? 0.0 : (p == i ? 2.0 / 3 : 1.0 / 6) * (q == j ? 2.0 / 3 : 1.0 / 6);
        for (int d = 0; d < 3; ++d) {
          const GlobalIndex upper = 3LL * node(1, p, q, 0) + d, lower = 3LL * node(0, p, q, o.n) + d;
          add(upper, first + k, -edge * edge * weight * normal[d]);
          add(lower, first + k, edge * edge * weight * normal[d]);
          add(first + k, upper, weight * normal[d] * (1 + 0.05 * i));
          add(first + k, lower, -weight * normal[d] * (1 + 0.05 * j));
        }
      }
    add(first + k, first + k, open ? 1.0 : 0.0);
  }
  s.A->fillComplete(s.map, s.map);

  s.x = Teuchos::rcp(new Vector(s.map));
  s.b = Teuchos::rcp(new Vector(s.map));
  {
    auto x = s.x->getDataNonConst();
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const bool position = mine[k] < first;
      s.identity_rows.push_back(position ? held(mine[k]) : is_open(static_cast<int>(mine[k] - first)));
      const double shape = std::sin(0.37 * static_cast<double>(mine[k]) + 0.2) + 0.5;
      x[k] = (position ? 1e-3 * o.size : 1e-3 * o.youngs_modulus) * shape;
    }
  }
  s.A->apply(*s.x, *s.b);
  return s;
}

double relative_error(const SaddleSystem& system, const Vector& x) {
  double mine[4] = {0, 0, 0, 0}, all[4];  // squares of error and size of positions, of pressures
  const auto computed = x.getData(), exact = system.x->getData();
  for (int k = 0; k < static_cast<int>(exact.size()); ++k) {
    const int part = system.map->getGlobalElement(k) < system.n_positions ? 0 : 2;
    mine[part] += std::pow(computed[k] - exact[k], 2);
    mine[part + 1] += std::pow(exact[k], 2);
  }
  Teuchos::reduceAll(*system.map->getComm(), Teuchos::REDUCE_SUM, 4, mine, all);
  return std::sqrt(std::max(all[0] / all[1], all[3] > 0 ? all[2] / all[3] : 0.0));
}

}  // namespace mortise
