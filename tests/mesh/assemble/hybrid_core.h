/// A portion of tets of a cut_grid with a hex, or two prisms, in its middle, and pyramids around
/// them: what a sub-domain is with cells of every type, behind a boundary of triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "base/array_index.h"
#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Cubes of six tets, along the grid's diagonals, become other cells; one central cube by
/// `is_hex` or two prisms, and the cubes that share a quad with it by pyramids and tets around a
/// new node in their middle.
class HybridCore {
 public:
  using Cube = std::array<int, 3>;

  /// @pre the portion has all tets of the cube and of its six neighbours, out of cut_grid(n), and
  /// its own nodes have the largest global numbers.
  HybridCore(Portion& portion, int n, const Cube& middle, bool is_hex)
      : part_(portion.part), n_(n), middle_(middle) {
    for (std::size_t v = 0; v < part_.nodes.size(); ++v) number_[cube_at(part_.nodes[v])] = v;
    for (std::size_t axis = 0; axis < (is_hex ? 3U : 2U); ++axis) {
      for (const int step : {-1, 1}) {
        Cube beside = middle;
        beside[axis] += step;
        add_neighbour(beside, axis, step);
      }
    }
    take_tets(middle);
    is_hex ? add_hex() : add_prisms();
  }

 private:
  Cube cube_at(const Vec3& p) const {
    const auto index = [this](double x) { return static_cast<int>(std::floor(x * n_ + 1e-9)); };
    return {index(p.x), index(p.y), index(p.z)};
  }
  Vec3 centre(const std::vector<std::int32_t>& nodes) const {
    Vec3 sum;
    for (const std::int32_t v : nodes) sum = sum + part_.nodes[at(v)];
    return (1.0 / static_cast<double>(nodes.size())) * sum;
  }
  std::int32_t corner(const Cube& cube, const Cube& step) const {
    return static_cast<std::int32_t>(
        number_.at({cube[0] + step[0], cube[1] + step[1], cube[2] + step[2]}));
  }

  std::vector<Tet> take_tets(const Cube& cube) {
    const auto is_there = [&](const Tet& tet) {
      return cube_at(centre({tet.begin(), tet.end()})) == cube;
    };
    std::vector<Tet> taken;
    std::copy_if(part_.tets.begin(), part_.tets.end(), std::back_inserter(taken), is_there);
    part_.tets.erase(std::remove_if(part_.tets.begin(), part_.tets.end(), is_there),
                     part_.tets.end());
    return taken;
  }

  void add(ElementType type, const std::vector<std::int32_t>& nodes) {
    ElementBlock& block = part_.blocks[type];
    block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
    block.regions.push_back(part_.region);
  }

  /// A tet on each face of the cube's skin, from its middle, but a pyramid on the side that it
  /// shares with the central cube.
  void add_neighbour(const Cube& cube, std::size_t axis, int step) {
    const std::vector<Tet> old = take_tets(cube);
    const auto apex = static_cast<std::int32_t>(part_.nodes.size());
    part_.nodes.push_back((1.0 / n_) * Vec3{cube[0] + 0.5, cube[1] + 0.5, cube[2] + 0.5});
    part_.local2global.push_back(
        1 + *std::max_element(part_.local2global.begin(), part_.local2global.end()));
    for (const Tet& tet : old) {
      for (const auto& face : tet_face_nodes) {
        const std::array<std::int32_t, 3> nodes = {tet[at(face[0])], tet[at(face[1])],
                                                   tet[at(face[2])]};
        const std::optional<std::pair<std::size_t, int>> side = side_of(nodes, cube);
        if (!side || *side == std::pair{axis, -step}) continue;
        part_.tets.push_back({nodes[0], nodes[2], nodes[1], apex});
      }
    }
    std::vector<std::int32_t> base;
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      Cube corner_step{};
      corner_step[axis] = step < 0 ? 1 : 0;
      corner_step[(axis + 1) % 3] = a;
      corner_step[(axis + 2) % 3] = b;
      base.push_back(corner(cube, corner_step));
    }
    if (step < 0) std::reverse(base.begin(), base.end());
    base.push_back(apex);
    add(ElementType::pyramid, base);
  }
  /// Axis and direction of the side of the cube that the face lies in.
  std::optional<std::pair<std::size_t, int>> side_of(const std::array<std::int32_t, 3>& face,
                                                     const Cube& cube) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {0, 1}) {
        const bool is_in = std::all_of(face.begin(), face.end(), [&](std::int32_t v) {
          const Vec3& p = part_.nodes[at(v)];
          const std::array<double, 3> x = {p.x, p.y, p.z};
          return std::abs(x[axis] * n_ - (cube[axis] + step)) < 1e-6;
        });
        if (is_in) return std::pair{axis, step == 0 ? -1 : 1};
      }
    }
    return std::nullopt;
  }

  void add_hex() {
    std::vector<std::int32_t> nodes;
    for (const Cube& step : {Cube{0, 0, 0}, Cube{1, 0, 0}, Cube{1, 1, 0}, Cube{0, 1, 0},
                             Cube{0, 0, 1}, Cube{1, 0, 1}, Cube{1, 1, 1}, Cube{0, 1, 1}}) {
      nodes.push_back(corner(middle_, step));
    }
    add(ElementType::hex, nodes);
  }
  /// Along the diagonals of the tets above and below.
  void add_prisms() {
    for (const Cube& third : {Cube{1, 0, 0}, Cube{0, 1, 0}}) {
      std::vector<std::int32_t> nodes;
      for (const int z : {0, 1}) {
        std::vector<Cube> steps = {{0, 0, z}, {1, 1, z}, {third[0], third[1], z}};
        if (third[0] == 1) std::swap(steps[1], steps[2]);
        for (const Cube& step : steps) nodes.push_back(corner(middle_, step));
      }
      add(ElementType::prism, nodes);
    }
  }

  NumberedPart& part_;
  int n_;
  Cube middle_;
  std::map<Cube, std::size_t> number_;
};

}  // namespace tetfarm
