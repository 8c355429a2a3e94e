/// The boundary faces of a listed mesh for whose cells is looked (listed_mesh.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetfarm {

/// Those with N nodes. In memory: 8 (N + 1) bytes and a bit for each.
template <std::size_t N>
class UnclaimedFaces {
 public:
  using Face = std::array<std::int64_t, N>;

  template <class Listed>
  explicit UnclaimedFaces(const std::vector<Listed>& faces) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      by_nodes_.emplace_back(turned(faces[f].nodes), f);
    }
    std::sort(by_nodes_.begin(), by_nodes_.end());
    is_taken_.resize(by_nodes_.size(), false);
  }

  /// Appends the face of a cell if it is one of these. Of several equal ones the first goes to the
  /// first who asks.
  void give(const Face& nodes, std::vector<std::size_t>& to) {
    const Face face = turned(nodes);
    auto found =
        std::lower_bound(by_nodes_.begin(), by_nodes_.end(), std::pair(face, std::size_t{0}));
    for (; found != by_nodes_.end() && found->first == face; ++found) {
      if (is_taken_[found->second]) continue;
      is_taken_[found->second] = true;
      to.push_back(found->second);
      return;
    }
  }

  /// Those that nobody got, ascending.
  std::vector<std::size_t> rest() const {
    std::vector<std::size_t> left;
    for (std::size_t f = 0; f < is_taken_.size(); ++f) {
      if (!is_taken_[f]) left.push_back(f);
    }
    return left;
  }

 private:
  /// The smallest number first, turning the same way round.
  static Face turned(Face face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  std::vector<std::pair<Face, std::size_t>> by_nodes_;  ///< sorted; with its number
  std::vector<bool> is_taken_;                          ///< by its number
};

}  // namespace tetfarm
