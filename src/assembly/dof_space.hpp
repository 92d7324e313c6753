// Unknowns and where they live: positions of nodes, pressures of secondary contact nodes, unknowns of elements and springs.
#pragma once

#include <vector>

#include "assembly/tpetra.hpp"
#include "mesh/partition.hpp"
#include "scene.hpp"

namespace mortise {

/// A point is what carries unknowns: node n is point n (3 unknowns), multiplier k is point n_nodes + k (1 unknown, a pressure; 4
/// with friction, a pressure and a traction; 3 of ties, a traction), and after the multipliers come the pressures of mixed
/// elements (1 unknown each), then augmented springs (2 unknowns each). Global numbers: in the order of points, so 3 n + i for
/// positions. A rank's *overlap* holds its own points first, then copies of all points its elements touch, of the far ends of
/// springs that begin at its own nodes, and of all contact-surface points (first version of ghosting: their positions are on
/// every rank).
class DofSpace {
 public:
  DofSpace(const Scene& scene, const Partition& partition, const RCP<const Comm>& comm);

  int n_nodes() const { return n_nodes_; }
  int n_unknowns() const { return static_cast<int>(first_.back()); }  ///< of all ranks
  int n_points() const { return static_cast<int>(local_.size()); }
  int size(int point) const { return static_cast<int>(first_[point + 1] - first_[point]); }
  bool is_node(int point) const { return point < n_nodes_; }
  GlobalIndex global(int point) const { return first_[point]; }

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
  int n_nodes_, n_owned_ = 0, n_owned_positions_ = 0;
  std::vector<GlobalIndex> first_;  // of each point, and at the end the number of all
  std::vector<int> local_, overlap_points_;
  RCP<const Map> owned_map_, overlap_map_;
  RCP<const Import> importer_;
};

}  // namespace mortise
