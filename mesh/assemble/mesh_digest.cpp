#include "mesh/assemble/mesh_digest.h"

#include <bit>
#include <cstring>

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little, "digests are of little-endian numbers");

Hash128 sum(const Hash128& a, const Hash128& b) {
  const std::uint64_t low = a.low + b.low;
  const std::uint64_t carry = low < a.low ? 1 : 0;
  return {a.high + b.high + carry, low};
}

void add_hash(Hasher& hasher, const Hash128& hash) {
  hasher.add(&hash.low, sizeof hash.low);
  hasher.add(&hash.high, sizeof hash.high);
}

}  // namespace

void MeshDigest::add_node(std::int64_t number, const Vec3& at) {
  std::array<unsigned char, 32> bytes;
  const std::array<double, 3> coordinates = {at.x, at.y, at.z};
  std::memcpy(bytes.data(), &number, 8);
  std::memcpy(bytes.data() + 8, coordinates.data(), 24);
  nodes_ = sum(nodes_, hash128(bytes.data(), bytes.size()));
  ++counts_[0];
}

void MeshDigest::add_tet(const std::array<std::int64_t, 4>& nodes) {
  tets_.add(nodes.data(), sizeof nodes);
  ++counts_[1];
}

void MeshDigest::add_boundary_triangle(const std::array<std::int64_t, 3>& nodes,
                                       std::int32_t patch) {
  const std::array<std::int64_t, 4> all = {nodes[0], nodes[1], nodes[2], patch};
  triangles_.add(all.data(), sizeof all);
  ++counts_[2];
}

Hash128 MeshDigest::finish() const {
  Hasher all;
  add_hash(all, nodes_);
  add_hash(all, tets_.finish());
  add_hash(all, triangles_.finish());
  add_hash(all, hash128(counts_.data(), sizeof counts_));
  return all.finish();
}

}  // namespace tetfarm
