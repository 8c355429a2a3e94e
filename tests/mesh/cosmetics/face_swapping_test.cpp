#include "mesh/cosmetics/face_swapping.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/spindle.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

TEST(FaceSwapping, replaces_two_fans_by_needles) {
  for (int n = 3; n <= 4; ++n) {
    const double half_height = 0.15;
    TetMesh mesh = spindle(n, half_height);
    mesh.tets.clear();
    for (int i = 1; i + 1 < n; ++i) {
      mesh.tets.push_back({2, 2 + i, 3 + i, 1});
      mesh.tets.push_back({2, 3 + i, 2 + i, 0});
    }
    TetComplex complex = make_tet_complex(mesh);
    ASSERT_THAT(validate(complex), IsEmpty());
    WorkMesh work(complex, n + 2);
    const auto found = find_face_removal(work, 0, 3, 0);
    ASSERT_TRUE(found.has_value()) << n;
    EXPECT_EQ(found->old_tets.size(), at(2 * (n - 2)));
    EXPECT_EQ(found->new_tets.size(), at(n));
    EXPECT_EQ(replace_tets(work, *found).size(), at(n));
    EXPECT_THAT(validate(complex), IsEmpty());
    EXPECT_EQ(complex.live_tets(), at(n));
  }
}

TEST(FaceSwapping, leaves_the_boundary_and_hollow_pairs_alone) {
  TetMesh mesh;
  // The segment between the apexes 3 and 4 passes outside the common face: no swap.
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {2, 2, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  TetComplex complex = make_tet_complex(mesh);
  ASSERT_THAT(validate(complex), IsEmpty());
  const WorkMesh work(complex, 5);
  for (int face = 0; face < 4; ++face) {
    EXPECT_FALSE(find_face_removal(work, 0, face, 0).has_value());
  }
}

bool has_each_once(std::vector<std::int32_t> tets) {
  std::sort(tets.begin(), tets.end());
  return std::adjacent_find(tets.begin(), tets.end()) == tets.end();
}

/// A patch that grows round a node comes to a face from both sides, and is refused when it is to be
/// done.
TEST(FaceSwapping, in_random_tets_is_a_2_3_swap_or_better_and_can_be_done_unless_it_meets_itself) {
  TetComplex complex = make_tet_complex(trial::random_ball(2, 150, 5));
  WorkMesh work(complex, 162);
  const double whole = volume(complex);
  int swaps = 0;
  int larger = 0;
  for (std::int32_t t = 0; t < std::ssize(complex.nodes); ++t) {
    for (int face = 0; face < 4 && complex.is_live(t); ++face) {
      const FaceHandle across = work.across(t, face);
      if (across == no_face) continue;
      // The plain swap: the edge between both apexes, and a tet over each side of the face.
      const auto [a, b, c] = complex.face_nodes(face_handle(t, face));
      const std::int32_t low = work.tet(t)[at(face)];
      const std::int32_t high = work.tet(tet_of(across))[at(face_of(across))];
      double plain = 1;
      for (const auto& [u, v] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
        plain = std::min(plain, quality(complex, {low, high, u, v}));
      }
      const double before = worst_of(work, {t, tet_of(across)});
      const auto found = find_face_removal(work, t, face, 0);
      if (!found) {
        EXPECT_FALSE(is_worth(before, plain));
        continue;
      }
      EXPECT_GE(found->new_worst, plain * (1 - 1e-12));
      EXPECT_TRUE(is_worth(found->old_worst, found->new_worst));
      EXPECT_EQ(found->old_worst, worst_of(work, found->old_tets));
      EXPECT_EQ(found->new_tets.size(), found->old_tets.size() / 2 + 2);
      EXPECT_FALSE(find_face_removal(work, t, face, found->new_worst).has_value());
      larger += found->old_tets.size() > 2 ? 1 : 0;
      const bool is_done = !replace_tets(work, *found).empty();
      EXPECT_EQ(is_done, has_each_once(found->old_tets));
      if (is_done) ++swaps;
    }
  }
  EXPECT_GT(swaps, 30);
  EXPECT_GT(larger, 0);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_NEAR(volume(complex), whole, 1e-12);
}

}  // namespace
}  // namespace tetfarm::cosmetics
