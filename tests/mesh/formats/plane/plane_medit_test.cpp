#include "mesh/formats/plane/plane_medit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string square_text =
    "MeshVersionFormatted 2\n"  // line 1
    "Dimension 2\n"             // 2
    "# two triangles\n"         // 3
    "Vertices\n"                // 4
    "4\n"                       // 5
    "0 0 1\n"                   // 6
    "1 0 1\n"                   // 7
    "1 1.5 2\n"                 // 8
    "0 1 2\n"                   // 9
    "Edges\n2\n"                // 10, 11
    "1 2 10\n"                  // 12
    "2 3 20\n"                  // 13
    "Triangles\n2\n"            // 14, 15
    "1 2 3 7\n"                 // 16
    "1 3 4 8\n"                 // 17
    "Corners\n1\n3\n"           // 18 to 20
    "End\n";

/// A file in a folder of its own.
class PlaneFile {
 public:
  explicit PlaneFile(const std::string& text, const std::string& name = "square.mesh")
      : path_(folder_.path() / name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  TempFolder folder_;
  std::filesystem::path path_;
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), with);
}

std::string refusal_of_text(const std::string& text) {
  const PlaneFile file(text);
  return error_text_of<InvalidInput>([&] { read_plane_medit(file.path()); });
}

/// Of the square with something else in it.
std::string refusal_of_change(const std::string& what, const std::string& with) {
  return refusal_of_text(replaced(square_text, what, with));
}

TEST(PlaneMedit, reads_vertices_edges_triangles_and_corners) {
  const PlaneFile file(square_text);
  const PlaneMesh mesh = read_plane_medit(file.path());
  EXPECT_THAT(mesh.points, ElementsAre(Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1.5}, Vec2{0, 1}));
  EXPECT_THAT(mesh.edges, ElementsAre(ElementsAre(0, 1), ElementsAre(1, 2)));
  EXPECT_THAT(mesh.patches, ElementsAre(10, 20));
  EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
  EXPECT_THAT(mesh.regions, ElementsAre(7, 8));
  EXPECT_THAT(mesh.corners, ElementsAre(2));
}

TEST(PlaneMedit, reads_a_plane_of_three_dimensions_and_passes_over_other_lists) {
  const PlaneFile file(
      "MeshVersionFormatted\n1\n\nDimension\n3\n\nVertices\n3\n0 0 2 0\n1 0 2 0\n0 1 2 0\n"
      "RequiredVertices\n2\n1\n2\nNormals\n1\n0 0 1\nTriangles\n1\n1 2 3 5\n");
  const PlaneMesh mesh = read_plane_medit(file.path());
  EXPECT_THAT(mesh.points, ElementsAre(Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}));
  EXPECT_THAT(mesh.regions, ElementsAre(5));
  EXPECT_THAT(mesh.corners, ElementsAre());
}

TEST(PlaneMedit, gives_back_what_it_wrote_bit_by_bit) {
  PlaneMesh mesh;
  mesh.points = {{1.0 / 3, -2e-17},
                 {std::sqrt(2), 1e17},
                 {-0.0, std::nextafter(1, 2)},
                 {5e-324, 1.7976931348623157e308},
                 {0.1, 0.2}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}, {4, 2, 0}};
  mesh.regions = {-3, 0, 2147483647};
  mesh.edges = {{0, 1}, {3, 1}};
  mesh.patches = {5, -2147483647};
  mesh.corners = {4, 0};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "written.mesh";
  write_plane_medit(mesh, path);
  const PlaneMesh back = read_plane_medit(path);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(std::signbit(back.points[2].x), true);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_EQ(back.edges, mesh.edges);
  EXPECT_EQ(back.patches, mesh.patches);
  EXPECT_EQ(back.corners, mesh.corners);
}

TEST(PlaneMedit, refuses_a_file_without_vertices_or_triangles) {
  EXPECT_EQ(refusal_of_text(square_text), "");
  EXPECT_THAT(refusal_of_text("MeshVersionFormatted 2\nDimension 2\nEnd\n"),
              AllOf(HasSubstr("square.mesh:3"), HasSubstr("no vertices")));
  EXPECT_THAT(refusal_of_text("MeshVersionFormatted 2\nDimension 2\nVertices 0\nEnd\n"),
              HasSubstr("no vertices"));
  EXPECT_THAT(refusal_of_text("MeshVersionFormatted 2\nDimension 2\nVertices 1\n0 0 0\nEnd\n"),
              AllOf(HasSubstr("square.mesh:5"), HasSubstr("no triangles")));
}

TEST(PlaneMedit, refuses_another_beginning_or_dimension) {
  EXPECT_THAT(refusal_of_text("solid cube\n"), HasSubstr("square.mesh:1"));
  EXPECT_THAT(refusal_of_text(""), HasSubstr("square.mesh"));
  EXPECT_THAT(refusal_of_change("Dimension 2", "Dimension 4"),
              AllOf(HasSubstr("square.mesh:2"), HasSubstr("neither 2 nor 3")));
  EXPECT_THAT(refusal_of_change("Dimension 2", "Dimension x"), HasSubstr("square.mesh:2"));
}

TEST(PlaneMedit, refuses_vertices_out_of_one_plane) {
  EXPECT_THAT(refusal_of_text("MeshVersionFormatted 1\nDimension 3\nVertices\n3\n0 0 2 0\n"
                              "1 0 2 0\n0 1 2.5 0\nTriangles\n1\n1 2 3 5\n"),
              AllOf(HasSubstr("square.mesh:7"), HasSubstr("one plane")));
}

TEST(PlaneMedit, refuses_a_file_that_ends_too_early_with_the_line) {
  for (const std::string last : {"1 1.5 2\n", "2 3 20\n", "1 3 4 8\n"}) {
    const std::size_t end = square_text.find(last) + last.size() - 3;
    EXPECT_THAT(refusal_of_text(square_text.substr(0, end)), HasSubstr("square.mesh:")) << last;
  }
}

TEST(PlaneMedit, refuses_any_beginning_of_a_file_or_reads_it) {
  for (std::size_t end = 0; end < square_text.size(); ++end) {
    const std::string said = refusal_of_text(square_text.substr(0, end));
    if (end < square_text.find("Corners") - 3) {
      EXPECT_THAT(said, HasSubstr("square.mesh")) << end;
    }
  }
}

TEST(PlaneMedit, refuses_counts_that_the_file_cannot_hold) {
  EXPECT_THAT(refusal_of_change("Vertices\n4\n", "Vertices\n4000000000000\n"),
              HasSubstr("square.mesh:5"));
  EXPECT_THAT(refusal_of_change("Vertices\n4\n", "Vertices\n-1\n"), HasSubstr("square.mesh:5"));
  EXPECT_THAT(refusal_of_change("Triangles\n2\n", "Triangles\n99999999999999999999\n"),
              HasSubstr("square.mesh:15"));
  EXPECT_THAT(refusal_of_change("Edges\n2\n", "Edges\n1000000\n"), HasSubstr("square.mesh:11"));
  EXPECT_THAT(refusal_of_change("Corners\n1\n", "Corners\n1000000\n"), HasSubstr("square.mesh:19"));
}

TEST(PlaneMedit, refuses_text_where_numbers_belong) {
  EXPECT_THAT(refusal_of_change("1 1.5 2\n", "1 two 2\n"),
              AllOf(HasSubstr("square.mesh:8"), HasSubstr("two")));
  EXPECT_THAT(refusal_of_change("1 1.5 2\n", "1 nan 2\n"), HasSubstr("square.mesh:8"));
  EXPECT_THAT(refusal_of_change("1 1.5 2\n", "1 1e999 2\n"), HasSubstr("square.mesh:8"));
  EXPECT_THAT(refusal_of_change("1 3 4 8\n", "1 3 four 8\n"), HasSubstr("square.mesh:17"));
  EXPECT_THAT(refusal_of_change("1 3 4 8\n", "1 3 4 8.5\n"), HasSubstr("square.mesh:17"));
  EXPECT_THAT(refusal_of_change("2 3 20\n", "2 3 x\n"), HasSubstr("square.mesh:13"));
}

TEST(PlaneMedit, refuses_numbers_of_nodes_below_one_and_numbers_too_large) {
  EXPECT_THAT(refusal_of_change("1 3 4 8\n", "1 0 4 8\n"),
              AllOf(HasSubstr("square.mesh:17"), HasSubstr("from 1")));
  EXPECT_THAT(refusal_of_change("2 3 20\n", "-2 3 20\n"), HasSubstr("square.mesh:13"));
  EXPECT_THAT(refusal_of_change("1 3 4 8\n", "1 3 4 3000000000\n"),
              AllOf(HasSubstr("square.mesh:17"), HasSubstr("too large")));
  EXPECT_THAT(refusal_of_change("1\n3\nEnd", "1\n0\nEnd"), HasSubstr("square.mesh:20"));
}

TEST(PlaneMedit, refuses_other_elements_than_triangles) {
  EXPECT_THAT(refusal_of_change("Corners", "Quadrilaterals\n1\n1 2 3 4 0\nCorners"),
              HasSubstr("only triangles"));
  EXPECT_EQ(refusal_of_change("Corners", "Quadrilaterals\n0\nCorners"), "");
}

TEST(PlaneMedit, says_which_file_is_missing) {
  const TempFolder folder;
  EXPECT_THROW(read_plane_medit(folder.path() / "none.mesh"), IoError);
  EXPECT_THROW(read_plane_sol(folder.path() / "none.sol"), IoError);
}

TEST(PlaneSol, gives_back_metrics_bit_by_bit) {
  const std::vector<Metric2> metrics{{1.0 / 3, -2e-9, 1e12}, {1, 0, 1}, {std::sqrt(2), 0.1, 7}};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "metric.sol";
  write_plane_sol(metrics, path);
  const NodeFields fields = read_plane_sol(path);
  ASSERT_EQ(fields.metrics.size(), 1U);
  EXPECT_EQ(fields.metrics[0], metrics);
  EXPECT_TRUE(fields.scalars.empty());
  EXPECT_TRUE(fields.vectors.empty());
}

TEST(PlaneSol, reads_fields_of_all_kinds_in_their_order) {
  const PlaneFile file(
      "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n2\n4 1 3 2 1\n"
      "0.5 1 2 3 10 20 7\n0.25 4 5 6 30 40 8\nEnd\n",
      "all.sol");
  const NodeFields fields = read_plane_sol(file.path());
  EXPECT_THAT(fields.scalars, ElementsAre(ElementsAre(0.5, 0.25), ElementsAre(7, 8)));
  EXPECT_THAT(fields.metrics, ElementsAre(ElementsAre(Metric2{1, 2, 3}, Metric2{4, 5, 6})));
  EXPECT_THAT(fields.vectors, ElementsAre(ElementsAre(Vec2{10, 20}, Vec2{30, 40})));
}

TEST(PlaneSol, writes_fields_of_all_kinds_as_it_reads_them) {
  NodeFields fields;
  fields.order = {NodeFieldKind::vector, NodeFieldKind::scalar, NodeFieldKind::metric,
                  NodeFieldKind::scalar};
  fields.scalars = {{1.0 / 3, -0.0}, {1e-300, 7}};
  fields.vectors = {{{10, 20}, {std::sqrt(2), 1e22}}};
  fields.metrics = {{{1, 2, 3}, {4, 5, 6}}};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "all.sol";
  write_plane_sol(fields, path);
  const NodeFields read = read_plane_sol(path);
  EXPECT_EQ(read.order, fields.order);
  EXPECT_EQ(read.scalars, fields.scalars);
  EXPECT_EQ(read.vectors, fields.vectors);
  EXPECT_EQ(read.metrics, fields.metrics);
}

TEST(PlaneSol, refuses_what_is_wrong_with_file_and_line) {
  const std::string text =
      "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n2\n1 3\n1 0 1\n2 0 2\nEnd\n";
  const auto refusal = [&](const std::string& what, const std::string& with) {
    const PlaneFile file(replaced(text, what, with), "metric.sol");
    return error_text_of<InvalidInput>([&] { read_plane_sol(file.path()); });
  };
  EXPECT_EQ(refusal("End", "End"), "");
  EXPECT_THAT(refusal("Dimension 2", "Dimension 3"), HasSubstr("metric.sol:2"));
  EXPECT_THAT(refusal("SolAtVertices", "SolAtTriangles"), HasSubstr("metric.sol:3"));
  EXPECT_THAT(refusal("\n2\n1 3", "\n2000\n1 3"), HasSubstr("metric.sol:4"));
  EXPECT_THAT(refusal("\n2\n1 3", "\n-2\n1 3"), HasSubstr("metric.sol:4"));
  EXPECT_THAT(refusal("1 3\n", "1 4\n"), AllOf(HasSubstr("metric.sol:5"), HasSubstr("tensor")));
  EXPECT_THAT(refusal("1 3\n", "9999 3\n"), HasSubstr("metric.sol:5"));
  EXPECT_THAT(refusal("1 0 1\n", "1 zero 1\n"), HasSubstr("metric.sol:6"));
  EXPECT_THAT(refusal("2 0 2\n", "2 0 inf\n"), HasSubstr("metric.sol:7"));
  EXPECT_THAT(refusal("2 0 2\nEnd\n", "2 0"), HasSubstr("metric.sol:7"));
}

}  // namespace
}  // namespace tetfarm
