#include "mesh/formats/plane/plane_sides.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/formats/plain_names.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_patch_name = 200;

/// A side of a triangle, so that both triangles of an edge give the same first two numbers.
struct HalfSide {
  std::int32_t low = 0, high = 0;
  std::int32_t triangle = 0;
  std::int32_t a = 0, b = 0;

  auto key() const { return std::tuple(low, high, triangle); }
  bool is_edge_of(const HalfSide& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfSide> sorted_half_sides(const PlaneMesh& mesh) {
  std::vector<HalfSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = mesh.triangles[t][i];
      const std::int32_t b = mesh.triangles[t][(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(t), a, b});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const HalfSide& s, const HalfSide& t) { return s.key() < t.key(); });
  return sides;
}

std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> patch_of_edges(
    const PlaneMesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> patches;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    patches[std::minmax(mesh.edges[k][0], mesh.edges[k][1])] = mesh.patches[k];
  }
  return patches;
}

/// Nodes of the border that edges of it join, directly or over others.
class BorderPieces {
 public:
  BorderPieces(std::size_t nodes, const std::vector<OuterSide>& border) : parents_(nodes) {
    std::iota(parents_.begin(), parents_.end(), 0);
    for (const OuterSide& side : border) parents_[at(root(side.a))] = root(side.b);
  }
  std::int32_t root(std::int32_t node) {
    while (parents_[at(node)] != node) {
      parents_[at(node)] = parents_[at(parents_[at(node)])];
      node = parents_[at(node)];
    }
    return node;
  }

 private:
  std::vector<std::int32_t> parents_;
};

}  // namespace

PlaneSides sides_of(const PlaneMesh& mesh) {
  const std::vector<HalfSide> halves = sorted_half_sides(mesh);
  const auto patches = patch_of_edges(mesh);
  PlaneSides sides;
  for (std::size_t i = 0; i < halves.size();) {
    const HalfSide& here = halves[i];
    std::size_t end = i + 1;
    while (end < halves.size() && halves[end].is_edge_of(here)) ++end;
    if (end - i > 2) {
      throw InvalidInput("nodes " + std::to_string(here.low + 1) + " and " +
                             std::to_string(here.high + 1) + " are a side of " +
                             std::to_string(end - i) + " triangles",
                         mesh.name);
    }
    if (end - i == 2) {
      sides.inner.push_back({here.a, here.b, here.triangle, halves[i + 1].triangle});
    } else {
      const auto patch = patches.find({here.low, here.high});
      sides.border.push_back(
          {here.a, here.b, here.triangle, patch == patches.end() ? 0 : patch->second});
    }
    i = end;
  }
  std::sort(sides.inner.begin(), sides.inner.end(), [](const InnerSide& s, const InnerSide& t) {
    return std::pair(s.triangle, s.neighbour) < std::pair(t.triangle, t.neighbour);
  });
  std::sort(sides.border.begin(), sides.border.end(), [](const OuterSide& s, const OuterSide& t) {
    return std::tuple(s.patch, s.triangle, s.a) < std::tuple(t.patch, t.triangle, t.a);
  });
  return sides;
}

std::string patch_name_of(const PlaneMesh& mesh, std::int32_t number) {
  const auto named = mesh.patch_names.find(number);
  return named == mesh.patch_names.end() ? "patch_" + std::to_string(number) : named->second;
}

std::vector<PlanePatch> border_patches(const PlaneMesh& mesh, const PlaneSides& sides) {
  std::vector<PlanePatch> patches;
  std::vector<std::string> names;
  for (const OuterSide& side : sides.border) {
    if (!patches.empty() && patches.back().number == side.patch) continue;
    patches.push_back({side.patch, ""});
    names.push_back(patch_name_of(mesh, side.patch));
  }
  const std::vector<std::string> plain = plain_names(names, longest_patch_name);
  for (std::size_t i = 0; i < patches.size(); ++i) patches[i].name = plain[i];
  return patches;
}

std::vector<bool> bound_holes(const PlaneMesh& mesh, const PlaneSides& sides,
                              const std::vector<PlanePatch>& patches) {
  BorderPieces pieces(mesh.points.size(), sides.border);
  // A hole runs clockwise: its area is negative.
  std::map<std::int32_t, double> area_of_piece;
  for (const OuterSide& side : sides.border) {
    const Vec2& p = mesh.points[at(side.a)];
    const Vec2& q = mesh.points[at(side.b)];
    const Vec2& origin = mesh.points[at(pieces.root(side.a))];
    area_of_piece[pieces.root(side.a)] +=
        (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  std::vector<bool> bound(patches.size(), true);
  std::size_t patch = 0;
  for (const OuterSide& side : sides.border) {
    while (patches[patch].number != side.patch) ++patch;
    if (area_of_piece[pieces.root(side.a)] > 0) bound[patch] = false;
  }
  return bound;
}

}  // namespace tetfarm
