#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/formats/communication/communication_table.h"
#include "tests/mesh/formats/wrong_bytes.h"

namespace tetfarm {
namespace {

/// Part 1 of 3 with two nodes, of which it shares one, and a ghost.
CommunicationTable small_table(bool is_of_tets_alone) {
  CommunicationTable table;
  table.part = 1;
  table.parts = 3;
  table.nodes_of_mesh = 9;
  table.is_of_tets_alone = is_of_tets_alone;
  table.cells[ElementType::tet] = 7;
  table.cells[ElementType::prism] = is_of_tets_alone ? 0 : 4;
  table.local2global = {5, 8};
  table.owner = {0, 1};
  table.neighbours = {{0, {0}, {6}}};
  GhostCell ghost{0, 2, ElementType::tet, {}};
  for (const std::size_t k : {0U, 1U, 2U, 3U}) ghost.nodes[k] = static_cast<std::int64_t>(5 - k);
  table.ghosts = {ghost};
  if (!is_of_tets_alone) {
    ghost.type = ElementType::pyramid;
    ghost.nodes[4] = 7;
    ghost.cell = 3;
    table.ghosts.push_back(ghost);
  }
  return table;
}

std::string l(std::int64_t value) { return raw_bytes(value); }

TEST(CommunicationFile, is_laid_out_as_documented) {
  EXPECT_EQ(communication_to_bytes(small_table(true)),
            std::string("TFCOMM1\0", 8) + l(1) + l(3) + l(9) + l(7) + l(2) + l(1) + l(1) + l(5) +
                l(8) + raw_bytes(0, 1) + l(0) + l(1) + raw_bytes(0) + raw_bytes(6) +
                raw_bytes(0, 2) + l(5) + l(4) + l(3) + l(2));
  EXPECT_EQ(communication_to_bytes(small_table(false)),
            std::string("TFCOMM2\0", 8) + l(1) + l(3) + l(9) + l(7) + l(0) + l(4) + l(0) + l(2) +
                l(1) + l(2) + l(5) + l(8) + raw_bytes(0, 1) + l(0) + l(1) + raw_bytes(0) +
                raw_bytes(6) + raw_bytes(0, 2, 10) + l(5) + l(4) + l(3) + l(2) +
                raw_bytes(0, 3, 14) + l(5) + l(4) + l(3) + l(2) + l(7));
}

TEST(CommunicationFile, as_text_has_a_line_for_each_thing) {
  EXPECT_EQ(
      communication_to_text(small_table(true)),
      "part 1 of 3 nodes 2 of 9 tets 7\nnode 0 5 0\nnode 1 8 1\nneighbour 0 1\n0 6\nghosts 1\n"
      "0 2 5 4 3 2\n");
  EXPECT_EQ(communication_to_text(small_table(false)),
            "part 1 of 3 nodes 2 of 9 tets 7 pyramids 0 prisms 4 hexes 0\nnode 0 5 0\nnode 1 8 1\n"
            "neighbour 0 1\n0 6\nghosts 2\n0 2 tet 5 4 3 2\n0 3 pyramid 5 4 3 2 7\n");
}

TEST(CommunicationFile, gives_back_what_was_written_and_refuses_what_is_wrong) {
  for (const bool is_of_tets_alone : {true, false}) {
    const CommunicationTable table = small_table(is_of_tets_alone);
    EXPECT_EQ(communication_from_bytes(communication_to_bytes(table), "a.comm"), table);
  }
  const auto refusal = [](const std::string& name, const std::string& bytes) -> std::string {
    try {
      communication_from_bytes(bytes, name);
    } catch (const CorruptFile& error) {
      return error.what();
    }
    return "";
  };
  const std::string right = communication_to_bytes(small_table(false));
  constexpr std::size_t neighbour = 8 + 10 * 8 + 2 * 8 + 2 * 4;
  constexpr std::size_t ghost = neighbour + 16 + 8;
  const std::string range =
      refusal("a.comm", std::string(right).replace(neighbour + 16, 4, raw_bytes(2)));
  EXPECT_NE(range.find("has a node out of range"), range.npos) << range;
  const std::string negative =
      refusal("a.comm", std::string(right).replace(neighbour + 16, 4, raw_bytes(-1)));
  EXPECT_NE(negative.find("has a node out of range"), negative.npos) << negative;
  for (const std::int32_t type : {1, 5, 9}) {
    const std::string unknown =
        refusal("a.comm", std::string(right).replace(ghost + 8, 4, raw_bytes(type)));
    EXPECT_NE(unknown.find("has a ghost of an unknown type"), unknown.npos) << type;
  }
  const std::string other = refusal("a.comm", "TFCOMM3" + right.substr(7));
  EXPECT_NE(other.find("is not a communication table"), other.npos) << other;
  EXPECT_NE(refusal("a.comm", right + "x"), "");
  EXPECT_NE(refusal("a.comm", right.substr(0, right.size() - 1)), "");
}

}  // namespace
}  // namespace tetfarm
