// Parts as their modelling program wrote them, mended, remeshed and meshed.
#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;

/// Its long straight edges have nodes that want short edges beside their middle, and nowhere else.
TEST(RemeshedParts, have_no_flat_triangles_along_edges_that_are_long_where_others_are_short) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const std::string part = std::string(data) + "/broken/printer_einsy_base.stl";
  const TemporaryFolder folder;
  const Ended made = run_program(
      {"surface", part, "--heal", "--size", "18.6", "-o", "even.stl", "--json"}, folder.path());
  ASSERT_EQ(made.code, 0) << made.err;
  const nlohmann::json figures = test::result_of(made);
  EXPECT_GT(figures["triangles"], 50'000);
  EXPECT_GT(figures["smallest_angle_deg"], 0.01);
  const Ended ended = run_program(test::run_words("even.stl", "out", 2), folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(test::result_of(ended)["min_dihedral_deg"], 1);
}

}  // namespace
}  // namespace tetfarm
