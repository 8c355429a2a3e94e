#include "mesh/artifacts/surface_file.h"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <random>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/artifacts/surface_without_blocks.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

SurfaceMesh two_patches(SurfaceMesh surface = shapes::unit_cube()) {
  surface.patch_names = {"wall", "far field"};
  surface.patch_of_triangle.resize(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    surface.patch_of_triangle[i] = i % 3 == 1 ? 1 : 0;
  }
  return surface;
}

SurfaceMesh two_regions(SurfaceMesh surface = shapes::unit_cube()) {
  surface = two_patches(std::move(surface));
  surface.sides.assign(surface.triangles.size(), Sides{1, 0});
  for (std::size_t i = 3; i < surface.sides.size(); i += 5) surface.sides[i] = {1, 2};
  surface.region_names = {"steel", ""};
  return surface;
}

SurfaceMesh no_patches() {
  SurfaceMesh surface = shapes::box({0, 0, 0}, {1, 1, 1}, 20);
  surface.patch_names.clear();
  surface.patch_of_triangle.clear();
  return surface;
}

void expect_same_surface(const SurfaceMesh& a, const SurfaceMesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.patch_of_triangle, b.patch_of_triangle);
  EXPECT_EQ(a.patch_names, b.patch_names);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.region_names, b.region_names);
}

/// A small file with the number at `offset` replaced and the checksums made right again.
template <class T>
std::string forge(std::string_view bytes, std::size_t offset, T value) {
  std::string content(content_of_blocks(bytes, "f"));
  std::memcpy(content.data() + offset, &value, sizeof value);
  return with_block_checksums(content);
}

// Numbers start after the magic (8 bytes) and the version (4); 6 counts, then 8 vertices.
constexpr std::size_t counts_at = 12;
constexpr std::size_t triangles_at = counts_at + 6 * 8 + 8 * 24;
constexpr std::size_t patches_at = triangles_at + 12 * 12;
constexpr std::size_t sides_at = patches_at + 12 * 4;

TEST(SurfaceBytes, come_back_as_they_were) {
  for (const SurfaceMesh& surface :
       {two_patches(), two_regions(), no_patches(), SurfaceMesh{}, shapes::tetrahedron(),
        two_regions(shapes::box({0, 0, 0}, {1, 2, 3}, 30))}) {
    expect_same_surface(surface_from_bytes(surface_to_bytes(surface), "f"), surface);
  }
}

TEST(SurfaceBytes, every_truncation_and_every_flipped_bit_is_refused) {
  const std::string bytes = surface_to_bytes(two_regions());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(surface_from_bytes(bytes.substr(0, size), "f"), CorruptFile) << size;
  }
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    EXPECT_THROW(surface_from_bytes(damaged, "f"), CorruptFile) << bit;
  }
  EXPECT_THROW(surface_from_bytes(bytes + '\0', "f"), CorruptFile);
}

TEST(SurfaceBytes, bytes_left_over_are_refused_though_the_checksum_is_right) {
  std::string content(content_of_blocks(surface_to_bytes(two_regions()), "f"));
  EXPECT_THROW(surface_from_bytes(with_block_checksums(content + std::string(4, '\0')), "f"),
               CorruptFile);
}

TEST(SurfaceBytes, a_count_beyond_the_file_is_refused_before_anything_is_allocated) {
  const std::string bytes = surface_to_bytes(two_regions());
  for (std::size_t field = 0; field < 6; ++field) {
    for (const std::uint64_t count : {std::uint64_t{1000}, std::uint64_t{0x7fffffff}, ~0UL}) {
      EXPECT_THROW(surface_from_bytes(forge(bytes, counts_at + 8 * field, count), "f"), CorruptFile)
          << field;
    }
  }
}

TEST(SurfaceBytes, an_index_out_of_range_is_refused_though_the_checksum_is_right) {
  const std::string bytes = surface_to_bytes(two_regions());
  for (const std::int32_t index : {-1, 8, 0x7fffffff}) {
    for (const std::size_t place : {triangles_at, patches_at, sides_at}) {
      EXPECT_THROW(surface_from_bytes(forge(bytes, place, index), "f"), CorruptFile) << place;
    }
  }
}

TEST(SurfaceBytes, the_message_names_the_file_and_what_is_wrong) {
  const std::string newer = forge(surface_to_bytes(two_patches()), 8, std::uint32_t{4});
  EXPECT_THAT(
      [&] { surface_from_bytes(newer, "store/ab/cd"); },
      ThrowsMessage<CorruptFile>(HasSubstr("store/ab/cd: has the format version 4, not 3")));
  EXPECT_THAT([&] { surface_from_bytes("", "e"); },
              ThrowsMessage<CorruptFile>(HasSubstr("expected kind of file")));
}

TEST(SurfaceBytes, do_not_change_between_releases) {
  // A new layout needs a new version number. This is the worked example of store/formats.md.
  EXPECT_EQ(surface_to_bytes(shapes::tetrahedron()).size(), 247U);
  EXPECT_EQ(hash128(surface_to_bytes(shapes::tetrahedron())).hex(),
            "814394ed5d6ffa6ccaf144bf10a4dca5");
}

class SurfaceFiles : public testing::Test {
 protected:
  SurfaceFile open(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return {path_, "surface"};
  }

  static WantedPieces some_pieces(const SurfaceMesh& surface, std::mt19937& random) {
    WantedPieces wanted;
    const auto pick = [&random](std::size_t below) {
      return static_cast<std::uint32_t>(random() % below);
    };
    for (std::size_t i = pick(60); i > 0; --i) {
      wanted.vertices.push_back(pick(surface.vertices.size()));
    }
    for (std::size_t i = pick(60); i > 0; --i) {
      wanted.triangles.push_back(pick(surface.triangles.size()));
    }
    return wanted;
  }

  static void expect_same(const SurfacePieces& a, const SurfacePieces& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.patches, b.patches);
    EXPECT_EQ(a.sides, b.sides);
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "surface";
};

TEST_F(SurfaceFiles, give_the_pieces_that_the_whole_surface_has) {
  std::mt19937 random(3);
  const SurfaceMesh box = shapes::box({0, 0, 0}, {1, 2, 3}, 30);
  for (const SurfaceMesh& surface :
       {two_patches(), two_regions(), no_patches(), two_patches(box), two_regions(box)}) {
    SurfaceFile file = open(surface_to_bytes(surface));
    EXPECT_EQ(file.patch_names(), surface.patch_names);
    EXPECT_EQ(file.region_names(), surface.region_names);
    for (int i = 0; i < 30; ++i) {
      const WantedPieces wanted = some_pieces(surface, random);
      expect_same(file.read(wanted), pieces_of(surface, wanted));
    }
  }
}

TEST_F(SurfaceFiles, are_not_read_whole_for_a_few_pieces) {
  const std::string bytes = surface_to_bytes(two_regions(shapes::box({0, 0, 0}, {1, 1, 1}, 60)));
  ASSERT_GT(bytes.size(), 1'000'000U);
  SurfaceFile file = open(bytes);
  file.read({{5000, 5002, 5001}, {7000, 7001}});
  EXPECT_LE(file.bytes_read(), 12 * block_size);
}

TEST_F(SurfaceFiles, have_no_pieces_beyond_their_end) {
  const SurfaceMesh surface = two_patches();
  SurfaceFile file = open(surface_to_bytes(surface));
  for (const WantedPieces& wanted : {WantedPieces{{0, 8}, {}}, WantedPieces{{}, {1, 12}}}) {
    EXPECT_THROW(file.read(wanted), Error);
    EXPECT_THROW(pieces_of(surface, wanted), Error);
  }
}

TEST_F(SurfaceFiles, that_are_damaged_or_cut_short_are_refused) {
  const std::string bytes = surface_to_bytes(two_regions(shapes::box({0, 0, 0}, {1, 1, 1}, 30)));
  const WantedPieces last = {{5401}, {10799}};
  EXPECT_NO_THROW(open(bytes).read(last));
  for (std::size_t size = 0; size < bytes.size(); size += 4001) {
    EXPECT_THROW(open(bytes.substr(0, size)), CorruptFile) << size;
  }
  std::string damaged = bytes;
  damaged[SurfaceCounts{5402}.triangles_at() - 1] ^= 1;
  EXPECT_THROW(open(damaged).read(last), CorruptFile);
  EXPECT_NO_THROW(open(damaged).read({{0}, {10799}})) << "that is elsewhere";
}

TEST_F(SurfaceFiles, that_lie_are_refused_though_the_checksums_are_right) {
  const std::string bytes = surface_to_bytes(two_regions());
  for (const std::int32_t index : {-1, 8, 0x7fffffff}) {
    for (const std::size_t place : {triangles_at, patches_at, sides_at}) {
      EXPECT_THROW(open(forge(bytes, place, index)).read({{}, {0}}), CorruptFile) << place;
    }
  }
  for (std::size_t field = 0; field < 6; ++field) {
    for (const std::uint64_t count : {std::uint64_t{1000}, std::uint64_t{0x7fffffff}, ~0UL}) {
      EXPECT_THROW(open(forge(bytes, counts_at + 8 * field, count)), CorruptFile) << field;
    }
  }
}

/// As the version before wrote it: two boxes, one in the other.
TEST_F(SurfaceFiles, without_blocks_are_read_whole) {
  const std::string bytes = read_file(std::string(TETFARM_SOURCE_DIR) +
                                      "/tests/mesh/artifacts/fixtures/surface_version_2");
  EXPECT_TRUE(is_surface_without_blocks(bytes));
  EXPECT_THROW(open(bytes), CorruptFile);
  const SurfaceMesh surface = surface_from_bytes(bytes, "old");
  EXPECT_EQ(surface.vertices.size(), 53U);
  EXPECT_EQ(surface.triangles.size(), 96U);
  EXPECT_THAT(surface.region_names, testing::ElementsAre("steel", "air gap"));
  EXPECT_THAT(surface.patch_names, testing::ElementsAre("outer", "inner"));
  EXPECT_EQ(meshed_sides(surface), 144);
  EXPECT_NEAR(domain_volume(surface), 27, 1e-12);
  EXPECT_EQ(surface_without_blocks(surface), bytes) << "what other tests take for such a file";
  const std::string again = surface_to_bytes(surface);
  EXPECT_FALSE(is_surface_without_blocks(again));
  expect_same_surface(surface_from_bytes(again, "new"), surface);
  for (std::size_t place = 0; place < bytes.size(); place += 3) {
    std::string damaged = bytes;
    damaged[place] ^= 2;
    EXPECT_THROW(surface_from_bytes(damaged, "old"), CorruptFile) << place;
    EXPECT_THROW(surface_from_bytes(bytes.substr(0, place), "old"), CorruptFile) << place;
  }
}

}  // namespace
}  // namespace tetfarm
