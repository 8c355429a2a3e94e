// Many more bodies than in the fast test.
#include "mesh/healing/body_union.h"

#include <gmock/gmock.h>

#include "tests/mesh/healing/random_bodies.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// Whether they became one sound surface that encloses what they did; else they are as they were.
bool are_united(const test::RandomBodies& bodies) {
  const bool is_sound = test::defects_of(bodies.all()).empty();
  test::Damaged work(bodies.all());
  if (unite_bodies(work.work) == 0) {
    EXPECT_EQ(work.surface.triangles, bodies.all().triangles);
    EXPECT_EQ(work.surface.vertices, bodies.all().vertices);
    return is_sound;
  }
  EXPECT_THAT(test::defects_of(work.surface), IsEmpty());
  EXPECT_THAT(bodies.points_told_wrongly_by(work.surface, 20), IsEmpty());
  return true;
}

TEST(BodyUnionSlow,
     groups_of_bodies_that_cross_or_are_quite_flush_are_united_and_enclose_what_they_did) {
  for (std::uint64_t seed = 100; seed < 1100; ++seed) {
    SCOPED_TRACE(seed);
    if (test::is_nearly_flush(seed)) continue;
    EXPECT_TRUE(are_united(test::RandomBodies(seed)));
  }
}

/// Up to the last bits, in which their faces and edges cross again and again.
TEST(BodyUnionSlow, most_groups_of_bodies_that_are_nearly_flush_are_united_and_the_rest_left) {
  int groups = 0;
  int united = 0;
  for (std::uint64_t seed = 100; seed < 1100; ++seed) {
    SCOPED_TRACE(seed);
    if (!test::is_nearly_flush(seed)) continue;
    ++groups;
    if (are_united(test::RandomBodies(seed))) ++united;
  }
  EXPECT_EQ(groups, 250);
  EXPECT_GE(united, 220);
}

}  // namespace
}  // namespace tetfarm
