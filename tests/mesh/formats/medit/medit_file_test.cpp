#include "mesh/formats/medit/medit_file.h"

#include <gmock/gmock.h>

#include <limits>

#include "mesh/formats/medit/read_medit.h"
#include "tests/mesh/formats/mesh_listing.h"
#include "tests/mesh/formats/turned_bytes.h"
#include "tests/mesh/formats/wrong_bytes.h"

namespace tetfarm {
namespace {

/// A tet with a triangle and, so that the file is a mesh of more types, a pyramid in another list.
class Gmf {
 public:
  Gmf(int version, bool is_turned) : version_(version), is_turned_(is_turned) {}

  std::string file() {
    small(1);
    small(version_);
    list(3, [&] { small(3); });
    list(4, [&] {
      large(5);
      for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0},
                                    {1.0, 0.0, 0.0},
                                    {0.0, 1.0, 0.0},
                                    {0.0, 0.0, 1.0},
                                    {0.5, 0.5, -0.25}}) {
        for (const double value : {x, y, z}) real(value);
        large(9);
      }
    });
    list(6, [&] { larges({1, 1, 2, 4, 3}); });
    list(8, [&] { larges({1, 1, 2, 3, 4, 2}); });
    list(7, [&] { larges({1, 1, 2, 4, 3, 4}); });
    list(49, [&] { larges({1, 1, 3, 4, 2, 5, 1}); });
    list(50, [&] { larges({1, 7}); });
    small(54);
    place(0);
    return bytes_;
  }

 private:
  template <class Write>
  void list(int keyword, const Write& write) {
    small(keyword);
    const std::size_t next = bytes_.size();
    place(0);
    write();
    const std::string all = bytes_;
    bytes_.clear();
    place(static_cast<std::int64_t>(all.size()));
    bytes_ = std::string(all).replace(next, bytes_.size(), bytes_);
  }
  void small(int value) { texts::append_number(bytes_, std::int32_t{value}, is_turned_); }
  void integer(std::int64_t value, bool is_wide) {
    if (is_wide) {
      texts::append_number(bytes_, value, is_turned_);
    } else {
      small(static_cast<int>(value));
    }
  }
  void large(std::int64_t value) { integer(value, version_ == 4); }
  void larges(std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) large(value);
  }
  void place(std::int64_t value) { integer(value, version_ >= 3); }
  void real(double value) {
    if (version_ == 1) {
      texts::append_number(bytes_, static_cast<float>(value), is_turned_);
    } else {
      texts::append_number(bytes_, value, is_turned_);
    }
  }

  int version_;
  bool is_turned_;
  std::string bytes_;
};

TEST(MeditFile, of_every_version_and_order_of_bytes_is_the_same_mesh) {
  for (const int version : {1, 2, 3, 4}) {
    for (const bool is_turned : {false, true}) {
      const TempFolder folder;
      write_unsynced(folder.path() / "a.meshb", Gmf(version, is_turned).file());
      EXPECT_EQ(mesh_listing(*open_mesh(folder.path() / "a.meshb")),
                "pieces\npart 0 region 2\n node 0 at 0 0 0\n node 1 at 1 0 0\n node 2 at 0 1 0\n"
                " node 3 at 0 0 1\n tet 0 1 2 3 region 2\n triangle 0 1 3 patch 2 region 2\n"
                " lists of regions:;\n"
                "part 1 region 1\n node 0 at 0 0 0\n node 1 at 1 0 0\n node 2 at 0 1 0\n"
                " node 3 at 0 0 1\n node 4 at 0.5 0.5 -0.25\n pyramid 0 2 3 1 4 region 1\n"
                " quad 0 1 3 2 patch 3 region 1\n lists of regions:;\n")
          << version << is_turned;
    }
  }
}

/// Of version 2: integers and places of 4 bytes, coordinates of 8.
constexpr std::size_t vertices = 20;
constexpr std::size_t triangles = vertices + 12 + 5 * 28;
constexpr std::size_t tets = triangles + 12 + 16;
constexpr std::size_t quads = tets + 12 + 20;

std::string at(std::size_t place, const std::string& what) {
  return "a.meshb: byte " + std::to_string(place) + ": " + what;
}

TEST(MeditFile, says_what_is_wrong_with_a_mesh_and_where) {
  const std::string right = Gmf(2, false).file();
  const std::string bytes = std::to_string(right.size());
  expect_refusals_of_bytes(
      "a.meshb", right,
      {{0, raw_bytes(2), at(0, "is not a Medit file: it begins like neither form")},
       {4, raw_bytes(5), at(4, "version 5 is not supported; 1 to 4 are")},
       {4, raw_bytes(0), at(4, "version 0 is not supported; 1 to 4 are")},
       {12, raw_bytes(8), at(12, "a list gives a wrong place for the next: byte 8")},
       {12, raw_bytes(9999), at(12, "a list gives a wrong place for the next: byte 9999")},
       {12, raw_bytes(19), at(8, "a list runs past the beginning of the next")},
       {16, raw_bytes(2),
        at(16, "the mesh is not three-dimensional; `tetfarm adapt` takes meshes of the plane")},
       {vertices + 8, raw_bytes(-1),
        at(vertices + 8, "a count of -1, but the file has only " + bytes + " bytes")},
       {vertices + 8, raw_bytes(99),
        at(vertices + 8, "a count of 99, but the file has only " + bytes + " bytes")},
       {vertices + 8, raw_bytes(6), at(vertices + 8, "a list runs past the beginning of the next")},
       {tets, raw_bytes(6), at(tets + 8, "a second list of the same kind (6)")},
       {triangles + 12, raw_bytes(6), "a.meshb: boundary triangle 0 has node 5 of 5"},
       {triangles + 12, raw_bytes(0), "a.meshb: boundary triangle 0 has node -1 of 5"},
       {triangles + 24, raw_bytes(0), "a.meshb: boundary triangle 0 has the patch -1"},
       {triangles + 24, raw_bytes(1'000'001), "a.meshb: boundary triangle 0 has the patch 1000000"},
       {tets + 12, raw_bytes(6), "a.meshb: tet 0 has node 5 of 5"},
       {tets + 28, raw_bytes(0), "a.meshb: a tet has the region 0"},
       {tets + 28, raw_bytes(-7), "a.meshb: a tet has the region 0"},
       {tets + 28, raw_bytes(1'000'001), "a.meshb: a tet has the region 1000001"},
       {quads + 12, raw_bytes(6), "a.meshb: boundary quad 0 has node 5 of 5"},
       {quads + 28, raw_bytes(0), "a.meshb: boundary quad 0 has the patch -1"},
       {quads + 12 + 20 + 12, raw_bytes(6), "a.meshb: pyramid 0 has node 5 of 5"},
       {quads + 12 + 20 + 12 + 20, raw_bytes(0), "a.meshb: a pyramid has the region 0"}},
      mesh_refusal_of);
  EXPECT_EQ(mesh_refusal_of("a.meshb", right.substr(0, 10)), at(10, "the file ends too early"));
}

TEST(MeditFile, says_what_is_wrong_with_a_surface_and_where) {
  std::string right = Gmf(2, false).file();
  expect_refusals_of_bytes(
      "a.meshb", right,
      {{quads + 12, raw_bytes(6), at(quads + 12, "vertex 6 of 5 (counted from 1)")}},
      surface_refusal_of);
  const SurfaceMesh with_quads = read_medit(right, "a.meshb");
  EXPECT_THAT(with_quads.patch_names, testing::ElementsAre("reference 3", "reference 4"));
  EXPECT_THAT(with_quads.patch_of_triangle, testing::ElementsAre(0, 1, 1));
  right.replace(quads, 4, raw_bytes(99));  // a list of no kind
  expect_refusals_of_bytes(
      "a.meshb", right,
      {{vertices + 12 + 28 + 8, raw_bytes(std::numeric_limits<double>::quiet_NaN()),
        at(vertices + 12 + 28, "a coordinate is nan")},
       {triangles + 12, raw_bytes(6), at(triangles + 12, "vertex 6 of 5 (counted from 1)")},
       {triangles + 20, raw_bytes(0), at(triangles + 12, "vertex 0 of 5 (counted from 1)")}},
      surface_refusal_of);
}

}  // namespace
}  // namespace tetfarm
