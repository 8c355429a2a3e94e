/// A cube of small cubes, six tets each, cut into three sub-domains: what the tests assemble.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <string>

#include "base/array_index.h"
#include "mesh/assemble/global_mesh.h"
#include "mesh/assemble/leaf_numbering.h"
#include "mesh/core/sorted_face.h"
#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

namespace tetfarm {

struct CutGrid {
  SurfaceMesh surface;
  std::map<std::uint64_t, MeshPart> parts;  ///< by heap number
  std::string table;

  Numbering numbering() const { return number_globally(surface, table); }
  /// Of the partitions of a VTKHDF file.
  std::vector<VtkhdfCounts> counts() const {
    std::vector<VtkhdfCounts> counts;
    for (const LeafNumbers& leaf : numbering().leaves) {
      const NumberedPart part = reader()(leaf).part;
      counts.push_back({std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces)});
    }
    return counts;
  }
  LeafNumbering numbering_of(const Subdomain& leaf) const {
    return leaf_numbering(numbering(), {leaf.path, leaf.region, leaf.node_origin});
  }
  Portion portion_of(const MeshPart& part) const {
    return make_portion(part, pieces_of(surface, surface_pieces(part.subdomain)),
                        numbering_of(part.subdomain));
  }
  Portion portion(std::uint64_t leaf) const { return portion_of(parts.at(leaf)); }
  ReadPortion reader() const {
    return [this](const LeafNumbers& leaf) { return portion(leaf.path.heap); };
  }
};

/// Builds a CutGrid from tets of which each has a leaf.
class CutGridBuilder {
 public:
  explicit CutGridBuilder(int n) : n_(n) {
    add_tets();
    make_surface();
    find_origins();
    for (const std::uint64_t leaf : std::set<std::uint64_t>(leaf_of_.begin(), leaf_of_.end())) {
      make_part(leaf);
    }
    for (const auto& [cut, nodes] : nodes_of_cut_) {
      grid_.table += "cut " + std::to_string(cut) + " " + std::to_string(nodes) + "\n";
    }
  }
  CutGrid take() { return std::move(grid_); }

 private:
  using Face = std::array<std::int32_t, 3>;
  std::int32_t node(const std::array<int, 3>& p) const {
    return static_cast<std::int32_t>((p[0] * (n_ + 1) + p[1]) * (n_ + 1) + p[2]);
  }
  Vec3 place(std::int32_t v) const {
    const int m = n_ + 1;
    const double h = n_;
    return {v / (m * m) / h, v / m % m / h, v % m / h};
  }

  void add_tets() {
    for (int cell = 0; cell < n_ * n_ * n_; ++cell) {
      const std::array<int, 3> low = {cell / (n_ * n_), cell / n_ % n_, cell % n_};
      std::array<int, 3> axes = {0, 1, 2};
      do {
        std::array<int, 3> here = low;
        Tet tet = {node(here), 0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
          ++here[at(axes[i])];
          tet[i + 1] = node(here);
        }
        if (tet_volume(place(tet[0]), place(tet[1]), place(tet[2]), place(tet[3])) < 0) {
          std::swap(tet[2], tet[3]);
        }
        tets_.push_back(tet);
        leaf_of_.push_back(2 * low[0] < n_ - 1 ? 2 : 2 * low[1] < n_ - 1 ? 6 : 7);
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      for (const Face& face : faces(t)) face2tets_[sorted_face(face)].push_back(t);
    }
  }
  std::array<Face, 4> faces(std::size_t t) const {
    std::array<Face, 4> result;
    for (std::size_t f = 0; f < 4; ++f) {
      for (std::size_t i = 0; i < 3; ++i) result[f][i] = tets_[t][at(tet_face_nodes[f][i])];
    }
    return result;
  }

  /// Vertex 1 is used by no triangle.
  void make_surface() {
    std::map<std::int32_t, std::int32_t> number;
    SurfaceMesh& surface = grid_.surface;
    surface.patch_names = {"low x", "elsewhere"};
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      for (const Face& face : faces(t)) {
        if (face2tets_[sorted_face(face)].size() == 2) continue;
        Triangle triangle;
        bool is_low = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto [it, is_new] = number.try_emplace(face[i], std::ssize(surface.vertices));
          if (is_new) surface.vertices.push_back(place(face[i]));
          if (surface.vertices.size() == 1) surface.vertices.push_back({7, 7, 7});
          triangle[i] = it->second;
          is_low = is_low && place(face[i]).x == 0;
        }
        face_origin_[sorted_face(face)] = {0, static_cast<std::uint32_t>(surface.triangles.size())};
        surface.triangles.push_back(triangle);
        surface.patch_of_triangle.push_back(is_low ? 0 : 1);
      }
    }
    for (const auto& [grid_node, v] : number) {
      node_origin_[grid_node] = {0, static_cast<std::uint32_t>(v)};
    }
  }

  static std::uint64_t last_common(std::uint64_t a, std::uint64_t b) {
    while (a != b) (a > b ? a : b) /= 2;
    return a;
  }

  void find_origins() {
    nodes_of_cut_ = {{1, 0}, {3, 0}};
    std::map<std::uint64_t, std::uint32_t> triangles_of_cut;
    std::map<std::int32_t, std::uint64_t> cut_of_node;
    for (const auto& [face, tets] : face2tets_) {
      if (tets.size() < 2 || leaf_of_[tets[0]] == leaf_of_[tets[1]]) continue;
      const std::uint64_t cut = last_common(leaf_of_[tets[0]], leaf_of_[tets[1]]);
      face_origin_[face] = {cut, triangles_of_cut[cut]++};
      for (const std::int32_t v : face) {
        const auto it = cut_of_node.try_emplace(v, cut).first;
        it->second = std::min(it->second, cut);
      }
    }
    for (const auto& [v, cut] : cut_of_node) {
      if (node_origin_.count(v) == 0) node_origin_[v] = {cut, nodes_of_cut_[cut]++};
    }
  }

  void make_part(std::uint64_t leaf) {
    MeshPart part;
    Subdomain& subdomain = part.subdomain;
    subdomain.path = {leaf};
    std::map<std::int32_t, std::int32_t> number;
    const auto local = [&](std::int32_t v) {
      const auto [it, is_new] = number.try_emplace(v, std::ssize(part.mesh.nodes));
      if (is_new) part.mesh.nodes.push_back(place(v));
      return it->second;
    };
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (leaf_of_[t] != leaf) continue;
      for (const Face& face : faces(t)) {
        const auto origin = face_origin_.find(sorted_face(face));
        if (origin == face_origin_.end()) continue;
        subdomain.triangles.push_back({local(face[0]), local(face[1]), local(face[2])});
        subdomain.triangle_origin.push_back(origin->second);
      }
    }
    subdomain.vertices = part.mesh.nodes;
    subdomain.node_origin.resize(part.mesh.nodes.size());
    for (const auto& [v, l] : number) subdomain.node_origin[at(l)] = node_origin_.at(v);
    part.is_on_cut = nodes_on_cuts(subdomain);
    part.mesh.boundary_nodes = static_cast<std::int32_t>(part.mesh.nodes.size());
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (leaf_of_[t] != leaf) continue;
      const Tet& tet = tets_[t];
      part.mesh.tets.push_back({local(tet[0]), local(tet[1]), local(tet[2]), local(tet[3])});
    }
    grid_.table += "leaf " + std::to_string(leaf) + " " +
                   std::to_string(std::ssize(part.mesh.nodes) - part.mesh.boundary_nodes) + " " +
                   std::to_string(part.mesh.tets.size()) + "\n";
    grid_.parts[leaf] = std::move(part);
  }

  int n_;
  CutGrid grid_;
  std::vector<Tet> tets_;
  std::vector<std::uint64_t> leaf_of_;
  std::map<Face, std::vector<std::size_t>> face2tets_;
  std::map<Face, Origin> face_origin_;
  std::map<std::int32_t, Origin> node_origin_;
  std::map<std::uint64_t, std::uint32_t> nodes_of_cut_;
};

/// n^3 cubes in the leaves L, RL and RR, with the volume 1. @pre n >= 3
inline CutGrid cut_grid(int n) { return CutGridBuilder(n).take(); }

}  // namespace tetfarm
