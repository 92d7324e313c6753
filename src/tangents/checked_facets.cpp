// The facet pairs of a contact pair, as the tangent check sees them.
#include <fmt/format.h>

#include <algorithm>

#include "assembly/element_tangent.hpp"
#include "tangents/checked_term.hpp"
#include "tangents/facet_pair.hpp"

namespace mortise {
namespace {

constexpr int n = FacetPair::n_pressures;
using Unknowns = std::array<double, n>;

/// A secondary facet, what lies opposite, and how far that may be away.
struct Facets {
  const StepProblem& problem;
  const MortarTerm& term;
  const double* x;
  std::vector<Vec3<double>> normals;  ///< of all secondary nodes

  Vec3<double> position(int node) const {
    const double* q = x + problem.dofs().local(node);
    return {q[0], q[1], q[2]};
  }
  Box box(const std::array<int, 4>& facet, double widened) const {
    Box box;
    for (int node : facet) box.include(position(node));
    box.widen(widened);
    return box;
  }

  Unknowns unknowns(int secondary, int primary) const {
    const ContactPair& pair = term.pair();
    Unknowns y{};
    for (int a = 0; a < 4; ++a) {
      const int node = pair.secondary.facets[secondary][a];
      const auto k =
          std::lower_bound(pair.secondary_nodes.begin(), pair.secondary_nodes.end(), node) - pair.secondary_nodes.begin();
      const auto x1 = position(node), x2 = position(pair.primary.facets[primary][a]);
      for (int i = 0; i < 3; ++i) {
        y[3 * a + i] = x1[i];
        y[12 + 3 * a + i] = x2[i];
        y[24 + 3 * a + i] = normals[k][i];
      }
      y[36 + a] = x[problem.dofs().local(term.pressure_point(k))];
    }
    return y;
  }
};

// Facets that face each other, as far apart as contact counts, over at least a hundredth of the secondary one: of less, round-off
// would be judged.
bool is_worth_checking(const ContactPair& pair, const std::vector<TrianglePoint>& rule, const Unknowns& y) {
  const auto at = [&](int a) { return Vec3<double>{y[3 * a], y[3 * a + 1], y[3 * a + 2]}; };
  const Vec3<double> first = cross(at(2) - at(0), at(3) - at(1)), other = cross(at(6) - at(4), at(7) - at(5));
  if (!(dot(first, other) < 0)) return false;
  double r[n] = {};
  if (!FacetPair::add_residual(rule, FacetPair{}, y.data(), r)) return false;
  const double covered = r[40] + r[41] + r[42] + r[43], gap = r[36] + r[37] + r[38] + r[39];
  return covered > 0.01 * 0.5 * norm(first) && std::abs(gap) <= std::max(pair.size, pair.primary_size) * covered;
}

}  // namespace

CheckedTerm checked_facets(const StepProblem& problem, const MortarTerm& term, const Partition& partition, int most) {
  const Scene& scene = problem.scene();
  const ContactPair& pair = term.pair();
  const long long n_primary = static_cast<long long>(pair.primary.facets.size());
  const int n_secondary = static_cast<int>(pair.secondary.facets.size()), stride = stride_for(n_secondary, most);

  CheckedTerm checked;
  checked.name = fmt::format("contact \"{}\" (mortar, {})", pair.name, pair.friction ? "without its friction" : "frictionless");
  checked.pieces_name = "secondary facets, with all primary ones opposite";
  checked.ways = {{TangentKind::quadrature_point, "AD in stages"},
                  {TangentKind::whole_element, "whole AD"},
                  {TangentKind::complex_step, "complex step"},
                  {TangentKind::central_differences, "central differences"},
                  {TangentKind::forward_differences, "forward differences"},
                  {TangentKind::backward_differences, "backward differences"}};
  checked.reference = TangentKind::whole_element;
  checked.time_unit = TangentKind::quadrature_point;
  checked.has_kinks = true;
  checked.n_pieces = n_secondary;
  checked.n_chosen = (n_secondary + stride - 1) / stride;
  checked.describe = [&scene, &pair, n_primary](long long key) {
    return fmt::format("facet of {} with the primary facet at {}",
                       describe_element(scene.mesh, pair.secondary_elements[key / n_primary]),
                       describe_node(scene.mesh, pair.primary.facets[key % n_primary][0]));
  };
  checked.pieces = [&problem, &term, &pair, &partition, n_primary, n_secondary, stride](const double* x) {
    const auto& rule = triangle_rule(pair.quadrature_degree);
    const int rank = problem.dofs().comm()->getRank();
    const double farthest = std::max(pair.size, pair.primary_size);
    const Facets facets{problem, term, x, term.normals(x)};
    std::vector<Box> boxes;
    for (const auto& facet : pair.primary.facets) boxes.push_back(facets.box(facet, 0));
    const BoxTree tree(std::move(boxes));
    std::vector<double> scale(n, pair.size);
    std::fill(&scale[24], &scale[36], 1.0);
    std::fill(&scale[36], &scale[40], pair.youngs_modulus);
    std::fill(&scale[40], &scale[44], pair.youngs_modulus * pair.size);
    std::vector<Piece> pieces;
    for (int s = 0; s < n_secondary; s += stride) {
      if (partition.element_rank[pair.secondary_elements[s]] != rank) continue;
      for (int p : tree.query(facets.box(pair.secondary.facets[s], farthest))) {
        const Unknowns y = facets.unknowns(s, p);
        if (!is_worth_checking(pair, rule, y)) continue;
        Piece piece{s * n_primary + p, scale, 0, {}};
        for (int k = 0; k < n; ++k) piece.magnitude = std::max(piece.magnitude, std::abs(y[k]) / scale[k]);
        piece.tangent = [y, &rule, scale](TangentKind kind, double relative_step, double* K) {
          double r[n] = {};
          std::fill_n(K, n * n, 0.0);
          return element_tangent<FacetPair>(kind, relative_step, rule, FacetPair{}, y.data(), scale.data(), r, K);
        };
        pieces.push_back(std::move(piece));
      }
    }
    return pieces;
  };
  return checked;
}

}  // namespace mortise
