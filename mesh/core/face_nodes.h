/// The nodes of a face of any type, as many as it has, turning one way round.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>

#include "base/check.h"
#include "mesh/core/elements.h"

namespace tetfarm {

/// Invariant: nodes are 0 or more. Faces are compared node by node, one with fewer nodes before
/// those that go on. Copied as bytes.
template <std::signed_integral Node>
class FaceNodes {
 public:
  FaceNodes() { nodes_.fill(none); }
  /// @pre at most most_face_nodes.
  explicit FaceNodes(std::span<const Node> nodes) : FaceNodes() {
    TF_CHECK(nodes.size() <= most_face_nodes);
    std::copy(nodes.begin(), nodes.end(), nodes_.begin());
  }

  std::size_t size() const {
    return static_cast<std::size_t>(std::find(nodes_.begin(), nodes_.end(), none) - nodes_.begin());
  }
  Node* begin() { return nodes_.data(); }
  Node* end() { return nodes_.data() + size(); }
  const Node* begin() const { return nodes_.data(); }
  const Node* end() const { return nodes_.data() + size(); }
  Node operator[](std::size_t i) const { return nodes_[i]; }

  /// Whichever node it begins with and whichever side is seen.
  FaceNodes sorted() const {
    FaceNodes face = *this;
    std::sort(face.begin(), face.end());
    return face;
  }
  /// Whichever node it begins with, seen from this side.
  FaceNodes smallest_first() const {
    FaceNodes face = *this;
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }
  /// Seen from the other side, beginning with the same node. @pre it has nodes.
  FaceNodes turned() const {
    FaceNodes face = *this;
    std::reverse(face.begin() + 1, face.end());
    return face;
  }

  /// The same face by other numbers.
  template <class Number>
  auto renumbered(const Number& number) const {
    FaceNodes<decltype(number(Node{}))> face;
    for (std::size_t k = 0; k < size(); ++k) face.set(k, number(nodes_[k]));
    return face;
  }
  /// @pre k <= size()
  void set(std::size_t k, Node node) { nodes_[k] = node; }

  friend auto operator<=>(const FaceNodes&, const FaceNodes&) = default;

 private:
  static constexpr Node none = -1;
  std::array<Node, most_face_nodes> nodes_;
};

}  // namespace tetfarm
