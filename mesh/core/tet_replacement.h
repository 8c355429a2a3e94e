/// Some tets of a complex go, and others that fill the same space come in their place.
///
/// The two sets are compared by their faces alone: positive tets with the same outer faces as those
/// that go fill the same space, so that no operation on a mesh needs a proof of its own. The steps
/// are apart for those who refuse between them (cosmetics) or keep a journal (boundary recovery):
/// open_faces, are_pairs, exchange_tets, glue_pairs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/core/tet_marks.h"

namespace tetfarm {

/// A face that needs a partner: one of the cavity that the old tets leave, or one of a new tet.
struct OpenFace {
  std::array<std::int32_t, 3> nodes;  ///< ascending
  /// Of the cavity: the face beyond, or no_face. Of a new tet: by its place in the list.
  FaceHandle handle;
  bool is_outer;  ///< of the cavity
  /// Whether ascending order turns it round, as the old or the new tet has it.
  bool is_turned;

  friend bool operator<(const OpenFace& a, const OpenFace& b) {
    if (a.nodes[0] != b.nodes[0]) return a.nodes[0] < b.nodes[0];
    if (a.nodes[1] != b.nodes[1]) return a.nodes[1] < b.nodes[1];
    if (a.nodes[2] != b.nodes[2]) return a.nodes[2] < b.nodes[2];
    return a.is_outer != b.is_outer ? a.is_outer : a.handle < b.handle;
  }
};

/// In ascending order: partners side by side, that of the cavity first. `marks` hold the old tets
/// afterwards. @pre the old tets are live, and there is room for them in `marks`.
/// Cost: O(k log k) for k tets.
std::vector<OpenFace> open_faces(const TetComplex& complex, std::span<const std::int32_t> old_tets,
                                 std::span<const Tet> new_tets, TetMarks& marks);

/// Whether the faces come in pairs that fit together: then positive new tets fill the cavity.
/// @pre ascending. Cost: O(k).
bool are_pairs(std::span<const OpenFace> faces);

/// Takes out the old tets and puts in the new ones, which have no neighbours yet, under the numbers
/// that come back. A node of the old tets that no new one holds is out of the complex: its node2tet
/// is -1. @pre the old tets are live, each named once. Cost: O(k).
std::vector<std::int32_t> exchange_tets(TetComplex& complex, std::span<const std::int32_t> old_tets,
                                        std::span<const Tet> new_tets);

/// Makes partners each other's neighbours. @pre are_pairs(faces), and `numbers` are those that
/// exchange_tets gave. Cost: O(k).
void glue_pairs(TetComplex& complex, std::span<const OpenFace> faces,
                std::span<const std::int32_t> numbers);

/// The face of the complex that an open face is, once the new tets have their numbers.
FaceHandle face_in_complex(const OpenFace& face, std::span<const std::int32_t> numbers);

}  // namespace tetfarm
