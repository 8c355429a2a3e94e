#include "mesh/inspect/region_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "mesh/inspect/shifted_ray.h"
#include "mesh/inspect/six_volumes.h"

namespace tetfarm {
RegionMap::RegionMap(const SurfaceMesh& surface, SurfaceSides sides)
    : surface_(surface),
      sides_(std::move(sides)),
      tree_(triangle_boxes(surface.vertices, surface.triangles)) {
  measure_sheets();
  TF_CHECK(sides_.side2sheet.size() == 2 * surface.triangles.size());
  TF_CHECK(sides_.triangle2part.size() == surface.triangles.size());
  gather_parts();
  if (unclear_part_) return;
  place_parts();
  number_regions();
}

Sides RegionMap::sides_of(std::size_t triangle) const {
  return {sheet2region_[at(sides_.side2sheet[side_behind(triangle)])],
          sheet2region_[at(sides_.side2sheet[side_in_front(triangle)])]};
}

/// Volumes as seen from the region that the sheet bounds, and the part that each sheet is of.
void RegionMap::measure_sheets() {
  std::vector<long double> sums(at(sides_.sheets), 0);
  sheet2part_.assign(at(sides_.sheets), -1);
  std::vector<Vec3> origin(at(sides_.parts));
  std::vector<bool> has_origin(at(sides_.parts), false);
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    const TrianglePoints points = triangle_points(surface_.vertices, surface_.triangles[t]);
    const std::size_t part = at(sides_.triangle2part[t]);
    if (!has_origin[part]) origin[part] = points[0];
    has_origin[part] = true;
    const long double volume = six_volumes(points, origin[part]);
    const std::size_t behind = at(sides_.side2sheet[side_behind(t)]);
    const std::size_t front = at(sides_.side2sheet[side_in_front(t)]);
    sums[behind] += volume;
    sums[front] -= volume;
    sheet2part_[behind] = sheet2part_[front] = sides_.triangle2part[t];
  }
  for (const long double sum : sums) sheet_volume_.push_back(static_cast<double>(sum / 6));
}

void RegionMap::gather_parts() {
  parts_.resize(at(sides_.parts));
  vertex2part_.assign(surface_.vertices.size(), -1);
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    const std::int32_t part = sides_.triangle2part[t];
    parts_[at(part)].triangles.push_back(static_cast<std::int32_t>(t));
    for (const std::int32_t v : surface_.triangles[t]) {
      std::int32_t& owner = vertex2part_[at(v)];
      owner = owner == -1 || owner == part ? part : -2;
    }
  }
  part2outside_.assign(parts_.size(), -1);
  for (std::size_t sheet = 0; sheet < sheet_volume_.size(); ++sheet) {
    if (sheet_volume_[sheet] > 0) continue;
    std::int32_t& outside = part2outside_[at(sheet2part_[sheet])];
    if (outside >= 0) unclear_part_ = sheet2part_[sheet];
    outside = static_cast<std::int32_t>(sheet);
    parts_[at(sheet2part_[sheet])].volume = -sheet_volume_[sheet];
  }
  const auto none = std::find(part2outside_.begin(), part2outside_.end(), -1);
  if (none != part2outside_.end()) {
    unclear_part_ = static_cast<std::int32_t>(none - part2outside_.begin());
  }
}

/// A vertex of no other part; without one, the centre of a triangle, exact only up to rounding.
Vec3 RegionMap::start_of_ray(std::int32_t part) const {
  TF_CHECK(!parts_[at(part)].triangles.empty());
  for (const std::int32_t t : parts_[at(part)].triangles) {
    for (const std::int32_t v : surface_.triangles[at(t)]) {
      if (vertex2part_[at(v)] == part) return surface_.vertices[at(v)];
    }
  }
  const TrianglePoints first = triangle_points(
      surface_.vertices, surface_.triangles[at(parts_[at(part)].triangles.front())]);
  return (first[0] + first[1] + first[2]) / 3;
}

/// The sheets of positive volume that have p inside: of each part at most one.
std::vector<std::int32_t> RegionMap::sheets_round(const Vec3& p, std::int32_t but_not_part) const {
  std::vector<std::pair<std::int32_t, int>> passed;
  tree_.query({p, {HUGE_VAL, p.y, p.z}}, [&](std::int32_t i) {
    const std::size_t t = at(i);
    if (sides_.triangle2part[t] == but_not_part) return;
    const int way = ray_passes(p, triangle_points(surface_.vertices, surface_.triangles[t]));
    if (way == 0) return;
    passed.emplace_back(sides_.side2sheet[side_behind(t)], way);
    passed.emplace_back(sides_.side2sheet[side_in_front(t)], -way);
  });
  std::sort(passed.begin(), passed.end());
  std::vector<std::int32_t> round;
  for (std::size_t i = 0; i < passed.size();) {
    const std::int32_t sheet = passed[i].first;
    int turns = 0;
    for (; i < passed.size() && passed[i].first == sheet; ++i) turns += passed[i].second;
    if (turns > 0 && sheet_volume_[at(sheet)] > 0) round.push_back(sheet);
  }
  return round;
}

void RegionMap::place_parts() {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    sheets_round_part_.push_back(parts_.size() > 1 ? sheets_round(start_of_ray(part), part)
                                                   : std::vector<std::int32_t>{});
    parts_[i].depth = static_cast<int>(sheets_round_part_[i].size());
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (const std::int32_t sheet : sheets_round_part_[i]) {
      const std::int32_t round = sheet2part_[at(sheet)];
      if (parts_[at(round)].depth == parts_[i].depth - 1) parts_[i].parent = round;
    }
  }
}

/// Sheets of positive volume get regions of their own; those round a part get that of the sheet of
/// the part's parent which has it inside.
void RegionMap::number_regions() {
  volume_.assign(1, 0);
  depth_.assign(1, 0);
  sheet2region_.assign(sheet_volume_.size(), 0);
  for (std::size_t sheet = 0; sheet < sheet_volume_.size(); ++sheet) {
    if (!(sheet_volume_[sheet] > 0)) continue;
    sheet2region_[sheet] = static_cast<std::int32_t>(volume_.size());
    volume_.push_back(0);
    depth_.push_back(parts_[at(sheet2part_[sheet])].depth + 1);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (const std::int32_t sheet : sheets_round_part_[i]) {
      if (sheet2part_[at(sheet)] != parts_[i].parent) continue;
      TF_CHECK(part2outside_[i] >= 0);
      sheet2region_[at(part2outside_[i])] = sheet2region_[at(sheet)];
    }
  }
  for (std::size_t sheet = 0; sheet < sheet_volume_.size(); ++sheet) {
    volume_[at(sheet2region_[sheet])] += sheet_volume_[sheet];
  }
}

std::optional<std::int32_t> RegionMap::region_at(const Vec3& p) const {
  bool is_on_surface = false;
  tree_.query({p, p}, [&](std::int32_t i) {
    is_on_surface = is_on_surface || is_on_triangle(p, triangle_points(surface_.vertices,
                                                                       surface_.triangles[at(i)]));
  });
  if (is_on_surface) return std::nullopt;
  std::int32_t region = 0;
  int deepest = -1;
  for (const std::int32_t sheet : sheets_round(p, -1)) {
    const int depth = parts_[at(sheet2part_[at(sheet)])].depth;
    if (depth <= deepest) continue;
    deepest = depth;
    region = sheet2region_[at(sheet)];
  }
  return region;
}

}  // namespace tetfarm
