/// What the parts of a mesh say of its nodes: that numbers run from 0 without gaps, and that a
/// node which several parts have lies at the same place in all of them, bit by bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/formats/external_sort.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

class NodeCheck {
 public:
  /// Reads each part once, without its elements. @throws InvalidInput when a number is negative or
  /// above all that a mesh with so many points could have; what the source throws.
  /// Memory: two bits a node, and `memory_bytes`.
  NodeCheck(const MeshSource& source, const std::filesystem::path& folder,
            std::size_t memory_bytes);

  /// Each part of the source once; calls first(number, place) for each node that no part before
  /// had.
  template <class First>
  void add(const NumberedPart& part, const First& first) {
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      const std::int64_t number = part.local2global[v];
      const auto at = static_cast<std::size_t>(number);
      if (has_several_[at]) shared_.push({number, part.number, part.nodes[v]});
      if (!is_new_[at]) continue;
      is_new_[at] = false;
      first(number, part.nodes[v]);
    }
  }
  /// What is wrong, a line each, at most `most`. Called once, after the last part.
  std::vector<std::string> finish(std::size_t most);
  /// Each once.
  std::int64_t nodes() const { return nodes_; }

 private:
  struct SharedNode {
    std::int64_t number = 0;
    std::int32_t part = 0;
    Vec3 place;
    bool operator<(const SharedNode& other) const {
      return number != other.number ? number < other.number : part < other.part;
    }
  };

  void meet(std::int64_t number);

  std::int64_t nodes_ = 0;
  std::vector<bool> is_new_;  ///< of each number of a node whether `add` has not met it
  std::vector<bool> has_several_;
  std::vector<std::string> gaps_;
  ExternalSort<SharedNode> shared_;
};

}  // namespace tetfarm
