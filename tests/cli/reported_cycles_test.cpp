// The page about an adaptation loop, written as main does it, from folders such as loops leave.
#include "cli/reported_cycles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A square with a square hole: patch 1 outside, 2 inside.
constexpr const char* mesh = R"(MeshVersionFormatted 2
Dimension 2
Vertices 8
0 0 0
3 0 0
3 3 0
0 3 0
1 1 0
2 1 0
2 2 0
1 2 0
Triangles 8
1 2 5 1
2 6 5 1
2 3 6 1
3 7 6 1
3 4 7 1
4 8 7 1
4 1 8 1
1 5 8 1
Edges 8
1 2 1
2 3 1
3 4 1
4 1 1
5 6 2
6 7 2
7 8 2
8 5 2
End
)";

class ReportedCycles : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    write_file_atomically((folder_.path() / name).string(), text);
  }
  void write_cycles(int count) const {
    std::string table = "cycle,vertices,unit_edges_percent\n";
    for (int i = 1; i <= count; ++i) {
      const std::string stem = (i < 10 ? "cycle_0" : "cycle_") + std::to_string(i);
      write(stem + ".mesh", mesh);
      write(stem + ".sol",
            "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n8\n1 1\n0 1 2 3 4 5 6 " +
                std::to_string(i) + "\nEnd\n");
      write(stem + ".log", "begins\nstep " + std::to_string(i) + " of <b>\n\n");
      table += std::to_string(i) + ",8,\n";
    }
    write("cycles.csv", table);
  }
  CyclesContent content() const { return reported_cycles(folder_.path(), 160); }

  const TempFolder folder_;
};

TEST_F(ReportedCycles, are_drawn_with_their_counts_and_what_the_solver_said_last) {
  write_cycles(2);
  ASSERT_TRUE(is_loop_folder(folder_.path()));
  const CyclesContent of_two = content();
  EXPECT_EQ(of_two.cycles, 2);
  ASSERT_EQ(of_two.shown.size(), 2U);
  EXPECT_EQ(of_two.shown[1].mesh.caption, "Cycle 2: 8 vertices, 8 triangles");
  EXPECT_EQ(of_two.shown[1].last_words, "step 2 of <b>");
  EXPECT_EQ(of_two.shown[0].mesh.png, of_two.shown[1].mesh.png) << "the same part of the plane";
  EXPECT_NE(of_two.shown[0].solution.png, of_two.shown[1].solution.png);
  EXPECT_THAT(of_two.head, ElementsAre("cycle", "vertices", "unit edges percent"));
  EXPECT_THAT(of_two.rows, ElementsAre(ElementsAre("1", "8", ""), ElementsAre("2", "8", "")));
}

TEST_F(ReportedCycles, have_the_first_field_along_what_is_not_the_outer_boundary) {
  write_cycles(1);
  const std::string chart = content().chart;
  EXPECT_THAT(chart, HasSubstr("cycle 1"));
  EXPECT_THAT(chart, HasSubstr("first field"));
  std::string open = mesh;
  open.resize(open.find("Edges 8"));
  write("cycle_01.mesh", open + "End\n");
  EXPECT_THAT(content().chart, IsEmpty());
}

TEST_F(ReportedCycles, of_many_are_the_first_the_last_and_some_between) {
  write_cycles(23);
  const CyclesContent of_many = content();
  EXPECT_EQ(of_many.cycles, 23);
  ASSERT_EQ(of_many.shown.size(), most_shown_cycles);
  EXPECT_EQ(of_many.shown.front().number, 1);
  EXPECT_EQ(of_many.shown.back().number, 23);
}

TEST_F(ReportedCycles, that_are_damaged_are_named_with_file_and_line) {
  const auto trouble = [this] {
    try {
      content();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  write_cycles(2);
  write("cycles.csv", "cycle,vertices\n1,8\n2\n");
  EXPECT_THAT(trouble(), HasSubstr("cycles.csv:3: has 1 cells where the head has 2"));
  write_cycles(2);
  write("cycle_02.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n1\n1 1\n0\nEnd\n");
  EXPECT_THAT(trouble(), HasSubstr("cycle_02.sol: gives values at 1 nodes; the mesh has 8"));
  std::filesystem::remove(folder_.path() / "cycle_02.sol");
  EXPECT_THAT(trouble(), HasSubstr("cycle_02.sol"));
}

TEST_F(ReportedCycles, make_the_page_of_a_folder) {
  write_cycles(2);
  ReportCommand command;
  command.view.client.job = folder_.path().string();
  command.output = (folder_.path() / "loop.html").string();
  const Said said = said_by([&] { return report_command(command); });
  EXPECT_EQ(said.error, "");
  EXPECT_EQ(said.err, command.output + ": 2 cycles\n");
  const std::string page = read_file(command.output);
  EXPECT_THAT(page, HasSubstr("<figcaption>Cycle 2: 8 vertices, 8 triangles</figcaption>"));
  EXPECT_THAT(page, HasSubstr("step 2 of &lt;b&gt;"));
}

TEST_F(ReportedCycles, are_not_looked_for_where_there_is_no_loop) {
  EXPECT_FALSE(is_loop_folder(folder_.path()));
  write("cycles.csv", "cycle\n");
  EXPECT_FALSE(is_loop_folder(folder_.path()));
  EXPECT_FALSE(is_loop_folder(folder_.path() / "none"));
}

}  // namespace
}  // namespace tetfarm
