/// A checksum of a mesh that does not depend on the file format it is kept in.
///
/// Two meshes have the same digest when they have the same nodes with the same numbers and
/// coordinates bit by bit, the same tets in the same order, the same boundary triangles with the
/// same patch numbers in the same order.
#pragma once

#include <array>
#include <cstdint>

#include "base/hash.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

/// XXH3-128 of four hashes (low half, high half, little endian, of each), of:
/// 1. nodes: the sum modulo 2^128 of XXH3-128(number, x, y, z), so that they may come in any order;
/// 2. tets: XXH3-128 of their four global numbers, one after the other, in order;
/// 3. boundary triangles: XXH3-128 of three global numbers and the patch number, in order;
/// 4. the counts of nodes, tets and boundary triangles.
/// Numbers are i64 and count from 0, coordinates f64, all little endian.
class MeshDigest {
 public:
  /// Each node of the mesh once.
  void add_node(std::int64_t number, const Vec3& at);
  void add_tet(const std::array<std::int64_t, 4>& nodes);
  /// Normal out of the domain.
  void add_boundary_triangle(const std::array<std::int64_t, 3>& nodes, std::int32_t patch);
  Hash128 finish() const;

 private:
  Hash128 nodes_;
  Hasher tets_;
  Hasher triangles_;
  std::array<std::int64_t, 3> counts_{};
};

}  // namespace tetfarm
