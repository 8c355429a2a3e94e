// The command that exports, called as main calls it.
#include <gtest/gtest.h>

#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

std::string said_of(const MeshSource& mesh) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "mesh.vtkhdf";
  export_mesh(mesh, find_mesh_format("", file), file);
  ExportCommand command;
  command.input = file.string();
  command.output = (folder.path() / "mesh.su2").string();
  ::testing::internal::CaptureStdout();
  const ExitCode code = export_command(command);
  const std::string said = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, ExitCode::ok);
  return said;
}

TEST(ExportCommand, names_the_types_of_elements_that_there_are) {
  const std::string tets = said_of(GridSource(cut_grid(2)));
  EXPECT_NE(tets.find("48 tets, 27 nodes, 48 boundary triangles"), std::string::npos) << tets;
  const std::string all = said_of(HybridGrid(3, 2));
  for (const char* type : {" tets, ", " pyramids, ", " prisms, ", " hexes, ", " boundary quads"}) {
    EXPECT_NE(all.find(type), std::string::npos) << type << " in " << all;
  }
}

}  // namespace
}  // namespace tetfarm
