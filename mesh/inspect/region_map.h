/// The regions into which a surface divides space, and where in them a point lies.
///
/// Source: the sheets of surface_sides.h. Each part of the surface (joined over edges) has one
/// sheet that faces outward, of negative volume; it bounds the region in which the part lies, which
/// is found by counting what a ray from the part passes (shifted_ray.h). The others bound a region
/// each.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/inspect/surface_sides.h"

namespace tetfarm {

/// Regions are numbered from 1 by their first side; 0 is the outside.
class RegionMap {
 public:
  /// @pre as join_sides; the surface outlives the map.
  /// Cost: O(n log n), and for each part the triangles along a ray.
  RegionMap(const SurfaceMesh& surface, SurfaceSides sides);

  std::int32_t regions() const { return static_cast<std::int32_t>(volume_.size()) - 1; }
  Sides sides_of(std::size_t triangle) const;
  /// Of a region; of the outside: minus that of all else.
  double volume(std::int32_t region) const { return volume_[at(region)]; }
  /// How many parts lie round the region.
  int depth(std::int32_t region) const { return depth_[at(region)]; }

  struct Part {
    std::vector<std::int32_t> triangles;
    double volume = 0;         ///< that it encloses
    std::int32_t parent = -1;  ///< the part round it that is nearest
    int depth = 0;             ///< how many parts are round it
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// A part with several sheets that face outward: its regions cannot be told apart.
  std::optional<std::int32_t> unclear_part() const { return unclear_part_; }

  /// Nothing when the point is on the surface. Cost: the triangles along a ray.
  std::optional<std::int32_t> region_at(const Vec3& p) const;

 private:
  void measure_sheets();
  void gather_parts();
  void place_parts();
  void number_regions();
  Vec3 start_of_ray(std::int32_t part) const;
  std::vector<std::int32_t> sheets_round(const Vec3& p, std::int32_t but_not_part) const;

  const SurfaceMesh& surface_;
  SurfaceSides sides_;
  BoxTree tree_;
  std::vector<double> sheet_volume_;
  std::vector<std::int32_t> sheet2part_;
  std::vector<std::int32_t> sheet2region_;
  std::vector<std::int32_t> vertex2part_;   // -2: of several
  std::vector<std::int32_t> part2outside_;  // the sheet round a part
  std::vector<std::vector<std::int32_t>> sheets_round_part_;
  std::vector<Part> parts_;
  std::vector<double> volume_;
  std::vector<int> depth_;
  std::optional<std::int32_t> unclear_part_;
};

}  // namespace tetfarm
