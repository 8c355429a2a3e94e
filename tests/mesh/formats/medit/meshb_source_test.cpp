#include "mesh/formats/medit/meshb_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats/registry/export_mesh.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

std::string meshb() {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format("meshb", ""), folder.path() / "a.meshb");
  return read_file(folder.path() / "a.meshb");
}

/// With an 8-byte number at a place.
std::string with(std::string bytes, std::size_t place, std::int64_t number) {
  return bytes.replace(place, 8, reinterpret_cast<const char*>(&number), 8);
}

// The first list begins at byte 24: keyword, place of the next, count, then nodes of 32 bytes.
constexpr std::size_t first_list = 24;

TEST(MeshbSource, names_the_byte_of_what_is_wrong) {
  EXPECT_EQ(refusal_of("a.meshb", meshb()), "");
  EXPECT_THAT(refusal_of("a.meshb", with(meshb(), 0, 2)), HasSubstr("a.meshb: byte 0: "));
  EXPECT_THAT(refusal_of("a.meshb", with(meshb(), first_list + 4, 7)),
              HasSubstr("byte " + std::to_string(first_list + 4)));
}

TEST(MeshbSource, refuses_counts_that_the_file_cannot_hold_and_nodes_that_are_not_there) {
  for (const std::int64_t count : {std::int64_t{-1}, std::int64_t{1} << 40, INT64_MAX}) {
    EXPECT_THAT(refusal_of("a.meshb", with(meshb(), first_list + 12, count)),
                HasSubstr("a count of " + std::to_string(count)));
  }
  // Fewer nodes than tets have.
  EXPECT_THAT(refusal_of("a.meshb", with(meshb(), first_list + 12, 5)), HasSubstr(" of 5"));
}

}  // namespace
}  // namespace tetfarm
