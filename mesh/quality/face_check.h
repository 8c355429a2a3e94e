/// Whether the tets of a mesh that passes by in parts fit together at their faces: each face is
/// shared by exactly two tets, from its two sides, or is a boundary triangle of exactly one, and
/// each boundary triangle is such a face. Exact, in bounded memory, for meshes of any size.
///
/// Faces are matched part by part. Those that have both their tets in one part, which are nearly
/// all, are done with; what is left, on cuts and on the boundary, is sorted together by the numbers
/// of its nodes, on disk where it must be. A set of tets of positive volume always has faces on its
/// outside, so that nothing that is there twice can be hidden in what is done with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/formats/external_sort.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// How often tets and boundary triangles have a face, in either direction: [0] with the nodes in
/// ascending order, turned or not, [1] the other way round. Counts end at 255.
struct FaceUse {
  std::array<std::uint8_t, 2> tets{};
  std::array<std::uint8_t, 2> boundary{};

  bool is_right() const;
  void add(const FaceUse& other);
  std::string text() const;
};

/// Its nodes in the whole mesh, ascending; of a quad the lowest, the lower of its neighbours, the
/// opposite one and the other neighbour. The fourth of a triangle is -1.
using FaceCorners = std::array<std::int64_t, 4>;

class FaceCheck {
 public:
  /// `memory_bytes` bounds what is kept besides the part that is looked at, but for the
  /// faces of one node and 12 bytes a node of the part. `folder` is for files without names.
  FaceCheck(const std::filesystem::path& folder, std::size_t memory_bytes);

  /// Each part once, in any order. @throws IoError. Cost: some 0.1 microseconds a tet.
  void add(const NumberedPart& part);
  /// Those that are not right, the first by their nodes, at most `most`. Called once, after the
  /// last part.
  std::vector<FaceCorners> finish(std::size_t most);

 private:
  struct OpenFace {
    FaceCorners nodes{};
    FaceUse use;
    bool operator<(const OpenFace& other) const { return nodes < other.nodes; }
  };

  void add_triangles(const NumberedPart& part);
  void add_quads(const NumberedPart& part);
  void keep_open(OpenFace open);

  std::size_t keys_at_once_;
  ExternalSort<OpenFace> open_;
};

/// A line for each face: its nodes and where they lie, which tets and boundary triangles have it.
/// Tets and triangles are counted part after part, from 0. Reads every part once.
/// @pre at most some dozens of faces.
std::vector<std::string> describe_faces(const MeshSource& source,
                                        const std::vector<FaceCorners>& faces);

}  // namespace tetfarm
