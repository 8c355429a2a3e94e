#include "mesh/formats/medit/read_medit.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/formats/turned_bytes.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class MeditBytes {
 public:
  MeditBytes(int version, bool is_turned) : version_(version), is_turned_(is_turned) {
    small(1);
    small(version);
  }
  void small(std::int32_t value) { texts::append_number(bytes, value, is_turned_); }
  void large(std::int64_t value) { texts::append_number(bytes, value, is_turned_); }
  void integer(std::int64_t value) {
    version_ < 4 ? small(static_cast<std::int32_t>(value)) : large(value);
  }
  void real(double value) {
    if (version_ == 1) {
      texts::append_number(bytes, static_cast<float>(value), is_turned_);
    } else {
      texts::append_number(bytes, value, is_turned_);
    }
  }
  /// A list, whose head says where the next begins.
  template <class Fill>
  void list(int keyword, const Fill& fill) {
    MeditBytes inside(version_, is_turned_);
    inside.bytes.clear();
    fill(inside);
    small(keyword);
    const std::int64_t place = version_ < 3 ? 4 : 8;
    const std::int64_t next = std::ssize(bytes) + place + std::ssize(inside.bytes);
    version_ < 3 ? small(static_cast<std::int32_t>(next)) : large(next);
    bytes += inside.bytes;
  }

  std::string bytes;

 private:
  int version_;
  bool is_turned_;
};

std::string binary(const SurfaceMesh& mesh, int version, bool is_turned) {
  MeditBytes file(version, is_turned);
  file.list(3, [](MeditBytes& list) { list.small(3); });
  file.list(4, [&](MeditBytes& list) {
    list.integer(std::ssize(mesh.vertices));
    for (const Vec3& p : mesh.vertices) {
      for (const double x : {p.x, p.y, p.z}) list.real(x);
      list.integer(0);
    }
  });
  file.list(8, [](MeditBytes& list) {
    for (const int number : {1, 1, 2, 3, 4, 0}) list.integer(number);
  });
  file.list(6, [&](MeditBytes& list) {
    list.integer(std::ssize(mesh.triangles));
    for (const Triangle& triangle : mesh.triangles) {
      for (const std::int32_t v : triangle) list.integer(v + 1);
      list.integer(5);
    }
  });
  file.small(54);
  file.integer(0);
  return file.bytes;
}

TEST(ReadMedit, every_version_and_order_of_bytes_gives_the_same_surface) {
  const SurfaceMesh cube = shapes::unit_cube();
  for (const int version : {1, 2, 3, 4}) {
    for (const bool is_turned : {false, true}) {
      const SurfaceMesh back = read_medit(binary(cube, version, is_turned), "a.meshb");
      EXPECT_EQ(back.vertices, cube.vertices) << version;
      EXPECT_EQ(back.triangles, cube.triangles) << version;
      EXPECT_THAT(back.patch_names, ElementsAre("reference 5")) << version;
    }
  }
}

constexpr const char* text =
    "MeshVersionFormatted 2\n\nDimension\n3\n# by hand\nVertices\n5\n0 0 0 1\n1 0 0 1\n0 1 0 1\n"
    "0 0 1 1\n9 9 9 0\n\nEdges\n1\n1 2 7\n\nTriangles\n2\n1 2 3 4\n1 4 2 6\n";

TEST(ReadMedit, text_passes_over_other_lists) {
  const SurfaceMesh mesh = read_medit(std::string(text) + "\nCorners\n1\n1\nEnd\n", "a.mesh");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 3, 1}));
  EXPECT_THAT(mesh.patch_names, ElementsAre("reference 4", "reference 6"));
}

TEST(ReadMedit, names_the_place_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& bytes) {
    return [=] { read_medit(bytes, "a.mesh"); };
  };
  EXPECT_THAT(reading(std::string(text) + "Quadrilaterals\n1\n1 2 3 6 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("vertex 6 of 5")));
  EXPECT_THAT(reading("MeshVersionFormatted 2\nDimension 2\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.mesh:2: ")));
  EXPECT_THAT(reading("nothing at all"), ThrowsMessage<InvalidInput>(HasSubstr("byte 0")));
  std::string bytes = binary(shapes::unit_cube(), 3, false);
  EXPECT_THAT(reading(bytes.substr(0, 200)), ThrowsMessage<InvalidInput>(HasSubstr("byte ")));
  bytes[12] = 9;  // the next list would begin inside the head of this one
  EXPECT_THAT(reading(bytes),
              ThrowsMessage<InvalidInput>(HasSubstr("a list runs past the beginning")));
}

}  // namespace
}  // namespace tetfarm
