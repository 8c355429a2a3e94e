#include "dashboard/fewer_triangles.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t finest_grid = 4096;  // cells along the longest side of the box

using CellOfVertex = std::vector<std::uint64_t>;

/// The cell of each vertex in a grid with `cells` of them along the longest side.
CellOfVertex cells_of(const std::vector<Vec3>& vertices, const Box3& box, std::uint64_t cells) {
  const Vec3 size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  const double scale = longest > 0 ? static_cast<double>(cells) / longest : 0;
  const auto place = [&](double from_low) {
    return std::min(cells - 1, static_cast<std::uint64_t>(std::max(0.0, from_low * scale)));
  };
  CellOfVertex found;
  found.reserve(vertices.size());
  for (const Vec3& vertex : vertices) {
    const Vec3 from = vertex - box.low;
    found.push_back((place(from.x) * cells + place(from.y)) * cells + place(from.z));
  }
  return found;
}

bool has_three_cells(const Triangle& triangle, const CellOfVertex& cells) {
  const std::uint64_t a = cells[at(triangle[0])];
  const std::uint64_t b = cells[at(triangle[1])];
  const std::uint64_t c = cells[at(triangle[2])];
  return a != b && b != c && c != a;
}

std::size_t count_left(const std::vector<Triangle>& triangles, const CellOfVertex& cells) {
  return static_cast<std::size_t>(
      std::count_if(triangles.begin(), triangles.end(),
                    [&](const Triangle& triangle) { return has_three_cells(triangle, cells); }));
}

/// Of the finest grid that leaves few enough.
CellOfVertex finest_cells(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                          std::size_t most) {
  Box3 box;
  for (const Vec3& vertex : vertices) box.add(vertex);
  std::uint64_t low = 1;  // one cell leaves none
  std::uint64_t high = finest_grid + 1;
  CellOfVertex best = cells_of(vertices, box, low);
  while (high - low > 1) {
    const std::uint64_t middle = (low + high) / 2;
    CellOfVertex cells = cells_of(vertices, box, middle);
    const bool are_few = count_left(triangles, cells) <= most;
    if (are_few) best = std::move(cells);
    (are_few ? low : high) = middle;
  }
  return best;
}

/// Numbers without gaps in place of cells; fills in the means of the cells.
std::vector<std::int32_t> number_cells(const std::vector<Vec3>& vertices, const CellOfVertex& cells,
                                       std::vector<Vec3>& means) {
  CellOfVertex used = cells;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<double> counts(used.size());
  means.assign(used.size(), Vec3{});
  std::vector<std::int32_t> number_of_vertex;
  number_of_vertex.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto cell = std::lower_bound(used.begin(), used.end(), cells[i]) - used.begin();
    number_of_vertex.push_back(static_cast<std::int32_t>(cell));
    means[at(cell)] += vertices[i];
    counts[at(cell)] += 1;
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] = means[i] / counts[i];
  return number_of_vertex;
}

/// Of several triangles between the same three cells the first stays.
void drop_doubles(FewerTriangles& left) {
  std::vector<Triangle> sorted = left.triangles;
  for (Triangle& triangle : sorted) std::sort(triangle.begin(), triangle.end());
  std::vector<std::size_t> order(sorted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sorted[a] < sorted[b]; });
  std::vector<char> is_double(sorted.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (sorted[order[i]] == sorted[order[i - 1]]) is_double[order[i]] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (is_double[i] != 0) continue;
    left.triangles[kept] = left.triangles[i];
    left.was[kept++] = left.was[i];
  }
  left.triangles.resize(kept);
  left.was.resize(kept);
}

/// Vertices that no triangle has go.
void drop_unused(FewerTriangles& left) {
  std::vector<std::int32_t> number(left.vertices.size(), -1);
  std::vector<Vec3> used;
  for (Triangle& triangle : left.triangles) {
    for (std::int32_t& corner : triangle) {
      std::int32_t& known = number[at(corner)];
      if (known < 0) {
        known = static_cast<std::int32_t>(used.size());
        used.push_back(left.vertices[at(corner)]);
      }
      corner = known;
    }
  }
  left.vertices = std::move(used);
}

}  // namespace

FewerTriangles fewer_triangles(const std::vector<Vec3>& vertices,
                               const std::vector<Triangle>& triangles, std::size_t most) {
  FewerTriangles left;
  if (triangles.size() <= most) {
    left = {vertices, triangles, std::vector<std::uint32_t>(triangles.size())};
    std::iota(left.was.begin(), left.was.end(), 0U);
    return left;
  }
  const CellOfVertex cells = finest_cells(vertices, triangles, most);
  const std::vector<std::int32_t> numbers = number_cells(vertices, cells, left.vertices);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!has_three_cells(triangles[i], cells)) continue;
    const auto& [a, b, c] = triangles[i];
    left.triangles.push_back({numbers[at(a)], numbers[at(b)], numbers[at(c)]});
    left.was.push_back(static_cast<std::uint32_t>(i));
  }
  TF_CHECK(left.triangles.size() <= most);
  drop_doubles(left);
  drop_unused(left);
  return left;
}

}  // namespace tetfarm
