// Unknowns and where they live: positions of nodes, pressures of secondary contact nodes, unknowns of elements and springs.
#pragma once

#include <algorithm>
#include <vector>

#include "assembly/tpetra.hpp"
#include "mesh/partition.hpp"
#include "scene.hpp"

namespace mortise {

/// A point is what carries unknowns: node n is point n (3 unknowns), multiplier k is point n_nodes + k (1 unknown), and after the
/// multipliers come the pressures of mixed elements (1 unknown each), then augmented springs (2 unknowns each).
/// Global numbers: in the order of points, so 3 n + i for positions, 3 n_nodes + k for multipliers and pressures. A rank's
/// *overlap* holds its own points first, then copies of all points its elements touch, of the far ends of springs that begin at
/// its own nodes, and of all contact-surface points (first version of ghosting: their positions are on every rank).
class DofSpace {
 public:
  DofSpace(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm);

  int n_nodes() const { return n_nodes_; }
  int n_unknowns() const { return static_cast<int>(global(n_points())); }  ///< of all ranks
  int n_points() const { return static_cast<int>(local_.size()); }
  int size(int point) const { return point < n_nodes_ ? 3 : point < first_spring_ ? 1 : 2; }
  GlobalIndex global(int point) const {
    return point < n_nodes_ ? 3LL * point : 2LL * n_nodes_ + point + std::max(0, point - first_spring_);
  }

  /// First local index of a point in the overlap; -1 if it is not on this rank. Owned points come first.
  int local(int point) const { return local_[point]; }
  bool owned(int point) const { return local_[point] >= 0 && local_[point] < n_owned_; }
  const std::vector<int>& overlap_points() const { return overlap_points_; }
  int n_owned() const { return n_owned_; }                      ///< owned unknowns on this rank
  int n_owned_positions() const { return n_owned_positions_; }  ///< the first of them

  RCP<const Map> owned_map() const { return owned_map_; }
  RCP<const Map> overlap_map() const { return overlap_map_; }
  RCP<const Import> importer() const { return importer_; }  ///< owned -> overlap; reversed with ADD it sums shares
  RCP<const Comm> comm() const { return owned_map_->getComm(); }
  std::size_t ghost_bytes() const;  ///< moved by one import on this rank

 private:
  int n_nodes_, first_spring_, n_owned_ = 0, n_owned_positions_ = 0;
  std::vector<int> local_, overlap_points_;
  RCP<const Map> owned_map_, overlap_map_;
  RCP<const Import> importer_;
};

}  // namespace mortise
