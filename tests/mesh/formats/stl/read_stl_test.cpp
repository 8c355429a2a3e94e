#include "mesh/formats/stl/read_stl.h"

#include <gmock/gmock.h>

#include <limits>

#include "base/error.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* one_facet =
    "solid a part\n"
    "facet normal nan nan nan\n outer loop\n"
    "vertex 0 0 0\n vertex +1 0 0\n vertex 0 1e0 0\n"
    "endloop\nendfacet\nendsolid a part\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadStl, welds_the_vertices_of_a_binary_cube) {
  const SurfaceMesh cube = shapes::unit_cube();
  const SurfaceMesh read = read_stl(texts::stl_binary(cube), "a.stl");
  EXPECT_EQ(read.vertices.size(), 8U);
  EXPECT_EQ(read.triangles.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(texts::vertex(read, read.triangles[i][k]),
                texts::vertex(cube, cube.triangles[i][k]));
    }
  }
}

TEST(ReadStl, numbers_vertices_in_the_order_of_their_first_use) {
  const SurfaceMesh read = read_stl(texts::stl_binary(shapes::unit_cube()), "a.stl");
  std::int32_t next = 0;
  for (const Triangle& triangle : read.triangles) {
    for (const std::int32_t v : triangle) {
      ASSERT_LE(v, next);
      if (v == next) ++next;
    }
  }
  EXPECT_EQ(next, 8);
}

TEST(ReadStl, tells_a_binary_file_that_begins_with_solid_by_its_size) {
  const std::string bytes = texts::stl_binary(shapes::unit_cube(), "solid binary after all");
  EXPECT_EQ(read_stl(bytes, "a.stl").triangles.size(), 12U);
}

TEST(ReadStl, minus_zero_is_zero_but_close_points_stay_apart) {
  SurfaceMesh mesh;
  mesh.vertices = {{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, 0, 0x1p-100}};
  mesh.triangles = {{0, 1, 2}, {3, 2, 4}};
  mesh.patch_of_triangle = {0, 0};
  mesh.patch_names = {"x"};
  for (const std::string& bytes : {texts::stl_binary(mesh), texts::stl_ascii(mesh)}) {
    const SurfaceMesh read = read_stl(bytes, "a.stl");
    EXPECT_EQ(read.vertices.size(), 4U);
    EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  }
}

TEST(ReadStl, ascii_solids_become_patches) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.patch_names = {"wall", "far field"};
  for (std::size_t i = 6; i < 12; ++i) mesh.patch_of_triangle[i] = 1;
  const SurfaceMesh read = read_stl(texts::stl_ascii(mesh), "a.stl");
  EXPECT_EQ(read.patch_names, mesh.patch_names);
  EXPECT_EQ(read.patch_of_triangle, mesh.patch_of_triangle);
  EXPECT_EQ(read.vertices.size(), 8U);
}

TEST(ReadStl, accepts_any_normal_plus_signs_capitals_and_windows_line_ends) {
  std::string text = one_facet;
  EXPECT_EQ(read_stl(text, "a.stl").triangles.size(), 1U);
  EXPECT_EQ(read_stl(text, "a.stl").patch_names[0], "a part");
  for (std::size_t i = 0; (i = text.find('\n', i)) != text.npos; i += 2) text.replace(i, 1, "\r\n");
  EXPECT_EQ(read_stl(text, "a.stl").patch_names[0], "a part");
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(read_stl(text, "a.stl").vertices[1], (Vec3{1, 0, 0}));
}

TEST(ReadStl, a_facet_may_be_without_a_normal) {
  const SurfaceMesh mesh = read_stl(
      "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid a\n",
      "a.stl");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ReadStl, keeps_a_degenerate_triangle_for_the_check_to_report) {
  const std::string text = with(one_facet, "vertex +1 0 0", "vertex 0 0 0");
  EXPECT_THAT(read_stl(text, "a.stl").triangles, ElementsAre(Triangle{0, 0, 1}));
}

TEST(ReadStl, names_the_line_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& from, const std::string& to) {
    return [=] { read_stl(with(one_facet, from, to), "a.stl"); };
  };
  EXPECT_THAT(
      reading("+1", "one"),
      ThrowsMessage<InvalidInput>(HasSubstr("a.stl:5: expected a coordinate, found \"one\"")));
  EXPECT_THAT(reading("+1", "nan"), ThrowsMessage<InvalidInput>(HasSubstr("a.stl:5: ")));
  EXPECT_THAT(reading("+1", "-inf"), ThrowsMessage<InvalidInput>(HasSubstr("a.stl:5: ")));
  EXPECT_THAT(reading("+1", "1e999"), ThrowsMessage<InvalidInput>(HasSubstr("too large")));
  EXPECT_THAT(reading("endloop", "vertex 1 1 1 endloop"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.stl:7: expected endloop")));
  EXPECT_THAT(reading("endsolid a part\n", ""),
              ThrowsMessage<InvalidInput>(HasSubstr("expected facet or endsolid, found nothing")));
}

TEST(ReadStl, a_coordinate_too_small_for_a_double_is_zero) {
  EXPECT_EQ(read_stl(with(one_facet, "1e0", "1e-999"), "a.stl").vertices.size(), 2U);
}

TEST(ReadStl, every_cut_of_an_ascii_facet_is_an_error) {
  const std::string text = one_facet;
  for (std::size_t size = 0; size + 8 < text.size(); ++size) {
    EXPECT_THROW(read_stl(text.substr(0, size), "a.stl"), InvalidInput) << size;
  }
}

TEST(ReadStl, a_binary_file_of_the_wrong_size_is_refused_with_both_sizes) {
  std::string bytes = texts::stl_binary(shapes::unit_cube());
  bytes.pop_back();
  EXPECT_THAT([&] { read_stl(bytes, "a.stl"); },
              ThrowsMessage<InvalidInput>(HasSubstr("has 684 bytes, this one 683")));
  const std::string solid = texts::stl_binary(shapes::unit_cube(), "solid binary");
  EXPECT_THAT([&] { read_stl(solid.substr(0, 300), "a.stl"); },
              ThrowsMessage<InvalidInput>(HasSubstr("has 684 bytes, this one 300")));
  const std::uint32_t huge = 0xffffffff;
  std::memcpy(bytes.data() + 80, &huge, 4);
  EXPECT_THROW(read_stl(bytes, "a.stl"), InvalidInput);
  EXPECT_THROW(read_stl(bytes.substr(0, 50), "a.stl"), InvalidInput);
}

TEST(ReadStl, a_binary_coordinate_that_is_not_finite_names_its_triangle) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::string bytes = texts::stl_binary(shapes::unit_cube());
    std::memcpy(bytes.data() + 84 + 50 * 3 + 12 + 12, &bad, sizeof bad);
    EXPECT_THAT([&] { read_stl(bytes, "a.stl"); },
                ThrowsMessage<InvalidInput>(HasSubstr("a.stl: byte 258: triangle 3")));
  }
}

}  // namespace
}  // namespace tetfarm
