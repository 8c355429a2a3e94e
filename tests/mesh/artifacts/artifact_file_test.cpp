#include "mesh/artifacts/artifact_file.h"

#include <gmock/gmock.h>

#include <cstring>
#include <functional>

#include "base/error.h"
#include "base/hash.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Subdomain some_subdomain() {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.path = TreePath{}.left().right();
  s.node_origin[3] = {5, 77};
  s.triangle_origin[2] = {0x123456789abcdef0, 0xfffffffe};
  return s;
}

TetMesh some_mesh() {
  TetMesh mesh;
  mesh.nodes = shapes::unit_cube().vertices;
  mesh.boundary_nodes = 8;
  mesh.nodes.push_back({0.5, 0.5, 0.25});
  for (const auto& [a, b, c] : shapes::unit_cube().triangles) mesh.tets.push_back({8, a, b, c});
  return mesh;
}

TEST(ArtifactFile, a_sub_domain_without_a_place_in_the_tree_is_refused) {
  Subdomain s = some_subdomain();
  s.path = TreePath{0};
  EXPECT_THROW(subdomain_from_bytes(subdomain_to_bytes(s), "s"), CorruptFile);
}

struct Kind {
  std::string name;
  std::string bytes;
  std::function<void(std::string_view)> read;
};

std::vector<Kind> kinds() {
  return {{"subdomain", subdomain_to_bytes(some_subdomain()),
           [](std::string_view b) { subdomain_from_bytes(b, "f"); }},
          {"tet mesh", tet_mesh_to_bytes(some_mesh()),
           [](std::string_view b) { tet_mesh_from_bytes(b, some_subdomain(), "f"); }}};
}

/// `bytes` with the number at `offset` replaced and the checksum made right again.
template <class T>
std::string forge(std::string bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  const Hash128 checksum = hash128(bytes.data(), bytes.size() - 16);
  std::memcpy(bytes.data() + bytes.size() - 16, &checksum.low, 8);
  std::memcpy(bytes.data() + bytes.size() - 8, &checksum.high, 8);
  return bytes;
}

TEST(ArtifactFile, a_subdomain_comes_back_as_it_was) {
  const Subdomain s = some_subdomain();
  const Subdomain back = subdomain_from_bytes(subdomain_to_bytes(s), "f");
  EXPECT_EQ(back.path, s.path);
  EXPECT_EQ(back.vertices, s.vertices);
  EXPECT_EQ(back.triangles, s.triangles);
  EXPECT_EQ(back.node_origin, s.node_origin);
  EXPECT_EQ(back.triangle_origin, s.triangle_origin);
}

TEST(ArtifactFile, a_tet_mesh_takes_its_boundary_nodes_from_the_subdomain) {
  const TetMesh mesh = some_mesh();
  Subdomain s = some_subdomain();
  const TetMesh back = tet_mesh_from_bytes(tet_mesh_to_bytes(mesh), s, "f");
  EXPECT_EQ(back.nodes, mesh.nodes);
  EXPECT_EQ(back.tets, mesh.tets);
  EXPECT_EQ(back.boundary_nodes, mesh.boundary_nodes);
  s.vertices.pop_back();
  EXPECT_THROW(tet_mesh_from_bytes(tet_mesh_to_bytes(mesh), s, "f"), CorruptFile);
}

TEST(ArtifactFile, every_truncation_is_refused) {
  for (const Kind& kind : kinds()) {
    for (std::size_t size = 0; size < kind.bytes.size(); ++size) {
      EXPECT_THROW(kind.read(std::string_view(kind.bytes).substr(0, size)), CorruptFile)
          << kind.name << " cut to " << size;
    }
  }
}

TEST(ArtifactFile, every_flipped_bit_is_refused) {
  for (const Kind& kind : kinds()) {
    for (std::size_t bit = 0; bit < 8 * kind.bytes.size(); ++bit) {
      std::string bytes = kind.bytes;
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
      EXPECT_THROW(kind.read(bytes), CorruptFile) << kind.name << " bit " << bit;
    }
  }
}

TEST(ArtifactFile, a_longer_file_and_another_kind_are_refused) {
  const std::vector<Kind> all = kinds();
  for (const Kind& kind : all) {
    EXPECT_THROW(kind.read(kind.bytes + '\0'), CorruptFile);
    for (const Kind& other : all) {
      if (other.name == kind.name) continue;
      EXPECT_THROW(kind.read(other.bytes), CorruptFile);
    }
  }
}

TEST(ArtifactFile, bytes_left_over_are_refused_though_the_checksum_is_right) {
  for (const Kind& kind : kinds()) {
    EXPECT_THROW(kind.read(forge(kind.bytes + std::string(4, '\0'), 8, std::uint32_t{1})),
                 CorruptFile);
  }
}

TEST(ArtifactFile, regions_come_back_as_they_were) {
  SurfaceMesh surface = shapes::unit_cube();
  surface.sides.assign(surface.triangles.size(), Sides{1, 0});
  surface.sides[3] = {1, 2};
  surface.region_names = {"steel", ""};
  Subdomain several = root_subdomain(surface);
  ASSERT_EQ(several.region, 0);
  const Subdomain back = subdomain_from_bytes(subdomain_to_bytes(several), "f");
  EXPECT_EQ(back.region, 0);
  EXPECT_EQ(back.sides, several.sides);
  Subdomain one = some_subdomain();
  one.region = 7;
  EXPECT_EQ(subdomain_from_bytes(subdomain_to_bytes(one), "f").region, 7);
}

// The numbers start after the magic (8 bytes) and the version (4).
TEST(ArtifactFile, a_count_beyond_the_file_is_refused_before_anything_is_allocated) {
  for (const Kind& kind : kinds()) {
    for (std::size_t field = 0; field < 3; ++field) {
      const std::size_t heap = kind.name == "subdomain" ? 8 : 0;
      for (const std::uint64_t count :
           {std::uint64_t{1000}, std::uint64_t{0x7fffffff}, ~std::uint64_t{0}}) {
        const std::size_t offset = 12 + heap + 8 * field;
        if (heap != 0 && field == 2) continue;
        EXPECT_THROW(kind.read(forge(kind.bytes, offset, count)), CorruptFile)
            << kind.name << " field " << field;
      }
    }
  }
}

TEST(ArtifactFile, an_index_out_of_range_is_refused_though_the_checksum_is_right) {
  const std::size_t first_tet = 12 + 3 * 8 + 24;
  EXPECT_THROW(tet_mesh_from_bytes(forge(tet_mesh_to_bytes(some_mesh()), first_tet, 9),
                                   some_subdomain(), "f"),
               CorruptFile);
}

TEST(ArtifactFile, the_message_names_the_file_and_what_is_wrong) {
  const std::string newer = forge(subdomain_to_bytes(some_subdomain()), 8, std::uint32_t{3});
  EXPECT_THAT(
      [&] { subdomain_from_bytes(newer, "store/ab/cd"); },
      ThrowsMessage<CorruptFile>(HasSubstr("store/ab/cd: has the format version 3, not 2")));
  EXPECT_THAT([&] { subdomain_from_bytes("", "e"); },
              ThrowsMessage<CorruptFile>(HasSubstr("expected kind of file")));
}

TEST(ArtifactFile, bytes_do_not_change_between_releases) {
  // A new layout needs a new version number.
  EXPECT_EQ(hash128(subdomain_to_bytes(some_subdomain())).hex(),
            "7b80cfc800e77f4bee0d697ab79e4fb0");
  EXPECT_EQ(hash128(tet_mesh_to_bytes(some_mesh())).hex(), "f18d475d32195c204be6f31dc5b69ce2");
}

}  // namespace
}  // namespace tetfarm
