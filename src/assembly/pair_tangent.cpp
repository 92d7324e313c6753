#include "assembly/pair_tangent.hpp"

#include <Sacado.hpp>
#include <algorithm>
#include <type_traits>

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

/// D and M by value. @return false if the facets do not overlap
template <class Output>
bool integrals_of(const AuxiliaryPlane& plane, const std::vector<TrianglePoint>& rule, Output& out,
                  MortarIntegrals<double>& integrals) {
  integrals = planar_integrals(plane.y, rule);
  double area = 0;
  for (int I = 0; I < 4; ++I) {
    out.covered_area[I] = integrals.D[I][0] + integrals.D[I][1] + integrals.D[I][2] + integrals.D[I][3];
    area += out.covered_area[I];
  }
  return area > 0;
}

/// D and M by AD over 16 in-plane coordinates, pulled back to the first 36 of n directions, and the derivative of the areas.
template <int n, class Output>
bool integrals_of(const AuxiliaryPlane& plane, bool is_frozen, const std::vector<TrianglePoint>& rule, Output& out,
                  MortarIntegrals<Sacado::Fad::SFad<double, n>>& integrals) {
  if (is_frozen) {
    MortarIntegrals<double> constant;
    for (auto& row : out.d_area) std::fill(std::begin(row), std::end(row), 0.0);
    if (!integrals_of(plane, rule, out, constant)) return false;
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) {
        integrals.D[I][J] = constant.D[I][J];
        integrals.M[I][J] = constant.M[I][J];
      }
    return true;
  }
  // 18, not 16: GCC unrolls loops of 16 and less completely before it vectorises, which is slower.
  using Planar = Sacado::Fad::SFad<double, 18>;
  using Fad = Sacado::Fad::SFad<double, n>;
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
  const auto pull = [&plane](const Planar& from) {
    Fad to(from.val());
    plane.pull_back(from.dx(), &to.fastAccessDx(0));
    for (int k = 36; k < n; ++k) to.fastAccessDx(k) = 0;
    return to;
  };
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
  return true;
}

/// The unknowns of a pair as variables of n directions.
template <class T>
struct PairVariables {
  std::array<Vec3<T>, 8> x;
  std::array<Vec3<T>, 4> n;
  std::array<T, 4> p;
};

template <int n>
PairVariables<Sacado::Fad::SFad<double, n>> seeded(const PairInput& input, const AuxiliaryPlane& plane) {
  using Fad = Sacado::Fad::SFad<double, n>;
  PairVariables<Fad> v;
  const auto x = relative(input, plane);
  for (int k = 0; k < 24; ++k) v.x[k / 3][k % 3] = Fad(n, k, x[k / 3][k % 3]);
  for (int k = 0; k < 12; ++k) v.n[k / 3][k % 3] = Fad(n, 24 + k, input.normal[k / 3][k % 3]);
  for (int I = 0; I < 4; ++I) v.p[I] = Fad(n, 36 + I, input.pressure[I]);
  return v;
}

/// In-plane coordinates as functions of 24 positions and 12 normal components. What D, M and gaps do not notice, the motion of
/// the centre and the spin of the axes, is left out (see `AuxiliaryPlane::pull_back`).
template <class T>
std::array<T, 16> planar_variables(const AuxiliaryPlane& plane, bool is_frozen) {
  std::array<T, 16> y;
  for (int k = 0; k < 16; ++k) {
    y[k] = plane.y[k];
    if constexpr (!std::is_same_v<T, double>) {
      if (is_frozen) continue;
      double unit[16] = {}, slope[36];
      unit[k] = 1;
      plane.pull_back(unit, slope);
      for (int c = 0; c < 36; ++c) y[k].fastAccessDx(c) = slope[c];
    }
  }
  return y;
}

/// The pair's shares in the reading that the input asks for.
template <class T>
PairShares<T> shares_as_read(const PairInput& input, const AuxiliaryPlane& plane, const std::vector<TrianglePoint>& rule,
                             const PairVariables<T>& v, const MortarIntegrals<T>& integrals) {
  auto shares = pair_shares(v.x, v.n, v.p, integrals);
  if (input.reading == ContactForce::interpolated_normal)
    interpolate_normals(planar_variables<T>(plane, input.frozen.has_value()).data(), v.x, v.n, rule, shares);
  return shares;
}

template <int n, class Fad, class Tangent>
void store_derivatives(const Fad* const rows[n], Tangent& out) {
  for (int r = 0; r < n; ++r) {
    out.row[r] = rows[r]->val();
    for (int c = 0; c < n; ++c) out.d[r][c] = rows[r]->fastAccessDx(c);
  }
}

/// The pair's shares with friction, given its variables and the tractions at the end of the step.
template <class T>
std::pair<PairShares<T>, FrictionShares<T>> all_shares(const PairInput& input, const PairFriction& friction,
                                                       const AuxiliaryPlane& plane, const std::vector<TrianglePoint>& rule,
                                                       const PairVariables<T>& v, const std::array<Vec3<T>, 4>& traction,
                                                       const MortarIntegrals<T>& integrals) {
  std::array<Vec3<T>, 8> dx;
  const Vec3<double>& centre = plane.centre;
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i) dx[a][i] = (v.x[a][i] - (friction.before[a][i] - centre[i])) / friction.theta;
  std::array<Vec3<T>, 4> acting;
  for (int I = 0; I < 4; ++I)
    for (int i = 0; i < 3; ++i)
      acting[I][i] = (1 - friction.traction_theta) * friction.traction_before[I][i] + friction.traction_theta * traction[I][i];
  auto shares = shares_as_read(input, plane, rule, v, integrals);
  auto of_friction = friction_shares(v.x, dx, v.n, acting, integrals, friction.is_moment_free);
  for (int a = 0; a < 8; ++a) shares.force[a] = shares.force[a] + of_friction.force[a];
  return {shares, of_friction};
}

template <class T>
void store_rows(const std::pair<PairShares<T>, FrictionShares<T>>& all, const T* rows[52]) {
  store_rows(all.first, rows);
  for (int k = 0; k < 12; ++k) rows[40 + k] = &all.second.slip[k / 3][k % 3];
}

}  // namespace

bool pair_values(const PairInput& input, const std::vector<TrianglePoint>& rule, PairOutput& out) {
  const auto plane = input.plane();
  MortarIntegrals<double> integrals;
  if (!integrals_of(plane, rule, out, integrals)) return false;
  const PairVariables<double> v{relative(input, plane), input.normal, input.pressure};
  const auto shares = shares_as_read(input, plane, rule, v, integrals);
  const double* rows[40];
  store_rows(shares, rows);
  for (int r = 0; r < 40; ++r) out.row[r] = *rows[r];
  return true;
}

bool pair_values(const PairInput& input, const PairFriction& friction, const std::vector<TrianglePoint>& rule,
                 FrictionalOutput& out) {
  const auto plane = input.plane();
  MortarIntegrals<double> integrals;
  if (!integrals_of(plane, rule, out, integrals)) return false;
  const PairVariables<double> v{relative(input, plane), input.normal, input.pressure};
  const auto shares = all_shares(input, friction, plane, rule, v, friction.traction, integrals);
  const double* rows[52];
  store_rows(shares, rows);
  for (int r = 0; r < 52; ++r) out.row[r] = *rows[r];
  return true;
}

bool pair_tangent(const PairInput& input, const std::vector<TrianglePoint>& rule, PairTangent& out) {
  using Fad = Sacado::Fad::SFad<double, 40>;
  const auto plane = input.plane();
  MortarIntegrals<Fad> integrals;
  if (!integrals_of<40>(plane, input.frozen.has_value(), rule, out, integrals)) return false;
  const auto v = seeded<40>(input, plane);
  const auto shares = shares_as_read(input, plane, rule, v, integrals);
  const Fad* rows[40];
  store_rows(shares, rows);
  store_derivatives<40>(rows, out);
  return true;
}

bool pair_tangent(const PairInput& input, const PairFriction& friction, const std::vector<TrianglePoint>& rule,
                  FrictionalTangent& out) {
  using Fad = Sacado::Fad::SFad<double, 52>;
  const auto plane = input.plane();
  MortarIntegrals<Fad> integrals;
  if (!integrals_of<52>(plane, input.frozen.has_value(), rule, out, integrals)) return false;
  std::array<Vec3<Fad>, 4> traction;
  for (int k = 0; k < 12; ++k) traction[k / 3][k % 3] = Fad(52, 40 + k, friction.traction[k / 3][k % 3]);
  const auto shares = all_shares(input, friction, plane, rule, seeded<52>(input, plane), traction, integrals);
  const Fad* rows[52];
  store_rows(shares, rows);
  store_derivatives<52>(rows, out);
  return true;
}

void whole_area_tangent(const PairInput& input, double whole_area[4], double d[4][36]) {
  using Planar = Sacado::Fad::SFad<double, 18>;
  const auto plane = input.plane();
  Quad<Planar> facet;
  for (int a = 0; a < 4; ++a) facet[a] = {Planar(18, 2 * a, plane.y[2 * a]), Planar(18, 2 * a + 1, plane.y[2 * a + 1])};
  const auto weights = facet_weights(facet);
  for (int a = 0; a < 4; ++a) {
    whole_area[a] = weights[a].val();
    if (input.frozen) {
      std::fill_n(d[a], 36, 0.0);
    } else {
      plane.pull_back(weights[a].dx(), d[a]);
    }
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
