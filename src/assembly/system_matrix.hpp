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

  /// Back to the constant part: zero as long as nothing was kept.
  void reset();

  /// What has been added so far, on top of the constant part of before, is from now on the constant part.
  void keep_as_constant();

  /// Forgets the constant part, and is zero.
  void clear();

  /// Adds a dense matrix over the unknowns of cell `c` (number in the constructor's list), row-major.
  void add(std::size_t c, const double* K);

  /// Adds to the diagonal entry of an owned or ghost unknown (overlap local index).
  void add_diagonal(int local, double value) { values_(diagonal_[local]) += value; }

  /// The matrix on the owned rows: sums the shares of all ranks in fixed order. Collective.
  RCP<Matrix> assemble();

  std::size_t bytes() const;  ///< of the values, the graph and the places of all cells, on this rank

 private:
  using LocalMatrix = Matrix::local_matrix_device_type;
  void share_rows(const LocalMatrix& local);

  /// A point of a cell: how many unknowns it has, and the length of their rows.
  struct Place {
    int size, stride;
  };
  const DofSpace& dofs_;
  Kokkos::View<double*, Kokkos::HostSpace> values_, constant_;
  std::vector<int> diagonal_;
  // Of cell c: its n points from places_[first_[c]] on, and n x n indices of the first entry of each block (a, b) in values_,
  // -1 where they are not coupled, from starts_[first_start_[c]] on.
  std::vector<std::size_t> first_{0}, first_start_{0};
  std::vector<Place> places_;
  std::vector<int> starts_;
  RCP<Matrix> overlap_;  // of one rank: the matrix itself
  // Of several ranks: the rows that others own, the matrix of the owned rows, and where in it each entry of values_ goes.
  RCP<Matrix> ghost_, owned_;
  std::vector<int> place_in_owned_;
  std::vector<int> of_others_;  // entries of the owned matrix that only other ranks add to
  RCP<const Export> exporter_;
};

}  // namespace mortise
