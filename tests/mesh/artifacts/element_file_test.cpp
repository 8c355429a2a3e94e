#include "mesh/artifacts/element_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "base/hash.h"
#include "mesh/artifacts/byte_stream.h"
#include "mesh/artifacts/checked_bytes.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

/// One tet of the sub-domain in the middle of its sharers.
ElementSection one_tet(Sharers sharers, double x) {
  ElementSection section;
  section.sharers = std::move(sharers);
  section.nodes = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  section.node_origin = {{0, 4}, {1, 0}, {2, 7}, {2, 9}};
  section.tets = {{0, 1, 2, 3}};
  section.tet_owner = {static_cast<std::uint8_t>(section.sharers.size() / 2)};
  section.triangles = {{0, 2, 1}};
  section.triangle_index = {31};
  section.triangle_owner = section.tet_owner;
  return section;
}

class ElementFiles : public ::testing::Test {
 protected:
  std::string bytes_ = elements_to_bytes({{5}, 12, {{1, 3}, {5, 2}}, {}}, {one_tet({4, 5, 6}, 2)},
                                         CoreElements{7, {0, 3}, {31}, 5});
  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "elements";

  ElementFile open(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return ElementFile(path_, "elements");
  }
};

TEST_F(ElementFiles, give_back_head_and_sections) {
  ElementFile file = open(bytes_);
  EXPECT_EQ(file.head().path.heap, 5U);
  EXPECT_EQ(file.head().next_node, 12U);
  EXPECT_THAT(file.head().gone, ElementsAre(Origin{1, 3}, Origin{5, 2}));
  ASSERT_EQ(file.head().sections.size(), 2U);
  EXPECT_THAT(file.head().sections[1].tets, ElementsAre(0, 1, 0));
  EXPECT_EQ(file.head().find({4, 5, 6}), 1U);
  EXPECT_EQ(file.head().find({4, 5}), std::nullopt);
  const ElementSection section = file.read(1);
  const ElementSection wanted = one_tet({4, 5, 6}, 2);
  EXPECT_EQ(section.sharers, wanted.sharers);
  EXPECT_EQ(section.nodes, wanted.nodes);
  EXPECT_EQ(section.node_origin, wanted.node_origin);
  EXPECT_EQ(section.tets, wanted.tets);
  EXPECT_EQ(section.tet_owner, wanted.tet_owner);
  EXPECT_EQ(section.triangles, wanted.triangles);
  EXPECT_EQ(section.triangle_index, wanted.triangle_index);
}

TEST_F(ElementFiles, one_section_is_read_without_the_others) {
  ElementFile file = open(bytes_);
  const std::uint64_t head = file.bytes_read();
  file.read(1);
  EXPECT_EQ(file.bytes_read(), head + file.head().sections[1].size);
  EXPECT_LT(file.bytes_read(), bytes_.size());
}

TEST_F(ElementFiles, damage_of_one_section_does_not_hurt_the_other) {
  std::string damaged = bytes_;
  damaged.back() ^= 1;
  ElementFile file = open(damaged);
  EXPECT_NO_THROW(file.read_core());
  EXPECT_THROW(file.read(1), CorruptFile);
}

TEST_F(ElementFiles, tell_the_core_by_what_was_taken_out_of_the_mesh) {
  ElementFile file = open(bytes_);
  EXPECT_THAT(file.head().sections[0].sharers, ElementsAre(5));
  EXPECT_THAT(file.head().sections[0].tets, ElementsAre(7));
  const CoreElements core = file.read_core();
  EXPECT_EQ(core.tets, 7U);
  EXPECT_EQ(core.triangles, 5U);
  EXPECT_THAT(core.taken_tets, ElementsAre(0, 3));
  EXPECT_THAT(core.taken_triangles, ElementsAre(31));
  EXPECT_THROW(open(elements_to_bytes({{5}, 12, {}, {}}, {one_tet({4, 5, 6}, 2)})).read_core(),
               CorruptFile);
  EXPECT_THROW(
      open(elements_to_bytes({{5}, 12, {}, {}}, {}, CoreElements{7, {3, 0}, {}})).read_core(),
      CorruptFile);
}

TEST_F(ElementFiles, a_core_that_names_what_was_taken_twice_is_refused) {
  EXPECT_THROW(
      open(elements_to_bytes({{5}, 12, {}, {}}, {}, CoreElements{7, {0, 3, 3}, {}})).read_core(),
      CorruptFile);
  EXPECT_THROW(
      open(elements_to_bytes({{5}, 12, {}, {}}, {}, CoreElements{7, {}, {4, 4}, 9})).read_core(),
      CorruptFile);
}

TEST_F(ElementFiles, a_section_that_would_end_beyond_all_numbers_is_cut_short) {
  constexpr std::size_t head_begins = 8 + 4 + 8 + checksum_size;
  const std::size_t head_ends = open(bytes_).head().sections[0].offset;
  // The size of the last section stands before its checksum, which ends the head.
  std::string head = bytes_.substr(head_begins, head_ends - head_begins);
  ByteWriter size;
  size.number(std::uint64_t{0} - head_ends);  // ends at 0 again
  head.replace(head.size() - checksum_size - 8, 8, size.bytes());
  ByteWriter checksum;
  checksum.hash(hash128(head));
  std::string damaged = bytes_;
  damaged.replace(head_begins, head.size(), head);
  damaged.replace(head_begins - checksum_size, checksum_size, checksum.bytes());
  ElementFile file = open(damaged);
  EXPECT_NO_THROW(file.read_core());
  EXPECT_THROW(file.read(1), CorruptFile);
}

TEST_F(ElementFiles, every_byte_that_is_wrong_is_noticed) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    std::string damaged = bytes_;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    EXPECT_THROW(
        {
          ElementFile file = open(damaged);
          file.read_core();
          file.read(1);
        },
        CorruptFile)
        << i;
  }
}

TEST_F(ElementFiles, cut_short_anywhere_is_noticed) {
  for (std::size_t size = 0; size < bytes_.size(); size += 3) {
    EXPECT_THROW(
        {
          ElementFile file = open(bytes_.substr(0, size));
          file.read_core();
          file.read(1);
        },
        CorruptFile)
        << size;
  }
}

TEST_F(ElementFiles, a_missing_file_is_an_error_of_the_world) {
  EXPECT_THROW(ElementFile(folder_.path() / "none", "none"), IoError);
}

TEST(SharedNodesFile, gives_back_what_was_written_and_notices_damage) {
  SharedNodes shared;
  shared.path = {9};
  shared.sets = {{8, 9}, {4, 8, 9}};
  shared.nodes = {{{0, 3}, 1}, {{4, 0}, 0}};
  const std::string bytes = shared_nodes_to_bytes(shared);
  const SharedNodes again = shared_nodes_from_bytes(bytes, "s");
  EXPECT_EQ(again.path, shared.path);
  EXPECT_EQ(again.sets, shared.sets);
  ASSERT_EQ(again.nodes.size(), 2U);
  EXPECT_EQ(again.nodes[0].origin, (Origin{0, 3}));
  EXPECT_EQ(again.nodes[0].set, 1U);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_THROW(shared_nodes_from_bytes(damaged, "s"), CorruptFile) << i;
    EXPECT_THROW(shared_nodes_from_bytes(bytes.substr(0, i), "s"), CorruptFile) << i;
  }
}

TEST(SharedNodesFile, refuses_a_node_of_a_set_that_is_not_there) {
  SharedNodes shared;
  shared.path = {9};
  shared.sets = {{8, 9}, {4, 8, 9}};
  shared.nodes = {{{0, 3}, 2}};
  EXPECT_THROW(shared_nodes_from_bytes(shared_nodes_to_bytes(shared), "s"), CorruptFile);
}

}  // namespace
}  // namespace tetfarm
