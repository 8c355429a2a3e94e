#include "mesh/layers/layer_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/inspect/vtp_text.h"

namespace tetfarm {
namespace {

using WallLines = std::array<const LayerLine*, 3>;

/// Into the domain, of length 1.
Vec3 normal_of(const WallLines& lines) {
  return normalized(cross(lines[2]->at - lines[0]->at, lines[1]->at - lines[0]->at));
}

/// The mean height over the corners of what lies below a level.
double height_of(const WallLines& lines, int level) {
  const Vec3 normal = normal_of(lines);
  double sum = 0;
  for (const LayerLine* line : lines) sum += dot(point_of(*line, level) - line->at, normal);
  return sum / 3;
}

WallLayers layers_of(std::int32_t triangle, const WallLines& lines) {
  const auto by_stop = [](const LayerLine* a, const LayerLine* b) { return a->stop < b->stop; };
  const auto [least, most] = std::minmax_element(lines.begin(), lines.end(), by_stop);
  WallLayers wall;
  wall.triangle = triangle;
  wall.layers = (*least)->stop;
  wall.cells = (*most)->stop;
  wall.first_wanted = (*least)->first_wanted;
  const LayerLine* shortest = nullptr;
  for (const LayerLine* line : lines) {
    wall.wanted = std::max(wall.wanted, line->wanted);
    if (line->reason == StopReason::complete) continue;
    if (shortest == nullptr || line->stop < shortest->stop) shortest = line;
  }
  if (shortest != nullptr) {
    wall.reason = shortest->reason;
    wall.because_of = shortest->because_of;
  }
  if (wall.layers == 0) return wall;
  wall.first_height = height_of(lines, 1);
  wall.total_height = height_of(lines, wall.layers);
  return wall;
}

bool is_within(double height, double wanted, double share) {
  return std::abs(height - wanted) <= share * wanted;
}

}  // namespace

std::vector<WallLayers> wall_layers(const LayerPlan& plan, const SurfaceMesh& surface) {
  TF_CHECK(plan.vertex2line.size() == surface.vertices.size());
  std::vector<WallLayers> walls;
  walls.reserve(plan.wall.size());
  for (const std::int32_t t : plan.wall) {
    WallLines lines{};
    const std::array<std::int32_t, 3> numbers = lines_of(plan, surface, t);
    for (std::size_t k = 0; k < 3; ++k) lines[k] = &plan.lines[at(numbers[k])];
    walls.push_back(layers_of(t, lines));
  }
  return walls;
}

LayerCoverage coverage_of(const std::vector<WallLayers>& walls) {
  LayerCoverage coverage;
  coverage.wall_triangles = std::ssize(walls);
  for (const WallLayers& wall : walls) {
    if (wall.reason == StopReason::complete) {
      ++coverage.full;
    } else {
      ++coverage.short_of_layers[wall.reason];
      coverage.none += wall.cells == 0 ? 1 : 0;
    }
    if (wall.layers == 0) continue;
    ++coverage.with_first;
    coverage.first_within_2 += is_within(wall.first_height, wall.first_wanted, 0.02) ? 1 : 0;
    coverage.first_within_10 += is_within(wall.first_height, wall.first_wanted, 0.1) ? 1 : 0;
  }
  return coverage;
}

std::string layer_map_vtp(const std::vector<WallLayers>& walls, const LayerPlan& plan,
                          const SurfaceMesh& surface) {
  TF_CHECK(walls.size() == plan.wall.size());
  VtpTriangles text;
  for (const StopReason reason : all_stop_reasons) {
    text.legend += "<!-- reason " + std::to_string(static_cast<int>(reason)) + ": " +
                   name_of(reason) + " -->\n";
  }
  for (const LayerLine& line : plan.lines) {
    text.coordinates += shortest_text(line.at.x) + " " + shortest_text(line.at.y) + " " +
                        shortest_text(line.at.z) + "\n";
  }
  text.points = plan.lines.size();
  text.triangles = walls.size();
  text.arrays = {{"Int64", "layers", {}},         {"Int64", "wanted", {}},
                 {"Float64", "first_height", {}}, {"Float64", "first_wanted", {}},
                 {"Float64", "total_height", {}}, {"Int64", "reason", {}},
                 {"Int64", "because_of", {}},     {"Int64", "triangle", {}}};
  for (const WallLayers& wall : walls) {
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, wall.triangle);
    for (const std::int32_t line : lines) text.corners += std::to_string(line) + ' ';
    text.corners.back() = '\n';
    const std::array<std::string, 8> values = {
        std::to_string(wall.layers),      std::to_string(wall.wanted),
        shortest_text(wall.first_height), shortest_text(wall.first_wanted),
        shortest_text(wall.total_height), std::to_string(static_cast<int>(wall.reason)),
        std::to_string(wall.because_of),  std::to_string(wall.triangle)};
    for (std::size_t i = 0; i < values.size(); ++i) text.arrays[i].values += values[i] + '\n';
  }
  return vtp_text(text);
}

}  // namespace tetfarm
