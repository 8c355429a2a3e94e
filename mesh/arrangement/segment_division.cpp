#include "mesh/arrangement/segment_division.h"

#include <algorithm>
#include <cstddef>

namespace tetfarm {
namespace {

/// In the order along a segment, whichever way it runs.
bool lies_before(const ExactPoint& a, const ExactPoint& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int order = cmp(a.at[i], b.at[i]);
    if (order != 0) return order < 0;
  }
  return false;
}

class Division {
 public:
  Division(ExactPoints& points, const std::vector<Segment>& segments, int axis)
      : points_(points), segments_(segments), axis_(axis), on_segment_(segments.size()) {}

  bool find_meets(std::int64_t& pairs_left) {
    struct Extent {
      std::size_t segment;
      Box3 box;
    };
    std::vector<Extent> extents;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      Box3 box;
      for (const std::int32_t end : segments_[s]) box.add(box_round(points_[end]));
      extents.push_back({s, box});
    }
    const int along = (axis_ + 1) % 3;
    std::ranges::stable_sort(extents, {},
                             [&](const Extent& extent) { return extent.box.low[along]; });
    for (std::size_t i = 0; i < extents.size(); ++i) {
      for (std::size_t j = i + 1; j < extents.size(); ++j) {
        if (extents[j].box.low[along] > extents[i].box.high[along]) break;
        if (--pairs_left < 0) return false;
        if (extents[i].box.overlaps(extents[j].box)) meet(extents[i].segment, extents[j].segment);
      }
    }
    return true;
  }

  std::vector<Segment> pieces() {
    std::vector<Segment> all;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (segments_[s][0] == segments_[s][1]) continue;
      std::vector<std::int32_t>& on = on_segment_[s];
      on.insert(on.end(), segments_[s].begin(), segments_[s].end());
      std::ranges::sort(
          on, [&](std::int32_t a, std::int32_t b) { return lies_before(points_[a], points_[b]); });
      on.erase(std::unique(on.begin(), on.end()), on.end());
      for (std::size_t i = 1; i < on.size(); ++i) {
        all.push_back({std::min(on[i - 1], on[i]), std::max(on[i - 1], on[i])});
      }
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  int turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return seen_turn(points_[a], points_[b], points_[c], axis_);
  }

  /// @pre p is on the segment's line.
  void divide_if_inside(std::size_t s, std::int32_t p) {
    const Segment& ends = segments_[s];
    if (p == ends[0] || p == ends[1]) return;
    const bool after_first = lies_before(points_[ends[0]], points_[p]);
    const bool before_second = lies_before(points_[p], points_[ends[1]]);
    if (after_first == before_second) on_segment_[s].push_back(p);
  }

  void meet(std::size_t s, std::size_t t) {
    const auto [a, b] = segments_[s];
    const auto [c, d] = segments_[t];
    const int side_a = a == b && c == d ? 1 : turn(c, d, a);
    const int side_b = a == b ? side_a : turn(c, d, b);
    const int side_c = a == b ? 1 : turn(a, b, c);
    const int side_d = c == d ? side_c : turn(a, b, d);
    if (c != d && side_a == 0) divide_if_inside(t, a);
    if (c != d && side_b == 0) divide_if_inside(t, b);
    if (a != b && side_c == 0) divide_if_inside(s, c);
    if (a != b && side_d == 0) divide_if_inside(s, d);
    if (side_a * side_b >= 0 || side_c * side_d >= 0) return;
    const mpq_class area_a = seen_area(points_[c], points_[d], points_[a], axis_);
    const mpq_class area_b = seen_area(points_[c], points_[d], points_[b], axis_);
    const std::int32_t crossing =
        points_.add(point_between(points_[a], points_[b], area_a / (area_a - area_b)));
    on_segment_[s].push_back(crossing);
    on_segment_[t].push_back(crossing);
  }

  ExactPoints& points_;
  const std::vector<Segment>& segments_;
  int axis_;
  std::vector<std::vector<std::int32_t>> on_segment_;
};

}  // namespace

std::optional<std::vector<Segment>> divide_segments(ExactPoints& points,
                                                    const std::vector<Segment>& segments, int axis,
                                                    std::int64_t& pairs_left) {
  Division division(points, segments, axis);
  if (!division.find_meets(pairs_left)) return std::nullopt;
  return division.pieces();
}

}  // namespace tetfarm
