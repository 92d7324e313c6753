// The sparse tangent: a graph made of cells, values added cell by cell, shares of other ranks summed by one export.
#pragma once

#include <vector>

#include "assembly/dof_space.hpp"

namespace mortise {

/// Points that are coupled with each other: the nodes of an element, or all that one secondary facet may meet.
using Cell = std::vector<int>;

/// Values of one graph. The graph is made once per list of cells; entries that are not hit stay explicit zeros.
class SystemMatrix {
 public:
  /// Pressures couple with positions and with themselves, not with each other.
  SystemMatrix(const DofSpace& dofs, const std::vector<Cell>& cells);

  void zero();

  /// Adds a dense matrix over the unknowns of cell `c` (number in the constructor's list), row-major.
  void add(std::size_t c, const double* K);

  /// Adds to the diagonal entry of an owned or ghost unknown (overlap local index).
  void add_diagonal(int local, double value) { values_(diagonal_[local]) += value; }

  /// The matrix on the owned rows: sums the shares of all ranks in fixed order. Collective.
  RCP<Matrix> assemble();

 private:
  struct Scatter {
    std::vector<int> size;    // unknowns per point of the cell
    std::vector<int> start;   // n x n: index in values_ of the first entry of block (a, b); -1: not coupled
    std::vector<int> stride;  // row length of point a
  };
  const DofSpace& dofs_;
  Kokkos::View<double*, Kokkos::HostSpace> values_;
  std::vector<int> diagonal_;
  std::vector<Scatter> scatter_;
  RCP<Matrix> overlap_, owned_;
  RCP<const Export> exporter_;
};

}  // namespace mortise
