// Axis-aligned boxes and a tree of them: which facets may meet.
#pragma once

#include <vector>

#include "physics/tensor.hpp"

namespace mortise {

/// Axis-aligned box; starts empty.
struct Box {
  double low[3] = {1e300, 1e300, 1e300};
  double high[3] = {-1e300, -1e300, -1e300};

  void include(const Vec3<double>& x);
  void include(const Box& other);
  void widen(double by);
  bool overlaps(const Box& other) const;
};

/// A binary tree over boxes, split at the median of the longest axis. Answers do not depend on anything but the boxes and their
/// order.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Indices of all boxes that overlap `box`, ascending.
  std::vector<int> query(const Box& box) const;

 private:
  struct Node {
    Box box;
    int first, last;  // range of order_ in a leaf
    int left = -1, right = -1;
  };
  int build(int first, int last);

  std::vector<Box> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace mortise
