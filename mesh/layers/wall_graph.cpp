#include "mesh/layers/wall_graph.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

using RowEntry = std::pair<std::int32_t, std::int32_t>;  // the row, and a number of it

NumberRows rows_of(std::vector<RowEntry> entries, std::size_t rows) {
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  NumberRows result;
  result.starts.assign(rows + 1, 0);
  result.numbers.reserve(entries.size());
  for (const auto& [row, number] : entries) {
    ++result.starts[at(row) + 1];
    result.numbers.push_back(number);
  }
  for (std::size_t i = 0; i < rows; ++i) result.starts[i + 1] += result.starts[i];
  return result;
}

/// Lowers values to at most that of a neighbour plus step(line, neighbour), the lowest first.
/// Returns whose value each comes from.
template <class Value, class Step>
std::vector<std::int32_t> lower(const WallGraph& graph, std::vector<Value>& values,
                                const Step& step) {
  TF_CHECK(values.size() == graph.feet.size());
  struct Entry {
    Value value;
    std::int32_t source;
    std::int32_t line;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<std::int32_t> sources(values.size());
  std::iota(sources.begin(), sources.end(), 0);
  std::vector<Entry> all;
  all.reserve(values.size());
  for (const std::int32_t line : sources) all.push_back({values[at(line)], line, line});
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>(),
                                                                       std::move(all));
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.value != values[at(entry.line)] || entry.source != sources[at(entry.line)]) continue;
    for (const std::int32_t next : graph.neighbours.of(entry.line)) {
      const Value most = entry.value + step(entry.line, next);
      if (values[at(next)] <= most) continue;
      values[at(next)] = most;
      sources[at(next)] = entry.source;
      queue.push({most, entry.source, next});
    }
  }
  return sources;
}

/// Finds faces and neighbours.
void connect(WallGraph& graph, std::span<const FanPiece> pieces) {
  std::vector<RowEntry> faces;
  std::vector<RowEntry> neighbours;
  const auto add_pair = [&neighbours](std::int32_t a, std::int32_t b) {
    if (a == b) return;
    neighbours.emplace_back(a, b);
    neighbours.emplace_back(b, a);
  };
  for (std::size_t i = 0; i < graph.wall.size(); ++i) {
    const Triangle& lines = graph.wall_lines[i];
    for (std::size_t k = 0; k < 3; ++k) {
      faces.emplace_back(lines[k], static_cast<std::int32_t>(i));
      add_pair(lines[k], lines[(k + 1) % 3]);
    }
  }
  for (const FanPiece& piece : pieces) {
    for (std::size_t k = 0; k < 2; ++k) add_pair(piece.from[k], piece.to[k]);
    add_pair(piece.from[0], piece.from[1]);
    add_pair(piece.to[0], piece.to[1]);
    add_pair(piece.from[0], piece.to[1]);
  }
  graph.faces = rows_of(std::move(faces), graph.feet.size());
  graph.neighbours = rows_of(std::move(neighbours), graph.feet.size());
}

}  // namespace

std::span<const std::int32_t> NumberRows::of(std::int32_t row) const {
  const std::int32_t first = starts[at(row)];
  return std::span(numbers).subspan(at(first), at(starts[at(row) + 1] - first));
}

WallGraph wall_graph(const SurfaceMesh& surface, std::vector<std::int32_t> wall) {
  WallGraph graph;
  graph.wall = std::move(wall);
  graph.vertex2line.assign(surface.vertices.size(), -1);
  std::vector<bool> is_wall(surface.triangles.size(), false);
  for (const std::int32_t t : graph.wall) {
    is_wall[at(t)] = true;
    for (const std::int32_t v : surface.triangles[at(t)]) graph.vertex2line[at(v)] = 0;
  }
  for (std::size_t v = 0; v < graph.vertex2line.size(); ++v) {
    if (graph.vertex2line[v] < 0) continue;
    graph.vertex2line[v] = static_cast<std::int32_t>(graph.feet.size());
    graph.feet.push_back(static_cast<std::int32_t>(v));
  }
  graph.at_border.assign(graph.feet.size(), false);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_wall[t]) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      const std::int32_t line = graph.vertex2line[at(v)];
      if (line >= 0) graph.at_border[at(line)] = true;
    }
  }
  for (const std::int32_t t : graph.wall) {
    Triangle lines = surface.triangles[at(t)];
    for (std::int32_t& line : lines) line = graph.vertex2line[at(line)];
    graph.wall_lines.push_back(lines);
  }
  connect(graph, {});
  return graph;
}

WallGraph with_fans(const WallGraph& graph, std::vector<std::int32_t> feet,
                    std::span<const FanCorner> corners, std::span<const FanPiece> pieces) {
  WallGraph fanned;
  fanned.wall = graph.wall;
  fanned.vertex2line.assign(graph.vertex2line.size(), -1);
  fanned.feet = std::move(feet);
  std::vector<std::int32_t> new_line(graph.feet.size(), -1);  // the first at the foot
  for (std::size_t i = fanned.feet.size(); i-- > 0;) {
    const std::int32_t old = graph.vertex2line[at(fanned.feet[i])];
    new_line[at(old)] = fanned.vertex2line[at(fanned.feet[i])] = static_cast<std::int32_t>(i);
  }
  for (const std::int32_t foot : fanned.feet) {
    fanned.at_border.push_back(graph.at_border[at(graph.vertex2line[at(foot)])]);
  }
  for (Triangle lines : graph.wall_lines) {
    for (std::int32_t& line : lines) line = new_line[at(line)];
    fanned.wall_lines.push_back(lines);
  }
  for (const FanCorner& corner : corners) {
    const auto wall = std::lower_bound(graph.wall.begin(), graph.wall.end(), corner.triangle);
    fanned.wall_lines[at(wall - graph.wall.begin())][at(corner.corner)] = corner.line;
  }
  connect(fanned, pieces);
  return fanned;
}

std::vector<std::int32_t> limit_slopes(const WallGraph& graph, std::span<const Vec3> places,
                                       double slope, std::vector<double>& values) {
  TF_CHECK(places.size() == graph.feet.size() && slope > 0);
  return lower(graph, values, [&](std::int32_t a, std::int32_t b) {
    return slope * distance(places[at(a)], places[at(b)]);
  });
}

std::vector<std::int32_t> limit_steps(const WallGraph& graph, std::span<const int> most,
                                      std::vector<int>& stops) {
  TF_CHECK(most.size() == graph.feet.size());
  return lower(graph, stops, [&](std::int32_t a, std::int32_t b) {
    return graph.feet[at(a)] == graph.feet[at(b)] ? 0 : std::min(most[at(a)], most[at(b)]);
  });
}

}  // namespace tetfarm
