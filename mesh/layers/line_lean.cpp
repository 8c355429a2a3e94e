#include "mesh/layers/line_lean.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/layers/marching_direction.h"

namespace tetfarm {
namespace {

/// A line keeps so much of what it sees of its worst face.
constexpr double share_of_visibility = 0.6;

/// Rounds in which directions become more like their neighbours'. From the wall on, nodes that are
/// near to each other have to agree to within their distance over the height of all layers.
int rounds_of(Lean lean) { return lean == Lean::from_wall ? 40 : 10; }

/// How much a neighbour so far away counts.
double weight_of(double distance, Lean lean) {
  switch (lean) {
    case Lean::as_nearest:
      return 1 / distance;
    case Lean::from_wall:
      return 1 / (distance * distance);
    default:
      return 1;
  }
}

/// What the neighbours' directions come to; zero where none moves.
Vec3 mean_of_neighbours(const LineGround& ground, const std::vector<Vec3>& directions,
                        std::int32_t line, Lean lean) {
  Vec3 sum;
  for (const std::int32_t n : ground.graph.neighbours.of(line)) {
    const double d = distance(ground.places[at(line)], ground.places[at(n)]);
    sum += directions[at(n)] * weight_of(d, lean);
  }
  return normalized(sum);
}

}  // namespace

std::vector<Sliver> slivers_of(const LineGround& ground) {
  constexpr double largest_share = 0.02;
  std::vector<std::pair<double, Sliver>> slivers;  // by height over longest edge
  for (const Triangle& lines : ground.graph.wall_lines) {
    std::size_t middle = 0;
    const auto place = [&](std::size_t k) { return ground.places[at(lines.at(k % 3))]; };
    const auto opposite = [&](std::size_t k) { return place(k + 2) - place(k + 1); };
    for (std::size_t k = 1; k < 3; ++k) {
      if (norm2(opposite(k)) > norm2(opposite(middle))) middle = k;
    }
    const Vec3 edge = opposite(middle);
    const Vec3 way = place(middle) - place(middle + 1);
    const double height_share = norm(cross(edge, way)) / norm2(edge);
    if (height_share >= largest_share) continue;
    const std::array<std::int32_t, 2> ends = {lines.at((middle + 1) % 3),
                                              lines.at((middle + 2) % 3)};
    slivers.push_back({height_share, {lines.at(middle), ends, dot(edge, way) / norm2(edge)}});
  }
  std::stable_sort(slivers.begin(), slivers.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Sliver> sorted;
  for (const auto& [height_share, sliver] : slivers) sorted.push_back(sliver);
  return sorted;
}

std::vector<Vec3> normals_at(const LineGround& ground, std::size_t line) {
  std::vector<Vec3> round;
  for (const std::int32_t f : ground.graph.faces.of(static_cast<std::int32_t>(line))) {
    round.push_back(ground.normals[at(f)]);
  }
  return round;
}

std::vector<Vec3> leaning(const LineGround& ground, std::span<const Vec3> along, Lean lean) {
  TF_CHECK(along.size() == ground.graph.feet.size() && ground.places.size() == along.size());
  if (lean == Lean::straight || lean == Lean::as_slivers) return {along.begin(), along.end()};
  std::vector<Vec3> directions;
  std::vector<double> least;
  for (std::size_t i = 0; i < along.size(); ++i) {
    directions.push_back(normalized(along[i]));
    least.push_back(share_of_visibility * visibility(directions[i], normals_at(ground, i)));
  }
  for (int round = 0; round < rounds_of(lean); ++round) {
    std::vector<Vec3> smoother = directions;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (directions[i] == Vec3{} || ground.graph.is_of_fan(i)) continue;
      const Vec3 mean = mean_of_neighbours(ground, directions, static_cast<std::int32_t>(i), lean);
      const Vec3 direction = ground.planes.held(i, normalized(directions[i] + mean));
      if (visibility(direction, normals_at(ground, i)) >= least[i]) smoother[i] = direction;
    }
    directions = std::move(smoother);
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i] == Vec3{}) continue;
    if (ground.graph.is_of_fan(i)) {
      directions[i] = along[i];
      continue;
    }
    directions[i] = directions[i] / visibility(directions[i], normals_at(ground, i));
  }
  return directions;
}

}  // namespace tetfarm
