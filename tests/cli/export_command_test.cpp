// The command that exports, called as main calls it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

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

/// A grid of tets in three sub-domains, and what is written of it.
class Exported : public ::testing::Test {
 protected:
  Exported() {
    const GridSource grid(cut_grid(2));
    export_mesh(grid, find_mesh_format("vtkhdf", command_.input), command_.input);
  }
  ExportCommand to(const std::string& name) const {
    ExportCommand command = command_;
    command.output = (folder_.path() / "new" / name).string();
    return command;
  }
  static Said exported(const ExportCommand& command) {
    return said_by([&] { return export_command(command); });
  }

  const TempFolder folder_;
  ExportCommand command_ = [this] {
    ExportCommand command;
    command.input = (folder_.path() / "mesh.vtkhdf").string();
    return command;
  }();
};

TEST_F(Exported, is_told_with_file_format_and_counts) {
  const ExportCommand command = to("mesh.su2");
  EXPECT_EQ(exported(command).out,
            command.output + ": SU2; 48 tets, 27 nodes, 48 boundary triangles\n");
}

TEST_F(Exported, is_told_to_programs) {
  ExportCommand command = to("mesh.su2");
  command.json = true;
  EXPECT_EQ(json::parse(exported(command).out), json({{"type", "export"},
                                                      {"file", command.output},
                                                      {"format", "su2"},
                                                      {"nodes", 27},
                                                      {"elements", 48},
                                                      {"boundary_triangles", 48},
                                                      {"subdomains", 3}}));
}

TEST_F(Exported, in_parts_is_told_with_their_sizes) {
  ExportCommand command = to("mesh.cgns");
  command.partitions = 2;
  command.numbering = "rcm";
  const std::string out = exported(command).out;
  EXPECT_THAT(out, HasSubstr("\n2 parts: largest/mean 1."));
  EXPECT_THAT(out,
              HasSubstr(" faces between them\nnode numbers of neighbours in a part differ by "));
  command.json = true;
  const json told = json::parse(exported(command).out);
  EXPECT_EQ(told["subdomains"], 2);
  ASSERT_EQ(told["partitions"]["elements"].size(), 2U);
  EXPECT_EQ(
      told["partitions"]["elements"][0].get<int>() + told["partitions"]["elements"][1].get<int>(),
      48);
  EXPECT_GT(told["partitions"]["cut_faces"], 0);
  EXPECT_EQ(told["numbering"]["order"], "rcm");
  for (const char* when : {"before", "after"}) {
    EXPECT_GE(told["numbering"][when]["bandwidth"].get<double>(),
              told["numbering"][when]["mean_difference"].get<double>());
  }
  EXPECT_THAT(out, HasSubstr(" on average, " +
                             std::to_string(told["numbering"]["after"]["bandwidth"].get<int>()) +
                             " at most (before: "));
  EXPECT_THAT(
      out, ::testing::EndsWith(
               ", " + std::to_string(told["numbering"]["before"]["bandwidth"].get<int>()) + ")\n"));
}

TEST_F(Exported, numbers_follow_one_another_more_closely_by_cuthill_and_mckee) {
  ExportCommand command = to("mesh.su2");
  command.json = true;
  command.numbering = "rcm";
  const json rcm = json::parse(exported(command).out)["numbering"];
  command.numbering = "hilbert";
  const json hilbert = json::parse(exported(command).out)["numbering"];
  EXPECT_EQ(hilbert["order"], "hilbert");
  EXPECT_NE(hilbert["after"], rcm["after"]);
  EXPECT_EQ(hilbert["before"], rcm["before"]);
  EXPECT_LE(rcm["after"]["bandwidth"], rcm["before"]["bandwidth"]);
}

TEST_F(Exported, in_parts_is_refused_where_a_file_has_none) {
  ExportCommand command = to("mesh.su2");
  command.partitions = 2;
  const Said said = exported(command);
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.error,
            "--partitions 2: a file of format su2 cannot say which part an element is in");
  EXPECT_THAT(said.help, ::testing::StartsWith("leave it out if the solver partitions the mesh "
                                               "itself; formats that can: vtkhdf, "));
  EXPECT_THAT(said.help, ::testing::Not(HasSubstr("su2")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "new"));
}

TEST(ExportCommand, to_a_folder_is_refused_before_the_mesh_is_looked_for) {
  const TempFolder folder;
  ExportCommand command;
  command.input = "no_such_mesh.vtkhdf";
  command.output = folder.path().string();
  command.format = "su2";
  const Said said = said_by([&] { return export_command(command); });
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.error, command.output + ": this is a folder; su2 needs the name of a file");
}

TEST(ConvertCommand, tells_what_the_surface_is) {
  const TempFolder folder;
  const std::string in = (folder.path() / "tet.off").string();
  write_file_atomically(
      in, "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  ConvertCommand command;
  command.input = in;
  command.output = (folder.path() / "tet.stl").string();
  EXPECT_EQ(said_by([&] { return convert_command(command); }).out,
            command.output + ": 4 triangles, 4 vertices, 1 patch\n");
  EXPECT_EQ(read_surface(command.output).triangles.size(), 4U);
  command.json = true;
  const json told = json::parse(said_by([&] { return convert_command(command); }).out);
  EXPECT_EQ(told, json({{"type", "convert"},
                        {"file", command.output},
                        {"vertices", 4},
                        {"triangles", 4},
                        {"patches", read_surface(in).patch_names}}));
}

TEST(ConvertCommand, scales_then_refines_then_puts_a_box_round) {
  const TempFolder folder;
  ConvertCommand command;
  command.input = (folder.path() / "tet.off").string();
  command.output = (folder.path() / "tet.stl").string();
  write_file_atomically(
      command.input,
      "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  command.scale = 2;
  command.max_edge = 2.5;  // halves the three edges of 2.83
  command.box = 1;
  command.box_size = 2;
  EXPECT_EQ(said_by([&] { return convert_command(command); }).code, ExitCode::ok);
  const SurfaceMesh surface = read_surface(command.output);
  EXPECT_EQ(surface.triangles.size(), 3 * 2 + 4 + 12 * 4U);
  EXPECT_EQ(surface.patch_names.back(), "outer");
  EXPECT_EQ(bounding_box(surface.vertices).high, (Vec3{3, 3, 3}));
}

TEST(ShapeCommand, tells_what_it_wrote) {
  const TempFolder folder;
  const ShapeCommand command{"duct", (folder.path() / "duct.off").string(), 0.5, 0.2};
  const Said said = said_by([&] { return shape_command(command); });
  const SurfaceMesh surface = read_surface(command.output);
  EXPECT_EQ(said.err, command.output + ": " + std::to_string(surface.triangles.size()) +
                          " triangles, " + std::to_string(surface.vertices.size()) + " vertices\n");
  ShapeCommand finer = command;
  finer.spacing = 0.25;
  said_by([&] { return shape_command(finer); });
  EXPECT_GT(read_surface(finer.output).triangles.size(), surface.triangles.size());
}

TEST_F(Exported, has_the_types_of_patches_that_are_typed_and_else_those_of_its_file) {
  ExportCommand command = to("a.vtkhdf");
  command.patch_types = {"low*=symmetry", "elsewhere=farfield"};
  EXPECT_EQ(exported(command).code, ExitCode::ok);
  ExportCommand again = to("b.b8.ugrid");
  again.input = command.output;
  again.patch_types = {"elsewhere=wall"};
  EXPECT_EQ(exported(again).code, ExitCode::ok);
  EXPECT_EQ(read_file(folder_.path() / "new/b.mapbc"), "2\n1 6661 low x\n2 4000 elsewhere\n");
}

TEST_F(Exported, refuses_the_type_of_a_patch_that_the_mesh_has_not) {
  ExportCommand command = to("a.vtkhdf");
  command.patch_types = {"low_y=symmetry"};
  EXPECT_THAT(exported(command).error,
              HasSubstr("--patch-type 'low_y=symmetry': \"low_y\" matches none of the patches "
                        "\"low x\", \"elsewhere\"; did you mean \"low x\"?"));
  EXPECT_FALSE(std::filesystem::exists(command.output));
}

}  // namespace
}  // namespace tetfarm
