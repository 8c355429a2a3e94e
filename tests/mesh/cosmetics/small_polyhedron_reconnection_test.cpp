#include "mesh/cosmetics/small_polyhedron_reconnection.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/edge_removal.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/spindle.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

/// Nodes 0 and 1 far apart, and n nodes round them, a little uneven: n needles on the edge 0-1.
TetMesh needles(int n, std::uint64_t seed) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, -1.5}, {0, 0, 1.5}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    mesh.nodes.push_back(Vec3{std::cos(angle), std::sin(angle), 0} +
                         0.3 * trial::random_vector(seed, static_cast<std::uint64_t>(i)));
    mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  }
  mesh.boundary_nodes = n + 2;
  return mesh;
}

/// Where only the ring can be filled otherwise, the whole search finds what the dynamic programme
/// does.
TEST(SmallPolyhedronReconnection, is_as_good_as_edge_removal_round_an_edge) {
  int compared = 0;
  for (int n = 3; n <= 8; ++n) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      TetComplex complex = make_tet_complex(needles(n, seed));
      ASSERT_THAT(validate(complex), IsEmpty());
      WorkMesh work(complex, n + 2);
      std::int32_t worst = 0;
      for (std::int32_t t = 1; t < n; ++t) {
        if (work.quality_of(t) < work.quality_of(worst)) worst = t;
      }
      ReconnectionOptions options;
      options.enough = 1;
      const auto removal = find_edge_removal(work, 0, 0, 1, 0);
      const auto found = find_reconnection(work, worst, options);
      if (removal) {
        ++compared;
        ASSERT_TRUE(found.has_value()) << n << " " << seed;
        EXPECT_GE(found->new_worst, removal->new_worst * (1 - 1e-12));
      }
      if (!found) continue;
      const double before = volume(complex);
      EXPECT_EQ(replace_tets(work, *found).size(), found->new_tets.size());
      EXPECT_THAT(validate(complex), IsEmpty());
      EXPECT_NEAR(volume(complex), before, 1e-12);
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(SmallPolyhedronReconnection, improves_what_it_touches_in_random_meshes) {
  int found_count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    TetComplex complex = make_tet_complex(trial::random_ball(2, 200, seed));
    WorkMesh work(complex, 162);
    const double before = volume(complex);
    for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
      if (!complex.is_live(t) || work.quality_of(t) > quality_of_angle(15)) continue;
      const auto found = find_reconnection(work, t);
      if (!found) continue;
      EXPECT_NEAR(found->old_worst, work.quality_of(t), 1e-15);
      const auto tets = replace_tets(work, *found);
      if (tets.empty()) continue;
      ++found_count;
      EXPECT_NEAR(worst_of(work, tets), found->new_worst, 1e-12);
      EXPECT_GT(found->new_worst, found->old_worst);
    }
    EXPECT_THAT(validate(complex), IsEmpty());
    EXPECT_NEAR(volume(complex), before, 1e-10 * before);
  }
  EXPECT_GT(found_count, 100);
}

TEST(SmallPolyhedronReconnection, raises_another_measure_where_one_is_given) {
  ReconnectionOptions options;
  options.enough = HUGE_VAL;
  options.measure = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return smallest_height2(a, b, c, d);
  };
  const auto lowest = [&options](const WorkMesh& work, const std::vector<std::int32_t>& tets) {
    double least = HUGE_VAL;
    for (const std::int32_t t : tets) {
      const auto& [a, b, c, d] = work.tet(t);
      least = std::min(least,
                       options.measure(work.point(a), work.point(b), work.point(c), work.point(d)));
    }
    return least;
  };
  int found_count = 0;
  int worse_quality = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TetComplex complex = make_tet_complex(trial::random_ball(2, 200, seed));
    WorkMesh work(complex, 162);
    for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
      if (!complex.is_live(t) || lowest(work, {t}) > 0.002) continue;
      const auto found = find_reconnection(work, t, options);
      if (!found) continue;
      const double before = lowest(work, found->old_tets);
      const double quality_before = worst_of(work, found->old_tets);
      const auto tets = replace_tets(work, *found);
      if (tets.empty()) continue;
      ++found_count;
      EXPECT_GT(lowest(work, tets), before);
      EXPECT_NEAR(lowest(work, tets), found->new_worst, 1e-12);
      if (worst_of(work, tets) < quality_before) ++worse_quality;
    }
    EXPECT_THAT(validate(complex), IsEmpty());
  }
  EXPECT_GT(found_count, 30);
  EXPECT_GT(worse_quality, 0);
}

/// Near a corner of a regular tet, a node that nobody needs.
TEST(SmallPolyhedronReconnection, leaves_out_an_inner_node_only_when_it_may_go) {
  TetMesh mesh;
  const double s = 1;
  mesh.nodes = {{s, s, s}, {-s, s, -s}, {s, -s, -s}, {-s, -s, s}, {0.9, 0.9, 0.85}};
  mesh.tets = {{1, 3, 2, 4}, {0, 2, 3, 4}, {0, 3, 1, 4}, {0, 1, 2, 4}};
  for (Tet& tet : mesh.tets) {
    if (tet_volume(mesh.nodes[at(tet[0])], mesh.nodes[at(tet[1])], mesh.nodes[at(tet[2])],
                   mesh.nodes[at(tet[3])]) < 0) {
      std::swap(tet[0], tet[1]);
    }
  }
  mesh.boundary_nodes = 4;
  for (const bool fixed : {false, true}) {
    TetComplex complex = make_tet_complex(mesh);
    ASSERT_THAT(validate(complex), IsEmpty());
    WorkMesh work(complex, fixed ? 5 : 4);
    std::int32_t worst = 0;
    for (std::int32_t t = 1; t < 4; ++t) {
      if (work.quality_of(t) < work.quality_of(worst)) worst = t;
    }
    const auto found = find_reconnection(work, worst);
    EXPECT_EQ(found.has_value(), !fixed);
    if (!found) continue;
    EXPECT_EQ(found->new_tets.size(), 1u);
    replace_tets(work, *found);
    EXPECT_THAT(validate(complex), IsEmpty());
  }
}

TEST(SmallPolyhedronReconnection, gives_up_after_the_steps_that_it_may_take) {
  TetComplex complex = make_tet_complex(needles(6, 1));
  WorkMesh work(complex, 8);
  ReconnectionOptions options;
  options.most_steps = 1;
  EXPECT_FALSE(find_reconnection(work, 0, options).has_value());
}

}  // namespace
}  // namespace tetfarm::cosmetics
