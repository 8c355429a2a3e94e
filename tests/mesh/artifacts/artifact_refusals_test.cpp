// What is said of artifacts that are wrong though their checksums are right: the whole message.
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include "base/error.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/block_file.h"
#include "mesh/artifacts/checked_bytes.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/artifacts/surface_file.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

template <class T>
std::string with_number(std::string bytes, std::size_t place, T value) {
  return bytes.replace(place, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
}

/// With one checksum at the end.
template <class T>
std::string checked_with(const std::string& bytes, std::size_t place, T value) {
  ByteWriter writer;
  writer.text(with_number(bytes.substr(0, bytes.size() - checksum_size), place, value));
  return finish_checked(std::move(writer));
}

TEST(ArtifactRefusals, of_a_subdomain) {
  const Subdomain root = root_subdomain(shapes::tetrahedron());
  Subdomain one = root;
  one.region = 1;
  one.sides.clear();
  const std::string bytes = subdomain_to_bytes(one);
  const auto said_of = [](const std::string& wrong) {
    return error_text_of([&] { subdomain_from_bytes(wrong, "s"); });
  };
  constexpr std::size_t triangles = 12 + 4 * 8 + 4 * 24;
  EXPECT_EQ(said_of(bytes), "");
  EXPECT_EQ(said_of(checked_with(bytes, 8, std::uint32_t{1})),
            "s: has the format version 1, not 2");
  EXPECT_EQ(said_of(checked_with(bytes, 12, std::uint64_t{0})), "s: has the tree path 0");
  EXPECT_EQ(said_of(checked_with(bytes, 20, std::uint64_t{1} << 31U)),
            "s: has a count of 2147483648");
  EXPECT_EQ(said_of(checked_with(bytes, 20, std::uint64_t{999})), "s: is cut short");
  EXPECT_EQ(said_of(checked_with(bytes, triangles, 4)), "s: has the index 4 of 4 items");
  EXPECT_EQ(said_of(checked_with(bytes, triangles + 8, -1)), "s: has the index -1 of 4 items");
  EXPECT_EQ(said_of(checked_with(bytes, triangles, 3)), "");
  EXPECT_EQ(said_of(checked_with(bytes, 36, std::uint64_t{0})), "s: is cut short")
      << "of several regions, each triangle has its sides";
  Subdomain several = root;
  several.region = 0;
  several.sides.assign(4, {1, 0});
  const std::string sides = subdomain_to_bytes(several);
  EXPECT_EQ(said_of(sides), "");
  EXPECT_EQ(said_of(checked_with(sides, sides.size() - checksum_size - 4, -1)),
            "s: has the index -1 of 2147483647 items");
  EXPECT_EQ(said_of(checked_with(sides, 36, std::uint64_t{1})), "s: has 32 surplus bytes");
}

TEST(ArtifactRefusals, of_a_tet_mesh) {
  const Subdomain root = root_subdomain(shapes::tetrahedron());
  TetMesh mesh;
  mesh.nodes = root.vertices;
  mesh.boundary_nodes = 4;
  mesh.nodes.push_back({0.1, 0.1, 0.1});
  mesh.tets = {{0, 1, 2, 4}};
  const std::string bytes = tet_mesh_to_bytes(mesh);
  const auto said_of = [&root](const std::string& wrong) {
    return error_text_of([&] { tet_mesh_from_bytes(wrong, root, "m"); });
  };
  EXPECT_EQ(said_of(bytes), "");
  EXPECT_EQ(said_of(checked_with(bytes, 12, std::uint64_t{5})),
            "m: has 5 boundary nodes, its sub-domain 4");
  EXPECT_EQ(said_of(checked_with(bytes, 36 + 24, 5)), "m: has the index 5 of 5 items");
  EXPECT_EQ(said_of(checked_with(bytes, 36 + 24 + 12, -1)), "m: has the index -1 of 5 items");
  EXPECT_EQ(said_of(checked_with(bytes, 28, std::uint64_t{0})), "m: has 16 surplus bytes");
}

TEST(ArtifactRefusals, of_a_surface) {
  SurfaceMesh surface = shapes::tetrahedron();
  surface.patch_names = {"a", "b"};
  surface.patch_of_triangle = {0, 1, 0, 1};
  surface.sides.assign(4, Sides{1, 0});
  surface.region_names = {"in"};
  const std::string content(content_of_blocks(surface_to_bytes(surface), "f"));
  const auto said_of = [](const std::string& wrong) {
    return error_text_of([&] { surface_from_bytes(with_block_checksums(wrong), "f"); });
  };
  const SurfaceCounts counts = {4, 4, 4, 2, 4, 1};
  EXPECT_EQ(counts.vertices_at(), 60U);
  EXPECT_EQ(counts.triangles_at(), 60U + 96);
  EXPECT_EQ(counts.patches_at(), 60U + 96 + 48);
  EXPECT_EQ(counts.sides_at(), 60U + 96 + 48 + 16);
  EXPECT_EQ(counts.names_at(), 60U + 96 + 48 + 16 + 32);
  EXPECT_EQ(said_of(content), "");
  EXPECT_EQ(said_of(with_number(content, 28, std::uint64_t{3})),
            "f: gives patches to only some triangles");
  EXPECT_EQ(said_of(with_number(content, 44, std::uint64_t{3})),
            "f: gives sides to only some triangles");
  EXPECT_EQ(said_of(with_number(content, counts.triangles_at() + 4, 4)),
            "f: has the index 4 of 4 items");
  EXPECT_EQ(said_of(with_number(content, counts.patches_at() + 12, 2)),
            "f: has the index 2 of 2 items");
  EXPECT_EQ(said_of(with_number(content, counts.sides_at() + 28, 2)),
            "f: has the index 2 of 2 items");
  EXPECT_EQ(said_of(with_number(content, counts.sides_at() + 28, 1)), "");
  EXPECT_EQ(said_of(content + "x"), "f: has 1 surplus bytes");
  EXPECT_EQ(said_of(content.substr(0, content.size() - 1)), "f: is cut short");
  EXPECT_EQ(error_text_of([&] { pieces_of(surface, {{4}, {}}); }), "the surface has no vertex 4");
  EXPECT_EQ(error_text_of([&] { pieces_of(surface, {{}, {4}}); }), "the surface has no triangle 4");
  EXPECT_EQ(error_text_of([&] { pieces_of(surface, {{3, 0}, {3, 0}}); }), "");
  const TempFolder folder;
  const std::string path = folder.path() / "surface";
  const auto said_of_file = [&](const std::string& wrong, const WantedPieces& wanted) {
    std::ofstream(path, std::ios::binary) << with_block_checksums(wrong);
    return error_text_of([&] { SurfaceFile(path, "f").read(wanted); });
  };
  EXPECT_EQ(said_of_file(content, {{3, 0}, {3, 0}}), "");
  EXPECT_EQ(said_of_file(content, {{4}, {}}), "the surface has no vertex 4");
  EXPECT_EQ(said_of_file(content, {{}, {4}}), "the surface has no triangle 4");
  EXPECT_EQ(said_of_file(with_number(content, counts.patches_at() + 12, 2), {{}, {3}}),
            "f: has the index 2 of 2 items");
  EXPECT_EQ(said_of_file(with_number(content, counts.patches_at() + 12, 2), {{}, {2}}), "");
  EXPECT_EQ(said_of_file(with_number(content, counts.sides_at() + 28, -1), {{}, {3}}),
            "f: has the index -1 of 2 items");
  EXPECT_EQ(said_of_file(with_number(content, 12, std::uint64_t{99}), {}), "f: is cut short");
  EXPECT_EQ(said_of_file(content + "x", {}), "f: has 1 surplus bytes");
}

TEST(ArtifactRefusals, of_elements) {
  const TempFolder folder;
  const std::string path = folder.path() / "elements";
  ElementSection section;
  section.sharers = {4, 5};
  section.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  section.node_origin = {{0, 4}, {1, 0}, {2, 7}, {2, 9}};
  section.tets = {{0, 1, 2, 3}};
  section.tet_owner = {1};
  const auto said_of = [&path](const std::string& bytes, bool reads_core) {
    std::ofstream(path, std::ios::binary) << bytes;
    return error_text_of([&] {
      ElementFile file(path, "e");
      if (reads_core) {
        file.read_core();
      } else {
        file.read(0);
      }
    });
  };
  const std::string bytes = elements_to_bytes({{5}, 12, {}, {}}, {section});
  EXPECT_EQ(said_of(bytes, false), "");
  EXPECT_EQ(said_of(bytes, true), "e: has no core");
  EXPECT_EQ(said_of(elements_to_bytes({{5}, 12, {}, {}}, {}), true), "e: has no core");
  ElementSection crowded = section;
  crowded.sharers.resize(256);
  std::iota(crowded.sharers.begin(), crowded.sharers.end(), 1);
  EXPECT_EQ(said_of(elements_to_bytes({{5}, 12, {}, {}}, {crowded}), false),
            "e: has a section with no sharers, or too many");
  crowded.sharers.pop_back();
  EXPECT_EQ(said_of(elements_to_bytes({{5}, 12, {}, {}}, {crowded}), false), "");
  EXPECT_EQ(said_of("TFNONE\r\n" + bytes.substr(8), false),
            "e: does not begin like the expected kind of file");
  EXPECT_EQ(said_of(with_number(bytes, 8, std::uint32_t{2}), false),
            "e: has the format version 2, not 3");
  EXPECT_EQ(said_of(with_number(bytes, 40, '\x7f'), false), "e: has a wrong checksum for its head");
  EXPECT_EQ(said_of(bytes.substr(0, bytes.size() - 1), false), "e: is cut short");
  EXPECT_EQ(said_of(bytes.substr(0, 30), false), "e: is cut short");
  EXPECT_EQ(said_of(with_number(bytes, bytes.size() - 1, '\x7f'), false),
            "e: has a wrong checksum for section 0");
  const auto core = [](CoreElements taken) {
    return elements_to_bytes({{5}, 12, {}, {}}, {}, std::move(taken));
  };
  EXPECT_EQ(said_of(core({7, {0, 3}, {4, 5}, 9}), true), "");
  EXPECT_EQ(said_of(core({7, {3, 0}, {}, 9}), true), "e: does not list what was taken in order");
  EXPECT_EQ(said_of(core({7, {}, {4, 4}, 9}), true), "e: does not list what was taken in order");
}

TEST(ArtifactRefusals, of_shared_nodes) {
  SharedNodes shared;
  shared.path = {9};
  shared.sets = {{8, 9}};
  shared.nodes = {{{0, 3}, 0}};
  const std::string bytes = shared_nodes_to_bytes(shared);
  const auto said_of = [](const std::string& wrong) {
    return error_text_of([&] { shared_nodes_from_bytes(wrong, "n"); });
  };
  EXPECT_EQ(said_of(bytes), "");
  const std::size_t set = bytes.size() - checksum_size - 4;
  EXPECT_EQ(said_of(checked_with(bytes, set, std::uint32_t{1})),
            "n: has a node of a set that does not exist");
  EXPECT_EQ(said_of(checked_with(bytes, 8, std::uint32_t{2})),
            "n: has the format version 2, not 1");
  EXPECT_EQ(said_of(checked_with(bytes, 20, std::uint64_t{2})), "n: is cut short");
}

TEST(ArtifactRefusals, of_blocks) {
  const std::string bytes = with_block_checksums(std::string(5000, 'x'));
  const auto said_of = [](const std::string& wrong) {
    return error_text_of([&] { content_of_blocks(wrong, "b"); });
  };
  EXPECT_EQ(said_of(bytes), "");
  EXPECT_EQ(said_of(bytes.substr(0, 16)), "b: is cut short");
  EXPECT_EQ(said_of(with_number(bytes, 4999, 'y')), "b: has a wrong checksum for block 1");
  EXPECT_EQ(said_of(with_number(bytes, 4095, 'y')), "b: has a wrong checksum for block 0");
}

}  // namespace
}  // namespace tetfarm
