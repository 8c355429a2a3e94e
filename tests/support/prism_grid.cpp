#include "tests/support/prism_grid.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

constexpr std::array<std::array<int, 2>, 4> square = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
/// The middle of a wedge in sixths of a box.
constexpr std::array<std::array<int, 2>, 4> middle = {{{3, 1}, {5, 3}, {3, 5}, {1, 3}}};

}  // namespace

PrismGrid::PrismGrid(GridLines lines) : lines_(std::move(lines)) {
  is_in_.assign(static_cast<std::size_t>(4 * size(0) * size(1) * size(2)), 0);
}

std::size_t PrismGrid::index(const Cell& c) const {
  return static_cast<std::size_t>(((c[0] * size(1) + c[1]) * size(2) + c[2]) * 4 + c[3]);
}

bool PrismGrid::holds(const Cell& cell) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell[k] < 0 || cell[k] >= size(k)) return false;
  }
  return is_in_[index(cell)] != 0;
}

void PrismGrid::for_each_cell(const std::function<void(const Cell&)>& visit) const {
  for (int x = 0; x < size(0); ++x) {
    for (int y = 0; y < size(1); ++y) {
      for (int z = 0; z < size(2); ++z) {
        for (int wedge = 0; wedge < 4; ++wedge) visit({x, y, z, wedge});
      }
    }
  }
}

void PrismGrid::set(bool is_in, const std::function<bool(int, int, int)>& accepts) {
  for_each_cell([&](const Cell& c) {
    const auto& m = middle[static_cast<std::size_t>(c[3])];
    if (accepts(6 * c[0] + m[0], 6 * c[1] + m[1], c[2])) is_in_[index(c)] = is_in ? 1 : 0;
  });
}

bool PrismGrid::is_empty() const {
  return std::all_of(is_in_.begin(), is_in_.end(), [](char c) { return c == 0; });
}

/// Below, above, and over the sides: that of the box, then the two diagonals.
std::array<PrismGrid::Cell, 5> PrismGrid::neighbours(const Cell& c) const {
  constexpr std::array<std::array<int, 2>, 4> step = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  const auto& s = step[static_cast<std::size_t>(c[3])];
  return {Cell{c[0], c[1], c[2] - 1, c[3]}, Cell{c[0], c[1], c[2] + 1, c[3]},
          Cell{c[0] + s[0], c[1] + s[1], c[2], (c[3] + 2) % 4},
          Cell{c[0], c[1], c[2], (c[3] + 1) % 4}, Cell{c[0], c[1], c[2], (c[3] + 3) % 4}};
}

/// The lower three, anticlockwise from above and the middle last, then the upper three.
std::array<PrismGrid::Node, 6> PrismGrid::corners(const Cell& c) {
  const auto& a = square[static_cast<std::size_t>(c[3])];
  const auto& b = square[static_cast<std::size_t>((c[3] + 1) % 4)];
  std::array<Node, 6> nodes{};
  for (int up = 0; up < 2; ++up) {
    const auto first = static_cast<std::size_t>(3 * up);
    const int z = c[2] + up;
    nodes[first] = {2 * c[0] + a[0], 2 * c[1] + a[1], z};
    nodes[first + 1] = {2 * c[0] + b[0], 2 * c[1] + b[1], z};
    nodes[first + 2] = {2 * c[0] + 1, 2 * c[1] + 1, z};
  }
  return nodes;
}

std::vector<std::array<PrismGrid::Node, 3>> PrismGrid::skin() const {
  std::vector<std::array<Node, 3>> triangles;
  for_each_cell([&](const Cell& cell) {
    if (!holds(cell)) return;
    const auto beyond = neighbours(cell);
    const auto p = corners(cell);
    const auto add_side = [&](std::size_t a, std::size_t b) {
      triangles.push_back({p[a], p[b], p[b + 3]});
      triangles.push_back({p[a], p[b + 3], p[a + 3]});
    };
    if (!holds(beyond[0])) triangles.push_back({p[0], p[2], p[1]});
    if (!holds(beyond[1])) triangles.push_back({p[3], p[4], p[5]});
    if (!holds(beyond[2])) add_side(0, 1);
    if (!holds(beyond[3])) add_side(1, 2);
    if (!holds(beyond[4])) add_side(2, 0);
  });
  return triangles;
}

void PrismGrid::thicken_edges() {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    std::map<std::array<Node, 2>, int> uses;
    for (const auto& t : skin()) {
      for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    std::erase_if(uses, [](const auto& use) { return use.second < 2; });
    if (uses.empty()) return;
    for_each_cell([&](const Cell& cell) {
      if (holds(cell)) return;
      const auto p = corners(cell);
      for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = 0; b < 6; ++b) {
          if (a == b || !uses.contains({p[a], p[b]})) continue;
          is_in_[index(cell)] = 1;
          has_changed = true;
        }
      }
    });
  }
}

SurfaceMesh PrismGrid::surface() const {
  SurfaceMesh mesh;
  std::map<Node, std::int32_t> number;
  const auto place = [this](std::size_t axis, int half) {
    const auto& lines = lines_[axis];
    const auto low = static_cast<std::size_t>(half / 2);
    return static_cast<double>(half % 2 == 0 ? lines[low] : (lines[low] + lines[low + 1]) / 2);
  };
  for (const auto& nodes : skin()) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Node& n = nodes[k];
      const auto [it, is_new] = number.try_emplace(n, static_cast<std::int32_t>(number.size()));
      if (is_new) mesh.vertices.push_back({place(0, n[0]), place(1, n[1]), place(2, 2 * n[2])});
      triangle[k] = it->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return with_one_patch(std::move(mesh));
}

}  // namespace tetfarm::shapes
