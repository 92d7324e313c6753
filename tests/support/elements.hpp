// Elements to test on: distorted, with straight edges, as blocks of one element.
#pragma once

#include <gtest/gtest.h>

#include "assembly/body_term.hpp"
#include "support/random.hpp"

namespace mortise::test {

/// All formulations on all elements that have them.
using Formulations = ::testing::Types<Standard<Hex8>, Standard<Hex20>, Standard<Hex27>, Standard<Tet4>, Standard<Tet10>,
                                      Standard<Wedge6>, FBar<Hex8>, Enhanced<Hex8>, Mixed<Hex8, 1>, Mixed<Hex27, 4>>;

/// The linear element with the same corners.
template <class Element>
struct CornersOf {
  using type = Hex8;
};
template <>
struct CornersOf<Tet4> {
  using type = Tet4;
};
template <>
struct CornersOf<Tet10> {
  using type = Tet4;
};
template <>
struct CornersOf<Wedge6> {
  using type = Wedge6;
};

/// Corners out of place by up to `size`, and the other nodes where straight edges have them.
template <class Element>
ElementNodes<Element> distorted(Random& random, double size) {
  using Linear = typename CornersOf<Element>::type;
  ElementNodes<Linear> corners;
  for (int a = 0; a < Linear::n_nodes; ++a)
    for (int i = 0; i < 3; ++i) corners[a][i] = Linear::node[a][i] + random.in(-size, size);
  ElementNodes<Element> X{};
  for (int a = 0; a < Element::n_nodes; ++a)
    for (int b = 0; b < Linear::n_nodes; ++b)
      for (int i = 0; i < 3; ++i)
        X[a][i] += Linear::N(b, {Element::node[a][0], Element::node[a][1], Element::node[a][2]}) * corners[b][i];
  return X;
}

/// A body of one element; its unknowns: positions, then pressures.
template <class Formulation>
struct OneElement {
  using Element = typename Formulation::Element;
  using Block = ElementBlock<Formulation>;
  static constexpr int n = Count<Formulation>::global;
  ElementNodes<Element> X;
  Block block;

  OneElement(const MaterialLaw& law, const ElementNodes<Element>& nodes) : X(nodes), block(law, TangentKind::quadrature_point) {
    typename Block::Points points{};
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] = static_cast<int>(k) < Element::n_nodes ? 3 * static_cast<int>(k) : static_cast<int>(k) + 2 * Element::n_nodes;
    block.append(0, points, points, X);
  }

  std::vector<double> at_rest() const {
    std::vector<double> x(n, 0.0);
    for (int k = 0; k < 3 * Element::n_nodes; ++k) x[k] = X[k / 3][k % 3];
    return x;
  }

  /// A deformation of some 20 %, and pressures.
  std::vector<double> deformed(Random& random, double pressure) const {
    auto x = at_rest();
    Tensor3<double> F = identity<double>();
    for (int k = 0; k < 9; ++k) F(k / 3, k % 3) += random.in(-0.15, 0.15);
    for (int a = 0; a < Element::n_nodes; ++a)
      for (int i = 0; i < 3; ++i)
        x[3 * a + i] = F(i, 0) * X[a][0] + F(i, 1) * X[a][1] + F(i, 2) * X[a][2] + random.in(-0.03, 0.03);
    for (int k = 3 * Element::n_nodes; k < n; ++k) x[k] = random.in(-pressure, pressure);
    return x;
  }

  std::vector<double> residual(const std::vector<double>& x) const {
    std::vector<double> r(n, 0.0);
    return block.add_force(x.data(), r.data()) ? r : std::vector<double>{};
  }

  /// Row-major; empty if the state is inadmissible.
  std::vector<double> tangent(TangentKind kind, const MaterialLaw& law, const std::vector<double>& x) const {
    std::vector<double> r(n), K(n * n);
    return block.tangent(kind, best_step(kind), law, 0, x.data(), r.data(), K.data()) ? K : std::vector<double>{};
  }
};

}  // namespace mortise::test
