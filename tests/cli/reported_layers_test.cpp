#include "cli/reported_layers.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/inspect/vtp_text.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A wall of two triangles: one has all of 4 layers, one folds after 3.
VtpTriangles map_of_two() {
  VtpTriangles text;
  text.points = 4;
  text.coordinates = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  text.triangles = 2;
  text.corners = "0 1 2\n0 2 3\n";
  text.arrays = {{"Int64", "layers", "4\n3\n"},
                 {"Int64", "wanted", "4\n4\n"},
                 {"Float64", "first_height", "0.1\n0.12\n"},
                 {"Float64", "first_wanted", "0.1\n0.1\n"},
                 {"Float64", "total_height", "0.4\n0.3\n"},
                 {"Int64", "reason", "0\n4\n"}};
  return text;
}

TEST(ReportedLayers, counts_the_triangles_of_the_map) {
  const GridSource grid(cut_grid(2));
  const ReportedLayers layers = reported_layers(vtp_text(map_of_two()), grid, nullptr);
  EXPECT_EQ(layers.full, 1);
  EXPECT_EQ(layers.by_reason, (std::map<std::string, std::int64_t>{{"fold", 1}}));
  EXPECT_THAT(layers.by_layers, ElementsAre(0, 0, 0, 1, 1));
  EXPECT_EQ(layers.first_heights.counts[20], 1) << "1";
  EXPECT_EQ(layers.first_heights.counts[28], 1) << "1.2";
  EXPECT_TRUE(layers.shapes.empty());
  EXPECT_EQ(layers.pictures.size(), 2) << "the file of the mesh does not tell the layers";
}

TEST(ReportedLayers, takes_how_well_cells_are_shaped_from_the_job) {
  const GridSource grid(cut_grid(2));
  wire::JobStatus status;
  (*status.mutable_numbers())["layers_top_jump_median"] = 1.25;
  const ReportedLayers layers = reported_layers(vtp_text(map_of_two()), grid, &status);
  ASSERT_EQ(layers.shapes.size(), 1);
  EXPECT_EQ(layers.shapes[0][1], "1.250");
}

TEST(ReportedLayers, are_not_made_of_a_map_without_the_numbers) {
  VtpTriangles text = map_of_two();
  text.arrays.pop_back();
  const GridSource grid(cut_grid(2));
  EXPECT_THAT(error_text_of<InvalidInput>([&] { reported_layers(vtp_text(text), grid, nullptr); }),
              HasSubstr("no array \"reason\""));
}

TEST(ReportedLayers, map_of_a_mesh_is_that_of_its_name_beside_it) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "wing.layers.vtp", "a map");
  EXPECT_EQ(layer_map_of(folder.path() / "wing.vtkhdf"), "a map");
  EXPECT_EQ(layer_map_of(folder.path() / "wing.lb8.ugrid"), "a map");
  EXPECT_EQ(layer_map_of(folder.path() / "hull.vtkhdf"), std::nullopt);
}

}  // namespace
}  // namespace tetfarm
