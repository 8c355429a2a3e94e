#include "mesh/formats/used_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(UsedVertices, stay_in_their_order_and_the_others_go) {
  SurfaceMesh surface;
  for (int v = 0; v < 6; ++v) surface.vertices.push_back({static_cast<double>(v), 0, 0});
  surface.triangles = {{5, 1, 3}, {3, 1, 2}};
  keep_used_vertices(surface);
  EXPECT_THAT(surface.vertices,
              ElementsAre(Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{3, 0, 0}, Vec3{5, 0, 0}));
  EXPECT_THAT(surface.triangles, ElementsAre(Triangle{3, 0, 2}, Triangle{2, 0, 1}));
  surface.triangles.clear();
  keep_used_vertices(surface);
  EXPECT_TRUE(surface.vertices.empty());
}

TEST(UsedVertices, are_counted_from_the_number_that_the_format_begins_with) {
  SurfaceMesh surface;
  surface.vertices.resize(3);
  const std::string name = "a";
  const InputScanner scanner("", name);
  EXPECT_EQ(vertex_of(scanner, surface, 0, 0), 0);
  EXPECT_EQ(vertex_of(scanner, surface, 2, 0), 2);
  EXPECT_EQ(vertex_of(scanner, surface, 3, 1), 2);
  for (const auto& [number, from] : {std::pair{-1, 0}, {3, 0}, {0, 1}, {4, 1}}) {
    try {
      vertex_of(scanner, surface, number, from);
      ADD_FAILURE() << number;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), "a:1: vertex " + std::to_string(number) + " of 3 (counted from " +
                                  std::to_string(from) + ")");
    }
  }
}

}  // namespace
}  // namespace tetfarm
