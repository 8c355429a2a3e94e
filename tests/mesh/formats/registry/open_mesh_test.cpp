#include "mesh/formats/registry/open_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/regions_of_faces.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// A format as `export` writes it, and the file that is opened.
struct Case {
  const char* format;
  const char* output;
  const char* file;

  const Format& facts() const { return find_mesh_format(format, output); }
};

const std::array cases = {Case{"vtkhdf", "a.vtkhdf", "a.vtkhdf"},
                          Case{"lb8.ugrid", "a.lb8.ugrid", "a.lb8.ugrid"},
                          Case{"b8.ugrid", "a.b8.ugrid", "a.b8.ugrid"},
                          Case{"lb8l.ugrid", "a.lb8l.ugrid", "a.lb8l.ugrid"},
                          Case{"b8l.ugrid", "a.b8l.ugrid", "a.b8l.ugrid"},
                          Case{"su2", "a.su2", "a.su2"},
                          Case{"meshb", "a.meshb", "a.meshb"},
                          Case{"cgns", "a.cgns", "a.cgns"},
                          Case{"msh41", "a.msh", "a.msh"},
                          Case{"msh41-text", "a.msh", "a.msh"},
                          Case{"msh41-split", "a.msh", "a_1.msh"},
                          Case{"msh41-ghosts", "a.msh", "a_1.msh"},
                          Case{"msh22", "a.msh", "a.msh"},
                          Case{"pvtu", "a.pvtu", "a.pvtu"},
                          Case{"tetgen", "a.node", "a.ele"}};

fs::path exported(const MeshSource& source, const TempFolder& folder, const Case& as) {
  export_mesh(source, find_mesh_format(as.format, as.output), folder.path() / as.output);
  return folder.path() / as.file;
}

GridSource grid_of_two_regions() {
  GridSource grid(cut_grid(4));
  for (const std::size_t part : {1, 2}) grid.parts[part].region = 2;
  return grid;
}

/// Of all tets by number: nodes and region.
std::vector<std::array<std::int64_t, 5>> tets_of(const MeshSource& source) {
  std::vector<std::array<std::int64_t, 5>> tets;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      auto& tet = tets.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        tet[k] = part.local2global[static_cast<std::size_t>(part.tets[t][k])];
      }
      tet[4] = part.region_of(t);
    }
  }
  return tets;
}

TEST(OpenMesh, every_format_of_files_that_is_read_and_written_has_a_case) {
  for (const Format& format : written_formats()) {
    if (format.open_mesh == nullptr || format.layout == FormatLayout::folder) continue;
    EXPECT_TRUE(std::ranges::any_of(cases, [&](const Case& as) {
      return as.format == format.name;
    })) << format.name;
  }
}

TEST(OpenMesh, every_format_gives_back_the_mesh_that_was_exported_bit_for_bit) {
  const GridSource grid = grid_of_two_regions();
  for (const Case& as : cases) {
    SCOPED_TRACE(as.format);
    const TempFolder folder;
    const auto read = open_mesh(exported(grid, folder, as), folder.path());
    EXPECT_EQ(content_of(*read), content_of(grid));
    auto wanted = tets_of(grid);
    if (!as.facts().has_regions) {
      for (auto& tet : wanted) tet[4] = 1;
    }
    EXPECT_EQ(tets_of(*read), wanted);
    EXPECT_EQ(read->patch_names().size(), as.facts().has_patch_names ? 2U : 0U);
    EXPECT_EQ(outline_of(*read).nodes, grid.nodes);
    if (read->knows_subdomains()) {
      ASSERT_EQ(read->size(), grid.size());
      for (std::size_t i = 0; i < grid.size(); ++i) {
        EXPECT_EQ(read->part(i).tets.size(), grid.parts[i].tets.size());
        EXPECT_EQ(read->part(i).region, grid.parts[i].region);
      }
    }
  }
}

TEST(OpenMesh, parts_of_several_regions_keep_the_region_of_each_tet_and_triangle) {
  GridSource grid(cut_grid(4));
  for (NumberedPart& part : grid.parts) {
    part.region_of_tet.assign(part.tets.size(), 1);
    std::fill(part.region_of_tet.begin() + 9, part.region_of_tet.end(), 2);
    set_regions_of_faces(part);
  }
  for (const Case& as : cases) {
    if (!as.facts().has_regions) continue;
    SCOPED_TRACE(as.format);
    const TempFolder folder;
    const auto read = open_mesh(exported(grid, folder, as), folder.path());
    EXPECT_EQ(content_of(*read), content_of(grid));
    EXPECT_EQ(tets_of(*read), tets_of(grid));
  }
}

TEST(OpenMesh, a_file_cut_short_anywhere_is_refused) {
  const GridSource grid = grid_of_two_regions();
  for (const Case& as : cases) {
    const TempFolder folder;
    const fs::path file = exported(grid, folder, as);
    const std::string bytes = read_file(file);
    for (const std::size_t sevenths : {0, 1, 2, 3, 4, 5, 6}) {
      const std::size_t length = bytes.size() * sevenths / 7;
      write_file_atomically(file, std::string_view(bytes).substr(0, length));
      EXPECT_THROW(open_mesh(file, folder.path()), InvalidInput) << as.format << ' ' << length;
    }
  }
}

TEST(OpenMesh, what_is_no_mesh_by_its_ending_is_refused_with_those_that_are) {
  try {
    open_mesh("wing.stl");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(".b8l.ugrid"), std::string::npos);
  }
  EXPECT_THROW(open_mesh("/nowhere/a.vtkhdf"), IoError);
  for (const Case& as : cases) {
    EXPECT_THROW(open_mesh(fs::path("/nowhere") / as.file), IoError) << as.format;
  }
}

}  // namespace
}  // namespace tetfarm
