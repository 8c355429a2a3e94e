#include "mesh/layers/first_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// Rounds over faces that are off by more than a share of the height that was asked for.
struct Aim {
  double allowed;
  int rounds;
};

/// First as exactly as can be; then, where no lines fulfil that, what is left is shared out so that
/// nothing is far off.
constexpr std::array aims = {Aim{0.01, 100}, Aim{0.09, 300}};

/// No corner of a face is lower than this share.
constexpr double least_at_corner = 0.7;

/// A line that serves all its faces exactly counts as one that is off by so much.
constexpr double least_mobility = 0.05;

/// What is less does not count.
constexpr double negligible = 1e-3;

class Levelling {
 public:
  Levelling(const LineGround& ground, const std::vector<bool>& held, std::vector<Vec3>& along)
      : ground_(ground), along_(along), mobility_(along.size(), 0) {
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (held[i] || along[i] == Vec3{}) continue;
      mobility_[i] = least_mobility;
      for (const std::int32_t face : faces_of(i)) {
        mobility_[i] = std::max(mobility_[i], std::abs(dot(along[i], normal(face)) - 1));
      }
    }
  }

  void level() {
    for (const Aim& aim : aims) level(aim);
  }

 private:
  void level(const Aim& aim) {
    std::set<std::int32_t> open;
    for (std::int32_t face = 0; face < std::ssize(ground_.graph.wall_lines); ++face) {
      open.insert(open.end(), face);
    }
    for (int round = 0; round < aim.rounds && !open.empty(); ++round) {
      std::set<std::int32_t> next;
      for (const std::int32_t face : open) {
        if (!fit(face, aim.allowed)) continue;
        for (const std::int32_t line : ground_.graph.wall_lines[at(face)]) {
          const auto faces = faces_of(at(line));
          next.insert(faces.begin(), faces.end());
        }
      }
      open = std::move(next);
    }
  }

  std::span<const std::int32_t> faces_of(std::size_t line) const {
    return ground_.graph.faces.of(static_cast<std::int32_t>(line));
  }
  const Vec3& normal(std::int32_t face) const { return ground_.normals[at(face)]; }

  /// Returns whether a line had to move.
  bool fit(std::int32_t face, double allowed) {
    const Triangle& lines = ground_.graph.wall_lines[at(face)];
    double sum = 0;
    double mobility = 0;
    for (const std::int32_t line : lines) {
      if (along_[at(line)] == Vec3{}) return false;
      sum += dot(along_[at(line)], normal(face));
      mobility += mobility_[at(line)];
    }
    bool moved = false;
    const double mean = sum / 3;
    const double wanted = std::clamp(mean, 1 - allowed, 1 + allowed);
    if (mean != wanted && mobility > 0) {
      for (const std::int32_t line : lines) {
        move(line, face, 3 * (wanted - mean) * mobility_[at(line)] / mobility);
      }
      moved = std::abs(mean - wanted) > negligible;
    }
    for (const std::int32_t line : lines) {
      const double height = dot(along_[at(line)], normal(face));
      if (height >= least_at_corner || mobility_[at(line)] == 0) continue;
      move(line, face, least_at_corner - height);
      moved = moved || least_at_corner - height > negligible;
    }
    return moved;
  }

  /// So much higher above the face.
  void move(std::int32_t line, std::int32_t face, double higher) {
    Vec3& along = along_[at(line)];
    Vec3 way = normal(face);
    const auto [first, second] = ground_.planes.of_line[at(line)];
    if (second >= 0) {
      way = normalized(along);
    } else if (first >= 0) {
      way = ground_.planes.planes[at(first)].along(way);
    }
    const double gain = dot(way, normal(face));
    if (!(gain > negligible)) return;  // the line cannot get any higher there
    along += higher / gain * way;
  }

  const LineGround& ground_;
  std::vector<Vec3>& along_;
  std::vector<double> mobility_;  // of each line
};

}  // namespace

void level_first_heights(const LineGround& ground, const std::vector<bool>& held,
                         std::vector<Vec3>& along) {
  TF_CHECK(along.size() == ground.graph.feet.size() && held.size() == along.size());
  Levelling(ground, held, along).level();
}

}  // namespace tetfarm
