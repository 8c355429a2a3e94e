#include "mesh/core/element_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ElementSection two_tets() {
  ElementSection section;
  section.sharers = {4, 7};
  section.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  section.node_origin = {{0, 1}, {0, 2}, {1, 0}, {4, 0}, {7, 0}};
  section.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  section.tet_owner = {0, 1};
  section.triangles = {{0, 2, 1}};
  section.triangle_index = {6};
  section.triangle_owner = {0};
  return section;
}

TEST(ElementSection, counts_the_tets_of_each_sharer) {
  ElementSection section = two_tets();
  EXPECT_THAT(validate(section), IsEmpty());
  EXPECT_THAT(tets_by_sharer(section), ElementsAre(1, 1));
  section.tet_owner = {1, 1};
  EXPECT_THAT(tets_by_sharer(section), ElementsAre(0, 2));
}

TEST(ElementSection, counts_the_triangles_of_each_sharer) {
  ElementSection section = two_tets();
  EXPECT_THAT(triangles_by_sharer(section), ElementsAre(1, 0));
  section.triangle_owner = {1};
  EXPECT_THAT(triangles_by_sharer(section), ElementsAre(0, 1));
}

TEST(ElementSection, validate_finds_each_broken_invariant) {
  const auto complains = [](void (*break_it)(ElementSection&)) {
    ElementSection section = two_tets();
    break_it(section);
    return !validate(section).empty();
  };
  EXPECT_TRUE(complains([](ElementSection& s) { s.node_origin.pop_back(); }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.tet_owner.pop_back(); }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.triangle_index.clear(); }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.sharers = {7, 4}; }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.sharers.clear(); }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.tet_owner[0] = 2; }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.triangle_owner[0] = 2; }));
  EXPECT_TRUE(complains([](ElementSection& s) { std::swap(s.node_origin[0], s.node_origin[1]); }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.node_origin[1] = s.node_origin[0]; }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.tets[0][1] = 5; }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.triangles[0][1] = -1; }));
  EXPECT_TRUE(complains([](ElementSection& s) { s.tets.pop_back(), s.tet_owner.pop_back(); }));
}

}  // namespace
}  // namespace tetfarm
