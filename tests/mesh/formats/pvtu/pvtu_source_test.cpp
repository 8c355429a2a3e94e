#include "mesh/formats/pvtu/pvtu_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats/registry/export_mesh.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

std::string piece() {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format("pvtu", ""), folder.path() / "a.pvtu");
  return read_file(folder.path() / "a" / "a_0.vtu");
}

TEST(PvtuSource, a_piece_alone_is_a_mesh_of_one_part) {
  EXPECT_EQ(refusal_of("a.vtu", piece()), "");
}

TEST(PvtuSource, names_the_line_or_byte_of_what_is_wrong) {
  const std::string right = piece();
  EXPECT_THAT(refusal_of("a.vtu", changed(right, "\"Int64", "\"Int32")), HasSubstr("a.vtu:9: "));
  EXPECT_THAT(refusal_of("a.vtu", changed(right, "LittleEndian", "BigEndian")),
              HasSubstr("little-endian"));
  EXPECT_THAT(refusal_of("a.vtu", changed(right, "offset=\"0\"", "offset=\"1\"")),
              HasSubstr(": byte "));
  EXPECT_THAT(refusal_of("a.vtu", changed(right, "offset=\"0\"", "offset=\"99999999999\"")),
              HasSubstr("a.vtu:6: "));
  EXPECT_THAT(
      refusal_of("a.vtu", changed(right, "NumberOfPoints=\"", "NumberOfPoints=\"9999999999")),
      HasSubstr("larger than the file"));
}

}  // namespace
}  // namespace tetfarm
