#include "mesh/assemble/face_balance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// The finalizer of SplitMix64: every bit of the result depends on every bit given.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

std::uint64_t hash_of_node(std::int64_t number, const Vec3& p) {
  std::uint64_t hash = mixed(static_cast<std::uint64_t>(number));
  for (const double x : {p.x, p.y, p.z}) hash = mixed(hash ^ std::bit_cast<std::uint64_t>(x));
  return hash;
}

/// Of the three in this or a turned order; its negative in the other.
std::uint64_t hash_of_face(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  // No branch: the hashes come in no order, so that each would be guessed wrong every other time.
  const std::uint64_t is_turned =
      std::uint64_t{a < b} ^ std::uint64_t{b < c} ^ std::uint64_t{a < c};
  const std::uint64_t hash = mixed(a + b + c);
  return (hash ^ (0 - is_turned)) + is_turned;
}

/// Of the four in this or a turned order; its negative from the other side. Which of them lie
/// opposite one another counts.
std::uint64_t hash_of_face(std::array<std::uint64_t, 4> quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  const auto& [first, next, opposite, last] = quad;
  const std::uint64_t hash = mixed(mixed(first + opposite) + 2 * mixed(next + last));
  return next < last ? hash : 0 - hash;
}

std::uint64_t hash_of_face(const std::vector<std::uint64_t>& hashes,
                           std::span<const std::int32_t> face) {
  const auto of = [&](std::size_t i) { return hashes[at(face[i])]; };
  return face.size() == 3 ? hash_of_face(of(0), of(1), of(2))
                          : hash_of_face({of(0), of(1), of(2), of(3)});
}

}  // namespace

std::uint64_t face_sum_of(const NumberedPart& part) {
  std::uint64_t sum = 0;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  std::vector<std::uint64_t> hashes(part.nodes.size());
  for (std::size_t v = 0; v < hashes.size(); ++v) {
    hashes[v] = hash_of_node(part.local2global[v], part.nodes[v]);
  }
  for (const Tet& tet : part.tets) {
    for (const auto& [i, j, k] : tet_face_nodes) {
      sum += hash_of_face(hashes[at(tet[at(i)])], hashes[at(tet[at(j)])], hashes[at(tet[at(k)])]);
    }
  }
  for (const Triangle& face : part.faces) {
    sum -= hash_of_face(hashes[at(face[0])], hashes[at(face[1])], hashes[at(face[2])]);
  }
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> cell, std::int32_t) {
        for_each_face_of(type, cell, [&](ElementType, std::span<const std::int32_t> face) {
          sum += hash_of_face(hashes, face);
        });
      });
  for_each_block_face(part.blocks,
                      [&](ElementType, std::span<const std::int32_t> face, std::int32_t,
                          std::int32_t) { sum -= hash_of_face(hashes, face); });
  return sum;
}

}  // namespace tetfarm
