#include "tests/support/relief.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

constexpr std::int64_t scale = 64;

/// The points of an outline at one height: of each side its start and the points within it.
struct Rim {
  std::vector<std::vector<std::int32_t>> sides;

  std::vector<std::int32_t> path() const {
    std::vector<std::int32_t> all;
    for (const auto& side : sides) all.insert(all.end(), side.begin(), side.end());
    return all;
  }
  /// With its end, which starts the next.
  std::vector<std::int32_t> side(std::size_t k) const {
    std::vector<std::int32_t> points = sides[k];
    points.push_back(sides[(k + 1) % sides.size()].front());
    return points;
  }
};

class ReliefMaker {
 public:
  ReliefMaker(const ReliefOptions& options, Chance& chance) : options_(options), chance_(chance) {}

  SurfaceMesh make(const Terrace& whole) {
    const Rim bottom = add_rim(whole.outline, 0);
    const Rim top = add_rim(whole.outline, whole.height);
    add_wall(bottom, top);
    holes_in_bottom_ = {};
    add_terrace(whole, top);
    add_level(bottom, holes_in_bottom_, false);
    return with_one_patch(std::move(mesh_));
  }

 private:
  void add_terrace(const Terrace& terrace, const Rim& rim) {
    std::vector<Rim> holes;
    for (const Terrace& inner : terrace.inside) {
      const Rim outside = add_rim(inner.outline, terrace.height);
      holes.push_back(outside);
      if (inner.height == terrace.height) {  // only drawn
        add_terrace(inner, outside);
        continue;
      }
      const Rim inside = add_rim(inner.outline, inner.height);
      add_wall(outside, inside);
      if (inner.height > 0) {
        add_terrace(inner, inside);
      } else {
        TF_CHECK(inner.inside.empty());
        holes_in_bottom_.push_back(inside);
      }
    }
    add_level(rim, holes, true);
  }

  Rim add_rim(const Loop& outline, std::int64_t height) {
    Rim rim;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const GridPoint step = outline[(k + 1) % outline.size()] - outline[k];
      std::set<int> places = {0};
      for (int i = chance_.pick(0, options_.most_splits); i > 0; --i) {
        places.insert(chance_.pick(1, static_cast<int>(scale) - 1));
      }
      rim.sides.emplace_back();
      for (const int place : places) {
        rim.sides.back().push_back(add_point(scale * outline[k] + place * step, height));
      }
    }
    return rim;
  }

  std::int32_t add_point(GridPoint p, std::int64_t height) {
    const int raise = options_.most_raise > 0 ? chance_.pick(0, options_.most_raise) : 0;
    points_.push_back(p);
    mesh_.vertices.push_back({static_cast<double>(p.x), static_cast<double>(p.y),
                              static_cast<double>(scale * height + raise)});
    return static_cast<std::int32_t>(points_.size()) - 1;
  }

  /// From the face outside the outline to the one inside it; looks out when that one is higher.
  void add_wall(const Rim& outside, const Rim& inside) {
    for (std::size_t k = 0; k < outside.sides.size(); ++k) {
      const auto a = outside.side(k), b = inside.side(k);
      for (std::size_t i = 0, j = 0; i + 1 < a.size() || j + 1 < b.size();) {
        const bool is_on_first =
            j + 1 == b.size() || (i + 1 < a.size() && (options_.has_wall_fans || chance_.coin()));
        if (is_on_first) {
          mesh_.triangles.push_back({a[i], a[i + 1], b[j]});
          ++i;
        } else {
          mesh_.triangles.push_back({a[i], b[j + 1], b[j]});
          ++j;
        }
      }
    }
  }

  void add_level(const Rim& rim, const std::vector<Rim>& holes, bool looks_up) {
    std::vector<std::int32_t> numbers = rim.path();
    std::vector<Loop> loops = {points_of(numbers)};
    for (const Rim& hole : holes) {
      std::vector<std::int32_t> path = hole.path();
      std::reverse(path.begin(), path.end());
      loops.push_back(points_of(path));
      numbers.insert(numbers.end(), path.begin(), path.end());
    }
    for (const auto& [a, b, c] : clip_ears(loops, options_.order)) {
      const Triangle up = {numbers[at(a)], numbers[at(b)], numbers[at(c)]};
      mesh_.triangles.push_back(looks_up ? up : Triangle{up[0], up[2], up[1]});
    }
  }

  Loop points_of(const std::vector<std::int32_t>& path) const {
    Loop loop;
    for (const std::int32_t i : path) loop.push_back(points_[at(i)]);
    return loop;
  }

  const ReliefOptions& options_;
  Chance& chance_;
  SurfaceMesh mesh_;
  std::vector<GridPoint> points_;  // of the vertices
  std::vector<Rim> holes_in_bottom_;
};

}  // namespace

SurfaceMesh relief(const Terrace& whole, const ReliefOptions& options, Chance& chance) {
  TF_CHECK(options.most_raise == 0 || options.most_splits == 0);
  return ReliefMaker(options, chance).make(whole);
}

}  // namespace tetfarm::shapes
