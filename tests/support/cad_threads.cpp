#include <algorithm>
#include <array>
#include <utility>

#include "tests/support/cad_families.h"
#include "tests/support/revolved.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

/// A ridge that climbs by `rise` from each corner of the ring to the next. Rows run along it; those
/// of one winding follow those of the one below, and the ring is closed by a step of one winding.
///
/// Valid because each row has one radius, so that a half-plane through the axis meets the rows
/// between two corners in the same order as at the corners, with steps greater than `rise`.
class ThreadMaker {
 public:
  ThreadMaker(Loop ring, std::vector<RevolvedRow> profile, int windings, std::int64_t rise,
              Chance& chance)
      : ring_(std::move(ring)),
        profile_(std::move(profile)),
        rows_(static_cast<std::int32_t>(profile_.size()) * windings + 1),
        rise_(rise),
        chance_(chance) {}

  /// With smooth ends of `root` below and above.
  SurfaceMesh make(std::int64_t root, std::int64_t end, EndCap cap) {
    const auto n = count();
    const std::int64_t pitch = n * rise_;
    const auto per_winding = static_cast<std::int32_t>(profile_.size());
    const std::int32_t low = add_ring(root, [end](std::int32_t) { return -end; });
    const auto rows_z = [&](std::int32_t row) {
      return (row / per_winding) * pitch + profile_[static_cast<std::size_t>(row % per_winding)].z;
    };
    for (std::int32_t row = 0; row < rows_; ++row) {
      add_ring(profile_[static_cast<std::size_t>(row % per_winding)].radius,
               [&](std::int32_t k) { return rows_z(row) + k * rise_; });
    }
    const std::int64_t top = rows_z(rows_ - 1) + pitch + end;
    const std::int32_t high = add_ring(root, [top](std::int32_t) { return top; });
    for (std::int32_t k = 0; k + 1 < n; ++k) {
      add_quad(mesh_, {low + k, low + k + 1, node(0, k + 1), node(0, k)}, chance_.coin());
      for (std::int32_t row = 0; row + 1 < rows_; ++row) add_patch(row, k);
      add_quad(mesh_, {node(rows_ - 1, k), node(rows_ - 1, k + 1), high + k + 1, high + k},
               chance_.coin());
    }
    add_closing_column(per_winding, low, high);
    add_end_cap(mesh_, low, n, cap, true);
    add_end_cap(mesh_, high, n, cap, false);
    return with_one_patch(std::move(mesh_));
  }

 private:
  std::int32_t count() const { return static_cast<std::int32_t>(ring_.size()); }
  std::int32_t node(std::int32_t row, std::int32_t k) const { return (row + 1) * count() + k; }

  template <class Height>
  std::int32_t add_ring(std::int64_t radius, const Height& height) {
    const auto first = static_cast<std::int32_t>(mesh_.vertices.size());
    for (std::int32_t k = 0; k < count(); ++k) {
      const GridPoint p = radius * ring_[static_cast<std::size_t>(k)];
      mesh_.vertices.push_back(
          {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(height(k))});
    }
    return first;
  }

  void add_patch(std::int32_t row, std::int32_t k) {
    add_quad(mesh_, {node(row, k), node(row, k + 1), node(row + 1, k + 1), node(row + 1, k)},
             chance_.coin());
  }

  /// From the last corner to the first, where everything is a winding higher: the ridge begins with
  /// a flat face there.
  void add_closing_column(std::int32_t per_winding, std::int32_t low, std::int32_t high) {
    const std::int32_t last = count() - 1;
    mesh_.triangles.push_back({low + last, low, node(0, last)});
    mesh_.triangles.push_back({node(0, last), low, node(0, 0)});
    mesh_.triangles.push_back({node(0, last), node(0, 0), node(per_winding, 0)});
    for (std::int32_t row = 0; row + per_winding + 1 < rows_; ++row) {
      const std::int32_t above = row + per_winding;
      add_quad(mesh_, {node(row, last), node(above, 0), node(above + 1, 0), node(row + 1, last)},
               chance_.coin());
    }
    // The last winding runs out into one node.
    for (std::int32_t row = rows_ - 1 - per_winding; row + 1 < rows_; ++row) {
      mesh_.triangles.push_back({node(row, last), node(rows_ - 1, 0), node(row + 1, last)});
    }
    mesh_.triangles.push_back({node(rows_ - 1, last), node(rows_ - 1, 0), high});
    mesh_.triangles.push_back({node(rows_ - 1, last), high, high + last});
    for (std::int32_t row = 1; row < per_winding; ++row) {
      mesh_.triangles.push_back({node(0, 0), node(row, 0), node(row + 1, 0)});
    }
  }

  Loop ring_;
  std::vector<RevolvedRow> profile_;  // of one winding: the first is the root, the others stand out
  std::int32_t rows_;
  std::int64_t rise_;
  Chance& chance_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh thread(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick_of({{{6, 7}, {6, 12}, {12, 36}, {36, 100}}}, size);
  const int windings = chance.pick_of({{{1, 1}, {1, 3}, {1, 8}, {1, 12}}}, size);
  const std::int64_t radius = 1 << 16;
  const std::int64_t root = chance.pick(2, 20);
  const std::int64_t rise = std::max<std::int64_t>(
      6, std::llround(static_cast<double>(root * radius) * chance.small(-2, 0)) / n);
  const std::int64_t part = rise * n / 6;
  std::vector<RevolvedRow> profile = {{root, 0}, {root + 1, chance.pick(1, 3) * part}};
  if (chance.coin()) profile.push_back({root + 1, profile.back().z + part});
  const std::int64_t end = chance.pick(1, 1000) * part;
  const EndCap cap = any_cap(chance);
  return ThreadMaker(circle(n, radius), profile, windings, rise, chance).make(root, end, cap);
}

}  // namespace tetfarm::shapes
