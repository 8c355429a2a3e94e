#include "mesh/decompose/work_estimate.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/decompose/surface_topology.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

constexpr double largest_cell_in_spacings = 3;
constexpr double smallest_cell_in_spacings = 0.4;
constexpr std::size_t enough_cells = 3500;
constexpr int most_levels = 24;
constexpr int most_roots_per_axis = 32;

/// Position in halves of the finest possible cell, counted in the sub-domain's box.
using Key = std::array<std::uint32_t, 3>;

struct PendingCell {
  Vec3 low;
  int level = 0;
  Key low_key{};
};

struct Cell {
  Vec3 centre;
  std::uint64_t row = 0;  // cells with equal numbers have the same y and z
  std::uint32_t x_key = 0;
  int level = 0;
  double spacing = 0;
};

/// Root cells are nearly cubes that fill the box exactly, so that no cell hangs over a flat side.
struct RootGrid {
  Box3 box;
  std::array<int, 3> count{};
  Vec3 cell;
};

RootGrid make_root_grid(const Box3& box) {
  RootGrid grid{box, {}, {}};
  const Vec3 size = box.size();
  const double shortest = std::max(std::min({size.x, size.y, size.z}),
                                   std::max({size.x, size.y, size.z}) / most_roots_per_axis);
  for (int axis = 0; axis < 3; ++axis) {
    grid.count[idx(axis)] = std::max(1, static_cast<int>(size[axis] / shortest + 0.5));
    grid.cell[axis] = size[axis] / grid.count[idx(axis)];
  }
  return grid;
}

Vec3 cell_size(const RootGrid& grid, int level) {
  return grid.cell / static_cast<double>(1U << static_cast<unsigned>(level));
}

/// The cells of an octree in which none is larger than `in_spacings` times the spacing at its
/// centre.
std::vector<Cell> fill_with_cells(const RootGrid& grid, const SpacingField& spacing,
                                  double in_spacings) {
  std::vector<Cell> cells;
  std::vector<PendingCell> stack;
  constexpr std::uint32_t root_key = 1U << (most_levels + 1);
  for (int i = grid.count[0] - 1; i >= 0; --i) {
    for (int j = grid.count[1] - 1; j >= 0; --j) {
      for (int k = grid.count[2] - 1; k >= 0; --k) {
        const auto key = [](int n) { return static_cast<std::uint32_t>(n) * root_key; };
        stack.push_back({grid.box.low + Vec3{i * grid.cell.x, j * grid.cell.y, k * grid.cell.z},
                         0,
                         {key(i), key(j), key(k)}});
      }
    }
  }
  while (!stack.empty()) {
    const PendingCell cell = stack.back();
    stack.pop_back();
    const Vec3 size = cell_size(grid, cell.level);
    const Vec3 centre = cell.low + 0.5 * size;
    const double h = spacing.at(centre);
    const std::uint32_t half = root_key >> static_cast<unsigned>(cell.level + 1);
    if (cell.level == most_levels || std::max({size.x, size.y, size.z}) <= in_spacings * h) {
      const std::uint64_t row = static_cast<std::uint64_t>(cell.low_key[1] + half) << 32U |
                                static_cast<std::uint64_t>(cell.low_key[2] + half);
      cells.push_back({centre, row, cell.low_key[0] + half, cell.level, h});
      continue;
    }
    for (unsigned child = 8; child-- > 0;) {
      PendingCell smaller = cell;
      ++smaller.level;
      for (int axis = 0; axis < 3; ++axis) {
        if ((child >> static_cast<unsigned>(axis) & 1U) == 0) continue;
        smaller.low[axis] = centre[axis];
        smaller.low_key[idx(axis)] += half;
      }
      stack.push_back(smaller);
    }
  }
  return cells;
}

std::vector<Cell> fill_with_enough_cells(const RootGrid& grid, const SpacingField& spacing) {
  double in_spacings = largest_cell_in_spacings;
  std::vector<Cell> cells = fill_with_cells(grid, spacing, in_spacings);
  double expected = static_cast<double>(cells.size());
  bool is_finer = false;
  while (expected < static_cast<double>(enough_cells) && in_spacings > smallest_cell_in_spacings) {
    in_spacings *= 0.8;
    expected /= 0.8 * 0.8 * 0.8;
    is_finer = true;
  }
  return is_finer ? fill_with_cells(grid, spacing, in_spacings) : cells;
}

struct Crossing {
  double x = 0;
  int step = 0;  // +1: the ray goes in, -1: it comes out
};

/// Whether the ray that goes up z from p, in the (y, z) projection, crosses the edge ab, and which
/// way: the half-open rule, and the same sign for both uses of an edge, so that triangles tile the
/// projection.
int upward_crossing(const Vec3& a, const Vec3& b, double y, double z) {
  const bool a_is_right = a.y > y;
  if (a_is_right == (b.y > y)) return 0;
  const Vec3& left = a_is_right ? b : a;
  const Vec3& right = a_is_right ? a : b;
  const bool is_below_edge = orient2d({left.y, left.z}, {right.y, right.z}, {y, z}) < 0;
  if (!is_below_edge) return 0;
  return a_is_right ? 1 : -1;
}

/// A row of cells along x, and where the line through their centres crosses the surface.
struct Column {
  double y = 0;
  double z = 0;
  std::size_t first_cell = 0;
  std::size_t last_cell = 0;
  std::vector<Crossing> crossings;
};

/// @pre cells are ordered by row.
std::vector<Column> find_columns(const std::vector<Cell>& cells) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i == 0 || cells[i].row != cells[i - 1].row) {
      columns.push_back({cells[i].centre.y, cells[i].centre.z, i, i, {}});
    }
    columns.back().last_cell = i + 1;
  }
  return columns;
}

/// Finds the crossings of all columns, by x.
void cross_surface(const Subdomain& subdomain, std::vector<Column>& columns) {
  std::vector<Box3> points;
  for (const Column& column : columns)
    points.push_back({{0, column.y, column.z}, {0, column.y, column.z}});
  const BoxTree tree(points);
  for (const Triangle& triangle : subdomain.triangles) {
    const Vec3& a = subdomain.vertices[idx(triangle[0])];
    const Vec3& b = subdomain.vertices[idx(triangle[1])];
    const Vec3& c = subdomain.vertices[idx(triangle[2])];
    const double low = std::min({a.x, b.x, c.x});
    const double high = std::max({a.x, b.x, c.x});
    const Vec3 normal = cross(b - a, c - a);
    const Box3 shadow{{0, std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                      {0, std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
    tree.query(shadow, [&](std::int32_t i) {
      Column& column = columns[idx(i)];
      const double y = column.y;
      const double z = column.z;
      const int turns =
          upward_crossing(a, b, y, z) + upward_crossing(b, c, y, z) + upward_crossing(c, a, y, z);
      if (turns == 0) return;
      const double x = a.x - (normal.y * (y - a.y) + normal.z * (z - a.z)) / normal.x;
      // A nearly vertical triangle may give anything, even a NaN: any point of it will do.
      column.crossings.push_back({x >= low && x <= high ? x : 0.5 * (low + high), -turns});
    });
  }
  for (Column& column : columns) {
    std::sort(column.crossings.begin(), column.crossings.end(),
              [](const Crossing& p, const Crossing& q) {
                return p.x != q.x ? p.x < q.x : p.step > q.step;
              });
  }
}

struct Interval {
  double low = 0;
  double high = 0;
};

std::vector<Interval> inside_intervals(const std::vector<Crossing>& crossings) {
  std::vector<Interval> inside;
  int depth = 0;
  for (const Crossing& crossing : crossings) {
    if (depth <= 0 && depth + crossing.step > 0) inside.push_back({crossing.x, crossing.x});
    if (depth > 0 && depth + crossing.step <= 0) inside.back().high = crossing.x;
    depth += crossing.step;
  }
  return inside;
}

/// Adds the part of each cell of one row that is inside. `cells` are ordered by x.
void sample_row(std::span<const Cell> cells, const std::vector<Interval>& inside,
                const RootGrid& grid, WorkSamples& work) {
  std::size_t next = 0;
  for (const Cell& cell : cells) {
    const Vec3 size = cell_size(grid, cell.level);
    const double low = cell.centre.x - 0.5 * size.x;
    const double high = cell.centre.x + 0.5 * size.x;
    while (next < inside.size() && inside[next].high <= low) ++next;
    double length = 0;
    double moment = 0;
    for (std::size_t i = next; i < inside.size() && inside[i].low < high; ++i) {
      const double from = std::max(low, inside[i].low);
      const double to = std::min(high, inside[i].high);
      length += to - from;
      moment += (to - from) * 0.5 * (from + to);
    }
    if (length <= 0) continue;
    const double h = cell.spacing;
    const double elements = SpacingField::elements_per_h3 * length * size.y * size.z / (h * h * h);
    work.samples.push_back(
        {{moment / length, cell.centre.y, cell.centre.z}, elements, h, {length, size.y, size.z}});
    work.total += elements;
  }
}

}  // namespace

WorkSamples sample_work(const Subdomain& subdomain, const SpacingField& spacing) {
  const RootGrid grid = make_root_grid(bounding_box(subdomain.vertices));
  std::vector<Cell> cells = fill_with_enough_cells(grid, spacing);
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.row != b.row ? a.row < b.row : a.x_key < b.x_key;
  });
  std::vector<Column> columns = find_columns(cells);
  cross_surface(subdomain, columns);
  WorkSamples work;
  for (const Column& column : columns) {
    sample_row(std::span(cells).subspan(column.first_cell, column.last_cell - column.first_cell),
               inside_intervals(column.crossings), grid, work);
  }
  return work;
}

double estimated_elements(const Subdomain& subdomain, const SpacingField& spacing) {
  if (subdomain.region > 0) return sample_work(subdomain, spacing).total;
  double sum = 0;
  for (const std::int32_t region : regions_of(subdomain)) {
    sum += sample_work(part_of_regions(subdomain, {region}, subdomain.path), spacing).total;
  }
  return sum;
}

}  // namespace tetfarm
