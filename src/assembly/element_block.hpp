// Elements of one formulation and one material: gather, evaluate, scatter.
#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include "assembly/element_tangent.hpp"
#include "assembly/material_law.hpp"
#include "assembly/system_matrix.hpp"
#include "physics/condensation.hpp"
#include "physics/formulations/energy_momentum.hpp"
#include "physics/formulations/standard.hpp"

namespace mortise {

/// The state at one quadrature point, for output.
struct PointSample {
  int element;  ///< number over all blocks
  int point;    ///< of the stiffness rule
  PointState state;
  double JxW;        ///< [m^3]
  const int* nodes;  ///< of the element
  const double* N;   ///< their shape functions at the point
  int n_nodes;
};

/// Elements that this rank owns. Unknowns are read and forces added at local ids that are found once.
template <class Formulation>
class ElementBlock {
 public:
  using Element = typename Formulation::Element;
  static constexpr int n_nodes = Element::n_nodes, n_pressures = Formulation::n_pressures;
  static constexpr bool has_discrete_gradient = std::is_same_v<Formulation, Standard<Element>>;

  ElementBlock(const MaterialLaw& law, TangentKind kind) : law_(law), kind_(kind), stiffness_(shear_modulus(law)) {}

  /// Nodes, then the points that carry the pressures.
  using Points = std::array<int, n_nodes + n_pressures>;

  /// @param points of the scene, @param local where their unknowns begin in vectors, @param X reference positions of the nodes
  /// [m]
  void append(int element, const Points& points, const Points& local, const ElementNodes<Element>& X) {
    elements_.push_back(element);
    points_.push_back(points);
    local_.push_back(local);
    geometry_.push_back(Formulation::geometry(X));
  }

  void append_cells(std::vector<Cell>& cells) {
    first_cell_ = cells.size();
    for (const auto& points : points_) cells.emplace_back(points.begin(), points.end());
  }

  std::size_t size() const { return elements_.size(); }
  int element(std::size_t e) const { return elements_[e]; }  ///< number over all blocks
  static constexpr int n_unknowns() { return n_global; }     ///< of an element, without local ones
  /// What is kept per element [bytes], without the matrix.
  static constexpr std::size_t bytes_per_element() {
    return sizeof(typename Formulation::Geometry) + 2 * sizeof(Points) + sizeof(int);
  }

  /// Adds the internal force (and the rows of pressures); all at local ids of the overlap. @return false: inadmissible
  bool add_force(const double* x, double* f) const {
    for (std::size_t e = 0; e < size(); ++e) {
      double y[n_all], r[n_all] = {};
      gather(e, x, y);
      if constexpr (Formulation::n_local == 0) {
        if (!Formulation::add_residual(law_, geometry_[e], y, r)) return false;
      } else {
        double K[n_all * n_all];
        if (!equilibrate(e, y, r, K)) return false;
      }
      scatter(e, r, f);
    }
    return true;
  }

  /// @param factor on the columns of positions
  bool add_tangent(const double* x, double factor, double* f, SystemMatrix& matrix) const {
    for (std::size_t e = 0; e < size(); ++e) {
      double r[n_global], K[n_global * n_global];
      if (!tangent(kind_, best_step(kind_), law_, e, x, r, K)) return false;
      scatter(e, r, f);
      if (factor != 1) scale_columns(factor, K);
      matrix.add(first_cell_ + e, K);
    }
    return true;
  }

  /// Energy-momentum force of a step from `x_n` to `x`. @throws std::logic_error if the formulation has none
  bool add_algorithmic_force(const double* x_n, const double* x, double* f) const {
    if constexpr (has_discrete_gradient) {
      for (std::size_t e = 0; e < size(); ++e) {
        double y_n[n_all], y[n_all], r[n_all] = {};
        gather(e, x_n, y_n);
        gather(e, x, y);
        if (!EnergyMomentum<Element>::add_residual(since(y_n), geometry_[e], y, r)) return false;
        scatter(e, r, f);
      }
      return true;
    } else {
      throw std::logic_error("a formulation without a discrete gradient");
    }
  }

  bool add_algorithmic_tangent(const double* x_n, const double* x, double* f, SystemMatrix& matrix) const {
    if constexpr (has_discrete_gradient) {
      for (std::size_t e = 0; e < size(); ++e) {
        double y_n[n_all], y[n_all], r[n_all] = {}, K[n_all * n_all] = {};
        gather(e, x_n, y_n);
        gather(e, x, y);
        const std::array<double, n_all> scale = takes_steps(kind_) ? scales(e) : std::array<double, n_all>{};
        if (!element_tangent<EnergyMomentum<Element>>(kind_, best_step(kind_), since(y_n), geometry_[e], y, scale.data(), r, K))
          return false;
        scatter(e, r, f);
        matrix.add(first_cell_ + e, K);
      }
      return true;
    } else {
      throw std::logic_error("a formulation without a discrete gradient");
    }
  }

  /// Residual and tangent of one element by any kind, local unknowns eliminated; overwrites r and K.
  /// @param relative_step  of complex step and differences: see `best_step`
  bool tangent(TangentKind kind, double relative_step, const MaterialLaw& law, std::size_t e, const double* x, double* r,
               double* K) const {
    double y[n_all];
    gather(e, x, y);
    if constexpr (Formulation::n_local == 0) {
      std::fill_n(r, n_global, 0.0);
      std::fill_n(K, n_global * n_global, 0.0);
      return differentiate(kind, relative_step, law, e, y, r, K);
    } else {
      double r_all[n_all], K_all[n_all * n_all];
      if (!equilibrate(e, y, r_all, K_all)) return false;
      const bool is_at_points = kind == TangentKind::quadrature_point || kind == TangentKind::analytic;
      if (!is_at_points || &law != &law_) {  // otherwise it has been found on the way
        std::fill_n(r_all, n_all, 0.0);
        std::fill_n(K_all, n_all * n_all, 0.0);
        if (!differentiate(kind, relative_step, law, e, y, r_all, K_all)) return false;
      }
      return condense<n_global, Formulation::n_local>(K_all, r_all, K, r);
    }
  }

  /// [J]
  double strain_energy(const double* x) const {
    double energy = 0;
    for (std::size_t e = 0; e < size(); ++e) {
      double y[n_all];
      settled(e, x, y);
      energy += Formulation::strain_energy(law_, geometry_[e], y);
    }
    return energy;
  }

  /// Calls `take` for every quadrature point.
  void sample(const double* x, const std::function<void(const PointSample&)>& take) const {
    for (std::size_t e = 0; e < size(); ++e) {
      double y[n_all], N[n_nodes];
      settled(e, x, y);
      for (int g = 0; g < geometry_[e].n_points; ++g) {
        for (int a = 0; a < n_nodes; ++a) N[a] = Element::N(a, Element::stiffness_rule[g].xi);
        const PointState state = Formulation::point(law_, geometry_[e], g, y);
        take({elements_[e], g, state, geometry_[e].JxW[g], points_[e].data(), N, n_nodes});
      }
    }
  }

  const MaterialLaw& law() const { return law_; }

  /// Size of each unknown of an element, for steps and for comparing entries of its tangent: edge [m], shear modulus [Pa], 1.
  std::array<double, Count<Formulation>::all> scales(std::size_t e) const {
    std::array<double, n_all> scale;
    const double size = std::cbrt(volume<Element>(geometry_[e]));
    for (int k = 0; k < n_all; ++k) scale[k] = k < 3 * n_nodes ? size : k < n_global ? stiffness_ : 1;
    return scale;
  }

  /// The unknowns of an element at `x`, without local ones.
  std::vector<double> unknowns(std::size_t e, const double* x) const {
    double y[n_all];
    gather(e, x, y);
    return {y, y + n_global};
  }

  const Points& points(std::size_t e) const { return points_[e]; }

 private:
  static constexpr int n_global = Count<Formulation>::global, n_all = Count<Formulation>::all;

  typename EnergyMomentum<Element>::template Since<MaterialLaw> since(const double* y_n) const { return {law_, y_n}; }

  static void scale_columns(double factor, double* K) {
    for (int r = 0; r < n_global; ++r)
      for (int c = 0; c < 3 * n_nodes; ++c) K[r * n_global + c] *= factor;
  }

  void gather(std::size_t e, const double* x, double* y) const {
    for (int a = 0; a < n_nodes; ++a)
      for (int i = 0; i < 3; ++i) y[3 * a + i] = x[local_[e][a] + i];
    for (int m = 0; m < n_pressures; ++m) y[3 * n_nodes + m] = x[local_[e][n_nodes + m]];
    for (int k = n_global; k < n_all; ++k) y[k] = 0;
  }

  void scatter(std::size_t e, const double* r, double* f) const {
    for (int a = 0; a < n_nodes; ++a)
      for (int i = 0; i < 3; ++i) f[local_[e][a] + i] += r[3 * a + i];
    for (int m = 0; m < n_pressures; ++m) f[local_[e][n_nodes + m]] += r[3 * n_nodes + m];
  }

  bool differentiate(TangentKind kind, double relative_step, const MaterialLaw& law, std::size_t e, const double* y, double* r,
                     double* K) const {
    const std::array<double, n_all> scale = takes_steps(kind) ? scales(e) : std::array<double, n_all>{};
    return element_tangent<Formulation>(kind, relative_step, law, geometry_[e], y, scale.data(), r, K);
  }

  /// Gathers, and solves for the local unknowns.
  void settled(std::size_t e, const double* x, double* y) const {
    gather(e, x, y);
    if constexpr (Formulation::n_local > 0) {
      double r[n_all], K[n_all * n_all];
      equilibrate(e, y, r, K);
    }
  }

  /// Local unknowns by Newton's method, always from zero: they are a function of the positions, so that no history hides in them.
  bool equilibrate(std::size_t e, double* y, double* r, double* K) const {
    constexpr int m = n_all - n_global;
    bool is_last = false;
    for (int iteration = 0; iteration < 20; ++iteration) {
      std::fill_n(r, n_all, 0.0);
      std::fill_n(K, n_all * n_all, 0.0);
      if (!Formulation::add_tangent(law_, geometry_[e], y, r, K)) return false;
      if (is_last) return true;
      double step[m];
      if (!local_step<n_global, m>(K, r, step)) return false;
      double greatest = 0;
      for (int k = 0; k < m; ++k) {
        y[n_global + k] += step[k];
        greatest = std::max(greatest, std::abs(step[k]));
      }
      is_last = greatest < 1e-9;  // Newton's next error is its square; the unknowns are strains
    }
    return false;
  }

  static double shear_modulus(const MaterialLaw& law) {
    Tensor3<double> P;
    double A[9][9];
    law.moduli(identity<double>(), P, A);
    return A[1][1];  // dP_12/dF_12 at rest
  }

  MaterialLaw law_;
  TangentKind kind_;
  double stiffness_;
  std::vector<int> elements_;
  std::vector<Points> points_, local_;
  std::vector<typename Formulation::Geometry> geometry_;
  std::size_t first_cell_ = 0;
};

}  // namespace mortise
