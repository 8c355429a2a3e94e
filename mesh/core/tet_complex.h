/// Tetrahedra with their neighbours: the working form of the Delaunay kernel, boundary recovery and
/// cosmetics. TetMesh is the published form.
///
/// Layout: structure of arrays, 32-bit handles; a sub-domain has fewer than 2^29 tets.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// A face of a tet: tet << 2 | face. `no_face` means nothing on the other side.
using FaceHandle = std::int32_t;
inline constexpr FaceHandle no_face = -1;
inline constexpr FaceHandle face_handle(std::int32_t tet, int face) { return tet << 2 | face; }
inline constexpr std::int32_t tet_of(FaceHandle handle) { return handle >> 2; }
inline constexpr int face_of(FaceHandle handle) { return handle & 3; }

/// Invariants (validate): 1. a live tet has four different nodes and positive volume; a dead one
/// has nodes[0] == -1; 2. neighbours[t][i] is the face on the other side of face i (opposite node
/// i) of t, with the same three nodes, and points back; 3. node2tet[v] is a live tet that holds v,
/// or -1.
struct TetComplex {
  std::vector<Vec3> points;
  std::vector<Tet> nodes;
  std::vector<std::array<FaceHandle, 4>> neighbours;
  std::vector<std::int32_t> node2tet;
  std::vector<std::int32_t> free_tets;

  /// The nodes of a face, anticlockwise as seen from outside the tet.
  std::array<std::int32_t, 3> face_nodes(FaceHandle face) const {
    const Tet& t = nodes[static_cast<std::size_t>(tet_of(face))];
    const auto& f = tet_face_nodes[static_cast<std::size_t>(face_of(face))];
    return {t[static_cast<std::size_t>(f[0])], t[static_cast<std::size_t>(f[1])],
            t[static_cast<std::size_t>(f[2])]};
  }
  bool is_live(std::int32_t tet) const { return nodes[static_cast<std::size_t>(tet)][0] >= 0; }
  std::size_t live_tets() const { return nodes.size() - free_tets.size(); }
  /// A tet to fill: a dead one, or a new one at the end.
  std::int32_t new_tet();
  void kill_tet(std::int32_t tet);
  /// Makes the two faces each other's neighbours; either may be no_face.
  void glue(FaceHandle a, FaceHandle b);
  /// The local number of node v in the tet, or -1.
  int local_node(std::int32_t tet, std::int32_t v) const;
};

/// Neighbours are found by sorting faces; faces without a partner get no_face.
/// Cost: O(n log n).
TetComplex make_tet_complex(const TetMesh& mesh);

/// The live tets in their order; nodes keep their numbers.
TetMesh to_tet_mesh(const TetComplex& complex, std::int32_t boundary_nodes);

/// What breaks the invariants, a line each (at most 20). Volumes in long double or 113 bits.
std::vector<std::string> validate(const TetComplex& complex);

}  // namespace tetfarm
