/// A box of n x n x n cubes in every type of cell, in slabs along x as parts: columns of hexes and
/// of pyramids that meet in the middle of a cube, and columns whose horizontal quads are cut in
/// two, of prisms, and of pyramids and tets. Which is which comes from a seed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"
#include "tests/support/part_of_cells.h"

namespace tetfarm {

class HybridGrid : public MeshSource {
 public:
  /// With a region for each slab the faces between slabs are boundary faces, once for each.
  HybridGrid(int n, int slabs, bool has_regions = false, std::uint32_t seed = 1)
      : n_(n), has_regions_(has_regions), random_(seed) {
    for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
      places_.push_back({static_cast<double>(i % (n + 1)),
                         static_cast<double>(i / (n + 1) % (n + 1)),
                         static_cast<double>(i / (n + 1) / (n + 1))});
    }
    std::vector<std::vector<ListedCell>> cells(static_cast<std::size_t>(slabs));
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < n; ++y) {
        is_cut_ = random_() % 2 == 0;
        for (int z = 0; z < n; ++z) {
          add_cube({x, y, z}, cells[static_cast<std::size_t>(x * slabs / n)]);
        }
      }
    }
    std::map<FaceKey, int> uses;
    for (const auto& slab : cells) count_face_uses(slab, uses);
    for (const auto& slab : cells) {
      if (has_regions_) {
        uses.clear();
        count_face_uses(slab, uses);
      }
      const auto patch_of = [&uses](ElementType type, std::span<const std::int64_t> face) {
        std::optional<std::int32_t> patch;
        if (uses.at(face_key(face)) == 1) patch = type == ElementType::quad ? 1 : 0;
        return patch;
      };
      const auto number = static_cast<std::int32_t>(parts.size());
      parts.push_back(
          part_of_cells(slab, places_, number, has_regions_ ? number + 1 : 1, patch_of));
    }
  }

  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  std::vector<std::string> patch_names() const override { return {"triangles", "quads"}; }
  std::vector<std::string> region_names() const override {
    std::vector<std::string> names = {"domain"};
    for (std::size_t i = 1; has_regions_ && i < size(); ++i) {
      names.push_back("domain " + std::to_string(i + 1));
    }
    return names;
  }
  double volume() const { return static_cast<double>(n_) * n_ * n_; }

  std::vector<NumberedPart> parts;

 private:
  /// The corners of a cube as a hex has them.
  std::vector<std::int64_t> corners(const std::array<int, 3>& low) const {
    std::vector<std::int64_t> nodes;
    for (const std::array<int, 3>& step :
         {std::array{0, 0, 0}, std::array{1, 0, 0}, std::array{1, 1, 0}, std::array{0, 1, 0},
          std::array{0, 0, 1}, std::array{1, 0, 1}, std::array{1, 1, 1}, std::array{0, 1, 1}}) {
      nodes.push_back(low[0] + step[0] +
                      (n_ + 1) * (low[1] + step[1] + (n_ + 1) * (low[2] + step[2])));
    }
    return nodes;
  }

  void add_cube(const std::array<int, 3>& low, std::vector<ListedCell>& cells) {
    const std::vector<std::int64_t> c = corners(low);
    if (random_() % 2 == 0) {
      if (!is_cut_) {
        cells.push_back({ElementType::hex, c});
      } else {
        cells.push_back({ElementType::prism, {c[0], c[1], c[2], c[4], c[5], c[6]}});
        cells.push_back({ElementType::prism, {c[0], c[2], c[3], c[4], c[6], c[7]}});
      }
      return;
    }
    const auto middle = static_cast<std::int64_t>(places_.size());
    places_.push_back({low[0] + 0.5, low[1] + 0.5, low[2] + 0.5});
    for_each_face_of(
        ElementType::hex, std::span<const std::int64_t>(c),
        [&](ElementType, std::span<const std::int64_t> face) { add_over(face, c, middle, cells); });
  }

  /// On a face of the cube: a pyramid, or two tets where the diagonal cuts it.
  void add_over(std::span<const std::int64_t> face, const std::vector<std::int64_t>& c,
                std::int64_t middle, std::vector<ListedCell>& cells) const {
    const auto has = [&face](std::int64_t node) {
      return std::find(face.begin(), face.end(), node) != face.end();
    };
    for (const auto& [a, b] : {std::pair{c[0], c[2]}, std::pair{c[4], c[6]}}) {
      if (!is_cut_ || !has(a) || !has(b)) continue;
      std::vector<std::int64_t> turned(face.rbegin(), face.rend());
      while (turned[0] != a) std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      cells.push_back({ElementType::tet, {turned[0], turned[1], turned[2], middle}});
      cells.push_back({ElementType::tet, {turned[0], turned[2], turned[3], middle}});
      return;
    }
    // The normal of a base points to its apex: into the cube.
    cells.push_back({ElementType::pyramid, {face[3], face[2], face[1], face[0], middle}});
  }

  int n_;
  bool has_regions_;
  std::mt19937 random_;
  bool is_cut_ = false;
  std::vector<Vec3> places_;
};

}  // namespace tetfarm
