#include "mesh/core/tet_replacement.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

OpenFace open_face(const Tet& tet, int face, FaceHandle handle, bool is_outer) {
  const auto& local = tet_face_nodes[at(face)];
  OpenFace open{{tet[at(local[0])], tet[at(local[1])], tet[at(local[2])]}, handle, is_outer, false};
  open.is_turned = sort_face(open.nodes);
  return open;
}

}  // namespace

std::vector<OpenFace> open_faces(const TetComplex& complex, std::span<const std::int32_t> old_tets,
                                 std::span<const Tet> new_tets, TetMarks& marks) {
  std::vector<OpenFace> faces;
  faces.reserve(4 * (old_tets.size() + new_tets.size()));
  marks.clear();
  for (const std::int32_t t : old_tets) marks.add(t);
  for (const std::int32_t t : old_tets) {
    for (int face = 0; face < 4; ++face) {
      const FaceHandle across = complex.neighbours[at(t)][at(face)];
      if (across != no_face && marks.has(tet_of(across))) continue;
      faces.push_back(open_face(complex.nodes[at(t)], face, across, true));
    }
  }
  for (std::size_t i = 0; i < new_tets.size(); ++i) {
    for (int face = 0; face < 4; ++face) {
      const FaceHandle handle = face_handle(static_cast<std::int32_t>(i), face);
      faces.push_back(open_face(new_tets[i], face, handle, false));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

bool are_pairs(std::span<const OpenFace> faces) {
  if (faces.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    const OpenFace& a = faces[i];
    const OpenFace& b = faces[i + 1];
    // A face of the cavity runs as its old tet has it, and so does that of the new one in its
    // place.
    if (a.nodes != b.nodes || b.is_outer || (a.is_turned == b.is_turned) != a.is_outer) {
      return false;
    }
    if (i > 0 && faces[i - 1].nodes == a.nodes) return false;
  }
  return true;
}

std::vector<std::int32_t> exchange_tets(TetComplex& complex, std::span<const std::int32_t> old_tets,
                                        std::span<const Tet> new_tets) {
  for (const std::int32_t t : old_tets) {
    TF_CHECK(complex.is_live(t));
    for (const std::int32_t v : complex.nodes[at(t)]) complex.node2tet[at(v)] = -1;
    complex.kill_tet(t);
  }
  std::vector<std::int32_t> numbers;
  numbers.reserve(new_tets.size());
  for (const Tet& tet : new_tets) {
    const std::int32_t t = complex.new_tet();
    complex.nodes[at(t)] = tet;
    for (const std::int32_t v : tet) complex.node2tet[at(v)] = t;
    numbers.push_back(t);
  }
  return numbers;
}

FaceHandle face_in_complex(const OpenFace& face, std::span<const std::int32_t> numbers) {
  if (face.is_outer) return face.handle;
  return face_handle(numbers[at(tet_of(face.handle))], face_of(face.handle));
}

void glue_pairs(TetComplex& complex, std::span<const OpenFace> faces,
                std::span<const std::int32_t> numbers) {
  TF_CHECK(faces.size() % 2 == 0);
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    TF_CHECK(faces[i].nodes == faces[i + 1].nodes);
    complex.glue(face_in_complex(faces[i], numbers), face_in_complex(faces[i + 1], numbers));
  }
}

}  // namespace tetfarm
