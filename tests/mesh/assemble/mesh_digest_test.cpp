#include "mesh/assemble/mesh_digest.h"

#include <gtest/gtest.h>

#include "base/hash.h"

namespace tetfarm {
namespace {

/// Numbers of eight bytes, one after the other.
template <class... Numbers>
Hash128 hash_of_numbers(Numbers... numbers) {
  std::string bytes;
  const auto add = [&bytes](const auto& number) {
    static_assert(sizeof number == 8);
    bytes.append(reinterpret_cast<const char*>(&number), 8);
  };
  (add(numbers), ...);
  return hash128(bytes);
}

using I = std::int64_t;

TEST(MeshDigest, of_tets_is_laid_out_as_it_says) {
  MeshDigest digest;
  digest.add_node(3, {1.5, -2, 0});
  digest.add_tet(7, {3, 1, 4, 2});
  digest.add_boundary_triangle({3, 1, 4}, 5);
  const Hash128 nodes = hash_of_numbers(I{3}, 1.5, -2.0, 0.0);
  const Hash128 tets = hash_of_numbers(I{7}, I{3}, I{1}, I{4}, I{2});
  const Hash128 triangles = hash_of_numbers(I{3}, I{1}, I{4}, I{5});
  const Hash128 counts = hash_of_numbers(I{1}, I{1}, I{1});
  EXPECT_EQ(digest.finish(),
            hash_of_numbers(nodes.low, nodes.high, tets.low, tets.high, triangles.low,
                            triangles.high, counts.low, counts.high));
  EXPECT_EQ(digest.tets(), (MeshDigest::Sum{tets, 1}));
}

TEST(MeshDigest, has_other_elements_behind_where_there_are_any) {
  MeshDigest digest;
  digest.add_node(0, {1, 2, 3});
  const Hash128 nodes = hash_of_numbers(I{0}, 1.0, 2.0, 3.0);
  const Hash128 counts = hash_of_numbers(I{1}, I{0}, I{0});
  EXPECT_EQ(digest.finish(), hash_of_numbers(nodes.low, nodes.high, I{0}, I{0}, I{0}, I{0},
                                             counts.low, counts.high));
  const std::array<I, 5> pyramid = {9, 8, 7, 6, 5};
  digest.add_other(ElementType::pyramid, 2, pyramid);
  const Hash128 others = hash_of_numbers(I{14}, I{2}, I{9}, I{8}, I{7}, I{6}, I{5});
  const Hash128 one = hash_of_numbers(I{1});
  EXPECT_EQ(digest.finish(),
            hash_of_numbers(nodes.low, nodes.high, I{0}, I{0}, I{0}, I{0}, counts.low, counts.high,
                            others.low, others.high, one.low, one.high));
}

TEST(MeshDigest, is_a_sum_that_carries_into_its_high_half_in_whatever_order) {
  MeshDigest all;
  MeshDigest there;
  MeshDigest turned;
  const std::array<I, 4> quad = {1, 2, 3, 4};
  // Of 20 hashes some carry.
  Hash128 sum;
  for (I i = 0; i < 20; ++i) {
    all.add_tet(i, {i, i + 1, i + 2, i + 3});
    there.add_tet(19 - i, {19 - i, 20 - i, 21 - i, 22 - i});
    all.add_other(ElementType::quad, i, quad);
    there.add_other(ElementType::quad, 19 - i, quad);
    const Hash128 next = hash_of_numbers(i, i, i + 1, i + 2, i + 3);
    const std::uint64_t low = sum.low + next.low;
    sum = {sum.high + next.high + (low < sum.low ? 1U : 0U), low};
  }
  EXPECT_EQ(all.tets(), (MeshDigest::Sum{sum, 20}));
  EXPECT_EQ(all.finish(), there.finish());
  turned.add_tets(all.tets());
  turned.add_others(all.others());
  EXPECT_EQ(turned.finish(), all.finish());
  turned.add_others(all.others());
  EXPECT_EQ(turned.others().count, 40);
}

}  // namespace
}  // namespace tetfarm
