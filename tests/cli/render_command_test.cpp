// The command that draws, called as main calls it.
#include <gtest/gtest.h>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

/// The pixels of a mesh of three parts, the last a region of its own, drawn apart.
std::string drawn_apart(const std::string& file, double explosion) {
  const TempFolder folder;
  GridSource grid(cut_grid(3));
  for (NumberedPart& part : grid.parts) part.region = 1;
  grid.parts.back().region = 2;
  const std::filesystem::path mesh = folder.path() / file;
  export_mesh(grid, find_mesh_format("", mesh), mesh);
  RenderCommand command;
  command.input = mesh.string();
  command.output = (folder.path() / "picture.png").string();
  command.view = "exploded";
  command.explode = explosion;
  command.size = "120x80";
  EXPECT_EQ(render_command(command), ExitCode::ok);
  return read_file(command.output);
}

TEST(RenderCommand, moves_sub_domains_apart_and_leaves_together_what_is_none) {
  EXPECT_NE(drawn_apart("mesh.vtkhdf", 2), drawn_apart("mesh.vtkhdf", 0));
  // Of this format are the regions known, and no sub-domains.
  EXPECT_EQ(drawn_apart("mesh.meshb", 2), drawn_apart("mesh.meshb", 0));
}

}  // namespace
}  // namespace tetfarm
