#include "mesh/formats/ply/read_ply.h"

#include <gmock/gmock.h>

#include <limits>

#include "base/error.h"
#include "tests/mesh/formats/turned_bytes.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

SurfaceMesh read(const std::string& bytes) { return read_ply(bytes, "a.ply"); }

std::string binary(const SurfaceMesh& mesh, bool is_big) {
  std::string bytes = "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
                      "_endian 1.0\ncomment by hand\nelement vertex " +
                      std::to_string(mesh.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n"
                      "property uchar red\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uint8 int32 vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z}) texts::append_number(bytes, x, is_big);
    bytes += '\xff';
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::int32_t v : triangle) texts::append_number(bytes, v, is_big);
  }
  return bytes;
}

TEST(ReadPly, both_orders_of_bytes_give_the_same_surface) {
  const SurfaceMesh cube = shapes::unit_cube();
  for (const bool is_big : {false, true}) {
    const SurfaceMesh back = read(binary(cube, is_big));
    EXPECT_EQ(back.vertices, cube.vertices);
    EXPECT_EQ(back.triangles, cube.triangles);
  }
}

constexpr const char* head =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
    "property float quality\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";

TEST(ReadPly, polygons_of_text_become_fans) {
  const SurfaceMesh mesh = read(std::string(head) + "4 0 1 2 3 0.25\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_EQ(mesh.vertices[3], (Vec3{0, 1, 0.5}));
}

TEST(ReadPly, passes_over_properties_of_vertices_and_faces_that_are_not_numbers) {
  const SurfaceMesh text = read(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float x\n"
      "property float y\nproperty float z\nproperty float quality\nelement face 1\n"
      "property list uchar int vertex_index\nproperty list uchar float texcoord\nend_header\n"
      "nan 0 0 0 -nan\n-nan(ind) 1 0 0 inf\n0 0 1 0 1.#QNAN\n3 0 1 2 2 nan inf\n");
  EXPECT_THAT(text.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_EQ(text.vertices[1], (Vec3{1, 0, 0}));
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float nx\nelement face 1\n"
      "property list uchar int vertex_index\nend_header\n";
  for (const float x : {0.0F, 1.0F, 2.0F}) {
    for (const float value : {x, x * x, 0.0F, std::numeric_limits<float>::quiet_NaN()}) {
      texts::append_number(bytes, value, false);
    }
  }
  bytes += '\3';
  for (const std::int32_t corner : {0, 1, 2}) texts::append_number(bytes, corner, false);
  EXPECT_EQ(read(bytes).vertices[2], (Vec3{2, 4, 0}));
  bytes[bytes.find("end_header") + 11 + 3] = '\x7f';  // of the first x
  bytes[bytes.find("end_header") + 11 + 2] = '\xc0';
  EXPECT_THAT([&] { read(bytes); }, ThrowsMessage<InvalidInput>(HasSubstr("a coordinate is nan")));
}

TEST(ReadPly, strips_are_triangles_that_all_turn_one_way) {
  const auto strips = [](const std::string& corners) {
    return read(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n" +
        corners + "\n");
  };
  EXPECT_THAT(strips("5 0 1 2 3 4").triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}));
  EXPECT_THAT(
      strips("9 0 1 2 3 -1 2 3 4 5").triangles,
      ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}, Triangle{4, 3, 5}));
  // Strips joined by corners that are there twice, and ones too short for a triangle.
  EXPECT_THAT(strips("8 0 1 2 2 3 3 4 5").triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{4, 3, 5}));
  EXPECT_THAT(strips("5 0 1 -1 2 3").triangles, testing::IsEmpty());
  EXPECT_THAT([&] { strips("3 0 1 6"); }, ThrowsMessage<InvalidInput>(HasSubstr("vertex 6 of 6")));
  EXPECT_THAT([&] { strips("3 0 1 -2"); }, ThrowsMessage<InvalidInput>(HasSubstr("vertex -2")));
}

TEST(ReadPly, names_the_place_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& text) { return [=] { read(text); }; };
  EXPECT_THAT(reading("OFF\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.ply:1: expected ply")));
  EXPECT_THAT(reading("ply\nformat binary_middle 1.0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ply:2: unknown format")));
  EXPECT_THAT(reading(std::string(head) + "3 0 1 4 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ply:15: vertex 4 of 4")));
  EXPECT_THAT(reading(std::string(head) + "2 0 1 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a face with 2 vertices")));
  const std::string whole = binary(shapes::unit_cube(), false);
  EXPECT_THAT(reading(whole.substr(0, whole.size() - 1)),
              ThrowsMessage<InvalidInput>(HasSubstr(": byte ")));
}

TEST(ReadPly, integers_of_two_bytes_have_a_sign_where_their_type_says_so) {
  const auto with_type = [](const std::string& type, std::uint16_t v) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 40000\nproperty char x\n"
        "property uchar y\nproperty short z\nelement face 1\nproperty list uchar " +
        type + " vertex_index\nend_header\n";
    for (int i = 0; i < 40000; ++i) bytes += "\xff\xff\xfe\xff";
    bytes += '\3';
    for (const std::uint16_t corner : {std::uint16_t{0}, std::uint16_t{1}, v}) {
      texts::append_number(bytes, corner, false);
    }
    return bytes;
  };
  const SurfaceMesh mesh = read(with_type("ushort", 39999));
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 39999}));
  EXPECT_EQ(mesh.vertices[7], (Vec3{-1, 255, -2}));
  EXPECT_THAT([&] { read(with_type("short", 39999)); },
              ThrowsMessage<InvalidInput>(HasSubstr("vertex -25537 of 40000")));
}

}  // namespace
}  // namespace tetfarm
