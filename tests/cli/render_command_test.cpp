// The command that draws, called as main calls it.
#include <gtest/gtest.h>

#include <functional>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"
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

RenderCommand of_small_grid(const TempFolder& folder) {
  const std::filesystem::path mesh = folder.path() / "mesh.vtkhdf";
  export_mesh(GridSource(cut_grid(2)), find_mesh_format("", mesh), mesh);
  RenderCommand command;
  command.input = mesh.string();
  command.output = (folder.path() / "picture.png").string();
  return command;
}

TEST(RenderCommand, looks_at_a_slice_at_right_angles_and_from_where_it_is_told_to) {
  const TempFolder folder;
  RenderCommand command = of_small_grid(folder);
  command.view = "slice";
  command.size = "120x80";
  const auto drawn = [&] {
    EXPECT_EQ(render_command(command), ExitCode::ok);
    return read_file(command.output);
  };
  const std::string by_itself = drawn();
  command.from = {0, -1, 0};
  EXPECT_EQ(drawn(), by_itself);
  command.from = {-1, -2, 1};
  EXPECT_NE(drawn(), by_itself);
}

std::string trouble_with(const RenderCommand& command) {
  const Said said = said_by([&] { return render_command(command); });
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.help, "");
  return said.error;
}

TEST(RenderCommand, refuses_to_colour_layers_where_there_are_none) {
  const TempFolder folder;
  RenderCommand command = of_small_grid(folder);
  command.colour = "layer";
  EXPECT_EQ(trouble_with(command),
            "--colour layer: layers have colours in cuts and slices; give --view cut or --view "
            "slice");
  command.view = "cut";
  EXPECT_EQ(trouble_with(command),
            "--colour layer: the mesh has no layers, or its file does not tell; the .vtkhdf file "
            "that a run writes does");
}

TEST(RenderCommand, refuses_what_is_no_picture_before_it_looks_for_the_mesh) {
  RenderCommand command;
  command.input = "nowhere.vtkhdf";
  command.output = "p.jpg";
  EXPECT_EQ(trouble_with(command),
            "p.jpg: render writes only PNG pictures; give a name that ends in .png");
  command.output = "p.PNG";
  for (const char* size : {"", "x", "80", "80x", "x60", "0x60", "80x0", "16385x60", "80x16385",
                           "80x60x2", "80*60", "-80x60", "8.5x60"}) {
    command.size = size;
    EXPECT_EQ(trouble_with(command),
              "--size: \"" + std::string(size) + "\" is not WIDTHxHEIGHT, each from 1 to 16384");
  }
  command.size = "16384x1";
  command.from = {0, 0, 0};
  EXPECT_EQ(trouble_with(command), "--from: must not be 0, 0, 0");
  command.from = {1, 0, 0};
  command.up = {0, 0, 0};
  EXPECT_EQ(trouble_with(command), "--up: must not be 0, 0, 0");
  command.up = {0, 0, 1};
  command.plane = {0, 0, 0};
  EXPECT_EQ(trouble_with(command), "--plane: must not be 0, 0, 0");
  command.plane = {0, 0, 1};
  const Said said = said_by([&] { return render_command(command); });
  EXPECT_EQ(said.error, "nowhere.vtkhdf: no such file");
}

/// A mesh to draw again and again.
class Drawn : public ::testing::Test {
 protected:
  Drawn() {
    GridSource grid(cut_grid(3));
    for (NumberedPart& part : grid.parts) part.region = 1;
    grid.parts.back().region = 2;
    command_.input = (folder_.path() / "mesh.vtkhdf").string();
    command_.output = (folder_.path() / "picture.png").string();
    command_.size = "60x40";
    export_mesh(grid, find_mesh_format("", command_.input), command_.input);
  }
  std::string drawn(const std::function<void(RenderCommand&)>& change = {}) const {
    RenderCommand command = command_;
    if (change) change(command);
    EXPECT_EQ(render_command(command), ExitCode::ok);
    return read_file(command.output);
  }

  const TempFolder folder_;
  RenderCommand command_;
};

TEST_F(Drawn, is_as_large_as_asked_for) {
  const std::string png = drawn();
  const auto number = [&png](std::size_t at) {
    return static_cast<unsigned char>(png.at(at + 2)) * 256 +
           static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(number(16), 60);
  EXPECT_EQ(number(20), 40);
}

TEST_F(Drawn, looks_otherwise_with_each_option) {
  const std::string plain = drawn();
  EXPECT_EQ(drawn(), plain);
  const std::vector<std::pair<const char*, std::function<void(RenderCommand&)>>> changes = {
      {"view cut", [](RenderCommand& c) { c.view = "cut"; }},
      {"colour region", [](RenderCommand& c) { c.colour = "region"; }},
      {"colour patch", [](RenderCommand& c) { c.colour = "patch"; }},
      {"from",
       [](RenderCommand& c) {
         c.from = {2, 1, 1};
       }},
      {"up",
       [](RenderCommand& c) {
         c.up = {0, 1, 0};
       }},
      {"zoom", [](RenderCommand& c) { c.zoom = 2; }},
      {"edges", [](RenderCommand& c) { c.edge_width = 0; }}};
  for (const auto& [name, change] : changes) EXPECT_NE(drawn(change), plain) << name;
  const auto cut = [](double x, double at) {
    return [x, at](RenderCommand& c) {
      c.view = "cut";
      c.plane = {x, 1 - x, 0};
      c.at = at;
    };
  };
  EXPECT_NE(drawn(cut(0, 0.3)), drawn(cut(0, 0.7)));
  EXPECT_NE(drawn(cut(0, 0.3)), drawn(cut(1, 0.3)));
}

}  // namespace
}  // namespace tetfarm
