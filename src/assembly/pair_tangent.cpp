#include "assembly/pair_tangent.hpp"

#include <Sacado.hpp>

namespace mortise {
namespace {

template <class T>
void store_rows(const PairShares<T>& shares, const T* rows[40]) {
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) rows[3 * a + i] = &shares.force[a][i];
  for (int I = 0; I < 4; ++I) {
    for (int i = 0; i < 3; ++i) rows[24 + 3 * I + i] = &shares.n_load[I][i];
    rows[36 + I] = &shares.weighted_gap[I];
  }
}

// Positions relative to the facet's centre: the shares do not notice, and far from the origin no digits are lost.
std::array<Vec3<double>, 8> relative(const PairInput& input, const AuxiliaryPlane& plane) {
  auto x = input.x;
  for (auto& p : x) p = p - plane.centre;
  return x;
}

}  // namespace

bool pair_values(const PairInput& input, const std::vector<TrianglePoint>& rule, PairOutput& out) {
  const auto plane = AuxiliaryPlane::project(input.x, input.normal);
  const auto integrals = planar_integrals(plane.y, rule);
  double area = 0;
  for (int I = 0; I < 4; ++I) {
    out.covered_area[I] = integrals.D[I][0] + integrals.D[I][1] + integrals.D[I][2] + integrals.D[I][3];
    area += out.covered_area[I];
  }
  if (!(area > 0)) return false;
  const auto shares = pair_shares(relative(input, plane), input.normal, input.pressure, integrals);
  const double* rows[40];
  store_rows(shares, rows);
  for (int r = 0; r < 40; ++r) out.row[r] = *rows[r];
  return true;
}

bool pair_tangent(const PairInput& input, const std::vector<TrianglePoint>& rule, PairTangent& out) {
  // 18, not 16: GCC unrolls loops of 16 and less completely before it vectorises, which is slower.
  using Planar = Sacado::Fad::SFad<double, 18>;
  const auto plane = AuxiliaryPlane::project(input.x, input.normal);
  Planar y[16];
  for (int k = 0; k < 16; ++k) y[k] = Planar(18, k, plane.y[k]);
  const auto planar = planar_integrals(y, rule);
  double area = 0;
  for (int I = 0; I < 4; ++I) {
    out.covered_area[I] = 0;
    for (int J = 0; J < 4; ++J) out.covered_area[I] += planar.D[I][J].val();
    area += out.covered_area[I];
  }
  if (!(area > 0)) return false;

  using Fad = Sacado::Fad::SFad<double, 40>;
  const auto pull = [&plane](const Planar& from) {
    Fad to(from.val());
    plane.pull_back(from.dx(), &to.fastAccessDx(0));
    for (int k = 36; k < 40; ++k) to.fastAccessDx(k) = 0;
    return to;
  };
  MortarIntegrals<Fad> integrals;
  for (int I = 0; I < 4; ++I) {
    for (int J = 0; J < 4; ++J) {
      integrals.D[I][J] = J < I ? integrals.D[J][I] : pull(planar.D[I][J]);
      integrals.M[I][J] = pull(planar.M[I][J]);
    }
  }
  for (int I = 0; I < 4; ++I)
    for (int c = 0; c < 36; ++c) {
      const auto& D = integrals.D[I];
      out.d_area[I][c] = D[0].fastAccessDx(c) + D[1].fastAccessDx(c) + D[2].fastAccessDx(c) + D[3].fastAccessDx(c);
    }
  const auto x = relative(input, plane);
  std::array<Vec3<Fad>, 8> x_ad;
  std::array<Vec3<Fad>, 4> n_ad;
  std::array<Fad, 4> p_ad;
  for (int k = 0; k < 24; ++k) x_ad[k / 3][k % 3] = Fad(40, k, x[k / 3][k % 3]);
  for (int k = 0; k < 12; ++k) n_ad[k / 3][k % 3] = Fad(40, 24 + k, input.normal[k / 3][k % 3]);
  for (int I = 0; I < 4; ++I) p_ad[I] = Fad(40, 36 + I, input.pressure[I]);
  const auto shares = pair_shares(x_ad, n_ad, p_ad, integrals);
  const Fad* rows[40];
  store_rows(shares, rows);
  for (int r = 0; r < 40; ++r) {
    out.row[r] = rows[r]->val();
    for (int c = 0; c < 40; ++c) out.d[r][c] = rows[r]->fastAccessDx(c);
  }
  return true;
}

void whole_area_tangent(const PairInput& input, double whole_area[4], double d[4][36]) {
  using Planar = Sacado::Fad::SFad<double, 18>;
  const auto plane = AuxiliaryPlane::project(input.x, input.normal);
  Quad<Planar> facet;
  for (int a = 0; a < 4; ++a) facet[a] = {Planar(18, 2 * a, plane.y[2 * a]), Planar(18, 2 * a + 1, plane.y[2 * a + 1])};
  const auto weights = facet_weights(facet);
  for (int a = 0; a < 4; ++a) {
    whole_area[a] = weights[a].val();
    plane.pull_back(weights[a].dx(), d[a]);
  }
}

void add_normal_curvature(const NodePatch& patch, const std::vector<Vec3<double>>& x, const Vec3<double>& b,
                          std::vector<double>& H) {
  constexpr int chunk = 30;  // directions at a time: an inner node of a regular surface has 9 patch nodes, 27 directions
  using Fad = Sacado::Fad::SFad<double, chunk>;
  const int n = 3 * static_cast<int>(x.size());
  const Vec3<Fad> b_ad{Fad(b[0]), Fad(b[1]), Fad(b[2])};
  std::vector<Vec3<Fad>> x_ad(x.size()), force;
  for (int first = 0; first < n; first += chunk) {
    for (int k = 0; k < n; ++k) {
      const bool seeded = k >= first && k < first + chunk;
      x_ad[k / 3][k % 3] = seeded ? Fad(chunk, k - first, x[k / 3][k % 3]) : Fad(x[k / 3][k % 3]);
    }
    normal_pull_back(patch, x_ad, b_ad, force);
    for (int r = 0; r < n; ++r)
      for (int c = first; c < std::min(n, first + chunk); ++c)
        H[static_cast<std::size_t>(r) * n + c] += force[r / 3][r % 3].dx(c - first);
  }
}

}  // namespace mortise
