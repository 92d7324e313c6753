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
  /// Pressures and unknowns of springs couple with positions and those of their own point, not with other points.
  SystemMatrix(const DofSpace& dofs, const std::vector<Cell>& cells);

  /// Back to the constant part: zero as long as nothing was kept.
  void reset();

  /// What has been added so far, on top of the constant part of before, is from now on the constant part.
  void keep_as_constant();

  /// Forgets the constant part, and is zero.
  void clear();

  /// Adds a dense matrix over the unknowns of cell `c` (number in the constructor's list), row-major.
  void add(std::size_t c, const double* K);

  /// Adds to the diagonal entry of an owned unknown (local index).
  void add_diagonal(int local, double value) { owned_values_[diagonal_[local]] += value; }

  /// The matrix on the owned rows: sums the shares of all ranks in fixed order. Collective.
  RCP<Matrix> assemble();

  std::size_t bytes() const;  ///< of the values, the graph and the places of all cells, on this rank

 private:
  using LocalGraph = Graph::local_graph_device_type;
  void share_rows(const LocalGraph& overlap_rows);
  void find_values();

  /// A point of a cell: whether its rows are those of another rank, its unknowns, and the length of their rows.
  struct Place {
    bool is_ghost;
    int size, stride;
  };
  const DofSpace& dofs_;
  RCP<Matrix> owned_;  // the rows of this rank, where shares are added in place
  RCP<Matrix> ghost_;  // shares of the rows of others; null on one rank
  RCP<const Export> exporter_;
  double *owned_values_ = nullptr, *ghost_values_ = nullptr;
  std::vector<double> owned_constant_, ghost_constant_;  // empty: zero
  std::vector<int> diagonal_;                            // of owned rows, in their values
  // Of cell c: its n points from places_[first_[c]] on, and n x n indices of the first entry of each block (a, b) in the values
  // of the rows of a, -1 where they are not coupled, from starts_[first_start_[c]] on.
  std::vector<std::size_t> first_{0}, first_start_{0};
  std::vector<Place> places_;
  std::vector<int> starts_;
};

}  // namespace mortise
