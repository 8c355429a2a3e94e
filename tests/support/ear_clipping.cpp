#include "tests/support/ear_clipping.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm::shapes {
namespace {

using Number = std::int32_t;

std::int64_t squared_distance(GridPoint a, GridPoint b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// One path through all loops: a hole is entered and left by the same bridge.
class Bridges {
 public:
  explicit Bridges(const std::vector<Loop>& loops) {
    for (const Loop& loop : loops) {
      std::vector<Number> numbers;
      for (const GridPoint& p : loop) {
        numbers.push_back(static_cast<Number>(points_.size()));
        points_.push_back(p);
      }
      loops_.push_back(std::move(numbers));
    }
    path_ = loops_.front();
    // From the right, so that some corner of the path is seen from each hole's rightmost one.
    std::vector<std::size_t> holes(loops_.size() - 1);
    std::iota(holes.begin(), holes.end(), 1U);
    std::stable_sort(holes.begin(), holes.end(), [this](std::size_t a, std::size_t b) {
      return points_[at(rightmost(loops_[a]))].x > points_[at(rightmost(loops_[b]))].x;
    });
    for (const std::size_t hole : holes) join(hole);
  }

  const std::vector<GridPoint>& points() const { return points_; }
  const std::vector<Number>& path() const { return path_; }

 private:
  Number rightmost(const std::vector<Number>& loop) const {
    return *std::max_element(loop.begin(), loop.end(), [this](Number a, Number b) {
      return points_[at(a)].x < points_[at(b)].x;
    });
  }

  bool is_clear_of(const std::vector<Number>& loop, Number from, Number to) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Number a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a == from || a == to || b == from || b == to) continue;
      if (segments_touch(points_[at(a)], points_[at(b)], points_[at(from)], points_[at(to)])) {
        return false;
      }
    }
    return true;
  }

  /// Whether `p` is seen from the path's place strictly between its two sides, on the left.
  bool is_ahead(std::size_t place, GridPoint p) const {
    const GridPoint before = points_[at(path_[(place + path_.size() - 1) % path_.size()])];
    const GridPoint here = points_[at(path_[place])];
    const GridPoint after = points_[at(path_[(place + 1) % path_.size()])];
    const bool left_of_first = turn(before, here, p) > 0, left_of_second = turn(here, after, p) > 0;
    return turn(before, here, after) > 0 ? left_of_first && left_of_second
                                         : left_of_first || left_of_second;
  }

  void join(std::size_t hole) {
    std::vector<Number>& loop = loops_[hole];
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), rightmost(loop)), loop.end());
    const Number from = loop.front();
    const std::size_t place = nearest_seen(from);
    std::vector<Number> way = loop;
    way.push_back(from);
    way.push_back(path_[place]);
    path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(place) + 1, way.begin(), way.end());
    loop.clear();
  }

  std::size_t nearest_seen(Number from) const {
    using Candidate = std::pair<std::int64_t, std::size_t>;
    Candidate last = {-1, 0};
    for (;;) {
      Candidate best = {std::numeric_limits<std::int64_t>::max(), 0};
      for (std::size_t i = 0; i < path_.size(); ++i) {
        const Candidate here = {squared_distance(points_[at(path_[i])], points_[at(from)]), i};
        if (here > last && here < best) best = here;
      }
      TF_CHECK(best.first < std::numeric_limits<std::int64_t>::max());
      if (is_seen(best.second, from)) return best.second;
      last = best;
    }
  }

  bool is_seen(std::size_t place, Number from) const {
    const Number to = path_[place];
    return is_ahead(place, points_[at(from)]) && is_clear_of(path_, from, to) &&
           std::all_of(loops_.begin() + 1, loops_.end(),
                       [&](const auto& loop) { return is_clear_of(loop, from, to); });
  }

  std::vector<GridPoint> points_;
  std::vector<std::vector<Number>> loops_;  // holes that are joined are empty
  std::vector<Number> path_;
};

class Ears {
 public:
  Ears(const Bridges& bridges, EarOrder order)
      : points_(bridges.points()), path_(bridges.path()), order_(order) {
    const auto n = static_cast<Number>(path_.size());
    for (Number i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
      is_left_.push_back(true);
    }
    find_all();
  }

  std::vector<std::array<std::int32_t, 3>> clip() {
    std::vector<std::array<std::int32_t, 3>> triangles;
    auto left = path_.size();
    for (Number last = 0; left > 3; --left) {
      // What hid an ear may be gone.
      if (ears_.empty()) find_all();
      TF_CHECK(!ears_.empty());
      auto place = order_ == EarOrder::next ? ears_.upper_bound(last) : ears_.begin();
      if (place == ears_.end()) place = ears_.begin();
      last = *place;
      triangles.push_back(triangle(last));
      remove(last);
    }
    Number rest = 0;
    while (!is_left_[at(rest)]) ++rest;
    triangles.push_back(triangle(rest));
    TF_CHECK(turn(point(previous_[at(rest)]), point(rest), point(next_[at(rest)])) > 0);
    return triangles;
  }

 private:
  const GridPoint& point(Number place) const { return points_[at(path_[at(place)])]; }

  std::array<std::int32_t, 3> triangle(Number place) const {
    return {path_[at(previous_[at(place)])], path_[at(place)], path_[at(next_[at(place)])]};
  }

  std::int64_t turn_at(Number place) const {
    return turn(point(previous_[at(place)]), point(place), point(next_[at(place)]));
  }

  void remove(Number place) {
    const Number before = previous_[at(place)], after = next_[at(place)];
    is_left_[at(place)] = false;
    ears_.erase(place);
    next_[at(before)] = after;
    previous_[at(after)] = before;
    for (const Number beside : {before, after}) {
      if (turn_at(beside) > 0) std::erase(blunt_, beside);
    }
    for (const Number beside : {before, after}) {
      ears_.erase(beside);
      if (is_ear(beside)) ears_.insert(beside);
    }
  }

  void find_all() {
    blunt_.clear();
    for (Number i = 0; i < static_cast<Number>(path_.size()); ++i) {
      if (is_left_[at(i)] && turn_at(i) <= 0) blunt_.push_back(i);
    }
    for (Number i = 0; i < static_cast<Number>(path_.size()); ++i) {
      if (is_left_[at(i)] && is_ear(i)) ears_.insert(i);
    }
  }

  /// No other corner in the closed triangle: only reflex and straight ones can be the first there.
  bool is_ear(Number place) const {
    const GridPoint a = point(previous_[at(place)]), b = point(place), c = point(next_[at(place)]);
    if (turn(a, b, c) <= 0) return false;
    const std::int64_t low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
    const std::int64_t low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
    return std::none_of(blunt_.begin(), blunt_.end(), [&](Number other) {
      const GridPoint& p = point(other);
      if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) return false;
      if (p == a || p == b || p == c) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

  const std::vector<GridPoint>& points_;
  const std::vector<Number>& path_;
  EarOrder order_;
  std::vector<Number> next_, previous_;
  std::vector<bool> is_left_;
  std::vector<Number> blunt_;  // places that turn right or not at all
  std::set<Number> ears_;
};

}  // namespace

std::vector<std::array<std::int32_t, 3>> clip_ears(const std::vector<Loop>& loops, EarOrder order) {
  const Bridges bridges(loops);
  return Ears(bridges, order).clip();
}

}  // namespace tetfarm::shapes
