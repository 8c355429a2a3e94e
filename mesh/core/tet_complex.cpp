#include "mesh/core/tet_complex.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {

namespace {

constexpr std::size_t most_messages = 20;

/// A face in the bucket of its smallest node.
struct BucketedFace {
  std::int32_t middle;
  std::int32_t largest;
  FaceHandle handle;

  bool same_nodes(const BucketedFace& b) const {
    return middle == b.middle && largest == b.largest;
  }
  friend bool operator<(const BucketedFace& a, const BucketedFace& b) {
    if (a.middle != b.middle) return a.middle < b.middle;
    return a.largest != b.largest ? a.largest < b.largest : a.handle < b.handle;
  }
};

/// The faces in buckets by smallest node: bucket v is [starts[v], starts[v + 1]).
struct FaceBuckets {
  std::vector<std::size_t> starts;
  std::vector<BucketedFace> faces;
};

FaceBuckets bucket_faces(const TetMesh& mesh) {
  FaceBuckets buckets;
  buckets.starts.assign(mesh.nodes.size() + 2, 0);
  for (const Tet& tet : mesh.tets) {
    for (int face = 0; face < 4; ++face) ++buckets.starts[at(sorted_face(tet, face)[0]) + 2];
  }
  for (std::size_t v = 2; v < buckets.starts.size(); ++v)
    buckets.starts[v] += buckets.starts[v - 1];
  buckets.faces.resize(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (int face = 0; face < 4; ++face) {
      const auto nodes = sorted_face(mesh.tets[t], face);
      buckets.faces[buckets.starts[at(nodes[0]) + 1]++] = {
          nodes[1], nodes[2], face_handle(static_cast<std::int32_t>(t), face)};
    }
  }
  return buckets;
}

/// True when `a` and `b` name the same three nodes in opposite directions, as two faces that touch
/// do.
bool are_opposite(const TetComplex& complex, FaceHandle a, FaceHandle b) {
  const auto node = [&](FaceHandle handle, std::size_t i) {
    const auto& local = tet_face_nodes[at(face_of(handle))];
    return complex.nodes[at(tet_of(handle))][at(local[i])];
  };
  for (std::size_t turn = 0; turn < 3; ++turn) {
    if (node(a, 0) == node(b, turn) && node(a, 1) == node(b, (turn + 2) % 3) &&
        node(a, 2) == node(b, (turn + 1) % 3)) {
      return true;
    }
  }
  return false;
}

/// Differences of doubles are exact in it: tells a flat tet's volume from zero where long double
/// cannot.
__extension__ typedef __float128 Quad;

template <typename Real>
bool is_volume_positive(const TetComplex& complex, const Tet& tet) {
  const Vec3& origin = complex.points[at(tet[0])];
  std::array<std::array<Real, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = complex.points[at(tet[i + 1])];
    m[i] = {Real(p.x) - Real(origin.x), Real(p.y) - Real(origin.y), Real(p.z) - Real(origin.z)};
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) >
         0;
}

bool has_positive_volume(const TetComplex& complex, const Tet& tet) {
  return is_volume_positive<long double>(complex, tet) || is_volume_positive<Quad>(complex, tet);
}

/// What is wrong with the nodes of tet t; empty when nothing is.
std::string wrong_nodes(const TetComplex& complex, std::int32_t t) {
  const Tet& tet = complex.nodes[at(t)];
  const auto points = static_cast<std::int32_t>(complex.points.size());
  for (std::size_t i = 0; i < 4; ++i) {
    if (tet[i] < 0 || tet[i] >= points) return "has node " + std::to_string(tet[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (tet[i] == tet[j]) return "has node " + std::to_string(tet[i]) + " twice";
    }
  }
  return has_positive_volume(complex, tet) ? "" : "has no positive volume";
}

/// What is wrong with the tet across a face; nullptr when nothing is.
const char* wrong_across(const TetComplex& complex, FaceHandle face, FaceHandle across) {
  if (across < 0 || at(tet_of(across)) >= complex.nodes.size()) return "which does not exist";
  if (!complex.is_live(tet_of(across))) return "which is dead";
  if (complex.neighbours[at(tet_of(across))][at(face_of(across))] != face) {
    return "which does not point back";
  }
  return are_opposite(complex, face, across) ? nullptr : "with other nodes";
}

/// What is wrong with the neighbours of tet t; empty when nothing is.
std::string wrong_neighbours(const TetComplex& complex, std::int32_t t) {
  for (int face = 0; face < 4; ++face) {
    const FaceHandle across = complex.neighbours[at(t)][at(face)];
    if (across == no_face) continue;
    const char* wrong = wrong_across(complex, face_handle(t, face), across);
    if (wrong == nullptr) continue;
    return "has across face " + std::to_string(face) + " tet " + std::to_string(tet_of(across)) +
           " " + wrong;
  }
  return "";
}

}  // namespace

std::int32_t TetComplex::new_tet() {
  if (!free_tets.empty()) {
    const std::int32_t tet = free_tets.back();
    free_tets.pop_back();
    TF_CHECK(!is_live(tet));
    return tet;
  }
  TF_CHECK(nodes.size() < std::size_t{1} << 29);
  nodes.push_back({-1, -1, -1, -1});
  neighbours.push_back({no_face, no_face, no_face, no_face});
  return static_cast<std::int32_t>(nodes.size() - 1);
}

void TetComplex::kill_tet(std::int32_t tet) {
  TF_CHECK(is_live(tet));
  nodes[at(tet)] = {-1, -1, -1, -1};
  neighbours[at(tet)] = {no_face, no_face, no_face, no_face};
  free_tets.push_back(tet);
}

void TetComplex::glue(FaceHandle a, FaceHandle b) {
  if (a != no_face) neighbours[at(tet_of(a))][at(face_of(a))] = b;
  if (b != no_face) neighbours[at(tet_of(b))][at(face_of(b))] = a;
}

int TetComplex::local_node(std::int32_t tet, std::int32_t v) const {
  const Tet& tet_nodes = nodes[at(tet)];
  for (int i = 0; i < 4; ++i) {
    if (tet_nodes[at(i)] == v) return i;
  }
  return -1;
}

TetComplex make_tet_complex(const TetMesh& mesh) {
  TF_CHECK(mesh.tets.size() < std::size_t{1} << 29);
  TetComplex complex;
  complex.points = mesh.nodes;
  complex.nodes = mesh.tets;
  complex.neighbours.assign(mesh.tets.size(), {no_face, no_face, no_face, no_face});
  complex.node2tet.assign(mesh.nodes.size(), -1);
  for (std::size_t t = mesh.tets.size(); t-- > 0;) {
    for (const std::int32_t node : mesh.tets[t]) {
      TF_CHECK(at(node) < mesh.nodes.size());
      complex.node2tet[at(node)] = static_cast<std::int32_t>(t);
    }
  }
  FaceBuckets buckets = bucket_faces(mesh);
  const auto face = [&](std::size_t i) {
    return buckets.faces.begin() + static_cast<std::ptrdiff_t>(i);
  };
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    const std::size_t end = buckets.starts[v + 1];
    std::sort(face(buckets.starts[v]), face(end));
    for (std::size_t i = buckets.starts[v]; i + 1 < end; ++i) {
      if (!face(i)->same_nodes(*face(i + 1))) continue;
      complex.glue(face(i)->handle, face(i + 1)->handle);
      ++i;
    }
  }
  return complex;
}

TetMesh to_tet_mesh(const TetComplex& complex, std::int32_t boundary_nodes) {
  TF_CHECK(boundary_nodes >= 0 && at(boundary_nodes) <= complex.points.size());
  TetMesh mesh;
  mesh.boundary_nodes = boundary_nodes;
  mesh.nodes = complex.points;
  mesh.tets.reserve(complex.live_tets());
  for (const Tet& tet : complex.nodes) {
    if (tet[0] >= 0) mesh.tets.push_back(tet);
  }
  TF_CHECK(mesh.tets.size() == complex.live_tets());
  return mesh;
}

std::vector<std::string> validate(const TetComplex& complex) {
  std::vector<std::string> wrong;
  const auto report = [&](const std::string& message) {
    if (wrong.size() < most_messages) wrong.push_back(message);
  };
  if (complex.neighbours.size() != complex.nodes.size()) return {"neighbours: wrong length"};
  if (complex.node2tet.size() != complex.points.size()) return {"node2tet: wrong length"};
  std::size_t dead = 0;
  for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
    if (!complex.is_live(t)) {
      ++dead;
      continue;
    }
    std::string what = wrong_nodes(complex, t);
    if (what.empty()) what = wrong_neighbours(complex, t);
    if (!what.empty()) report("tet " + std::to_string(t) + " " + what);
  }
  if (dead != complex.free_tets.size()) report("free_tets does not list the dead tets");
  for (const std::int32_t t : complex.free_tets) {
    if (t < 0 || at(t) >= complex.nodes.size() || complex.is_live(t)) {
      report("free_tets holds tet " + std::to_string(t));
    }
  }
  for (std::size_t v = 0; v < complex.node2tet.size(); ++v) {
    const std::int32_t t = complex.node2tet[v];
    if (t == -1) continue;
    if (t < 0 || at(t) >= complex.nodes.size() || !complex.is_live(t) ||
        complex.local_node(t, static_cast<std::int32_t>(v)) < 0) {
      report("node2tet of node " + std::to_string(v) + " is tet " + std::to_string(t));
    }
  }
  return wrong;
}

}  // namespace tetfarm
