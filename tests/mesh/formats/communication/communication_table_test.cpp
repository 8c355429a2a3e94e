#include "mesh/formats/communication/communication_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

std::vector<CommunicationTable> tables_of(const GridSource& grid) {
  const TempFolder folder;
  std::vector<CommunicationTable> tables;
  for_each_communication_table(grid, outline_of(grid), folder.path(),
                               [&](const CommunicationTable& table) { tables.push_back(table); });
  return tables;
}

std::vector<std::string> complaints_of(const std::vector<CommunicationTable>& tables) {
  return communication_complaints(static_cast<std::int32_t>(tables.size()), [&](std::int32_t i) {
    return tables.at(static_cast<std::size_t>(i));
  });
}

TEST(CommunicationTable, lists_are_all_shared_nodes_and_the_same_on_both_sides) {
  const GridSource grid(cut_grid(4));
  const auto tables = tables_of(grid);
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_THAT(complaints_of(tables), testing::IsEmpty());
  for (const CommunicationTable& table : tables) {
    const std::set<std::int64_t> mine(table.local2global.begin(), table.local2global.end());
    for (const NeighbourNodes& list : table.neighbours) {
      const auto& others = grid.parts.at(static_cast<std::size_t>(list.neighbour)).local2global;
      EXPECT_EQ(std::count_if(others.begin(), others.end(),
                              [&](std::int64_t node) { return mine.contains(node); }),
                std::ssize(list.local));
    }
  }
}

TEST(CommunicationTable, ghosts_are_all_tets_of_others_with_a_node_of_the_part) {
  const GridSource grid(cut_grid(4));
  for (const CommunicationTable& table : tables_of(grid)) {
    const std::set<std::int64_t> mine(table.local2global.begin(), table.local2global.end());
    std::vector<GhostCell> expected;
    for (const NumberedPart& part : grid.parts) {
      if (part.number == table.part) continue;
      for (std::size_t t = 0; t < part.tets.size(); ++t) {
        GhostCell ghost{part.number, static_cast<std::int32_t>(t), ElementType::tet, {}};
        bool is_near = false;
        for (std::size_t k = 0; k < 4; ++k) {
          ghost.nodes[k] = part.local2global[static_cast<std::size_t>(part.tets[t][k])];
          is_near = is_near || mine.contains(ghost.nodes[k]);
        }
        if (is_near) expected.push_back(ghost);
      }
    }
    EXPECT_EQ(table.ghosts, expected) << table.part;
  }
}

TEST(CommunicationTable, bytes_give_the_table_back_and_damage_is_refused) {
  const GridSource grid(cut_grid(4));
  for (const CommunicationTable& table : tables_of(grid)) {
    const std::string bytes = communication_to_bytes(table);
    EXPECT_EQ(communication_from_bytes(bytes, "a.comm"), table);
    EXPECT_THROW(communication_from_bytes(bytes.substr(0, bytes.size() - 1), "a.comm"),
                 CorruptFile);
    EXPECT_THROW(communication_from_bytes("x" + bytes, "a.comm"), CorruptFile);
  }
}

TEST(CommunicationTable, complains_of_each_kind_of_error) {
  const auto right = tables_of(GridSource(cut_grid(4)));
  auto tables = right;
  std::swap(tables[0].neighbours[0].local[0], tables[0].neighbours[0].local[1]);
  EXPECT_THAT(complaints_of(tables), testing::Not(testing::IsEmpty()));
  tables = right;
  const std::int32_t shared = tables[1].neighbours[0].local[0];
  tables[1].owner[static_cast<std::size_t>(shared)] = 2;
  EXPECT_THAT(complaints_of(tables),
              testing::Contains(testing::HasSubstr("a node with two owners")));
  tables = right;
  // All who have it agree, and are wrong.
  const std::int64_t node = tables[1].local2global[static_cast<std::size_t>(shared)];
  for (CommunicationTable& table : tables) {
    for (std::size_t v = 0; v < table.owner.size(); ++v) {
      if (table.local2global[v] == node) table.owner[v] = 2;
    }
  }
  EXPECT_THAT(complaints_of(tables), testing::Contains(testing::HasSubstr("not the lowest part")));
  EXPECT_THAT(complaints_of(tables),
              testing::Not(testing::Contains(testing::HasSubstr("a node with two owners"))));
  tables = right;
  for (CommunicationTable& table : tables) {
    std::erase_if(table.neighbours,
                  [&](const NeighbourNodes& list) { return list.neighbour + table.part == 3; });
  }
  EXPECT_THAT(complaints_of(tables), testing::Contains(testing::HasSubstr("not in all lists")));
}

TEST(CommunicationTable, files_of_both_forms_are_written) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  write_communication(grid, outline_of(grid), folder.path());
  write_communication_text(grid, outline_of(grid), folder.path());
  const auto tables = tables_of(grid);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = "part-" + std::to_string(i) + ".comm";
    EXPECT_EQ(communication_from_bytes(read_file(folder.path() / name), name), tables[i]);
    EXPECT_THAT(read_file(folder.path() / (name + ".txt")),
                testing::StartsWith("part " + std::to_string(i) + " of 3 nodes "));
  }
}

}  // namespace
}  // namespace tetfarm
