#include "mesh/formats/input_file.h"

#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/coordinate_text.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/mesh_text.h"
#include "mesh/formats/node_records.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

std::string read_at(const InputFile& file, std::int64_t place, std::size_t bytes) {
  std::string read(bytes, '?');
  try {
    file.read(place, read.data(), bytes);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return read;
}

TEST(InputFile, reads_what_is_there_of_a_file_and_of_bytes_and_no_more) {
  const TempFolder folder;
  const std::string path = folder.path() / "a";
  write_file_atomically(path, "tetfarm");
  const InputFile from_disk(path);
  const InputFile from_bytes("tetfarm", path);
  for (const InputFile* file : {&from_disk, &from_bytes}) {
    EXPECT_EQ(file->size(), 7);
    EXPECT_EQ(file->name(), path);
    EXPECT_EQ(read_at(*file, 0, 7), "tetfarm");
    EXPECT_EQ(read_at(*file, 3, 4), "farm");
    EXPECT_EQ(read_at(*file, 7, 0), "");
    EXPECT_EQ(file->at<char>(6), 'm');
    const std::string ends = path + ": byte 7: the file ends too early";
    EXPECT_EQ(read_at(*file, 4, 4), ends);
    EXPECT_EQ(read_at(*file, 8, 0), ends);
    EXPECT_EQ(read_at(*file, -1, 1), ends);
  }
  EXPECT_THROW(InputFile(folder.path() / "none"), IoError);
}

TEST(TurnBytes, turns_each_number_round) {
  std::array<std::int64_t, 2> large = {1, 2};
  turn_bytes(std::span<std::int64_t>(large));
  EXPECT_EQ(large, (std::array<std::int64_t, 2>{std::int64_t{1} << 56U, std::int64_t{2} << 56U}));
  std::array<std::int32_t, 2> small = {1, 2};
  turn_bytes(std::span<std::int32_t>(small));
  EXPECT_EQ(small, (std::array<std::int32_t, 2>{1 << 24, 2 << 24}));
}

TEST(CountLimit, is_the_last_number_of_32_bits_with_a_sign) {
  require_32_bits(2147483647, "nodes", "Gmsh 2.2", "use msh41");
  try {
    require_32_bits(2147483648, "nodes", "Gmsh 2.2", "use msh41");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "the mesh is too large for Gmsh 2.2, whose counts end at 2147483647: 2147483648 "
                 "nodes; use msh41");
    EXPECT_EQ(error.code(), ExitCode::failed);
  }
}

TEST(CoordinateText, has_as_few_digits_as_tell_the_number) {
  std::string text = "v ";
  append_coordinates(text, {0.1, -2, 1e-300});
  append_coordinates(text, {1.0 / 3, 12345678, 0});
  EXPECT_EQ(text, "v 0.1 -2 1e-300\n0.3333333333333333 12345678 0\n");
}

TEST(MeshText, is_the_file_also_behind_what_was_let_go) {
  const TempFolder folder;
  std::string lines = "# first\n";
  constexpr int count = 2 * 65536 + 10;
  for (int i = 0; i < count; ++i) lines += std::to_string(i) + "\n";
  write_file_atomically(folder.path() / "a", lines);
  MeshText text(folder.path() / "a", '#');
  EXPECT_EQ(text.name(), (folder.path() / "a").string());
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(text.scanner().integer("a number"), i);
    text.pass();
  }
  try {
    text.scanner().expect("more");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.what(), (folder.path() / "a").string() + ":" + std::to_string(count + 2) +
                                ": expected more, found nothing");
  }
}

TEST(MeshText, of_an_empty_file_is_empty_and_of_none_is_an_error) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a", "");
  EXPECT_TRUE(MeshText(folder.path() / "a").scanner().at_end());
  EXPECT_THROW(MeshText(folder.path() / "none"), IoError);
  EXPECT_THROW(MeshText(folder.path()), IoError);
}

TEST(NodeRecords, lie_where_the_numbers_of_the_nodes_say) {
  const TempFolder folder;
  NumberedPart part;
  part.nodes = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  part.local2global = {2, 3, 0};
  OutputFile file(folder.path() / "a");
  const NumberText style = NumberText::text(9);
  write_node_records(file, 4, 3, part, style,
                     [](NumberText& text, std::int64_t node, const Vec3& p) {
                       text.words(std::to_string(node) + std::to_string(static_cast<int>(p.x)));
                       text.end_record();
                     });
  file.finish();
  EXPECT_EQ(read_file(folder.path() / "a"), std::string("\0\0\0\0"
                                                        "03\n\0\0\0"
                                                        "21\n32\n",
                                                        16));
}

TEST(NodeRecords, list_the_faces_of_each_patch_in_their_order) {
  NumberedPart part;
  part.faces.resize(5);
  part.patch_of_face = {2, 0, 2, 2, 0};
  const std::vector<std::vector<std::size_t>> expected = {{1, 4}, {}, {0, 2, 3}, {}};
  EXPECT_EQ(faces_by_patch(part, 4), expected);
  ElementBlock block;
  block.patches = part.patch_of_face;
  EXPECT_EQ(faces_by_patch(block, 4), expected);
}

}  // namespace
}  // namespace tetfarm
