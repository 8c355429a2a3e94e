#include "mesh/recovery/surface_splitting.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace tetfarm {
namespace {

/// The edge ab in a triangle, in either direction.
struct EdgePlace {
  std::size_t triangle;
  std::int32_t opposite;
};

std::vector<EdgePlace> triangles_on(const SplitSurface& surface, std::int32_t a, std::int32_t b) {
  std::vector<EdgePlace> found;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t u = t[k], v = t[(k + 1) % 3];
      if ((u == a && v == b) || (u == b && v == a)) found.push_back({i, t[(k + 2) % 3]});
    }
  }
  return found;
}

Triangle with(Triangle t, std::int32_t old_node, std::int32_t new_node) {
  std::replace(t.begin(), t.end(), old_node, new_node);
  return t;
}

}  // namespace

SplitSurface unsplit(const std::vector<Triangle>& triangles) {
  SplitSurface surface{triangles, std::vector<std::int32_t>(triangles.size()), {}};
  std::iota(surface.source.begin(), surface.source.end(), 0);
  return surface;
}

void split_edge(SplitSurface& surface, std::int32_t a, std::int32_t b, std::int32_t node) {
  SteinerSplit split{node, {}};
  for (const auto& [i, opposite] : triangles_on(surface, a, b)) {
    const Triangle whole = surface.triangles[i];
    split.sources.push_back(surface.source[i]);
    surface.triangles[i] = with(whole, b, node);
    surface.triangles.push_back(with(whole, a, node));
    surface.source.push_back(surface.source[i]);
  }
  TF_CHECK(!split.sources.empty());
  surface.splits.push_back(std::move(split));
}

void split_face(SplitSurface& surface, std::int32_t triangle, std::int32_t node) {
  const auto i = static_cast<std::size_t>(triangle);
  TF_CHECK(i < surface.triangles.size());
  const auto [a, b, c] = surface.triangles[i];
  surface.splits.push_back({node, {surface.source[i]}});
  surface.triangles[i] = {a, b, node};
  surface.triangles.push_back({b, c, node});
  surface.triangles.push_back({c, a, node});
  surface.source.push_back(surface.source[i]);
  surface.source.push_back(surface.source[i]);
}

std::vector<std::int32_t> sources_at(const SplitSurface& surface, std::int32_t a, std::int32_t b) {
  std::vector<std::int32_t> sources;
  for (const EdgePlace& place : triangles_on(surface, a, b)) {
    sources.push_back(surface.source[place.triangle]);
  }
  return sources;
}

std::optional<std::array<std::int32_t, 2>> opposite_corners(const SplitSurface& surface,
                                                            std::int32_t a, std::int32_t b) {
  const auto found = triangles_on(surface, a, b);
  if (found.size() != 2 || surface.source[found[0].triangle] != surface.source[found[1].triangle]) {
    return std::nullopt;
  }
  return std::array{found[0].opposite, found[1].opposite};
}

void swap_edge(SplitSurface& surface, std::int32_t a, std::int32_t b) {
  const auto found = triangles_on(surface, a, b);
  TF_CHECK(found.size() == 2);
  Triangle& first = surface.triangles[found[0].triangle];
  Triangle& second = surface.triangles[found[1].triangle];
  // In each, one end of the edge gives way to the other triangle's corner.
  first = with(first, b, found[1].opposite);
  second = with(second, a, found[0].opposite);
}

void replace_fan(SplitSurface& surface, std::int32_t node, const std::vector<SurfacePart>& parts) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle t = surface.triangles[i];
    if (std::find(t.begin(), t.end(), node) != t.end()) continue;
    surface.triangles[kept] = t;
    surface.source[kept++] = surface.source[i];
  }
  surface.triangles.resize(kept);
  surface.source.resize(kept);
  TF_CHECK(surface.source.size() == surface.triangles.size());
  for (const auto& [triangle, source] : parts) {
    surface.triangles.push_back(triangle);
    surface.source.push_back(source);
  }
}

}  // namespace tetfarm
