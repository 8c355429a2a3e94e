/// A checksum of a mesh that does not depend on the file format it is kept in.
///
/// Two meshes have the same digest when they have the same nodes with the same numbers and
/// coordinates bit by bit, the same tets in the same order, the same boundary triangles with the
/// same patch numbers, in any order: formats that list them patch by patch keep the digest. Other
/// cells and boundary quads count in the same way where there are any.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/hash.h"
#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

/// XXH3-128 of four hashes (low half, high half, little endian, of each), of:
/// 1. nodes: the sum modulo 2^128 of XXH3-128(number, x, y, z);
/// 2. tets: the same sum of XXH3-128(number, four global node numbers);
/// 3. boundary triangles: the same sum of XXH3-128(three global node numbers, patch number);
/// 4. the counts of nodes, tets and boundary triangles;
/// and, where there are others, two more, of:
/// 5. the same sum of XXH3-128(VTK's code of the type, number among those of the type or the patch
///    number of a boundary face, global node numbers);
/// 6. their count.
/// Numbers are i64 and count from 0, coordinates f64, all little endian. As all are sums, the parts
/// of a mesh may be summed apart, in any order.
class MeshDigest {
 public:
  /// A sum of hashes, and how many they are.
  struct Sum {
    Hash128 hash;
    std::int64_t count = 0;

    friend bool operator==(const Sum&, const Sum&) = default;
  };

  /// Each node of the mesh once.
  void add_node(std::int64_t number, const Vec3& at);
  void add_tet(std::int64_t number, const std::array<std::int64_t, 4>& nodes);
  /// Normal out of the domain.
  void add_boundary_triangle(const std::array<std::int64_t, 3>& nodes, std::int32_t patch);
  /// A cell that is no tet, or a boundary face that is no triangle, its nodes in our order.
  void add_other(ElementType type, std::int64_t number_or_patch,
                 std::span<const std::int64_t> nodes);
  /// What another digest has summed.
  void add_tets(const Sum& tets);
  void add_others(const Sum& others);
  const Sum& tets() const { return tets_; }
  const Sum& others() const { return others_; }
  Hash128 finish() const;

 private:
  template <class Record>
  static void add(const Record& record, Sum& sum);
  static void add(const Sum& one, Sum& sum);

  Sum nodes_;
  Sum tets_;
  Sum triangles_;
  Sum others_;
};

}  // namespace tetfarm
