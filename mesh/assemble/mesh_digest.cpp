#include "mesh/assemble/mesh_digest.h"

#include <bit>
#include <cstring>
#include <vector>

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little, "digests are of little-endian numbers");

Hash128 sum_of(const Hash128& a, const Hash128& b) {
  const std::uint64_t low = a.low + b.low;
  const std::uint64_t carry = low < a.low ? 1 : 0;
  return {a.high + b.high + carry, low};
}

void add_hash(Hasher& hasher, const Hash128& hash) {
  hasher.add(&hash.low, sizeof hash.low);
  hasher.add(&hash.high, sizeof hash.high);
}

}  // namespace

template <class Record>
void MeshDigest::add(const Record& record, Sum& sum) {
  sum.hash = sum_of(sum.hash, hash128(record.data(), sizeof record));
  ++sum.count;
}

void MeshDigest::add_node(std::int64_t number, const Vec3& at) {
  const std::array<double, 3> coordinates = {at.x, at.y, at.z};
  std::array<std::int64_t, 4> record = {number};
  std::memcpy(record.data() + 1, coordinates.data(), sizeof coordinates);
  add(record, nodes_);
}

void MeshDigest::add_tet(std::int64_t number, const std::array<std::int64_t, 4>& nodes) {
  add(std::array{number, nodes[0], nodes[1], nodes[2], nodes[3]}, tets_);
}

void MeshDigest::add(const Sum& one, Sum& sum) {
  sum.hash = sum_of(sum.hash, one.hash);
  sum.count += one.count;
}

void MeshDigest::add_tets(const Sum& tets) { add(tets, tets_); }
void MeshDigest::add_others(const Sum& others) { add(others, others_); }

void MeshDigest::add_boundary_triangle(const std::array<std::int64_t, 3>& nodes,
                                       std::int32_t patch) {
  add(std::array<std::int64_t, 4>{nodes[0], nodes[1], nodes[2], patch}, triangles_);
}

void MeshDigest::add_other(ElementType type, std::int64_t number_or_patch,
                           std::span<const std::int64_t> nodes) {
  std::vector<std::int64_t> record = {code_of(ElementCodes::vtk, type), number_or_patch};
  record.insert(record.end(), nodes.begin(), nodes.end());
  others_.hash = sum_of(others_.hash, hash128(record.data(), record.size() * sizeof(std::int64_t)));
  ++others_.count;
}

Hash128 MeshDigest::finish() const {
  Hasher all;
  for (const Sum& sum : {nodes_, tets_, triangles_}) add_hash(all, sum.hash);
  const std::array<std::int64_t, 3> counts = {nodes_.count, tets_.count, triangles_.count};
  add_hash(all, hash128(counts.data(), sizeof counts));
  if (others_.count > 0) {
    add_hash(all, others_.hash);
    add_hash(all, hash128(&others_.count, sizeof others_.count));
  }
  return all.finish();
}

}  // namespace tetfarm
