#include "mesh/healing/loop_filling.h"

#include <limits>

#include "base/check.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

constexpr double impossible_area = std::numeric_limits<double>::infinity();

/// The least area of each part of a loop: from vertex i to vertex k, closed by the edge between.
class LeastAreas {
 public:
  LeastAreas(std::span<const Vec3> vertices, std::span<const std::int32_t> loop,
             const IsTaken& is_taken)
      : vertices_(vertices),
        loop_(loop),
        count_(loop.size()),
        area_(count_ * count_, 0),
        apex_(count_ * count_, 0) {
    for (std::size_t length = 2; length < count_; ++length) {
      for (std::size_t i = 0; i + length < count_; ++i) {
        const std::size_t k = i + length;
        // The last part is closed by an edge of the loop itself.
        const bool is_whole = length + 1 == count_;
        find(i, k, !is_whole && is_taken(loop_[i], loop_[k]));
      }
    }
  }

  std::optional<std::vector<Triangle>> triangles() const {
    if (!(area_[count_ - 1] < impossible_area)) return std::nullopt;
    std::vector<Triangle> made;
    add(0, count_ - 1, made);
    return made;
  }

 private:
  std::size_t at(std::size_t i, std::size_t k) const { return i * count_ + k; }

  double area_of(std::size_t i, std::size_t j, std::size_t k) const {
    const TrianglePoints c = triangle_points(vertices_, {loop_[i], loop_[j], loop_[k]});
    if (is_degenerate(c)) return impossible_area;
    return norm(cross(c[1] - c[0], c[2] - c[0]));
  }

  void find(std::size_t i, std::size_t k, bool is_closed_off) {
    double best = impossible_area;
    std::size_t apex = i + 1;
    for (std::size_t j = i + 1; j < k && !is_closed_off; ++j) {
      const double parts = area_[at(i, j)] + area_[at(j, k)];
      if (!(parts < best)) continue;
      const double sum = parts + area_of(i, j, k);
      if (!(sum < best)) continue;
      best = sum;
      apex = j;
    }
    area_[at(i, k)] = best;
    apex_[at(i, k)] = apex;
  }

  void add(std::size_t i, std::size_t k, std::vector<Triangle>& made) const {
    if (k - i < 2) return;
    const std::size_t j = apex_[at(i, k)];
    made.push_back({loop_[i], loop_[j], loop_[k]});
    add(i, j, made);
    add(j, k, made);
  }

  std::span<const Vec3> vertices_;
  std::span<const std::int32_t> loop_;
  std::size_t count_;
  std::vector<double> area_;
  std::vector<std::size_t> apex_;
};

}  // namespace

std::optional<std::vector<Triangle>> fill_loop(std::span<const Vec3> vertices,
                                               std::span<const std::int32_t> loop,
                                               const IsTaken& is_taken) {
  TF_CHECK(loop.size() >= 3);
  if (loop.size() > longest_loop) return std::nullopt;
  return LeastAreas(vertices, loop, is_taken).triangles();
}

}  // namespace tetfarm
