// Elements of one type: their nodes, one element after the other.
#pragma once

#include <cassert>
#include <iterator>

#include "mesh/topology.hpp"

namespace mortise {

/// Nodes of one element within a list; 0-based indices into Mesh::coordinates, in Exodus order.
template <class Int>
struct NodeSpan {
  Int* first;
  std::size_t n;
  Int* begin() const { return first; }
  Int* end() const { return first + n; }
  std::size_t size() const { return n; }
  Int& operator[](std::size_t a) const { return first[a]; }
  template <class Other>
  bool operator==(const Other& other) const {
    return std::equal(begin(), end(), std::begin(other), std::end(other));
  }
};
using ElementNodeList = NodeSpan<const int>;

/// A list of elements, each seen as a span of its nodes.
class ElementList {
 public:
  explicit ElementList(ElementType type = ElementType::hex8) : type_(type) {}

  ElementType type() const { return type_; }
  std::size_t n_nodes() const { return static_cast<std::size_t>(topology(type_).n_nodes); }  ///< of each element
  std::size_t size() const { return nodes_.size() / n_nodes(); }
  bool empty() const { return nodes_.empty(); }

  ElementNodeList operator[](std::size_t e) const { return {nodes_.data() + e * n_nodes(), n_nodes()}; }
  NodeSpan<int> operator[](std::size_t e) { return {nodes_.data() + e * n_nodes(), n_nodes()}; }

  /// Appends an element. @param element as many nodes as the type has
  template <class Nodes>
  void push_back(const Nodes& element) {
    assert(std::size(element) == n_nodes());
    nodes_.insert(nodes_.end(), std::begin(element), std::end(element));
  }
  void push_back(std::initializer_list<int> element) { push_back<std::initializer_list<int>>(element); }

  /// The elements from number `begin` to before `end`.
  ElementList part(std::size_t begin, std::size_t end) const {
    ElementList some(type_);
    some.nodes_.assign(nodes_.begin() + static_cast<long>(begin * n_nodes()),
                       nodes_.begin() + static_cast<long>(end * n_nodes()));
    return some;
  }

  /// Forgets all elements from number `n` on.
  void resize(std::size_t n) { nodes_.resize(n * n_nodes()); }

  const std::vector<int>& nodes() const { return nodes_; }
  std::vector<int>& nodes() { return nodes_; }  ///< a multiple of n_nodes()

  template <class List>
  class Iterator {
   public:
    Iterator(List& list, std::size_t e) : list_(&list), e_(e) {}
    auto operator*() const { return (*list_)[e_]; }
    Iterator& operator++() { return ++e_, *this; }
    bool operator!=(const Iterator& other) const { return e_ != other.e_; }

   private:
    List* list_;
    std::size_t e_;
  };
  Iterator<const ElementList> begin() const { return {*this, 0}; }
  Iterator<const ElementList> end() const { return {*this, size()}; }
  Iterator<ElementList> begin() { return {*this, 0}; }
  Iterator<ElementList> end() { return {*this, size()}; }

  bool operator==(const ElementList& other) const { return type_ == other.type_ && nodes_ == other.nodes_; }

 private:
  ElementType type_;
  std::vector<int> nodes_;
};

}  // namespace mortise
