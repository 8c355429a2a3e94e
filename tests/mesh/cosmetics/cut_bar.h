/// A bar of small cubes, six tets each, cut into sub-domains: what parallel cosmetics is tested on.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/element_section.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm::trial {

struct LeafMesh {
  Subdomain leaf;
  TetMesh mesh;
};

using Cell = std::array<int, 3>;

/// Which leaf a cube belongs to.
using LeafOfCell = std::function<std::uint64_t(const Cell&)>;
/// Where a corner of cubes lies.
using PlaceOfCorner = std::function<Vec3(const Cell&)>;

inline Vec3 on_the_grid(const Cell& corner) {
  return {static_cast<double>(corner[0]), static_cast<double>(corner[1]),
          static_cast<double>(corner[2])};
}

/// The tets of a bar of cubes with the leaf of each, then the parts made of them.
class CutBar {
 public:
  CutBar(const Cell& cubes, const LeafOfCell& leaf_of, const PlaceOfCorner& place = on_the_grid)
      : cubes_(cubes) {
    for_each(cubes_, [&](const Cell& cell) { add_cube(cell, leaf_of(cell)); });
    for_each({cubes[0] + 1, cubes[1] + 1, cubes[2] + 1},
             [&](const Cell& corner) { places_[node(corner)] = place(corner); });
    find_faces();
    for (const std::uint64_t leaf : std::set<std::uint64_t>(leaf_of_.begin(), leaf_of_.end())) {
      make_part(leaf);
    }
  }

  std::map<std::uint64_t, LeafMesh> parts;
  std::size_t surface_triangles = 0;
  std::size_t tets() const { return tets_.size(); }

 private:
  using Face = std::array<std::int32_t, 3>;

  template <class Visitor>
  static void for_each(const Cell& counts, const Visitor& visit) {
    for (int x = 0; x < counts[0]; ++x) {
      for (int y = 0; y < counts[1]; ++y) {
        for (int z = 0; z < counts[2]; ++z) visit(Cell{x, y, z});
      }
    }
  }
  std::int32_t node(const Cell& p) const {
    return (p[0] * (cubes_[1] + 1) + p[1]) * (cubes_[2] + 1) + p[2];
  }

  void add_cube(const Cell& cell, std::uint64_t leaf) {
    std::array<int, 3> axes = {0, 1, 2};
    do {
      Cell here = cell;
      Tet tet = {node(here), 0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i) {
        ++here[at(axes[i])];
        tet[i + 1] = node(here);
      }
      const bool is_even = (axes[1] - axes[0] + 3) % 3 == 1;
      if (!is_even) std::swap(tet[2], tet[3]);
      tets_.push_back(tet);
      leaf_of_.push_back(leaf);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  Face face_of(std::size_t t, std::size_t f) const {
    Face face{};
    for (std::size_t i = 0; i < 3; ++i) face[i] = tets_[t][at(tet_face_nodes[f][i])];
    return face;
  }

  void find_faces() {
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      for (std::size_t f = 0; f < 4; ++f) face2tets_[sorted_face(face_of(t, f))].push_back(t);
    }
    std::set<std::int32_t> on_surface;
    std::set<std::int32_t> on_cut;
    std::uint32_t surface = 0;
    std::uint32_t cut = 0;
    for (const auto& [face, tets] : face2tets_) {
      if (tets.size() == 1) {
        face_origin_[face] = {0, surface++};
        on_surface.insert(face.begin(), face.end());
      } else if (leaf_of_[tets[0]] != leaf_of_[tets[1]]) {
        face_origin_[face] = {1, cut++};
        on_cut.insert(face.begin(), face.end());
      }
    }
    surface_triangles = surface;
    std::uint32_t next = 0;
    for (const std::int32_t v : on_cut) {
      if (!on_surface.contains(v)) node_origin_[v] = {1, next++};
    }
    for (const std::int32_t v : on_surface) node_origin_[v] = {0, static_cast<std::uint32_t>(v)};
  }

  void make_part(std::uint64_t heap) {
    LeafMesh part;
    part.leaf.path = {heap};
    std::map<std::int32_t, std::int32_t> number;
    const auto local = [&](std::int32_t v) {
      const auto [it, is_new] =
          number.try_emplace(v, static_cast<std::int32_t>(part.mesh.nodes.size()));
      if (is_new) part.mesh.nodes.push_back(places_.at(v));
      return it->second;
    };
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (leaf_of_[t] != heap) continue;
      for (std::size_t f = 0; f < 4; ++f) {
        const Face face = face_of(t, f);
        const auto origin = face_origin_.find(sorted_face(face));
        if (origin == face_origin_.end()) continue;
        part.leaf.triangles.push_back({local(face[0]), local(face[1]), local(face[2])});
        part.leaf.triangle_origin.push_back(origin->second);
      }
    }
    part.leaf.vertices = part.mesh.nodes;
    part.leaf.node_origin.resize(part.mesh.nodes.size());
    for (const auto& [v, l] : number) part.leaf.node_origin[at(l)] = node_origin_.at(v);
    part.mesh.boundary_nodes = static_cast<std::int32_t>(part.mesh.nodes.size());
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (leaf_of_[t] != heap) continue;
      const Tet& tet = tets_[t];
      part.mesh.tets.push_back({local(tet[0]), local(tet[1]), local(tet[2]), local(tet[3])});
    }
    parts[heap] = std::move(part);
  }

  Cell cubes_;
  std::map<std::int32_t, Vec3> places_;
  std::vector<Tet> tets_;
  std::vector<std::uint64_t> leaf_of_;
  std::map<Face, std::vector<std::size_t>> face2tets_;
  std::map<Face, Origin> face_origin_;
  std::map<std::int32_t, Origin> node_origin_;
};

}  // namespace tetfarm::trial
