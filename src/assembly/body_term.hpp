// The internal force of one body as a term of the scene, and what is derived from its state.
#pragma once

#include <variant>
#include <vector>

#include "assembly/element_block.hpp"
#include "assembly/formulations.hpp"
#include "scene.hpp"

namespace mortise {

/// Internal force of the elements of one body that this rank owns: a block for each type of element.
class BodyTerm {
 public:
  BodyTerm(const Scene& scene, const Body& body, const Partition& partition, const DofSpace& dofs);

  /// One cell per element, appended; `add_tangent` counts from there.
  void append_cells(std::vector<Cell>& cells);

  /// Adds f_int(x) to `f` (both on the overlap). @return false if a state is inadmissible on this rank
  bool add_force(const double* x, double* f) const;

  /// The same, and K = df_int/dx into the matrix. @param factor on the columns of positions: dx/dq of the time scheme
  bool add_tangent(const double* x, double factor, double* f, SystemMatrix& K) const;

  /// Adds the energy-momentum force of a step from `x_n` to `x` (thesis eq. 5.61), and its derivative with respect to `x`.
  /// Precondition: standard elements (the deck reader sees to it).
  bool add_algorithmic_force(const double* x_n, const double* x, double* f) const;
  bool add_algorithmic_tangent(const double* x_n, const double* x, double* f, SystemMatrix& K) const;

  /// The tangent is the same at every state: elements without unknowns or means of their own, and a stress that is linear in F.
  bool has_constant_tangent() const;

  /// Strain energy of this rank's elements [J].
  double strain_energy(const double* x) const;

  /// Calls `take` for every quadrature point of this rank's elements.
  void sample(const double* x, const std::function<void(const PointSample&)>& take) const;

  std::size_t n_elements() const;
  std::size_t bytes() const;  ///< kept for the elements of this rank, without the matrix
  const Body& body() const { return body_; }

  using Block = std::variant<ElementBlock<Standard<Hex8>>, ElementBlock<Standard<Hex20>>, ElementBlock<Standard<Hex27>>,
                             ElementBlock<Standard<Tet4>>, ElementBlock<Standard<Tet10>>, ElementBlock<Standard<Wedge6>>,
                             ElementBlock<FBar<Hex8>>, ElementBlock<Enhanced<Hex8>>, ElementBlock<Mixed<Hex8, 1>>,
                             ElementBlock<Mixed<Hex27, 4>>>;
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  const Body& body_;
  std::vector<Block> blocks_;
};

/// The law by which a body's elements see its material.
MaterialLaw law_of(const Body& body, TangentKind tangent);

}  // namespace mortise
