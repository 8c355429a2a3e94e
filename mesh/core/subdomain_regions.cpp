#include "mesh/core/subdomain_regions.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Takes the vertices that the part's triangles use, which still have the numbers of the whole.
void take_used_vertices(const Subdomain& whole, Subdomain& part) {
  std::vector<std::int32_t> old2new(whole.vertices.size(), -1);
  TF_CHECK(whole.node_origin.size() == whole.vertices.size());
  for (const Triangle& triangle : part.triangles) {
    for (const std::int32_t v : triangle) {
      TF_CHECK(v >= 0 && static_cast<std::size_t>(v) < old2new.size());
      old2new[static_cast<std::size_t>(v)] = 0;
    }
  }
  const auto used =
      old2new.size() - static_cast<std::size_t>(std::count(old2new.begin(), old2new.end(), -1));
  part.vertices.reserve(used);
  part.node_origin.reserve(used);
  for (std::size_t v = 0; v < old2new.size(); ++v) {
    if (old2new[v] < 0) continue;
    old2new[v] = static_cast<std::int32_t>(part.vertices.size());
    part.vertices.push_back(whole.vertices[v]);
    part.node_origin.push_back(whole.node_origin[v]);
  }
  for (Triangle& triangle : part.triangles) {
    for (std::int32_t& v : triangle) v = old2new[static_cast<std::size_t>(v)];
  }
}

}  // namespace

std::vector<std::int32_t> regions_of(const Subdomain& subdomain) {
  if (subdomain.region > 0) return {subdomain.region};
  std::int32_t last = 0;
  for (const auto& [behind, front] : subdomain.sides) last = std::max({last, behind, front});
  std::vector<bool> is_there(static_cast<std::size_t>(last) + 1, false);
  for (const Sides& sides : subdomain.sides) {
    for (const std::int32_t region : sides) is_there[static_cast<std::size_t>(region)] = true;
  }
  std::vector<std::int32_t> regions;
  for (std::int32_t region = 1; region <= last; ++region) {
    if (is_there[static_cast<std::size_t>(region)]) regions.push_back(region);
  }
  return regions;
}

std::vector<Triangle> triangles_out_of(const Subdomain& subdomain, std::int32_t region) {
  if (subdomain.region > 0) return subdomain.triangles;
  std::vector<Triangle> triangles;
  TF_CHECK(subdomain.sides.size() == subdomain.triangles.size());
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    const auto& [a, b, c] = subdomain.triangles[t];
    if (subdomain.sides[t][0] == region) triangles.push_back({a, b, c});
    if (subdomain.sides[t][1] == region) triangles.push_back({a, c, b});
  }
  return triangles;
}

RegionHalves halves_of(const std::vector<std::int32_t>& regions) {
  const auto middle = regions.begin() + static_cast<std::ptrdiff_t>(regions.size() / 2);
  return {{regions.begin(), middle}, {middle, regions.end()}};
}

std::int32_t region_of_leaf(TreePath path, std::int32_t regions) {
  TF_CHECK(regions >= 1);
  std::vector<std::int32_t> here(static_cast<std::size_t>(regions));
  std::iota(here.begin(), here.end(), 1);
  for (int bit = path.depth() - 1; bit >= 0 && here.size() > 1; --bit) {
    RegionHalves halves = halves_of(here);
    here = std::move((path.heap >> bit & 1U) != 0 ? halves.right : halves.left);
  }
  TF_CHECK(here.size() == 1);
  return here.front();
}

Subdomain part_of_regions(const Subdomain& whole, const std::vector<std::int32_t>& regions,
                          TreePath path) {
  TF_CHECK(whole.region == 0);
  TF_CHECK(!regions.empty() && std::is_sorted(regions.begin(), regions.end()));
  Subdomain part;
  part.path = path;
  part.region = regions.size() == 1 ? regions.front() : 0;
  const auto kept = [&regions](std::int32_t region) {
    return std::binary_search(regions.begin(), regions.end(), region) ? region : 0;
  };
  const auto kept_sides = [&kept](const Sides& sides) {
    return Sides{kept(sides[0]), kept(sides[1])};
  };
  TF_CHECK(whole.sides.size() == whole.triangles.size());
  const auto triangles = static_cast<std::size_t>(
      std::count_if(whole.sides.begin(), whole.sides.end(), [&](const Sides& sides) {
        return kept_sides(sides) != Sides{0, 0};
      }));
  part.triangles.reserve(triangles);
  part.triangle_origin.reserve(triangles);
  if (part.region == 0) part.sides.reserve(triangles);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const Sides sides = kept_sides(whole.sides[t]);
    if (sides == Sides{0, 0}) continue;
    Triangle triangle = whole.triangles[t];
    if (part.region > 0 && sides[0] == 0) std::swap(triangle[1], triangle[2]);
    part.triangles.push_back(triangle);
    part.triangle_origin.push_back(whole.triangle_origin[t]);
    if (part.region == 0) part.sides.push_back(sides);
  }
  take_used_vertices(whole, part);
  return part;
}

}  // namespace tetfarm
