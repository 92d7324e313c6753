#include "contact/bounding_volume.hpp"

#include <algorithm>
#include <numeric>

namespace mortise {

void Box::include(const Vec3<double>& x) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], x[i]);
    high[i] = std::max(high[i], x[i]);
  }
}

void Box::include(const Box& other) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

void Box::widen(double by) {
  for (int i = 0; i < 3; ++i) {
    low[i] -= by;
    high[i] += by;
  }
}

bool Box::overlaps(const Box& other) const {
  for (int i = 0; i < 3; ++i)
    if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
  return true;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
}

int BoxTree::build(int first, int last) {
  constexpr int leaf_size = 4;
  Node node;
  node.first = first;
  node.last = last;
  for (int k = first; k < last; ++k) node.box.include(boxes_[order_[k]]);
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  if (last - first <= leaf_size) return index;
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (node.box.high[i] - node.box.low[i] > node.box.high[axis] - node.box.low[axis]) axis = i;
  const int middle = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
    const double ca = boxes_[a].low[axis] + boxes_[a].high[axis], cb = boxes_[b].low[axis] + boxes_[b].high[axis];
    return ca != cb ? ca < cb : a < b;
  });
  const int left = build(first, middle), right = build(middle, last);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

std::vector<int> BoxTree::query(const Box& box) const {
  std::vector<int> hits, stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!node.box.overlaps(box)) continue;
    if (node.left < 0) {
      for (int k = node.first; k < node.last; ++k)
        if (boxes_[order_[k]].overlaps(box)) hits.push_back(order_[k]);
    } else {
      stack.push_back(node.left);
      stack.push_back(node.right);
    }
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

}  // namespace mortise
