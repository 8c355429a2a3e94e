// The bytes of portions: what is in them, and all that is said of those that are wrong.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "mesh/artifacts/checked_bytes.h"
#include "mesh/assemble/portion.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

/// A tet with one boundary triangle, and where asked for a hex with one boundary quad.
Portion small_portion(bool has_hex) {
  Portion portion;
  NumberedPart& part = portion.part;
  part.number = 3;
  part.region = 2;
  for (int i = 0; i < 8; ++i) {
    part.nodes.push_back({static_cast<double>(i & 1), static_cast<double>(i / 2 % 2), i / 4 + 0.5});
    part.local2global.push_back(10 + i);
  }
  part.tets = {{0, 1, 2, 4}};
  part.faces = {{0, 2, 1}};
  part.patch_of_face = {5};
  portion.surface_triangles = {77};
  if (has_hex) {
    ElementBlock& hexes = part.blocks[ElementType::hex];
    hexes.nodes = {0, 1, 3, 2, 4, 5, 7, 6};
    hexes.regions = {2};
    ElementBlock& quads = part.blocks[ElementType::quad];
    quads.nodes = {0, 2, 3, 1};
    quads.regions = {2};
    quads.patches = {6};
  }
  ElementCounts first;
  first[ElementType::tet] = 100;
  first[ElementType::hex] = 50;
  take_figures(std::vector<bool>(8, false), first, portion);
  portion.placed = {{8, 80, {1, 2}}, {100, 7, {3, 4}}};
  return portion;
}

void expect_same_shapes(const ShapeStatistics& a, const ShapeStatistics& b) {
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.min_dihedral_deg, b.min_dihedral_deg);
  EXPECT_EQ(a.max_dihedral_deg, b.max_dihedral_deg);
  EXPECT_EQ(a.dihedral_histogram, b.dihedral_histogram);
  EXPECT_EQ(a.min_radius_ratio, b.min_radius_ratio);
  EXPECT_EQ(a.sum_radius_ratio, b.sum_radius_ratio);
  EXPECT_EQ(a.smallest_height, b.smallest_height);
  EXPECT_EQ(a.worst_centroid, b.worst_centroid);
}

TEST(PortionFile, gives_back_each_thing_that_it_was_given) {
  for (const bool has_hex : {false, true}) {
    const Portion portion = small_portion(has_hex);
    const Portion read = portion_from_bytes(portion_to_bytes(portion), "p");
    EXPECT_EQ(read.part.number, 3);
    EXPECT_EQ(read.part.region, 2);
    EXPECT_EQ(read.part.nodes, portion.part.nodes);
    EXPECT_EQ(read.part.local2global, portion.part.local2global);
    EXPECT_EQ(read.part.faces, portion.part.faces);
    EXPECT_EQ(read.part.patch_of_face, portion.part.patch_of_face);
    EXPECT_EQ(read.surface_triangles, portion.surface_triangles);
    EXPECT_EQ(read.tets, 1);
    EXPECT_EQ(read.others, portion.others);
    EXPECT_EQ(read.face_sum, portion.face_sum);
    EXPECT_EQ(read.tet_digest, portion.tet_digest);
    EXPECT_EQ(read.other_digest, portion.other_digest);
    EXPECT_EQ(read.placed, portion.placed);
    expect_same_shapes(read.shapes.all, portion.shapes.all);
    expect_same_shapes(read.shapes.near_cuts, portion.shapes.near_cuts);
    expect_same_shapes(read.shapes.away_from_cuts, portion.shapes.away_from_cuts);
    ASSERT_EQ(read.shapes.regions.size(), 2U);
    EXPECT_EQ(read.shapes.regions[1].volume, portion.shapes.regions[1].volume);
    expect_same_shapes(read.shapes.regions[1].shapes, portion.shapes.all);
    EXPECT_EQ(read.shapes.regions[0].volume, 0);
  }
  EXPECT_NEAR(small_portion(true).shapes.regions[1].volume, 1 + 1.0 / 6, 1e-12);
}

TEST(PortionFile, has_figures_and_digests_of_its_cells_and_their_numbers) {
  const Portion portion = small_portion(true);
  EXPECT_EQ(portion.shapes.all.tets, 1);
  EXPECT_EQ(portion.shapes.near_cuts.tets, 0);
  EXPECT_EQ(portion.shapes.away_from_cuts.tets, 1);
  MeshDigest digest;
  digest.add_tet(100, {10, 11, 12, 14});
  const std::array<std::int64_t, 8> hex = {10, 11, 13, 12, 14, 15, 17, 16};
  digest.add_other(ElementType::hex, 50, hex);
  const std::array<std::int64_t, 4> quad = {10, 12, 13, 11};
  digest.add_other(ElementType::quad, 6, quad);
  EXPECT_EQ(portion.tet_digest, digest.tets());
  EXPECT_EQ(portion.other_digest, digest.others());
}

/// The bytes with the number at `place` replaced, and the checksum made right again.
template <class T>
std::string forged(std::string bytes, std::size_t place, T value) {
  bytes.replace(place, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
  ByteWriter writer;
  writer.text(bytes.substr(0, bytes.size() - checksum_size));
  return finish_checked(std::move(writer));
}

TEST(PortionFile, says_what_is_wrong_though_the_checksum_is_right) {
  const std::string bytes = portion_to_bytes(small_portion(false));
  const auto said_of = [](const std::string& wrong) {
    return error_text_of<CorruptFile>([&] { portion_from_bytes(wrong, "p"); });
  };
  EXPECT_EQ(said_of(bytes), "");
  constexpr std::size_t faces = 12 + 2 * 4 + 3 * 8 + 8 * (24 + 8);
  EXPECT_EQ(said_of(forged(bytes, 8, std::uint32_t{1})), "p: has the format version 1, not 2");
  EXPECT_EQ(said_of(forged(bytes, 16, 0)), "p: has no valid region");
  EXPECT_EQ(said_of(forged(bytes, 16, (1 << 20) + 1)), "p: has no valid region");
  EXPECT_EQ(said_of(forged(bytes, 20, std::uint64_t{1} << 31U)), "p: has a count of 2147483648");
  EXPECT_EQ(said_of(forged(bytes, faces, 8)), "p: has an element with a node that does not exist");
  EXPECT_EQ(said_of(forged(bytes, faces + 8, -1)),
            "p: has an element with a node that does not exist");
  EXPECT_EQ(said_of(forged(bytes, faces + 8, 7)), "");
  EXPECT_EQ(said_of(forged(bytes + std::string(4, '\0'), 8, std::uint32_t{2})),
            "p: has 4 surplus bytes");
  EXPECT_EQ(said_of(portion_cells_to_bytes(small_portion(false))),
            "p: does not begin like the expected kind of file");
}

TEST(PortionFile, of_cells_says_what_is_wrong_though_the_checksum_is_right) {
  Portion portion = small_portion(true);
  const std::string bytes = portion_cells_to_bytes(portion);
  const auto said_of = [&](const std::string& wrong) {
    return error_text_of<CorruptFile>([&] { add_portion_cells(wrong, "c", portion); });
  };
  EXPECT_EQ(said_of(bytes), "");
  EXPECT_EQ(portion.part.blocks[ElementType::hex].regions, (std::vector<std::int32_t>{2}));
  EXPECT_EQ(said_of(forged(bytes, 8, std::uint32_t{1})), "c: has the format version 1, not 2");
  EXPECT_EQ(said_of(forged(bytes, 12, 4)), "c: belongs to another portion");
  EXPECT_EQ(said_of(forged(bytes, 16, std::uint64_t{2})), "c: belongs to another portion");
  EXPECT_EQ(said_of(forged(bytes, 24, 8)), "c: has an element with a node that does not exist");
  EXPECT_EQ(said_of(forged(bytes, 40 + 28, -1)),
            "c: has an element with a node that does not exist");
  EXPECT_EQ(said_of(forged(bytes + std::string(4, '\0'), 12, 3)), "c: has 4 surplus bytes");
  EXPECT_EQ(said_of(portion_cells_to_bytes(small_portion(false))),
            "c: has the format version 1, not 2");
}

TEST(PortionFile, of_cells_gives_back_their_marks) {
  Portion portion = small_portion(true);
  portion.part.marks[CellMark::layer] = {4, 7};
  const std::string bytes = portion_cells_to_bytes(portion);
  EXPECT_NE(bytes, portion_cells_to_bytes(small_portion(true)));
  Portion read = portion_from_bytes(portion_to_bytes(portion), "p");
  add_portion_cells(bytes, "c", read);
  EXPECT_EQ(read.part.marks, portion.part.marks);
  EXPECT_EQ(read.part.tets, portion.part.tets);
  const std::size_t count = bytes.size() - checksum_size - 8 - 2 * 4 - 8;
  EXPECT_EQ(error_text_of<CorruptFile>(
                [&] { add_portion_cells(forged(bytes, count, std::uint64_t{1}), "c", read); }),
            "c: has marks of some cells only");
}

TEST(PortionFile, of_cells_tells_each_mark_apart) {
  Portion portion = small_portion(true);
  portion.part.marks[CellMark::pml_depth] = {5, 6};
  Portion read = portion_from_bytes(portion_to_bytes(portion), "p");
  add_portion_cells(portion_cells_to_bytes(portion), "c", read);
  EXPECT_TRUE(read.part.marks[CellMark::layer].empty());
  EXPECT_EQ(read.part.marks[CellMark::pml_depth], (std::vector<std::int32_t>{5, 6}));
}

TEST(PortionFile, of_cells_with_axes_has_a_version_of_its_own) {
  Portion portion = small_portion(true);
  portion.part.marks[CellMark::pml_depth] = {5, 6};
  EXPECT_EQ(portion_cells_to_bytes(portion)[8], 3);
  portion.part.marks[CellMark::pml_axes] = {1, 7};
  const std::string bytes = portion_cells_to_bytes(portion);
  EXPECT_EQ(bytes[8], 4);
  Portion read = portion_from_bytes(portion_to_bytes(portion), "p");
  add_portion_cells(bytes, "c", read);
  EXPECT_EQ(read.part.marks, portion.part.marks);
}

TEST(PortionFile, of_cells_without_marks_are_without_them_also_behind_others_with) {
  Portion portion = small_portion(true);
  portion.part.marks[CellMark::layer] = {4, 7};
  add_portion_cells(portion_cells_to_bytes(small_portion(true)), "c", portion);
  EXPECT_TRUE(portion.part.marks.empty());
}

TEST(PortionFile, with_feet_of_its_nodes_has_a_version_of_its_own) {
  const TempFolder folder;
  for (const bool has_hex : {false, true}) {
    Portion portion = small_portion(has_hex);
    EXPECT_EQ(portion_to_bytes(portion)[8], has_hex ? 3 : 2);
    for (std::int32_t v = 0; v < 8; ++v) portion.part.feet.add(17 - v, v - 1);
    const std::string bytes = portion_to_bytes(portion);
    EXPECT_EQ(bytes[8], 4);
    const Portion read = portion_from_bytes(bytes, "p");
    EXPECT_EQ(read.part.feet, portion.part.feet);
    EXPECT_EQ(read.part.faces, portion.part.faces);
    EXPECT_EQ(read.others, portion.others);
    EXPECT_EQ(read.placed, portion.placed);
    const std::string path = folder.path() / "p";
    write_file_atomically(path, bytes);
    EXPECT_TRUE(portion_counts(path, "p").has_feet);
    EXPECT_EQ(portion_counts(path, "p").others, portion.others);
    EXPECT_EQ(error_text_of<CorruptFile>(
                  [&] { portion_from_bytes(forged(bytes, 20, std::uint64_t{1} << 40), "p"); }),
              "p: has a count of 1099511627776");
  }
}

TEST(PortionFile, tells_its_counts_by_its_first_bytes_alone) {
  const TempFolder folder;
  const std::string path = folder.path() / "p";
  const auto said_of = [&path](const std::string& bytes) {
    write_file_atomically(path, bytes);
    return error_text_of<CorruptFile>([&path] { portion_counts(path, "p"); });
  };
  const std::string bytes = portion_to_bytes(small_portion(true));
  EXPECT_EQ(said_of(bytes), "");
  const PortionCounts counts = portion_counts(path, "p");
  EXPECT_EQ(counts.nodes, 8);
  EXPECT_EQ(counts.tets, 1);
  EXPECT_EQ(counts.faces, 1);
  EXPECT_EQ(counts.others[ElementType::hex], 1);
  EXPECT_EQ(counts.others[ElementType::quad], 1);
  EXPECT_EQ(counts.others[ElementType::prism], 0);
  EXPECT_FALSE(counts.has_feet);
  EXPECT_EQ(said_of(bytes.substr(0, 19)), "p: does not begin like the expected kind of file");
  EXPECT_EQ(said_of("TFPTET\r\n" + bytes.substr(8)),
            "p: does not begin like the expected kind of file");
  EXPECT_EQ(said_of(bytes.substr(0, 43)), "p: is cut short");
  EXPECT_EQ(said_of(bytes.substr(0, 44 + 4 * 8 - 1)), "p: is cut short");
  EXPECT_EQ(said_of(bytes.substr(0, 44 + 4 * 8)), "");
}

}  // namespace
}  // namespace tetfarm
