#include "mesh/formats/plane/plane_su2.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"
#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

const std::string square =
    "% two triangles\n"         // line 1
    "NDIME= 2\n"                // 2
    "NELEM= 2\n"                // 3
    "5 0 1 2 0\n"               // 4
    "5 0 2 3\n"                 // 5
    "NPOIN= 4\n"                // 6
    "0 0 0\n"                   // 7
    "1 0 % without a number\n"  // 8
    "1 1.5 2\n"                 // 9
    "0 1 3\n"                   // 10
    "NMARK= 2\n"                // 11
    "MARKER_TAG= lower wall\n"  // 12
    "MARKER_ELEMS= 1\n"         // 13
    "3 0 1\n"                   // 14
    "MARKER_TAG= right\n"       // 15
    "MARKER_ELEMS= 1\n"         // 16
    "3 1 2 7\n";                // 17

/// In an order of which nothing could be known beforehand.
const std::string markers_first =
    "NDIME=2\nNMARK=1\nMARKER_TAG=a\nMARKER_ELEMS=2\n3 0 1\n3 2 0\nNELEM = 1\n5 0 1 2\n"
    "NPOIN= 3 3\n0 0\n1 0\n0 1\n";

std::string refusal_of_plane(const std::string& name, const std::string& text) {
  try {
    read_plane_su2(text, name);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PlaneSu2, reads_triangles_points_and_markers_with_their_names) {
  const PlaneMesh mesh = read_plane_su2(square, "a.su2");
  EXPECT_THAT(mesh.points, ElementsAre(Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1.5}, Vec2{0, 1}));
  EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
  EXPECT_THAT(mesh.edges, ElementsAre(ElementsAre(0, 1), ElementsAre(1, 2)));
  EXPECT_THAT(mesh.patches, ElementsAre(1, 2));
  EXPECT_THAT(mesh.patch_names, ElementsAre(Pair(1, "lower"), Pair(2, "right")));
  EXPECT_THAT(mesh.regions, ElementsAre(0, 0));
}

TEST(PlaneSu2, reads_lists_in_any_order) {
  const PlaneMesh mesh = read_plane_su2(markers_first, "a.su2");
  EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2)));
  EXPECT_THAT(mesh.edges, ElementsAre(ElementsAre(0, 1), ElementsAre(2, 0)));
  EXPECT_EQ(mesh.points.size(), 3U);
}

TEST(PlaneSu2, passes_over_vertices_in_markers) {
  const PlaneMesh mesh = read_plane_su2(changed(square, "3 1 2 7", "1 2"), "a.su2");
  EXPECT_EQ(mesh.edges.size(), 1U);
}

TEST(PlaneSu2, refuses_what_is_wrong_with_the_line) {
  expect_refusals(
      "a.su2", square,
      {{"NDIME= 2", "NDIME= 3", "a.su2:2: the mesh is not one of the plane"},
       {"5 0 2 3", "9 0 1 2 3",
        "a.su2:5: element type 9 is a quadrilateral: only triangles (5) are read"},
       {"5 0 2 3", "10 0 1 2 3",
        "a.su2:5: element type 10 is no triangle: only triangles (5) are read"},
       {"3 0 1\n", "5 0 1 2\n", "a.su2:14: element type 5 in a marker is no line (3)"},
       {"5 0 2 3", "5 0 2 4", "a.su2:5: there is no node 4: the file has 4, counted from 0"},
       {"3 1 2 7", "3 1 9", "a.su2:17: there is no node 9: the file has 4, counted from 0"},
       {"5 0 2 3", "5 0 2 -1", "a.su2:5: there is no node -1"},
       {"5 0 2 3", "5 0 2", "a.su2:5: expected a node number, found nothing"},
       {"1 1.5 2", "1 nan 2", "a.su2:9: a coordinate is nan"},
       {"1 1.5 2", "1", "a.su2:9: expected a coordinate, found nothing"},
       {"NELEM= 2", "NELEM= 200000000000",
        "a.su2:3: a count of 200000000000, but only 167 bytes left in the file"}},
      refusal_of_plane);
}

TEST(PlaneSu2, finds_the_line_of_a_missing_node_before_the_nodes_too) {
  EXPECT_EQ(refusal_of_plane("a.su2", changed(markers_first, "3 2 0", "3 3 0")),
            "a.su2:6: there is no node 3: the file has 3, counted from 0");
}

TEST(PlaneSu2, refuses_any_beginning_of_a_file_or_reads_it) {
  for (std::size_t end = 0; end < square.find("NMARK"); ++end) {
    const std::string said = refusal_of_plane("a.su2", square.substr(0, end));
    if (end < square.find("0 1 3\n") + 3) {
      EXPECT_THAT(said, HasSubstr("a.su2:")) << end;
    }
  }
}

TEST(PlaneSu2, gives_back_what_it_wrote_bit_by_bit) {
  PlaneMesh mesh = square_ring();
  mesh.points[5] = {2 + 1.0 / 3, std::nextafter(1, 2)};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "ring.su2";
  write_plane_su2(mesh, path);
  const PlaneMesh back = read_plane_su2(read_file(path), "ring.su2");
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.edges.size(), 8U) << "the edge inside has no place in the format";
  EXPECT_THAT(back.patches, ElementsAre(1, 2, 2, 2, 3, 3, 3, 3));
  EXPECT_THAT(back.patch_names,
              ElementsAre(Pair(1, "inlet"), Pair(2, "patch_5"), Pair(3, "the_body")));
}

}  // namespace
}  // namespace tetfarm
