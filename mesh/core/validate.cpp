#include "mesh/core/validate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"
#include "mesh/core/signed_volume.h"

namespace tetfarm {
namespace {

using std::to_string;

/// Items in buckets by their smallest node: two passes of `for_each`, which calls its argument with
/// (smallest node, key), instead of one sort of everything. Each bucket comes out sorted.
template <class Key>
struct Buckets {
  std::vector<std::size_t> end;  // bucket b is keys[b == 0 ? 0 : end[b - 1]] up to keys[end[b]]
  std::vector<Key> keys;

  template <class ForEach>
  Buckets(std::size_t bucket_count, ForEach for_each) : end(bucket_count, 0) {
    for_each([&](std::int32_t bucket, Key) { ++end[at(bucket)]; });
    std::size_t start = 0;
    for (std::size_t& e : end) start += std::exchange(e, start);
    keys.resize(start);
    for_each([&](std::int32_t bucket, Key key) { keys[end[at(bucket)]++] = key; });
    start = 0;
    for (const std::size_t e : end) {
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(start),
                keys.begin() + static_cast<std::ptrdiff_t>(e));
      start = e;
    }
  }
};

constexpr std::uint64_t odd_bit = 1;
constexpr std::uint64_t boundary_bit = 2;

/// The two larger nodes of a face, and whether it runs through its nodes in an odd order. Equal but
/// for the two lowest bits when the nodes are the same.
struct FaceKey {
  std::int32_t smallest = 0;
  std::uint64_t key = 0;
};

FaceKey face_key(std::int32_t a, std::int32_t b, std::int32_t c) {
  if (b < a && b < c) {
    std::swap(a, b);
    std::swap(b, c);
  } else if (c < a) {
    std::swap(a, c);
    std::swap(b, c);
  }
  const std::uint64_t odd = b > c ? odd_bit : 0;
  if (b > c) std::swap(b, c);
  return {a, static_cast<std::uint64_t>(b) << 33 | static_cast<std::uint64_t>(c) << 2 | odd};
}

/// How often tets and boundary triangles use a face, in each direction.
struct FaceUse {
  std::array<int, 2> tets{};
  std::array<int, 2> boundary{};

  bool is_right() const {
    if (boundary[0] == 0 && boundary[1] == 0) return tets[0] == 1 && tets[1] == 1;
    return std::max(boundary[0], boundary[1]) == 1 && tets == boundary;
  }
  std::string text() const {
    return "used by " + to_string(tets[0] + tets[1]) + " tets (" + to_string(tets[0]) +
           " in one, " + to_string(tets[1]) + " in the other direction) and " +
           to_string(boundary[0] + boundary[1]) + " boundary triangles (" + to_string(boundary[0]) +
           ", " + to_string(boundary[1]) + ")";
  }
};

template <std::size_t N>
bool are_different_nodes(const std::array<std::int32_t, N>& nodes, std::size_t node_count) {
  for (std::size_t i = 0; i < N; ++i) {
    if (nodes[i] < 0 || at(nodes[i]) >= node_count) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (nodes[i] == nodes[j]) return false;
    }
  }
  return true;
}

template <std::size_t N>
std::string nodes_text(const std::array<std::int32_t, N>& nodes) {
  std::string text = "(";
  for (std::size_t i = 0; i < N; ++i) text += (i == 0 ? "" : ", ") + to_string(nodes[i]);
  return text + ")";
}

void find_bad_indices(const TetMesh& mesh, const std::vector<Triangle>& triangles,
                      Complaints& complaints) {
  if (mesh.boundary_nodes < 0 || at(mesh.boundary_nodes) > mesh.nodes.size()) {
    complaints.add(to_string(mesh.boundary_nodes) + " boundary nodes of " +
                   to_string(mesh.nodes.size()) + " nodes");
    return;
  }
  for (std::size_t i = 0; i < mesh.tets.size() && !complaints.full(); ++i) {
    if (are_different_nodes(mesh.tets[i], mesh.nodes.size())) continue;
    complaints.add("tet " + to_string(i) + " " + nodes_text(mesh.tets[i]) +
                   " does not have four different nodes that exist");
  }
  for (std::size_t i = 0; i < triangles.size() && !complaints.full(); ++i) {
    if (are_different_nodes(triangles[i], at(mesh.boundary_nodes))) continue;
    complaints.add("boundary triangle " + to_string(i) + " " + nodes_text(triangles[i]) +
                   " does not have three different nodes of the boundary");
  }
}

void find_bad_nodes(const TetMesh& mesh, Complaints& complaints) {
  std::vector<bool> is_used(mesh.nodes.size(), false);
  for (const Tet& tet : mesh.tets) {
    for (const std::int32_t v : tet) is_used[at(v)] = true;
  }
  for (std::size_t v = 0; v < mesh.nodes.size() && !complaints.full(); ++v) {
    const Vec3& p = mesh.nodes[v];
    if (!is_used[v]) complaints.add("node " + to_string(v) + " " + text_of(p) + " is in no tet");
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      complaints.add("node " + to_string(v) + " " + text_of(p) + " is not finite");
    }
  }
}

/// As good as random, and another for each number (the finalizer of SplitMix64).
std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ x >> 27U) * 0x94d049bb133111ebULL;
  return x ^ x >> 31U;
}
std::uint64_t scrambled_node(std::int32_t v) {
  return scrambled((static_cast<std::uint64_t>(v) + 1) * 0x9e3779b97f4a7c15ULL);
}

/// What a face adds to a sum in which it and the same face the other way round are nothing.
std::uint64_t signed_face(const std::array<std::int32_t, 3>& nodes,
                          const std::array<std::uint64_t, 3>& scrambled_nodes) {
  const auto& [a, b, c] = nodes;
  const std::uint64_t face =
      scrambled(scrambled_nodes[0] + scrambled_nodes[1] + scrambled_nodes[2]);
  const bool is_odd = (a > b) != ((b > c) != (a > c));
  return is_odd ? 0 - face : face;
}

bool has_repeated_face(const TetMesh& mesh, const std::vector<Triangle>& triangles) {
  const Buckets<std::uint64_t> faces(mesh.nodes.size(), [&triangles](auto visit) {
    for (const auto& [a, b, c] : triangles) {
      const FaceKey face = face_key(a, b, c);
      visit(face.smallest, face.key);
    }
  });
  std::size_t i = 0;
  for (const std::size_t end : faces.end) {
    for (; i + 1 < end; ++i) {
      if (faces.keys[i] >> 2 == faces.keys[i + 1] >> 2) return true;
    }
    i = end;
  }
  return false;
}

/// Whether the faces of the tets, each with its direction, come to the boundary's triangles when
/// those that meet cancel out. Then tets of positive volume cover what the boundary encloses once,
/// so that no face can have two on one side; that one wrong mesh in 2^64 passes is accepted. All
/// meshes but wrong ones are done with here.
bool faces_come_to_boundary(const TetMesh& mesh, const std::vector<Triangle>& triangles) {
  std::uint64_t sum = 0;
  for (const Tet& tet : mesh.tets) {
    std::array<std::uint64_t, 4> scrambled_nodes;
    for (std::size_t i = 0; i < 4; ++i) scrambled_nodes[i] = scrambled_node(tet[i]);
    for (const auto& local : tet_face_nodes) {
      const std::size_t i = at(local[0]), j = at(local[1]), k = at(local[2]);
      sum += signed_face({tet[i], tet[j], tet[k]},
                         {scrambled_nodes[i], scrambled_nodes[j], scrambled_nodes[k]});
    }
  }
  for (const auto& [a, b, c] : triangles) {
    sum -= signed_face({a, b, c}, {scrambled_node(a), scrambled_node(b), scrambled_node(c)});
  }
  return sum == 0 && !has_repeated_face(mesh, triangles);
}

void find_bad_faces(const TetMesh& mesh, const std::vector<Triangle>& triangles,
                    Complaints& complaints) {
  if (faces_come_to_boundary(mesh, triangles)) return;
  const auto for_each_face = [&](auto visit) {
    for (const Tet& tet : mesh.tets) {
      for (const auto& [i, j, k] : tet_face_nodes) {
        const auto local = [&](int n) { return tet[static_cast<std::size_t>(n)]; };
        const FaceKey face = face_key(local(i), local(j), local(k));
        visit(face.smallest, face.key);
      }
    }
    for (const auto& [a, b, c] : triangles) {
      const FaceKey face = face_key(a, b, c);
      visit(face.smallest, face.key | boundary_bit);
    }
  };
  const Buckets<std::uint64_t> faces(mesh.nodes.size(), for_each_face);
  std::size_t i = 0;
  for (std::size_t bucket = 0; bucket < faces.end.size() && !complaints.full(); ++bucket) {
    while (i < faces.end[bucket]) {
      const std::uint64_t nodes = faces.keys[i] >> 2;
      FaceUse use;
      for (; i < faces.end[bucket] && faces.keys[i] >> 2 == nodes; ++i) {
        auto& of = (faces.keys[i] & boundary_bit) != 0 ? use.boundary : use.tets;
        ++of[faces.keys[i] & odd_bit];
      }
      if (use.is_right()) continue;
      const std::array<std::int32_t, 3> face = {static_cast<std::int32_t>(bucket),
                                                static_cast<std::int32_t>(nodes >> 31),
                                                static_cast<std::int32_t>(nodes & 0x7fffffff)};
      complaints.add("face " + nodes_text(face) + " at " + text_of(mesh.nodes[bucket]) + " is " +
                     use.text());
    }
  }
}

/// Six times the volume in doubles, or 0 where rounding may be more than a thousandth of it.
double certain_volume6(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const double volume6 = dot(cross(u, v), w);
  // Rounding is less than 1e-15 times the product of the lengths.
  constexpr double share2 = 1e-24;
  return volume6 * volume6 > share2 * (norm2(u) * norm2(v) * norm2(w)) ? volume6 : 0;
}

void find_bad_volumes(const TetMesh& mesh, const std::vector<Triangle>& triangles,
                      Complaints& complaints) {
  const auto p = [&mesh](std::int32_t v) { return mesh.nodes[at(v)]; };
  long double of_tets = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tets[i];
    const Vec3& from = mesh.nodes[at(a)];
    const double certain = certain_volume6(from, p(b), p(c), p(d));
    if (certain > 0) {
      of_tets += static_cast<long double>(certain) / 6;
      continue;
    }
    const long double volume = signed_volume(from, p(b), p(c), p(d));
    of_tets += volume;
    if (volume > 0 || has_positive_volume(from, p(b), p(c), p(d))) continue;
    complaints.add("tet " + to_string(i) + " " + nodes_text(mesh.tets[i]) + " at " + text_of(from) +
                   " has the volume " + text_of(static_cast<double>(volume)));
  }
  const Vec3 centre = bounding_box(mesh.nodes).centre();
  long double enclosed = 0;
  for (const auto& [a, b, c] : triangles) {
    enclosed += signed_volume(centre, p(a), p(b), p(c));
  }
  if (std::fabs(of_tets - enclosed) <= 1e-9L * std::fabs(enclosed)) return;
  complaints.add("the tets fill " + text_of(static_cast<double>(of_tets)) +
                 " but the boundary encloses " + text_of(static_cast<double>(enclosed)));
}

}  // namespace

std::vector<std::string> validate(const TetMesh& mesh, const std::vector<Triangle>& triangles) {
  Complaints complaints;
  find_bad_indices(mesh, triangles, complaints);
  if (!complaints.empty()) return complaints.take();
  find_bad_nodes(mesh, complaints);
  find_bad_faces(mesh, triangles, complaints);
  find_bad_volumes(mesh, triangles, complaints);
  return complaints.take();
}

std::vector<std::array<std::int32_t, 2>> unmatched_edges(const std::vector<Triangle>& triangles) {
  std::int32_t last = -1;
  for (const Triangle& triangle : triangles) {
    TF_CHECK(*std::min_element(triangle.begin(), triangle.end()) >= 0);
    last = std::max(last, *std::max_element(triangle.begin(), triangle.end()));
  }
  const auto for_each_edge = [&](auto visit) {
    for (const Triangle& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
        visit(low, static_cast<std::uint32_t>(high) << 1 | (low == triangle[i] ? 0U : 1U));
      }
    }
  };
  const Buckets<std::uint32_t> edges(at(last + 1), for_each_edge);
  std::vector<std::array<std::int32_t, 2>> unmatched;
  std::size_t i = 0;
  for (std::size_t bucket = 0; bucket < edges.end.size(); ++bucket) {
    while (i < edges.end[bucket]) {
      const std::uint32_t other = edges.keys[i] >> 1;
      int balance = 0;
      for (; i < edges.end[bucket] && edges.keys[i] >> 1 == other; ++i) {
        balance += (edges.keys[i] & 1) == 0 ? 1 : -1;
      }
      const auto low = static_cast<std::int32_t>(bucket);
      const auto high = static_cast<std::int32_t>(other);
      if (balance > 0) unmatched.push_back({low, high});
      if (balance < 0) unmatched.push_back({high, low});
    }
  }
  return unmatched;
}

}  // namespace tetfarm
