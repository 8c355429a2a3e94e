#include "mesh/formats/ugrid/ugrid_source.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/formats/ugrid/ugrid_file.h"
#include "tests/mesh/formats/mesh_listing.h"
#include "tests/mesh/formats/wrong_bytes.h"

namespace tetfarm {
namespace {

/// A tet with its four triangles, turned inwards, of the patches 2, 1, 1 and 3.
template <class Integer>
std::string ugrid_tet() {
  std::string bytes;
  for (const Integer count : {4, 4, 0, 1, 0, 0, 0}) bytes += raw_bytes(count);
  for (const double x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) bytes += raw_bytes(x);
  for (const Integer v : {1, 2, 3, 1, 4, 2, 2, 4, 3, 3, 4, 1}) bytes += raw_bytes(v);
  for (const Integer patch : {2, 1, 1, 3}) bytes += raw_bytes(patch);
  for (const Integer v : {1, 2, 3, 4}) bytes += raw_bytes(v);
  return bytes;
}

constexpr std::size_t triangles = 28 + 4 * 24;
constexpr std::size_t patches = triangles + 4 * 12;
constexpr std::size_t tets = patches + 4 * 4;

std::string at(std::size_t place, const std::string& what) {
  return "a.lb8.ugrid: byte " + std::to_string(place) + ": " + what;
}

TEST(UgridSource, says_what_is_wrong_and_where) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refusals_of_bytes(
      "a.lb8.ugrid", ugrid_tet<std::int32_t>(),
      {{4, raw_bytes(-1), at(4, "a count is negative")},
       {24, raw_bytes(-1), at(24, "a count is negative")},
       {0, raw_bytes(5), at(0, "the counts are of 212 bytes and more, but the file has only 204")},
       {12, raw_bytes(2), "a.lb8.ugrid: the length of the file does not match its counts"},
       {12, raw_bytes(0), "a.lb8.ugrid: the length of the file does not match its counts"},
       {28 + 2 * 24 + 8, raw_bytes(nan), at(28 + 2 * 24 + 8, "a coordinate is nan")},
       {triangles, raw_bytes(5), at(triangles, "boundary triangle 0 has node 5 of 4")},
       {triangles + 20, raw_bytes(0), at(triangles + 20, "boundary triangle 1 has node 0 of 4")},
       {patches + 4, raw_bytes(0), "a.lb8.ugrid: boundary triangle 1 has the patch -1"},
       {patches + 4, raw_bytes(-9), "a.lb8.ugrid: boundary triangle 1 has the patch -1"},
       {tets, raw_bytes(5), "a.lb8.ugrid: tet 0 has node 4 of 4"},
       {tets, raw_bytes(0), "a.lb8.ugrid: tet 0 has node -1 of 4"}},
      mesh_refusal_of);
}

TEST(UgridSource, believes_no_count_that_no_file_could_hold) {
  const std::int64_t most = std::numeric_limits<std::int64_t>::max() / 1024;
  const auto said = [](std::size_t place, const std::string& what) {
    return "a.lb8l.ugrid: byte " + std::to_string(place) + ": " + what;
  };
  expect_refusals_of_bytes(
      "a.lb8l.ugrid", ugrid_tet<std::int64_t>(),
      {{8, raw_bytes(most + 1), said(8, "a count is larger than the file")},
       {40, raw_bytes(most + 1), said(40, "a count is larger than the file")},
       {8, raw_bytes(std::int64_t{-1}), said(8, "a count is negative")},
       {0, raw_bytes(std::int64_t{6}),
        said(0, "the counts are of 328 bytes and more, but the file has only 312")}},
      mesh_refusal_of);
}

TEST(UgridSource, as_a_surface_says_what_is_wrong_and_where) {
  expect_refusals_of_bytes(
      "a.lb8.ugrid", ugrid_tet<std::int32_t>(),
      {{triangles, raw_bytes(5), at(triangles, "vertex 5 of 4 (counted from 1)")},
       {triangles + 20, raw_bytes(0), at(triangles + 20, "vertex 0 of 4 (counted from 1)")}},
      surface_refusal_of);
  std::string quads = ugrid_tet<std::int32_t>() + std::string(4, '\0');
  quads.insert(triangles + 4 * 12, 16, '\0');
  quads[8] = 1;
  EXPECT_EQ(surface_refusal_of("a.lb8.ugrid", quads),
            at(triangles + 4 * 12, "vertex 0 of 4 (counted from 1)"));
}

/// What is said when that file lies beside the mesh.
std::string with_beside(const std::string& ending, const std::string& text) {
  const TempFolder folder;
  write_unsynced(folder.path() / "a.lb8.ugrid", ugrid_tet<std::int32_t>());
  write_unsynced(folder.path() / ("a" + ending), text);
  try {
    return mesh_listing(*open_mesh(folder.path() / "a.lb8.ugrid"));
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    return message.substr(message.find("/a.") + 1);
  }
}

TEST(UgridSource, turns_its_boundary_outwards_and_takes_names_from_beside) {
  const std::string rest =
      "region \"domain\"\npart 0 region 1\n node 0 at 0 0 0\n node 1 at 1 0 0\n node 2 at 0 1 0\n"
      " node 3 at 0 0 1\n tet 0 1 2 3 region 1\n triangle 0 2 1 patch 1 region 1\n"
      " triangle 0 1 3 patch 0 region 1\n triangle 1 2 3 patch 0 region 1\n"
      " triangle 2 0 3 patch 2 region 1\n lists of regions:;\n";
  EXPECT_EQ(with_beside(".none", ""), "pieces\n" + rest);
  EXPECT_EQ(with_beside(".mapbc", "3\n1 3000 low z\n2 4000\n\n3 5000   top \nx 1 y\n"),
            "pieces\npatch \"low z\"\npatch \"top \"\n" + rest);
}

TEST(UgridSource, takes_regions_from_beside_that_cover_all_cells) {
  const std::string text = with_beside(".regions", "2 1 1 far away\n");
  EXPECT_EQ(text.substr(0, 60),
            "pieces\nregion \"\"\nregion \"far away\"\npart 0 region 2\n node 0 a");
  for (const char* line : {"x", "1 1", "0 1 1", "1000001 1 1", "1 2 1", "1 0 1", "1 1 2"}) {
    EXPECT_EQ(with_beside(".regions", std::string(line) + "\n"),
              "a.regions: a line does not match the mesh: " + std::string(line));
  }
  EXPECT_EQ(with_beside(".regions", "1 1 0 none\n"), "a.regions: the lines do not cover all cells");
  EXPECT_EQ(with_beside(".regions", "1 1 0 none\n3 1 1 top\n").substr(0, 59),
            "pieces\nregion \"none\"\nregion \"\"\nregion \"top\"\npart 0 region 3");
}

TEST(UgridForm, is_what_stands_before_the_ending_in_whatever_case) {
  const auto text = [](const std::string& name) -> std::string {
    const auto form = ugrid_form(name);
    if (!form) return "text";
    return std::string(form->big_endian ? "big " : "little ") + (form->wide ? "wide " : "narrow ") +
           (form->short_reals ? "short" : "double");
  };
  EXPECT_EQ(text("a.b8.ugrid"), "big narrow double");

  EXPECT_EQ(text("a.LB8.UGRID"), "little narrow double");
  EXPECT_EQ(text("a.B8L.Ugrid.GZ"), "big wide double");
  EXPECT_EQ(text("a.lb8l.ugrid"), "little wide double");
  EXPECT_EQ(text("a.b4.ugrid"), "big narrow short");
  EXPECT_EQ(text("a.lb4.ugrid"), "little narrow short");
  EXPECT_EQ(text("a.ugrid"), "text");
  EXPECT_EQ(text("lb8.ugrid"), "text");
}

}  // namespace
}  // namespace tetfarm
