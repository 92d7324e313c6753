// A saddle-point matrix taken apart into the blocks of positions and pressures.
#pragma once

#include <array>
#include <vector>

#include "assembly/tpetra.hpp"

namespace mortise {

/// The blocks of  [ K B1 ; B2 C ]  as matrices of their own, with the global numbers of the whole. Their graphs and maps are made
/// once per graph of the whole; after that only values are copied.
class BlockSplit {
 public:
  /// @param n_positions unknowns with a global number below are positions, the others pressures
  BlockSplit(const RCP<const Map>& map, GlobalIndex n_positions);

  /// Copies the values of A. Collective. @return whether the graph is another one than the last time
  bool take(const Matrix& A);

  /// Position (0) or pressure (1) part of the unknowns of this rank.
  const RCP<const Map>& map(int part) const { return maps_[part]; }
  GlobalIndex n_pressures() const { return n_pressures_; }  ///< on all ranks

  RCP<Matrix> K() const { return blocks_[0][0].matrix; }
  RCP<Matrix> B1() const { return blocks_[0][1].matrix; }  ///< forces by pressures
  RCP<Matrix> B2() const { return blocks_[1][0].matrix; }  ///< gaps by positions
  RCP<Matrix> C() const { return blocks_[1][1].matrix; }

  void restrict_to(int part, const Vector& whole, Vector& v) const;
  void extend(int part, const Vector& v, Vector& whole) const;

 private:
  struct Block {
    RCP<Matrix> matrix;
    Kokkos::View<double*, Kokkos::HostSpace> values;
    std::vector<std::size_t> source;  // entry of the whole for each entry of the block
  };
  void take_graph(const Matrix& A);

  GlobalIndex n_positions_, n_pressures_;
  std::array<std::vector<int>, 2> rows_;  // local rows of each part
  std::array<RCP<const Map>, 2> maps_;
  std::array<std::array<Block, 2>, 2> blocks_;
  RCP<const Graph> graph_;  // held, so that its address is not given to another one
};

}  // namespace mortise
